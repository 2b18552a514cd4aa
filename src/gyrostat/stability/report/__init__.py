"""The analysis of one equilibrium.

`derived_parts` derives the two matrices and their criteria when they are asked for, and `report` gives the
verdicts at numbers. Two kinds of equilibria have reports of their own: permanent rotations in any direction
(`rotation_report`) and those where two directions are parallel (`parallel_report`). `analysis` chooses.
"""
