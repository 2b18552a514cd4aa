"""Exact mathematics, without mechanics.

A text becomes an expression through a whitelist (`inputs`, `spelling`, `scanner`, `grammar`, within `limits`
by `magnitudes` and `parts`; numbers in `numbers`; what is `occurring` in one comes in its order). Expressions
become polynomials over Q and matrices of them (`generators`, `polynomials`, `matrices`) and are written again
as a person would (`readable`). The sign of a number is exact (`exact`): rational, in `balls` of any
`precision`, 0 by a separation bound (`algebraic`) or a normal form (`transcendental`, of its `constituents`,
over `quotients`); that of a polynomial is known from its factors (`margins`, `forms`), of pencils of matrices
whether one is `definite`. Real `roots` are isolated, over π by balls (`enclosed_roots`), `zeros` of functions
too, and the points of a sphere that `pencils` of matrices take to a vector. Where polynomials vanish on a
sphere is a set (`sphere_sets`) of curves, split off (`sphere_curves`), and of points (`sphere_zeros`, in
`number_fields`, `real_fields` at one root); plane curves F(x, t) = 0 are taken apart (`elimination`,
`plane_curves`, `stations`), roots of polynomials that depend on a parameter followed as `strands`. Truncated
power `series` have coefficients in any ring, as that of the `eigenvalues` of a Hamiltonian, or of
`rational_functions`. Any other `arithmetic`, as that of `floats`, and `double_double` come last.
"""
