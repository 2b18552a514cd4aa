"""Relative equilibria along a parameter: pieces of one verdict, and marks where something happens.

`continuation` is the one verb. For a body of revolution `meeting_equations` says where its equilibria meet,
`bifurcation_kinds` in which way, `meeting_values` at which numbers; `stations_at_rate` has all values at
which something may change, and `revolution_branches` goes from one to the next. A `piece_and_mark` is what
all of them give. For a free gyrostat the same is done by `free_meeting_equations`, `free_meetings`,
`rotor_planes` (in a plane of its rotor) and `free_branches`, for a heavy one by `heavy_branches`.
"""
