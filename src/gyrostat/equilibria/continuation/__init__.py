"""Relative equilibria along a parameter: pieces of one verdict, and marks where something happens.

`continuation` is the one verb. It has `following` go from one station to the next on a Curve, which says what is
between and what meets: `revolution_branches` of a body of revolution, whose stations `stations_at_rate` has,
`free_branches` and `heavy_branches` of permanent rotations, both by `pencil_branches`; `heavy_changes` has the
values at which stability changes in a field. A `piece_and_mark` is what all give. `meeting_equations` says where
equilibria meet, `bifurcation_kinds` in which way, `meeting_values` at which numbers; `free_meeting_equations`,
`free_meetings` and `rotor_planes` (in a plane of its rotor) the same of a free gyrostat.
"""
