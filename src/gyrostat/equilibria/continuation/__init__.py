"""Continuation of relative equilibria along a parameter: pieces of one verdict, and marks between them.

`continuation` is the one verb; `following` goes from one station to the next on a Curve, which says what is
between and what meets, and gives `pieces` and each `mark`. For a body of revolution the Curve is in
`revolution_branches`, by `stations_at_rate`; for permanent rotations it is in `free_branches` and
`heavy_branches`, by `pencil_branches`, and `heavy_changes` has the values at which stability changes in a
field; for a satellite it is in `orbit_branches`. `meeting_equations` says where branches meet,
`bifurcation_kinds` in which way, `meeting_values` at which numbers; for a free gyrostat `free_meetings` and
`free_meeting_equations` do that.
"""
