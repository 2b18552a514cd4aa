"""Derives what a formula names a second time, at rational numbers, without anything of the first derivation.

`counterexample` has Newton and Euler's equations at a point, `frame_equations` those of satellites and
vehicles, and `torques` those of permanent rotations. `signs` finds the signs of energies, and `least_energy`
tells whether an equilibrium stays stable under damping. `names_at_numbers` gives what a formula names, with
`three_turns` for Euler's angles; `separatrix_residual` tests the separatrix of a free body. `oscillations`
follows motions near an equilibrium by `power_series`, as `arnold`'s theorem needs it. `counts_by_newton`
counts equilibria by a search.
"""
