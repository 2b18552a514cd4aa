"""A second derivation, at rational numbers, which uses nothing of the first one.

`counterexample` is Newton and Euler's equations at a point, `frame_equations` those of satellites and
vehicles, `torques` those of permanent rotations; `signs` are those of energies there, and `least_energy`
tells whether damping spares a point. `names_at_numbers` gives what a formula names, with `three_turns` for
Euler's angles and `separatrix_residual` for that of a free body. `oscillations` follows motions near an
equilibrium by `power_series`, for `arnold`'s theorem. `counts_by_newton` counts equilibria by search.
"""
