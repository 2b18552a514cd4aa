"""Arithmetic in the field of a root of an irreducible polynomial over ℚ: quotients and common divisors."""
from flint import fmpq_mat, fmpq_mpoly, fmpq_poly
from sympy import Add, Expr, Mul

from ..enclosures.rationals import to_sympy


def in_one(polynomial: fmpq_mpoly, index: int) -> fmpq_poly:
    """Return a polynomial in several generators as one in one of them, with 0 for the others."""
    coefficients = {e[index]: c for e, c in polynomial.to_dict().items() if sum(e) == e[index]}
    return fmpq_poly([coefficients.get(n, 0) for n in range(max(coefficients, default=-1) + 1)])


def divided(tops: list[fmpq_poly], under: fmpq_poly, modulus: fmpq_poly) -> list[fmpq_poly]:
    """Return quotients in the field of a root of the modulus: top = quotient·under + rest·modulus.

    One linear system gives them all. The inverse of `under` would be much longer than the quotients are.

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
    """Return the value of a polynomial at a root, as an expression."""
    return Add(*(Mul(to_sympy(c), root**n) for n, c in enumerate(polynomial.coeffs()) if c))


def common_divisor(f: list[fmpq_poly], g: list[fmpq_poly], modulus: fmpq_poly) -> list[fmpq_poly]:
    """Return the monic greatest common divisor of two polynomials over the field, by Euclid's algorithm.

    Coefficients stand from the constant term on.

    Examples
    --------
    >>> x, one, modulus = (fmpq_poly(c) for c in ([0, 1], [1], [-2, 0, 1]))
    >>> common_divisor([-2 * one, 0 * one, one], [x, one], modulus)
    [x, 1]
    """
    while g := _monic(g, modulus):
        rest = [c % modulus for c in f]
        while len(rest) >= len(g):
            lead, shift = rest[-1], len(rest) - len(g)
            rest = [(c - lead * g[n - shift]) % modulus if n >= shift else c for n, c in enumerate(rest[:-1])]
        f, g = g, rest
    return f


def _monic(f: list[fmpq_poly], modulus: fmpq_poly) -> list[fmpq_poly]:
    f = [c % modulus for c in f]
    while f and not f[-1]:
        f.pop()
    return [*divided(f[:-1], f[-1], modulus), fmpq_poly([1])] if len(f) > 1 else [fmpq_poly([1])] * len(f)
