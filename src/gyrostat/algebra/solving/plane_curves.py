"""A plane curve F(x, t) = 0 over −1 < x < 1: its multiple points by resultants, and boxes about them."""
import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import arb, arb_poly, ctx, fmpq, fmpq_mpoly, fmpq_poly
from sympy import Expr, S, Symbol

from ..._cached import cached_property
from ...errors import ScopeError
from ..enclosures.algebraic import is_algebraic
from ..enclosures.balls import ball, dyadic, interval
from ..enclosures.precision import own_precision
from ..enclosures.rationals import to_flint, to_sympy
from ..enclosures.real_roots import isolated_roots
from ..reals.exact import sign_of_constant
from ..rings.elimination import linear
from ..rings.polynomials import Ring, by_degree, cancel
from .roots import inserted, nearest, real_roots

LARGEST = 150                                          # degree of a polynomial whose roots are points of it


@dataclass(frozen=True)
class Box:
    """A neighbourhood of a point of a curve.

    Every branch inside it, at before and at after, goes on to the point.

    Parameters
    ----------
    low, high : Fraction
        of x
    before, after : Fraction
        of t, on either side of the point
    order : int
        multiplicity of the point as a root at its t
    """

    low: Fraction
    high: Fraction
    before: Fraction
    after: Fraction
    order: int


