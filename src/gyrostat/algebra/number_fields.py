"""The field of a root of an irreducible polynomial over ℚ."""
from flint import fmpq_mat, fmpq_poly
from sympy import Add, Expr, Mul, Rational


def divided(tops: list[fmpq_poly], under: fmpq_poly, modulus: fmpq_poly) -> list[fmpq_poly]:
    """Quotients in the field of a root of an irreducible polynomial: top = quotient·under + rest·modulus.

    By one linear system: an inverse would be much longer than the quotients are.

    Examples
    --------
    >>> divided([fmpq_poly([1])], fmpq_poly([1, 1]), fmpq_poly([-2, 0, 1]))
    [x + (-1)]
    """
    under, size = under % modulus, modulus.degree()
    width = size + under.degree()
    columns = [[0] * n + f.coeffs() for f, count in ((under, size), (modulus, under.degree()))
               for n in range(count)]
    system, sides = ([[c[n] if n < len(c) else 0 for c in several] for n in range(width)]
                     for several in (columns, [(top % modulus).coeffs() for top in tops]))
    found = fmpq_mat(system).solve(fmpq_mat(sides))
    return [fmpq_poly([found[n, m] for n in range(size)]) for m in range(len(tops))]


def at_root(polynomial: fmpq_poly, root: Expr) -> Expr:
    """The value at a root."""
    return Add(*(Mul(Rational(int(c.p), int(c.q)), root**n) for n, c in enumerate(polynomial.coeffs()) if c))
