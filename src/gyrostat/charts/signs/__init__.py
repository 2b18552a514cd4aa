"""The exact verdict at every point of a grid: floats if they prove it, else whole numbers and balls.

A margin, with the `grid_constants` inserted, becomes a program; `block_writing` writes its values, and
`compiled_margins` offers this to users. `given_columns` reads what is given, and `leaves` what a program
starts from; `float_screening` decides most points of a list after one look at its columns. `grid_signs`
proves the signs that floats leave, those of doubles in whole numbers by `dyadic`. `criteria_codes` tells what
two criteria decide, by one loop for all margins, and then by the `three_valued` answers of each;
`verdicts_in_blocks` makes verdicts of it. Points that only gyroscopic forces stabilise are decided together
(`stabilized_points`): D4 is `recorded` once, and the `computation` is repeated in `ball_arrays`.
`verdict_arrays` is the verb.
"""
