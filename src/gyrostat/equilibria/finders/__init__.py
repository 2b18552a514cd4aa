"""Complete lists of relative equilibria at numbers, one finder for each kind of scene.

`rate_level_tilt` reads what is asked: numbers, and a rate, a level or a tilt; `rotors_in_rpm` takes π out of
them. `revolution` finds those of a body of revolution in U(k3), each a `precession_branch`, `free` the
rotations of a free body, each a `free_rotation`. `heavy` finds those of any other body in a field, each a
`heavy_rotation`, decided by its `heavy_data`: `heavy_levels` on a level of C1, `heavy_polynomials` in fields
of any degree. `orbit` finds the attitudes of a satellite, each an `orbital_equilibrium`, decided by its
`orbital_invariants`; `orbital_axial` has those in closed form.
"""
