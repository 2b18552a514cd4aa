"""Real roots of irreducible polynomials as SymPy's CRootOf, isolated for SymPy by python-flint.

To show a root, or a product with one, SymPy evaluates it, from isolating intervals that it makes smaller by
continued fractions: hours for roots that are 10⁻¹⁵ apart, or of the size 10³⁰. python-flint isolates them at
once.
"""
import math
from collections.abc import Sequence

from flint import fmpz_poly
from sympy import CRootOf, Expr, Poly, PurePoly, Rational, Symbol
from sympy.polys import rootoftools
from sympy.polys.domains import QQ, ZZ
from sympy.polys.rootisolation import RealInterval

from ...errors import ScopeError
from ..enclosures.algebraic import over_integers
from ..enclosures.balls import ends
from ..enclosures.precision import own_precision
from ..enclosures.real_roots import isolated_roots

BITS = 256                                             # of a root that SymPy is lent
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
    whole = over_integers(near)
    refuse_close(whole)
    found = [CRootOf(near, n) for n in range(len(isolated_roots(whole)))]
    for root in {root for number in found for root in number.atoms(CRootOf)}:
        _lend(root.poly)
    return [unit * number for number in found]


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
    if poly in known:
        return
    with own_precision(BITS):
        roots = isolated_roots(over_integers(poly))
    known[poly] = [RealInterval(tuple(QQ(x.numerator, x.denominator) for x in ends(root)), poly.rep.to_list(),
                                ZZ) for root in roots]
