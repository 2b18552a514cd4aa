"""Turns a verdict into the values of a parameter for which it holds.

`solve` solves one condition for one parameter, with the `cases` of the others, and gives `sets` of intervals
with exact ends. With numbers for the others, `line_decomposition` cuts the line of the parameter where a
verdict may change. `stabilizing_set` is the verb that uses both, with `stable_tilts` for E3; `wheel_speeds`
asks for the speed of a wheel that holds an attitude in orbit. `spectra` follows the eigenvalues along a
parameter to where they collide.
"""
