"""Theorems that decide where both criteria are silent.

For a body of revolution, `boundary` takes the first coefficient of the reduced motion that is not 0, and
`drift` tells whether a tilted equilibrium is stable as a point, too. For any body the ladder asks the others
in turn: `two_directions` for satellites and vehicles, `momentum_sphere` for a free body,
`given_integrals` of the user, `no_torque` where U is constant, and `amended_expansion`, which expands the
amended potential to higher degree. `minimum_on_orbit` proves that the energy is least where it is degenerate,
with damping too.
"""
