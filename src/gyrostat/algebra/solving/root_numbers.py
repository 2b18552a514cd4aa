"""Real roots of irreducible polynomials as SymPy's CRootOf, isolated for SymPy by python-flint.

To show a root, or a product with one, SymPy evaluates it, from isolating intervals that it makes smaller by
continued fractions: hours for roots that are 10⁻¹⁵ apart, or of the size 10³⁰. python-flint isolates them at
once.
"""
import math
from collections.abc import Iterator, Sequence
from typing import Any

from flint import arb, fmpz_poly
from sympy import CRootOf, Expr, Poly, PurePoly, Rational, Symbol
from sympy.polys import rootoftools
from sympy.polys.domains import QQ, ZZ
from sympy.polys.rootisolation import RealInterval

from ...errors import ScopeError
from ..enclosures.algebraic import over_integers, real_roots_of
from ..enclosures.balls import ends

APART = 600                                            # bits, for each root
DIFFERENT = ("these numbers are of so different sizes that equilibria, or the quantities that decide their "
             "stability, are no longer told apart: leave out what is far too small to matter, or make "
             "smaller what is far too large")
MODERATE = 9                                           # powers of ten of roots that are left as they are


def roots_of(coefficients: Sequence[Rational]) -> list[Expr]:
    """Return the real roots of a polynomial of degree 3 or more, irreducible over ℚ, in increasing order.

    Very large or very small ones are a power of ten times a root near 1.

    Parameters
    ----------
    coefficients : sequence of Rational
        from the constant term

    Raises
    ------
    ScopeError
        roots are of so different sizes that to tell them apart takes minutes

    Examples
    --------
    >>> roots_of([Rational(-1), Rational(-1), Rational(0), Rational(1)])
    [CRootOf(x**3 - x - 1, 0)]
    """
    unit = Rational(10) ** _order(coefficients[0] / coefficients[-1], len(coefficients) - 1)
    near = Poly([a * unit**n for n, a in enumerate(coefficients)][::-1], Symbol("x"))
    refuse_close(over_integers(near))
    factor, first = CRootOf(near, 0).as_coeff_Mul()        # for each that it makes SymPy factors once more
    _lend(first.poly)
    return [unit * (factor * CRootOf._new(first.poly, n)) for n in range(len(real_roots_of(first.poly)))]


def _order(product: Rational, degree: int) -> int:
    """Return the power of ten of the geometric mean of the roots, by their product; 0 if it is moderate."""
    bits = int(abs(product.p)).bit_length() - int(product.q).bit_length()
    order = round(bits * math.log10(2) / degree)
    return order if abs(order) > MODERATE else 0


def refuse_close(polynomial: fmpz_poly) -> None:
    """Refuse a polynomial with roots of such sizes that it takes minutes to isolate them.

    Its coefficients are compared with those that roots of one modulus would give.

    Raises
    ------
    ScopeError
        roots lie too far apart
    """
    while not polynomial[0]:
        polynomial = polynomial.right_shift(1)
    bits, degree = [int(c).bit_length() for c in polynomial.coeffs()], polynomial.degree()
    above = max(degree * b - (degree - n) * bits[0] - n * bits[-1] for n, b in enumerate(bits))
    if above > degree * APART:
        raise ScopeError(DIFFERENT)


def refuse_touching(polynomial: fmpz_poly) -> None:
    """Refuse a polynomial with roots so close that FLINT takes minutes to isolate all complex ones.

    By the discriminant the product of the distances of its roots is compared with that of distances as large
    as the roots; a double root is none of two close ones.

    Raises
    ------
    ScopeError
        roots lie too close to each other
    """
    while not polynomial[0]:
        polynomial = polynomial.right_shift(1)
    resultant = polynomial.resultant(polynomial.derivative())
    discriminant = int(resultant // polynomial.leading_coefficient()).bit_length()
    ends, degree = [int(polynomial[n]).bit_length() for n in (0, polynomial.degree())], polynomial.degree()
    if resultant and (degree - 1) * sum(ends) - discriminant > degree * APART:
        raise ScopeError(DIFFERENT)


def _lend(poly: PurePoly) -> None:
    """Give SymPy the isolating intervals of the real roots, if it has not found them itself."""
    known = rootoftools._reals_cache
    if poly not in known:
        known[poly] = _Intervals(poly)


class _Intervals(list[Any]):
    """SymPy's isolating intervals of the real roots of a polynomial, each made when SymPy asks for it."""

    def __init__(self, poly: PurePoly):
        super().__init__(real_roots_of(poly))
        self._poly = poly

    def __getitem__(self, n: Any) -> Any:
        if isinstance(found := super().__getitem__(n), arb):
            found = self[n] = RealInterval(tuple(QQ(x.numerator, x.denominator) for x in ends(found)),
                                           self._poly.rep.to_list(), ZZ)
        return found

    def __iter__(self) -> Iterator[RealInterval]:
        return (self[n] for n in range(len(self)))
