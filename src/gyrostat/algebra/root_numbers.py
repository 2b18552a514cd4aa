"""The real roots of an irreducible polynomial as SymPy's numbers, which SymPy is told where to find.

To show a root, or a product with one, SymPy evaluates it, from isolating intervals that continued fractions
make smaller: hours for roots that are 10⁻¹⁵ apart, or of the size 10³⁰. python-flint isolates them at once.
"""
import math
from collections.abc import Sequence

from flint import arb, fmpz_poly
from sympy import CRootOf, Expr, Poly, PurePoly, Rational, Symbol
from sympy.polys import rootoftools
from sympy.polys.domains import QQ, ZZ
from sympy.polys.rootisolation import RealInterval

from .balls import ends
from .precision import own_precision

BITS = 256                                             # of a root that SymPy is lent
MODERATE = 9                                           # powers of ten of roots that are left as they are


def roots_of(coefficients: Sequence[Rational]) -> list[Expr]:
    """In increasing order, of a polynomial of degree 3 or more, irreducible over ℚ.

    Very large or small ones are each a power of ten times a root near 1.

    Parameters
    ----------
    coefficients : sequence of Rational
        from the constant term

    Examples
    --------
    >>> roots_of([Rational(-1), Rational(-1), Rational(0), Rational(1)])
    [CRootOf(x**3 - x - 1, 0)]
    """
    unit = Rational(10) ** _order(coefficients[0] / coefficients[-1], len(coefficients) - 1)
    near = Poly([a * unit**n for n, a in enumerate(coefficients)][::-1], Symbol("x"))
    whole = fmpz_poly([int(c) for c in reversed(near.clear_denoms(convert=True)[1].all_coeffs())])
    count = sum(root.imag == 0 for root, _ in whole.complex_roots())
    found = [CRootOf(near, n) for n in range(count)]
    for root in {root for number in found for root in number.atoms(CRootOf)}:
        _lend(root.poly)
    return [unit * number for number in found]


def _order(product: Rational, degree: int) -> int:
    """The power of ten of the geometric mean of the roots, whose product is given; 0 if it is moderate."""
    bits = int(abs(product.p)).bit_length() - int(product.q).bit_length()
    order = round(bits * math.log10(2) / degree)
    return order if abs(order) > MODERATE else 0


def _lend(poly: PurePoly) -> None:
    """Give SymPy the isolating intervals of the real roots, if it has not found them itself."""
    known = rootoftools._reals_cache
    if poly in known:
        return
    coefficients = poly.rep.to_list()
    with own_precision(BITS):
        roots = fmpz_poly([int(c) for c in reversed(coefficients)]).complex_roots()
    real = sorted((root.real for root, _ in roots if root.imag == 0), key=arb.mid)
    known[poly] = [RealInterval(tuple(QQ(x.numerator, x.denominator) for x in ends(root)), coefficients, ZZ)
                   for root in real]
