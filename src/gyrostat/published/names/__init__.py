"""Derives what a formula may name.

`derived_names` has all names of a scene. A few subjects have modules of their own: `kinematics` for Euler's
angles, `jacobi` for elliptic functions, `rotations` for permanent rotations, `windows` for normal forms, and
`frames` for satellites and vehicles.
"""
