"""Enclosures with proved errors (ball arithmetic), and other arithmetics on expressions.

`precision` sets how many bits python-flint computes with, `rationals` takes its fractions to SymPy and back,
`balls` encloses an expression, `real_roots` all real roots of a polynomial, and `algebraic` says how near to
0 an algebraic number can be that is not 0.
`arithmetic` walks over an expression and evaluates it in any arithmetic: `floats` does so over arrays,
`double_double` with 106 bits.
"""
