"""The rotations on a level over a factor of the resultant, in balls; and rates that have none there."""
from collections.abc import Callable
from typing import NamedTuple

from flint import arb, arb_poly, fmpq, fmpq_mat, fmpq_mpoly, fmpq_poly
from sympy import Expr, Matrix, S, eye

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import doubled, own_precision
from ...algebra.enclosures.rationals import to_flint
from ...algebra.reals.number_fields import at_root, divided, in_one
from ...algebra.rings.polynomials import Ring, by_degree
from ...algebra.solving.common_points import CommonPoints
from ...algebra.solving.real_fields import BITS, RealNumbers
from ...algebra.solving.roots import roots_of_factor
from ...notation import symbol

TOLD = arb(2) ** -64                                       # the radius of k by which rotations are sorted
OMEGA, SIGMA, EPSILON = symbol("omega"), symbol("sigma"), symbol("epsilon")


class Field(NamedTuple):
    """A body in U = c·k + k·Qk/2 and the value of C1."""

    inertia: Matrix
    curved: Matrix
    linear: Matrix
    rotor: Matrix
    level: Expr

    def along(self, axes: list[int]) -> "Field":
        """Return the parts along some of the axes."""
        I, Q, c, l, level = self
        within, parts = (axes, axes), (axes, [0])
        return Field(I.extract(*within), Q.extract(*within), c.extract(*parts), l.extract(*parts), level)

    @property
    def in_flint(self) -> tuple[list[list[fmpq]], list[list[fmpq]], list[fmpq], list[fmpq], fmpq]:
        """The same numbers, which are rational, for FLINT: two matrices, two vectors and C1."""
        rows = [[list(map(to_flint, row)) for row in m.tolist()] for m in self[:2]]
        vectors = [list(map(to_flint, v)) for v in self[2:4]]
        return rows[0], rows[1], vectors[0], vectors[1], to_flint(self.level)

    @property
    def pencil(self) -> Matrix:
        return OMEGA**2 * self.inertia - self.curved + SIGMA * eye(len(self.linear))

    @property
    def vector(self) -> Matrix:
        return self.linear - OMEGA * self.rotor


class LevelZeros(RealNumbers):
    """The rotations over the roots omega of a factor: k = adj(N) b/det N, in balls, or in their field."""

    def __init__(self, met: CommonPoints, factor: fmpq_poly, ring: Ring, above: list[fmpq_mpoly],
                 below: fmpq_mpoly, changed: Callable[[], list[fmpq_mpoly]], axes: list[int]):
        self.met, self.factor, self.ring, self.above, self.below = met, factor, ring, above, below
        self.changed, self.axes = changed, axes
        self._parts = [in_sigma(ring, f) for f in (below, *above)]
        self._least, self._values = BITS, dict[int, list[list[arb]]]()

    @cached_property
    def rates(self) -> list[Expr]:
        """The roots, exact, in increasing order."""
        return roots_of_factor(self.factor)

    @property
    def told(self) -> bool:
        """Whether k is told at all of them: det N ≠ 0. From then on enclosures have as many bits."""
        for precision in doubled(BITS):
            if all(x.rad() < TOLD for k in self.values(precision) for x in k):
                self._least = precision
                return True
        return False

    def values(self, precision: int) -> list[list[arb]]:
        """Return enclosures of k for each root."""
        precision = max(precision, self._least)
        if precision not in self._values:
            with own_precision(precision):
                rates = [ball(rate, precision) for rate in self.rates]
                sigmas = self.met.over(rates, precision)
                self._values[precision] = [self._at(*found) for found in zip(rates, sigmas)]
        return self._values[precision]

    def _at(self, omega: arb, sigma: arb) -> list[arb]:
        under, *tops = (arb_poly([arb_poly(part)(omega) for part in parts])(sigma) for parts in self._parts)
        given = dict(zip(self.axes, tops))
        return [given[n] / under if n in given else arb(0) for n in range(3)]

    def expression(self, root: int, place: int) -> Expr:
        """Return a component of k as an expression."""
        if place not in self.axes:
            return S.Zero
        rate = self.rates[root]
        return at_root(self._tops[self.axes.index(place)], rate) / at_root(self.factor.derivative(), rate)

    def is_fraction(self, root: int, place: int) -> bool:
        """Tell whether a component of k is a fraction; then it is so at every rate."""
        if place not in self.axes or self.varies(place, range(len(self.rates))):
            return place not in self.axes
        top, slope = self._tops[self.axes.index(place)], self.factor.derivative()
        return top * slope[slope.degree()] == slope * top[slope.degree()]

    @cached_property
    def _tops(self) -> list[fmpq_poly]:
        """The components of k times the derivative of the factor, which makes their coefficients short."""
        ones, sigmas, _ = (in_omega(self.ring, x) for x in self.changed())
        (s,) = divided([sigmas], ones % self.factor, self.factor)
        under, slope = placed(self.ring, self.below, s, self.factor), self.factor.derivative()
        return divided([placed(self.ring, x, s, self.factor) * slope for x in self.above], under, self.factor)


