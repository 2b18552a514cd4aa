"""What a formula may name, as the library derives it.

`derived_names` has all names of a scene. Those of a few subjects are apart: `kinematics` of Euler's angles,
`jacobi` of elliptic functions, `rotations` of permanent rotations, `windows` of normal forms, `frames` of
satellites and vehicles.
"""
