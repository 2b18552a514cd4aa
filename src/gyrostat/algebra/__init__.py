"""Exact mathematics without mechanics: expressions, polynomials, proved signs, complete lists of zeros.

A text of a user becomes an expression through a whitelist; nothing is evaluated (`text`). Expressions become
polynomials over ℚ, are computed with, and are written again as a person would write them (`rings`). The sign
of a number is proved (`reals`), by fractions or by `enclosures` whose precision grows until they exclude 0.
On these stands `solving`: the sign of a polynomial on a domain, all real roots, all zeros on a sphere, the
branches of plane curves. `pencils` finds the points that matrices of one parameter take to a vector,
`rotations` all critical points on the rotations.
"""