def at_rate(ring: Ring, polynomial: fmpq_mpoly, rate: fmpq) -> fmpq_poly:
    """Return a polynomial at a rate as one in sigma."""
    return fmpq_poly([part(rate) for part in in_sigma(ring, polynomial)])


def nothing_at(field: Field, rate: fmpq, length: fmpq_poly, moment: fmpq_poly) -> bool:
    """Tell whether it is proved that no rotation of a rational rate is on the level.

    Where det N = 0 and b has no part in the kernel, both polynomials vanish, too.
    """
    return all(factor.degree() == 1 and _turned_off(field, rate, -factor[0] / factor[1])
               for factor, _ in length.gcd(moment).factor()[1])


def _turned_off(field: Field, rate: fmpq, sigma: fmpq) -> bool:
    """Tell whether no k with N k = b and k·k = 1 is on the level; N is singular, with a kernel along e.

    k = a ± t e, where (N + e eᵀ) a = b and t² = (1 − a·a)/e·e; then C1 is A ± B t.
    """
    inertia, curved, linear, rotor = (fmpq_mat(m.rows, m.cols, list(map(to_flint, m))) for m in field[:4])
    size = inertia.nrows()
    N = inertia * rate**2 - curved + fmpq_mat(size, size, [sigma * (i % (size + 1) == 0)
                                                           for i in range(size * size)])
    b = linear - rotor * rate
    reduced, rank = N.rref()
    if fmpq_mat([[*row, *side] for row, side in zip(N.tolist(), b.tolist())]).rank() > rank:
        return True
    if rank != size - 1:
        return False
    pivots = [next(n for n in range(size) if reduced[m, n]) for m in range(rank)]
    free = next(n for n in range(size) if n not in pivots)
    e = fmpq_mat([[-reduced[pivots.index(n), free] if n in pivots else fmpq(1)] for n in range(size)])
    a = (N + e * e.transpose()).solve(b)

    def product(x: fmpq_mat, y: fmpq_mat) -> fmpq:
        return (x.transpose() * y)[0, 0]

    square = (1 - product(a, a)) / product(e, e)
    once = 2 * rate * product(a, inertia * e) + product(rotor, e)
    rest = rate * (product(a, inertia * a) + square * product(e, inertia * e)) + product(rotor, a)
    return square < 0 or (rest - to_flint(field.level)) ** 2 != once**2 * square


def in_omega(ring: Ring, polynomial: fmpq_mpoly) -> fmpq_poly:
    """Return the polynomial in omega, with 0 for the other names."""
    return in_one(polynomial, ring.generators.index(OMEGA))


def in_sigma(ring: Ring, polynomial: fmpq_mpoly) -> list[fmpq_poly]:
    """Return the coefficients of the powers of sigma, polynomials in omega."""
    place = ring.generators.index(SIGMA)
    return [in_omega(ring, part) for part in by_degree(polynomial, place, polynomial.degrees()[place])]


def placed(ring: Ring, polynomial: fmpq_mpoly, s: fmpq_poly, modulus: fmpq_poly) -> fmpq_poly:
    """Insert s for sigma, modulo a polynomial."""
    value = fmpq_poly([0])
    for part in reversed(in_sigma(ring, polynomial)):
        value = (value * s + part) % modulus
    return value
