"""Theorems that decide where both criteria are silent, by terms of higher order.

For a body of revolution, `boundary` takes the first coefficient of the reduced motion that is not 0, and
`drift` tells whether a tilted equilibrium is stable as a point, too. For any body the ladder asks the others
in turn: `two_directions` for satellites and vehicles, `momentum_sphere` for a free body, `given_integrals` if
the user gives some, `no_torque` if U is constant, and `amended_expansion`, which expands the amended
potential to higher degree. `minimum_on_orbit` tells whether the energy is least where its second variation is
degenerate, which decides under damping.
"""
