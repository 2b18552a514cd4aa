"""Real numbers whose signs are proved, and fields and matrices of them.

`exact` finds the sign of an expression: by fractions, or by enclosures down to a separation bound.
`transcendental` proves zeros among π, exponentials, sines and logarithms by a normal form. `number_fields`
computes in the field of a root of a polynomial, `eigenvalues` in that of the two eigenvalues of a Hamiltonian
matrix; `number_matrices` finds ranks, kernels and negative squares. `minimal_polynomial` describes a number
by its polynomial and an interval.
"""