class PlaneCurve:
    """The zeros of the numerator of a rational function of x and t.

    Parameters
    ----------
    expression : Expr
        rational in x and t, with rational or algebraic coefficients
    x, t : Symbol
    also : sequence of Expr
        whose numerators are asked for, too
    ends : (−1, 1) or ()
        of x; (): every x

    Attributes
    ----------
    components : list
        irreducible factors in which x occurs, each once, none of an end alone
    lines : list
        those in which t alone occurs: at their roots every x is on the curve
    poles : list
        factors of the denominator

    Raises
    ------
    ScopeError
        the expression is not rational in x and t, or vanishes identically

    Examples
    --------
    >>> x, t = Symbol("x"), Symbol("t")
    >>> curve = PlaneCurve(x * (x**2 - t) / 2, x, t)
    >>> curve.double
    ((0, 0),)
    >>> [round(float(r.mid()), 3) for r in curve.roots(Fraction(1, 4))]
    [-0.5, 0.0, 0.5]
    """

    def __init__(self, expression: Expr, x: Symbol, t: Symbol, also: Sequence[Expr] = (),
                 ends: Sequence[Expr] = (S.NegativeOne, S.One)):
        self.ring, self.x, self.t, self.ends = Ring([expression, x, t, *also]), x, t, ends
        others = [g for g in self.ring.generators if g not in (x, t)]
        if any(g.free_symbols or not is_algebraic(g) or g.is_real is False for g in others):
            raise ScopeError(f"{expression} is not rational in {x} and {t} with algebraic coefficients, so "
                             "that its branches cannot all be found: give a field that is rational in k3, "
                             "numbers without pi or functions, and another name along the axis")
        self.place = [self.ring.generators.index(s) for s in (x, t)]
        top, bottom = self.ring.fraction(expression)
        top, bottom = cancel(self.ring.reduce(top), bottom)
        if not top:
            raise ScopeError(f"{expression} vanishes at every {x} and {t}: everything is an equilibrium, "
                             "there are no branches to follow")
        self.rational = not others
        self.components, self.lines = [], []
        at_ends = [self.ring.gens[x] - int(end) for end in ends]
        for factor, _ in top.factor()[1]:
            if self.degree(factor, 0):
                self.components += [] if factor in at_ends else [factor]
            elif self.degree(factor, 1):
                self.lines.append(factor)
        self.poles = [factor for factor, _ in bottom.factor()[1]]
        self.whole = math.prod(self.components, start=self.ring.one)
        self.slopes = [self.whole]

    def degree(self, polynomial: fmpq_mpoly, which: int) -> int:
        """Return the degree in x (0) or t (1)."""
        return int(polynomial.degrees()[self.place[which]]) if polynomial else 0

    def polynomial(self, expression: Expr) -> fmpq_mpoly:
        """Return the numerator of one of the other expressions, or of its derivatives."""
        return self.ring.numerator(expression)

    @cached_property
    def double(self) -> tuple[tuple[Expr, Expr], ...]:
        """(t, x) of every point between the ends where branches may meet: there x is a multiple root."""
        found = []
        for n, F in enumerate(self.components):
            found += self.common(F, F.derivative(self.place[0])) if self.degree(F, 0) > 1 else []
            for G in self.components[n + 1:]:
                found += self.common(F, G)
        return tuple(dict.fromkeys(found))

    def common(self, F: fmpq_mpoly, G: fmpq_mpoly) -> list[tuple[Expr, Expr]]:
        """Return the common zeros (t, x) of a component and a polynomial it does not divide; t canonical."""
        t = self.place[1]
        n = math.gcd(*(int(e[t]) for f in (F, G) for e in f.to_dict())) or 1
        powers = [n if place == t else 1 for place in range(len(self.ring.generators))]
        F, G = F.deflate(powers), G.deflate(powers)    # with s for tⁿ
        if self.degree(F, 0) * self.degree(G, 1) + self.degree(G, 0) * self.degree(F, 1) > LARGEST:
            raise ScopeError(f"the points of a curve of degree {self.degree(self.whole, 0)} in {self.x} and "
                             f"{self.degree(self.whole, 1)} in {self.t} are roots of polynomials of degree "
                             f"over {LARGEST}: give a field of lower degree")
        over_x = self._resultant(F, G, 1)
        if over_x.is_constant() and over_x:
            return []
        over_t = self._resultant(F, G, 0)
        across = real_roots(self.ring.expression(over_x), self.x, *self.ends)
        along = real_roots(self.ring.expression(over_t), self.t)
        if across is None or along is None:
            raise ScopeError(f"{self.ring.expression(F)} and {self.ring.expression(G)} have a curve in "
                             "common once their algebraic numbers are related: write these in one root")
        pairs = [(s, x0) for x0 in across for s in self._above(F, G, x0, along)]
        if n == 1:
            return pairs
        roots = real_roots(self.ring.expression(over_t.inflate(powers)), self.t) or []
        return [(root, x0) for s, x0 in pairs for root in roots if nearest(root, along, n) == s]

    def _resultant(self, F: fmpq_mpoly, G: fmpq_mpoly, which: int) -> fmpq_mpoly:
        """Eliminate x (0) or t (1) from two polynomials by their resultant."""
        if not self.degree(F, which):
            return F
        return F.resultant(G, F.context().names()[self.place[which]]) if self.degree(G, which) else G

    def _above(self, F: fmpq_mpoly, G: fmpq_mpoly, x0: Expr, along: list[Expr]) -> list[Expr]:
        """Return the t among those given at which both polynomials vanish at x0."""
        a, b = linear(F, G, self.place[1])
        lead = by_degree(F, self.place[1], self.degree(F, 1))[-1]
        if a and sign_of_constant(below := inserted(self.ring, a, {self.x: x0})) and (
                sign_of_constant(inserted(self.ring, lead, {self.x: x0}))):
            return [nearest(-inserted(self.ring, b, {self.x: x0}) / below, along)]
        return [t0 for t0 in along if all(self.sign(f, t0, x0) == 0 for f in (F, G))]

    def sign(self, polynomial: fmpq_mpoly, t0: Expr, x0: Expr) -> int | None:
        """Return the sign of a polynomial at a point, exactly."""
        return sign_of_constant(inserted(self.ring, polynomial, {self.x: x0, self.t: t0}))

    def at_edge(self, s: int) -> list[Expr]:
        """Return the t at which a component comes to x = s."""
        edge = [inserted(self.ring, F, {self.x: S(s)}) for F in self.components]
        return list(dict.fromkeys(t0 for f in edge for t0 in real_roots(f, self.t) or ()))

    def box(self, t0: Expr, x0: Expr, gap: Fraction, reach: Fraction) -> Box:
        """Return a box about a point, less than gap in x and less than reach in t on either side.

        The first of the derivatives in x that is not 0 at the point is not 0 in the box, so that x0 is the
        only root in it at t0; and no branch crosses its lower or its upper side.
        """
        first = 2 if (t0, x0) in self.double else 1
        order = next(n for n in range(first, self.degree(self.whole, 0) + 1)
                     if self.sign(self._slope(n), t0, x0))
        precision, size = 128, min(gap, Fraction(1, 8)) / 2
        while True:
            with own_precision(precision):
                step = reach / 2 * size ** (order + 1)
                middle, at = (dyadic(ball(value, precision), small)
                              for value, small in ((x0, size / 16), (t0, step / 16)))
                if middle is not None and at is not None:
                    T = interval(at - step, at + step)
                    sides = [self._enclosed(self.whole, T, interval(middle + s * size)) for s in (-1, 1)]
                    slope = self._enclosed(self._slope(order), T, interval(middle - size, middle + size))
                    if all(side > 0 or side < 0 for side in (*sides, slope)):
                        return Box(middle - size, middle + size, at - step / 2, at + step / 2, order)
                    size /= 4
            precision += 64

    def _slope(self, n: int) -> fmpq_mpoly:
        while len(self.slopes) <= n:
            self.slopes.append(self.slopes[-1].derivative(self.place[0]))
        return self.slopes[n]

    def _enclosed(self, polynomial: fmpq_mpoly, t: arb, x: arb) -> arb:
        """Enclose a polynomial over balls, at the precision that is set."""
        at = {self.x: x, self.t: t}
        values = [at[g] if g in at else ball(g, ctx.prec) for g in self.ring.generators]
        # products, since ** gives no finite power of a ball that contains 0
        return sum((math.prod((v for v, e in zip(values, powers) for _ in range(int(e))), start=arb(c))
                    for powers, c in polynomial.to_dict().items()), arb(0))

    def roots(self, t: Fraction, count: int | None = None, precision: int = 96) -> list[arb]:
        """Return the roots between the ends at a t, in increasing order, to half of the precision.

        At that t they are simple, and none is an end; count is their number, if it is known.
        """
        if not self.rational and count is None:
            placed = inserted(self.ring, self.whole, {self.t: to_sympy(t)})
            count = len(real_roots(placed, self.x, *self.ends) or ())
        while True:
            with own_precision(precision):
                found = self._simple(t, count)
            if found is not None:
                return found
            precision *= 2

    def _simple(self, t: Fraction, count: int | None) -> list[arb] | None:
        parts = by_degree(self.whole, self.place[0], self.degree(self.whole, 0))
        if self.rational:
            at = [fmpq(0)] * len(self.ring.generators)
            at[self.place[1]] = to_flint(t)
            real = isolated_roots(fmpq_poly([part(*at) for part in parts]))
        else:
            here = interval(t)
            try:
                found = arb_poly([self._enclosed(part, here, arb(0))
                                  for part in parts]).complex_roots(tol=arb(2) ** -(ctx.prec // 2 + 8))
            except ValueError:                             # not isolated at this precision
                return None
            real = [x.real for x in found if x.imag.contains(0)]
        small = arb(2) ** -(ctx.prec // 2 + 2)
        if any(r.rad() > (abs(r.mid()) + 2.0**-10) * small for r in real) or any(
                r.overlaps(arb(int(end))) for r in real for end in self.ends):
            return None
        inside = sorted((r for r in real if not self.ends or r > -1 and r < 1), key=arb.mid)
        return inside if count is None or len(inside) == count else None
