"""Equilibria, checked when they are built, with their orbits and their symmetries.

An `equilibrium` satisfies its equations by the `relations` between its names; `claimed_point` makes one of a
point that a user claims, `unit_vectors` names directions. What is asked of it is `derived_once`, in one
`derivation_ring`; `coadjoint_orbit` has the tangent space of the orbit and in it the symplectic slice.
`parallel_directions` treats two directions that coincide. `recognition` proves that a scene is a body of
revolution, about whatever axis; `standard_axes` turns an equilibrium so that this axis is the third. Then
`reduction` leaves one degree of freedom, k3, and `reduced_series` expands it near an equilibrium, `near_pole`
in fractional powers at k3 = ±1.
"""
