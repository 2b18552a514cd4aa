"""Numbers with proved errors, and arithmetic of other kinds on expressions.

`precision` sets how many bits python-flint computes with, `rationals` takes its fractions to SymPy and back,
`balls` encloses an expression, and `algebraic` says how near to 0 an algebraic number can be that is not 0.
`arithmetic` walks over an expression and computes in any numbers: `floats` does so over arrays,
`double_double` with 106 bits.
"""
