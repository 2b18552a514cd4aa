"""Straight-line programs of margins: what is computed at each point of a grid, without division.

`straightline` writes a margin in an order that leaves least to do for each point. Named numbers, such as
trace and determinant of small matrices, become programs by `quotients`. `rounding` proves a bound of the
error of a program in doubles. `tiles` runs it over blocks that fit a cache, and `kernels` compiles it to one
loop.
"""
