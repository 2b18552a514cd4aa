"""Describes the permanent rotations of a gyrostat in a uniform field by plane curves over the rate omega."""
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache

from sympy import Add, Expr, Rational, S, Symbol, oo, sqrt

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.reals.exact import evaluate, plain, proved_sign
from ...algebra.rings.matrices import applied
from ...algebra.rings.polynomials import Ring, cancel, lowest_terms
from ...algebra.solving.plane_branches import Span, Strand, strands
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.roots import between, in_order, real_roots
from ...errors import ScopeError, ValuesError
from ...mechanics.scenes.system import System
from ...notation import Stored
from ...stability.criteria.amended_form import dot
from ...stability.form import Invariants
from ...stability.normal_forms.windows import resonance_margins
from ...stability.spectrum import conditions
from ..finders.heavy import OMEGA, SIGMA, heavy_forms
from ..finders.heavy_form import HeavyForm
from ..finders.heavy_polynomials import DIRECTION
from .cone_curves import PRECISION, RHO, TAU, End, Near
from .inertia_axes import InertiaAxes

SLOWER = {SIGMA: OMEGA**2 * TAU}


@dataclass(frozen=True)
class RateCurve(Stored):
    """The permanent rotations of every rate, as a plane curve over omega.

    With ∇U = omega² Ik + omega l + sigma k and b = c − omega l, k = (sigma + omega² I)⁻¹ b. If b is across
    the axis of a moment m at every omega, so is k, or sigma = −omega² m and the part of k along that axis is
    what abs(k) = 1 leaves. Derived in docs/explanation/derivations/amended-potential.md, section 7.

    Parameters
    ----------
    scene : System
        at given numbers, with U = c·k
    b : tuple of Expr, shape (3,)
        in omega
    unknown : Symbol
        sigma; or a component of k, for rotations with sigma = −omega² m
    equation : Expr
        a polynomial in the unknown and omega, of which the unknown is a root
    k : tuple of Expr, shape (3,)
        in omega and the unknown
    through : tuple of Expr
        the rates at which branches cross in a circle of rotations, if two moments are equal
    moment : Expr or None
        the m of sigma = −omega² m; None if sigma is the unknown
    """

    scene: System
    b: tuple[Expr, ...]
    unknown: Symbol
    equation: Expr
    k: tuple[Expr, ...]
    through: tuple[Expr, ...] = ()
    moment: Expr | None = None
    parameter, omega_squared = OMEGA, OMEGA**2
    folds = ()

    @cached_property
    def plane(self) -> PlaneCurve:
        """The plane curve, for its real roots in balls."""
        return PlaneCurve(self.equation, self.unknown, OMEGA, ends=())

    def directed(self, omega: Expr, root: Expr) -> tuple[Expr, ...]:
        """Return the k of a root of the equation, exact."""
        return tuple(evaluate(x, {OMEGA: omega, self.unknown: root}) for x in self.k)

    def at(self, span: Span, value: Expr) -> HeavyForm:
        """Return the rotation at a rational rate, or at the end of the span, where roots meet."""
        if value == span.high:
            return self._among_others(span)
        if not isinstance(value, Rational):
            raise ValuesError(f"omega = {value}: give a rational rate, at which the rotation is found "
                              "exactly")
        root = _roots(self.equation, self.unknown, value)[span.place]
        return HeavyForm(self.scene, self.directed(value, root), value)

    def _among_others(self, span: Span) -> HeavyForm:
        """Return the rotation where roots meet: two of one sigma have the signs of their branches."""
        found = self.all_at(span.high)
        level = found[span.place][0]
        axes, before = InertiaAxes(self.scene.body), self.at(span, between(span.low, span.high)).k
        return next(rotation for sigma, rotation in found if proved_sign(sigma - level) == 0 and not any(
            proved_sign(evaluate(dot(axes.part(m, before), rotation.k), {})) == -1 for m in axes.moments))

    def all_at(self, omega: Expr) -> list[tuple[Expr, HeavyForm]]:
        """Return sigma and rotation of all with k across the axes that b is across, in the order of sigma."""
        found = []
        for whole in heavy_forms(self.scene, {"omega": omega}):
            for rotation in self._on_branches(whole):
                if not any(proved_sign(evaluate(dot(axis, rotation.k), {})) for axis in self._across):
                    found.append((self.sigma(rotation), rotation))
        order = in_order([sigma for sigma, _ in found])
        return sorted(found, key=lambda pair: order.index(pair[0]))

    def _on_branches(self, rotation: HeavyForm) -> list[HeavyForm]:
        """Return the rotation; on a circle of them the two through which branches pass, along b."""
        if rotation.circle is None:
            return [rotation]
        k, a = rotation.k, rotation.circle                 # k may be turned about a
        slopes, kept = (tuple(x - dot(v, a) / dot(a, a) * y for x, y in zip(v, a))
                        for v in (self.scene.body.gyrostatic_momentum, k))
        scale = sqrt(dot(kept, kept) / dot(slopes, slopes))
        return [replace(rotation, k=tuple(evaluate(x - y - side * z, {}) for x, y, z in zip(k, kept, slopes)))
                for side in (-scale, scale)]

    @cached_property
    def _across(self) -> list[tuple[Expr, ...]]:
        """The axes that b is across at every omega."""
        axes = InertiaAxes(self.scene.body)
        return [axes.axis(m) for m in axes.moments if not axes.is_along(m, self.b)]

    def sigma(self, rotation: HeavyForm) -> Expr:
        """Return the sigma of a rotation on the curve, exact."""
        k, at = rotation.k, rotation.omega
        return evaluate(dot(k, [evaluate(y, {OMEGA: at}) - at**2 * x for x, y in zip(
            applied(self.scene.body.tensor.tolist(), k), self.b)]), {})

    def near(self, span: Span, value: Fraction) -> Near:
        """Return the rotation at a rational rate in doubles."""
        omega = Rational(value.numerator, value.denominator)
        if omega == span.high:
            rotation = self._among_others(span)
            return Near(tuple(map(float, rotation.k)), float(omega), float(self.sigma(rotation)))
        root = self.plane.roots(value, precision=PRECISION)[span.place]
        here = {OMEGA: ball(omega, PRECISION), self.unknown: root}
        k = tuple(float(ball(x, PRECISION, here).mid()) for x in self.k)
        sigma = SIGMA if self.moment is None else -OMEGA**2 * self.moment
        return Near(k, float(omega), float(ball(sigma, PRECISION, here).mid()))

    def end(self, span: Span, at: Expr, root: Expr | None, side: int) -> End:
        """Return a limit of the arc: two rotations become one, or a principal axis, omega → ±∞."""
        k = self._far(span.place, at) if root is None else self.directed(at, root)
        return End(tuple(map(plain, k)), at)

    def _far(self, place: int, omega: Expr) -> tuple[Expr, ...]:
        """Return the k of a root, counted from below, as omega goes to −∞ or ∞: along a principal axis."""
        axes, side = InertiaAxes(self.scene.body), 2 * (place % 2) - 1
        if self.moment is not None:
            axis = axes.axis(self.moment)
            return tuple(side * x / sqrt(dot(axis, axis)) for x in axis)
        free = in_order([m for m in axes.moments if axes.is_along(m, self.b)])[::-1]
        vector = [y.coeff(OMEGA, 1) * (1 if omega == oo else -1) for y in self.b]
        if not axes.is_along(free[place // 2], vector):
            vector = [y.xreplace({OMEGA: S.Zero}) for y in self.b]
        return tuple(side * x for x in axes.direction(free[place // 2], vector))

    @cached_property
    def critical(self) -> list[Expr]:
        """Every omega at which k·adj(K)k or p² − 4q vanishes on the curve, among others, and 0."""
        form = self._form
        return in_order(list({S.Zero: None} | self._zeros(form.form[-1], conditions(form.spectrum)[-1])))

    @cached_property
    def cuts(self) -> tuple[list[Expr], bool | None]:
        """Every omega at which a resonance holds on the curve, among others; and False: D4 is not cut at."""
        _, p, q = self._form.spectrum
        return in_order(list(self._zeros(*(at for _, _, at in resonance_margins(p, q))))), False

    @cached_property
    def _form(self) -> Invariants:
        """The invariants with tau = sigma/omega², in which the polynomials have a lower degree in omega."""
        return HeavyForm(self.scene, tuple(x.xreplace(SLOWER) for x in self.k), OMEGA).invariants(None)

    def _zeros(self, *margins: Expr) -> dict[Expr, None]:
        """Return every omega at which a margin vanishes on the curve, but not along a component of it."""
        unknown = TAU if self.unknown == SIGMA else self.unknown
        curve = PlaneCurve(self.equation.xreplace(SLOWER), unknown, OMEGA, ends=())
        name = str(curve.whole.context().names()[curve.place[0]])
        found: dict[Expr, None] = {}
        for margin in margins:
            top = cancel(*curve.ring.fraction(margin))[0]
            part = curve.whole / curve.whole.gcd(top)
            found |= dict.fromkeys(real_roots(curve.ring.expression(part.resultant(top, name)), OMEGA) or ())
        return found


@lru_cache(maxsize=64)
def _roots(equation: Expr, unknown: Symbol, omega: Expr) -> list[Expr]:
    """Return the roots of an equation at a rate, in increasing order; they are kept for each branch."""
    return real_roots(evaluate(equation, {OMEGA: omega}), unknown) or []


def rate_curves(scene: System, c: Sequence[Expr]) -> Iterator[tuple[RateCurve, Strand]]:
    """Yield the curve and the strand of every admissible arc of a body with a rotor in U = c·k, at numbers.

    Multiple roots of the equation are folds, but for those that are known. If at one omega b is across the
    axis of a moment m, then at sigma = −omega² m two rotations, whose parts along it have two signs, have one
    sigma, and their branches cross; or there is none, or one across it. If two moments are equal, those are
    two points of a circle of rotations, along b.

    Raises
    ------
    ScopeError
        a number is not rational, or there are circles of rotations at every omega
    """
    axes, rotor = InertiaAxes(scene.body), scene.body.gyrostatic_momentum
    if not all(isinstance(x, Rational) for x in (*scene.body.entries, *rotor, *c)):
        raise ScopeError(f"c = {c}, l = {rotor}: with a rotor the arcs are found at rational numbers; round "
                         "the others, also those of the inertia, to decimals, or give one rate omega")
    b = tuple(x - OMEGA * y for x, y in zip(c, rotor))
    k = axes.divided(b, SIGMA, OMEGA**2)
    parts = {m: axes.part(m, b) for m in axes.moments}
    known: dict[Expr, dict[Expr, bool]] = {S.Zero: {S.Zero: False}}            # all of k is sigma b there
    through = []
    for m in parts:
        for at in axes.values_across(m, c, rotor, OMEGA):
            crossing = proved_sign(_left(parts, m, at)) == 1
            known.setdefault(at, {})[-at**2 * m] = crossing
            through += [at] if crossing and axes.order(m) > 1 else []
    curve = RateCurve(scene, b, SIGMA, _numerator(k), k, tuple(through))
    yield from ((curve, strand) for strand in strands(curve.equation, SIGMA, OMEGA, known))
    for m in parts:
        if not axes.is_along(m, b):
            if not isinstance(m, Rational):
                raise ScopeError(f"c = {c}, l = {rotor}: both are along one principal axis, and the other "
                                 "moments are irrational: give one rate omega")
            axis = axes.axis(m)
            unknown = DIRECTION[axis.index(1)] if sum(map(bool, axis)) == 1 else RHO
            across = (lowest_terms(x.xreplace({SIGMA: -OMEGA**2 * m})) for x in k)
            along = tuple(x + unknown * y for x, y in zip(across, axis))
            curve = RateCurve(scene, b, unknown, _numerator(along), along, moment=m)
            yield from ((curve, strand) for strand in strands(curve.equation, unknown, OMEGA, {S.Zero: {}}))


def _numerator(k: Sequence[Expr]) -> Expr:
    """Return the numerator of abs(k)² − 1."""
    square = dot(k, k) - 1
    ring = Ring([square])
    return ring.expression(ring.fraction(square)[0])


def _left(parts: Mapping[Expr, Sequence[Expr]], m: Expr, omega: Expr) -> Expr:
    """Return what abs(k) = 1 leaves for the square of the part with the moment m, at sigma = −omega² m."""
    return 1 - Add(*((evaluate(x, {OMEGA: omega}) / (omega**2 * (n - m))) ** 2
                     for n, part in parts.items() if n != m for x in part))
