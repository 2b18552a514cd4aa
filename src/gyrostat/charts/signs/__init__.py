"""The exact verdict at every point of a grid: floats if they prove it, else whole numbers and balls.

A margin, with the `grid_constants` inserted, becomes a program in an order that leaves least to do for each
point (`straightline`); named numbers, such as trace and determinant of small matrices, become one without
division (`quotients`). `leaves` are what it starts from, and `rounding` proves a bound of its error.
`kernels` compiles the program, `tiles` runs it over blocks that fit a cache, `block_writing` writes the
results, and `compiled_margins` offers this to users. `given_columns` reads what is given; `float_screening`
decides most points of a list after one look at its columns. `grid_signs` proves the signs that are left,
those of doubles in whole numbers by `dyadic`. `criteria_codes` tells what two criteria decide, by one loop
for all margins, and then by the `three_valued` answers of each; `verdicts_in_blocks` makes verdicts of it.
Points that only gyroscopic forces stabilise are decided together (`stabilized_points`), in `ball_arrays`.
`verdict_arrays` is the verb.
"""
