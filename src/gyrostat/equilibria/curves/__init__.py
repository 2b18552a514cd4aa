"""Curves of relative equilibria, with the verdicts along them.

`staude` has the cone of directions about which a body in a field turns permanently. Its arcs are cut and
decided in one way, in `arc`, on `cone_curves` without a rotor and on `rate_curves` with one; `inertia_axes`
splits their vectors along the principal axes of any tensor.
`amended_potential` has the rotations on a level as its critical points. For a body of revolution,
`precessions` are the regular ones at fixed momentum, and `critical_values` their energies. `rotor_planes` has
the curves in a plane of two components of the rotor at which rotations of a free gyrostat meet.
"""
