"""Relative equilibria along a parameter: pieces of one verdict, and marks where something happens.

`continuation` is the one verb; `following` goes from one station to the next on a Curve, which says what
is between and what meets, and gives `pieces` and each `mark`. Of a body of revolution the Curve is in
`revolution_branches`, by `stations_at_rate`; of permanent rotations in `free_branches` and `heavy_branches`,
by `pencil_branches`, and `heavy_changes` has the values at which stability changes in a field.
`meeting_equations` says where branches meet, `bifurcation_kinds` in which way, `meeting_values` at which
numbers; of a free gyrostat `free_meeting_equations`, `free_meetings` and `rotor_planes` do that.
"""
