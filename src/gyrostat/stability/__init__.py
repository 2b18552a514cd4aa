"""From two matrices to a verdict.

At an equilibrium the field is linearised on the coadjoint orbit (`linearization`) and the energy varied twice
on the symplectic slice (`energy_casimir`); each gives a criterion (`conditions`), reduced by what follows
from what (`implication`), and true, false or not proved at numbers (`truth`); of a dual spinner damped in
both bodies `energy_sink` gives one, of first order. Where both are silent the reduced motion decides
(`boundary`, of a free body `sphere`), of any body what is `elementary` (`amended`, without a torque
`torquefree`); `drift` says what holds of the point itself. `report`, which `analysis` makes, asks them in
this order, at numbers that `values` checks and `notes` comments, and gives a `decision`; in any direction k a
`rotation_report` does, by a `closed_form`. Every relative equilibrium is found by `relative_equilibria`: in
U(k3) by `branches` as it is `asked`, each a `branch`, of a free body by `permanent_rotations`
(`rotors_in_rpm`), of any other by `heavy_rotations`, on a level of C1 by `heavy_levels`, decided by the
closed forms of `amended_form`; Staude's cone has them all without a rotor (`staude`, `staude_arcs`). Where
they meet, `bifurcations` say in equations and `meetings` in numbers, each of one of the `kinds`; `critical`,
`pieces`, `followed` and `continuation` follow them along a parameter (of a free body `rotation_loci`,
`rotation_meetings`, `followed_rotations`, `rotor_planes`); `critical_values` (`precessions`) and `spectra`
their levels and eigenvalues. `solve` (`cases`, `sets`) and `stabilizing` (`decomposition`, `tilts`) turn a
verdict into values.
"""
