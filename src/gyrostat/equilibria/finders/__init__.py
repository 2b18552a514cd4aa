"""Complete lists of relative equilibria at numbers, one finder for each kind of scene.

`rate_level_tilt` reads what is asked: numbers, and a rate, a level or a tilt. Each finder has a form, which
says where an equilibrium lies, what decides it and in which words. `revolution` finds those of a body of
revolution in U(k3) (`revolution_form`), `free` the rotations of a free body (`free_form`). `heavy` finds
those of any other body in a field (`heavy_form`): `heavy_levels` on a level of C1 (`level_rates`),
`heavy_polynomials` in fields of any degree. `orbit` finds the attitudes of a satellite in the gravity
gradient, `one_torque` with one more torque in closed form, `orbit_torques` in any other potential,
`amended_orbit` (`orbital_form`), and `circles_of_attitudes` if a turn is a symmetry.
"""
