"""From two matrices to a verdict.

At an equilibrium the field is linearised on the coadjoint orbit (`linearization`) and the energy varied twice
on the symplectic slice (`energy_casimir`); each gives a criterion (`conditions`), reduced by what follows
from what (`implication`), and true, false or not proved at numbers (`truth`); of a dual spinner damped in
both bodies `energy_sink` gives one, of first order. In any direction k both come from a `closed_form`. Where
both are silent the reduced motion decides (`boundary`, of a free body `sphere`), of any body what is
`elementary`: `integrals` of the user, `torquefree`, a degenerate potential (`amended`), or, where gyroscopic
forces hold a maximum (`windows`), the normal form (`birkhoff`) of the energy on the orbit (`orbit_chart`, at
numbers a `local_motion`), with its `resonances`, its D4 exactly by `averages`; `drift` says what holds of the
point itself. What is `derived` a `report`, which `analysis` makes, asks in this order, at numbers that
`values` checks and `notes` comments, and gives a `decision`, or a `normal_form`, with names left open D4 in
them (`window_families`); a `rotation_report` in any direction. Every relative equilibrium is found by
`relative_equilibria`: in U(k3) by `branches` as it is `asked`, each a `branch`, of a free body by
`permanent_rotations` (`rotors_in_rpm`), of any other by `heavy_rotations`, each a `heavy_rotation`, on a
level of C1 by `heavy_levels`, in any polynomial by `heavy_polynomials`, decided by the
closed forms of `amended_form` of its `heavy_data`; they are critical points of the `amended_potential`, and
on arcs: Staude's cone (`staude`, `staude_arcs`), with a rotor the curves of `gyrostat_arcs` (`rate_curves`).
Where they meet,
`bifurcations` say in equations and `meetings` in numbers, each of one of the `kinds`; `critical`, `pieces`,
`followed` and `continuation` follow them along a parameter (of a free body `rotation_loci`,
`rotation_meetings`, `followed_rotations`, `rotor_planes`; of a heavy one `followed_heavy`); `critical_values`
(`precessions`) and `spectra` their levels and eigenvalues. `solve` (`cases`, `sets`) and `stabilizing`
(`decomposition`, `tilts`) turn a verdict into values.

In the frame of two directions the second variation is a stiffness beside the momenta (`orientation_form`),
the characteristic polynomial a `sextic`; damping (`secular_in_frame`) and what lies between (`in_frame`) are
their own; of parallel directions there is a `parallel_report`; `orbital_equilibria` finds those of a
satellite, each an `orbital_equilibrium`, some in closed form (`orbital_axial`).
"""
