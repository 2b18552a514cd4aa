"""Polynomials over ℚ: expressions enter, are computed with, and leave as a person writes them.

`generators` finds what of an expression becomes a variable of its ring, `polynomials` makes the ring and
leads into it and out of it, `readable` completes squares and keeps products, and `subexpressions` lists parts
in an order that never changes. `matrices` multiplies, takes determinants and finds kernels without fractions,
`elimination` removes a variable, `rational_functions` divides, `series` cuts powers off at a degree. Where a
number such as π occurs, `constituents` says what it is made of, `quotients` reduces by what the variables
satisfy, and `enclosed_roots` isolates the roots of polynomials by balls.
"""
