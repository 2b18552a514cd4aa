"""Real roots of polynomials over ℤ: isolated by Descartes' rule of signs, enclosed by Newton's method.

Two roots that are 2⁻ⁿ apart take n halvings. Methods that find all complex roots at once, as python-flint's,
converge but slowly where two nearly coincide: minutes for n = 1000.
"""
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from flint import arb, arb_poly, ctx, fmpq, fmpq_poly, fmpz_poly

from .precision import own_precision

NEXT = fmpz_poly([1, 1])                               # x + 1
GUARD = 64                                             # bits


class Place(NamedTuple):
    """The interval from c 2ⁿ to (c + 1) 2ⁿ with one root inside, and the sign of f at its lower end.

    The sign 0 says that c 2ⁿ itself is the root.
    """

    c: int
    n: int
    sign: int


def isolated_roots(polynomial: fmpz_poly | fmpq_poly) -> list[arb]:
    """Return the distinct real roots of a polynomial, isolated, in increasing order.

    They have the precision that is set, or a higher one if that does not tell them apart.

    Parameters
    ----------
    polynomial : fmpz_poly or fmpq_poly
        not 0

    References
    ----------
    Collins & Akritas, Polynomial real root isolation using Descartes' rule of signs, SYMSAC (1976) 272-275.

    Examples
    --------
    >>> roots = isolated_roots(fmpz_poly([0, -2, 0, 1]))
    >>> [round(float(x.mid()), 4) for x in roots]
    [-1.4142, 0.0, 1.4142]
    """
    f = polynomial.numer() if isinstance(polynomial, fmpq_poly) else polynomial
    f //= f.gcd(f.derivative())
    below = [Place(-c - (sign != 0), n, -sign) for c, n, sign in _positive(f(fmpz_poly([0, -1])))][::-1]
    places = [*below, *[Place(0, 0, 0)] * (not f[0]), *_positive(f)]
    bits = ctx.prec
    while True:
        found = [_enclosed(f, place, bits) for place in places]
        if all(a < b for a, b in pairwise(found)):
            return found
        bits *= 2


def _positive(f: fmpz_poly) -> Iterator[Place]:
    """Yield where the positive roots of a polynomial are, in increasing order; all roots are simple.

    By Descartes' rule for (1 + x)ⁿ g(1/(1 + x)), no change of sign of its coefficients says that g has no
    root between 0 and 1, and one change that it has one.
    """
    top = _bound(f)
    waiting = [(_stretched(f, top), 0, top)]
    while waiting:
        g, c, n = waiting.pop()
        if not g[0]:
            g = g.right_shift(1)
            if c:
                yield Place(c, n, 0)
        changes = _changes(fmpz_poly(g.coeffs()[::-1])(NEXT))
        if changes == 1:
            yield Place(c, n, 1 if g[0] > 0 else -1)
        elif changes:
            half = _stretched(g, -1)
            waiting += [(half(NEXT), 2 * c + 1, n - 1), (half, 2 * c, n - 1)]


def _bound(f: fmpz_poly) -> int:
    """Return n such that every root is less than 2ⁿ, by Fujiwara's bound 2 max |aᵢ/a|^(1/(d − i))."""
    *rest, lead = (int(c).bit_length() for c in f.coeffs())
    return 1 + max((-((lead - 1 - bits) // (len(rest) - i)) for i, bits in enumerate(rest) if bits),
                   default=0)


def _stretched(f: fmpz_poly, n: int) -> fmpz_poly:
    """Return f(2ⁿ x), times a power of 2 if n < 0."""
    degree = f.degree()
    return fmpz_poly([c << (n * i if n > 0 else -n * (degree - i)) for i, c in enumerate(f.coeffs())])


def _changes(f: fmpz_poly) -> int:
    """Count the changes of sign of the coefficients."""
    return sum(a != b for a, b in pairwise(c > 0 for c in f.coeffs() if c))


def _enclosed(f: fmpz_poly, place: Place, bits: int) -> arb:
    """Enclose a root to so many bits: by halves until the slope hardly changes, then by Newton's method."""
    low, width, slope = place.c * fmpq(2) ** place.n, fmpq(2) ** place.n, f.derivative()
    if not place.sign:
        return _ball(low, low, bits)
    precision = max(bits, place.c.bit_length()) + GUARD
    while not _steady(slope, root := _ball(low, low + width, precision), precision):
        width, precision = width / 2, precision + GUARD
        if not (value := f(low + width)):
            return _ball(low + width, low + width, bits)
        if value * place.sign > 0:
            low += width
    while root.rel_accuracy_bits() < bits:
        with own_precision(precision):
            middle = arb(root.mid())
            nearer = root.intersection(middle - arb_poly(f)(middle) / arb_poly(slope)(root))
        root, precision = nearer, precision * (1 if 2 * nearer.rad() < root.rad() else 2)
    return root


def _ball(low: fmpq, high: fmpq, precision: int) -> arb:
    with own_precision(precision):
        return arb(low).union(arb(high))


def _steady(slope: fmpz_poly, root: arb, precision: int) -> bool:
    """Tell whether the slope changes by less than a quarter in a ball: Newton's method contracts there."""
    with own_precision(precision):
        here = arb_poly(slope)(root)
        return here.is_finite() and 4 * here.rad() < abs(here).lower()
