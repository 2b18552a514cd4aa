"""The zeros of two polynomials on the sphere k·k = 1 that come in opposite pairs, k and −k, by a resultant.

Each pair is a point of the projective plane, in which two curves meet.
"""
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from math import prod

from flint import arb, arb_poly, fmpq_mpoly, fmpq_poly
from sympy import Expr, S

from ..._cached import cached_property
from ..enclosures.precision import doubled, own_precision
from ..reals.number_fields import in_one
from ..rings.polynomials import by_degree
from .common_points import CommonPoints
from .real_fields import BITS, FieldNumbers, RealNumbers
from .sphere_curves import PLANE, Terms, X, Y

FRAMES = 1, 2, 5                                       # in one of them no two pairs share y, as a rule


def opposite_zeros(given: Sequence[Terms], left_out: Sequence[Terms], above: Sequence[Terms],
                   exact: Callable[[], Iterable[FieldNumbers]]) -> list[FieldNumbers] | None:
    """Return every real zero of two polynomials, each even or odd, if all complex zeros are simple.

    Parameters
    ----------
    given : sequence of Terms
        none of them 0
    left_out : sequence of Terms
        polynomials whose zeros are left out
    above : sequence of Terms
        polynomials whose quotients by the first of left_out follow the coordinates
    exact : callable
        returns the same zeros as expressions, when these are asked for

    Returns
    -------
    list of FieldNumbers
        by abs(k1 + k2 + k3), each beside its opposite; None if it is not proved that they are all
    """
    several = [*given, *left_out, *above]
    if len(given) != 2 or any(len({sum(e) % 2 for e in f}) != 1 for f in several) or len(
            {sum(e) % 2 for f in (left_out[0], *above) for e in f}) != 1:
        return None
    for n in FRAMES:
        zeros = OppositeZeros(given, left_out, above, n, exact)
        if zeros.complete and (order := zeros.order) is not None:
            return [FieldNumbers(zeros, n, [(place, sign if place < 3 else S.One)
                                            for place in range(3 + len(above))])
                    for n in order for sign in (S.One, S.NegativeOne)]
    return None


class OppositeZeros(RealNumbers):
    """One of each pair of real zeros, and the values of quotients at it.

    With k = (x, y + n x, 1 − (n + 1) x) times a number, two forms are 0 where two plane curves meet. If the
    resultant in x is of full degree in y, no common point is infinite, and by Bézout's theorem there are no
    more. A multiple root y is admitted if it is rational, and all that lies over it is left out.
    """

    def __init__(self, given: Sequence[Terms], left_out: Sequence[Terms], above: Sequence[Terms], n: int,
                 exact: Callable[[], Iterable[FieldNumbers]]):
        self.left_out, self.above, self.n, self._found = left_out, above, n, exact
        self._values: dict[int, list[list[arb]]] = {}
        self._least = BITS
        self._degrees, self._curves = [max(map(sum, f)) for f in given], [self._placed(f) for f in given]

    @cached_property
    def _met(self) -> CommonPoints:
        F, G = self._curves
        return CommonPoints(F, G, 0, 1)

    def _placed(self, f: Terms) -> fmpq_mpoly:
        """Return the form in the coordinates x and y of the frame."""
        k, most = (X, Y + self.n * X, 1 - (self.n + 1) * X), max(map(sum, f))
        square = sum((x**2 for x in k), PLANE.constant(0))
        return sum((c * prod((x**a for x, a in zip(k, e)), start=square ** ((most - sum(e)) // 2))
                    for e, c in f.items()), PLANE.constant(0))

    @property
    def complete(self) -> bool:
        """Whether it is proved that beside the simple points no pair is a zero that is not left out."""
        return all(f.degrees()[0] == d for f, d in zip(self._curves, self._degrees)) and (
            self._met.degree == prod(self._degrees)) and all(
            map(self._over, (f for product in self._met.multiple for f, _ in product.factor()[1])))

    def _over(self, factor: fmpq_poly) -> bool:
        """Tell whether a factor has a rational root over which all common points are left out."""
        if factor.degree() > 1:
            return False
        y = -factor[0] / factor[1]

        def at(f: fmpq_mpoly) -> fmpq_poly:
            return fmpq_poly([in_one(part, 1)(y) for part in by_degree(f, 0, f.degrees()[0])])

        shared = at(self._curves[0]).gcd(at(self._curves[1]))
        product = prod(at(self._placed(f)) for f in self.left_out)
        return not product ** shared.degree() % shared

    @cached_property
    def order(self) -> list[int] | None:
        """The places of the zeros by k1 + k2 + k3; None if one may be left out, or the sums are not told."""
        for precision in doubled(BITS):
            points = self.values(precision)
            with own_precision(precision):
                sums = [sum(values[:3]) for values in points]
                found = sorted(range(len(points)), key=lambda n: float(sums[n].mid()))
                told = all(x > 0 for x in sums) and all(sums[a] < sums[b] for a, b in pairwise(found))
                if told and not any(_value(f, k).contains(0) for f in self.left_out for k in points):
                    self._least = precision
                    return found
        return None

    def values(self, precision: int) -> list[list[arb]]:
        """Return enclosures of k, with k1 + k2 + k3 > 0, and of the quotients, at each zero."""
        precision = max(precision, self._least)
        if precision not in self._values:
            with own_precision(precision):
                self._values[precision] = [self._at(x, y) for x, y in self._met.points(precision)]
        return self._values[precision]

    def _at(self, x: arb, y: arb) -> list[arb]:
        k = [x, y + self.n * x, 1 - (self.n + 1) * x]
        length = sum((a * a for a in k), arb(0)).sqrt()
        k = [a / length if sum(k) > 0 else -a / length for a in k]
        bottom = _value(self.left_out[0], k)
        return [*k, *(_value(f, k) / bottom for f in self.above)]

    @cached_property
    def _exact(self) -> list[FieldNumbers]:
        return list(self._found())

    def expression(self, root: int, place: int) -> Expr:
        """Return one of the numbers of a zero as an expression."""
        return self._same(root)[place]

    def is_fraction(self, root: int, place: int) -> bool:
        """Tell whether one of the numbers of a zero is a fraction."""
        own = self._factors[root]
        if len(own) == 1 and self.varies(place, [n for n, x in enumerate(self._factors) if x == own]):
            return False
        return self._same(root).is_fraction(place)

    @cached_property
    def _factors(self) -> list[list[int]]:
        """The irreducible factors that may vanish at each root y; one of them does."""
        factors = [f for f, _ in self._met.simple.factor()[1]]
        with own_precision(BITS):
            return [[m for m, f in enumerate(factors) if arb_poly(f)(y).contains(0)]
                    for _, y in self._met.points(BITS)]

    def _same(self, root: int) -> FieldNumbers:
        """Return the exact zero that has the same enclosures."""
        for precision in doubled(BITS):
            values = self.values(precision)[root]
            same = [zero for zero in self._exact
                    if all(a.overlaps(b) for a, b in zip(values, zero.balls(precision)))]
            if len(same) == 1:
                break
        return same[0]


def _value(f: Terms, k: Sequence[arb]) -> arb:
    """Return the value of a polynomial at a point.

    By products, since ** gives no finite power of a ball that contains 0.
    """
    return sum((prod((x for x, n in zip(k, e) for _ in range(n)), start=arb(c)) for e, c in f.items()),
               arb(0))
