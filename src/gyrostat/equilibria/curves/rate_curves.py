"""Describes the permanent rotations of a gyrostat in a uniform field by plane curves over the rate omega."""
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache

from sympy import Add, Expr, Mul, Rational, S, Symbol, oo, sqrt

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.reals.exact import evaluate, plain, proved_sign
from ...algebra.rings.polynomials import cancel
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
from .cone_curves import PRECISION, TAU, End, Near

SLOWER = {SIGMA: OMEGA**2 * TAU}


@dataclass(frozen=True)
class RateCurve(Stored):
    """The permanent rotations of every rate, as a plane curve over omega.

    With ∇U = omega² Ik + omega l + sigma k and b = c − omega l, k_i = b_i/(sigma + omega² I_i). If b_i is 0
    at every omega, k_i = 0, or sigma = −omega² I_i and k_i is what abs(k) = 1 leaves. Derived in
    docs/explanation/derivations/amended-potential.md, section 7.

    Parameters
    ----------
    scene : System
        at given numbers, in principal axes, with U = c·k
    b : tuple of Expr, shape (3,)
        in omega
    unknown : Symbol
        sigma; or k_i, for rotations with sigma = −omega² I_i
    equation : Expr
        a polynomial in the unknown and omega, of which the unknown is a root
    k : tuple of Expr, shape (3,)
        in omega and the unknown
    through : tuple of Expr
        the rates at which branches cross in a circle of rotations, if two moments are equal
    """

    scene: System
    b: tuple[Expr, ...]
    unknown: Symbol
    equation: Expr
    k: tuple[Expr, ...]
    through: tuple[Expr, ...] = ()
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
        """Return the rotation where roots meet: two of one sigma have k_i of the signs of their branches."""
        found = self.all_at(span.high)
        level = found[span.place][0]
        signs = [proved_sign(x) for x in self.at(span, between(span.low, span.high)).k]
        return next(rotation for sigma, rotation in found if proved_sign(sigma - level) == 0
                    and all(proved_sign(x) in (0, sign) for x, sign in zip(rotation.k, signs)))

    def all_at(self, omega: Expr) -> list[tuple[Expr, HeavyForm]]:
        """Return sigma and rotation of all with k_i = 0 if b_i is 0 at every omega, in the order of sigma."""
        found = []
        for whole in heavy_forms(self.scene, {"omega": omega}):
            for rotation in self._on_branches(whole):
                if not any(proved_sign(x) for x, y in zip(rotation.k, self.b) if not y):
                    found.append((self.sigma(rotation), rotation))
        order = in_order([sigma for sigma, _ in found])
        return sorted(found, key=lambda pair: order.index(pair[0]))

    def _on_branches(self, rotation: HeavyForm) -> list[HeavyForm]:
        """Return the rotation; on a circle of them the two through which branches pass, along b."""
        if rotation.circle is None:
            return [rotation]
        within = [not x for x in rotation.circle]          # the axes in whose plane k may be turned
        slopes = [y.coeff(OMEGA, 1) if turns else S.Zero for y, turns in zip(self.b, within)]
        square = Add(*(x**2 for x, turns in zip(rotation.k, within) if turns))
        scale = sqrt(square / dot(slopes, slopes))
        return [replace(rotation, k=tuple(evaluate(side * y, {}) if turns else x
                                          for x, y, turns in zip(rotation.k, slopes, within)))
                for side in (-scale, scale)]

    def sigma(self, rotation: HeavyForm) -> Expr:
        """Return the sigma of a rotation on the curve, exact."""
        k, at = rotation.k, rotation.omega
        return evaluate(dot(k, [evaluate(y, {OMEGA: at}) - at**2 * m * x
                                for x, y, m in zip(k, self.b, self.scene.body.moments)]), {})

    def near(self, span: Span, value: Fraction) -> Near:
        """Return the rotation at a rational rate in doubles."""
        omega = Rational(value.numerator, value.denominator)
        if omega == span.high:
            rotation = self._among_others(span)
            return Near(tuple(map(float, rotation.k)), float(omega), float(self.sigma(rotation)))
        root = self.plane.roots(value, precision=PRECISION)[span.place]
        here = {OMEGA: ball(omega, PRECISION), self.unknown: root}
        k = tuple(float(ball(x, PRECISION, here).mid()) for x in self.k)
        parts = zip(self.k, self.scene.body.moments)
        sigma = SIGMA if self.unknown == SIGMA else next(-OMEGA**2 * m for x, m in parts if x == self.unknown)
        return Near(k, float(omega), float(ball(sigma, PRECISION, here).mid()))

    def end(self, span: Span, at: Expr, root: Expr | None, side: int) -> End:
        """Return a limit of the arc: two rotations become one, or a principal axis, omega → ±∞."""
        k = self._far(span.place, at) if root is None else self.directed(at, root)
        return End(tuple(map(plain, k)), at)

    def _far(self, place: int, omega: Expr) -> tuple[Expr, ...]:
        """Return the k of a root, counted from below, as omega goes to −∞ or ∞: along a principal axis."""
        moments = self.scene.body.moments
        if self.unknown != SIGMA:
            side = 2 * place - 1
            return tuple(S(side) if x == self.unknown else S.Zero for x in self.k)
        free = sorted({m for m, y in zip(moments, self.b) if y}, reverse=True)
        parts = [y if m == free[place // 2] else S.Zero for m, y in zip(moments, self.b)]
        leading = [y.coeff(OMEGA, 1) * (1 if omega == oo else -1) for y in parts]
        vector = leading if any(leading) else parts
        return tuple((2 * (place % 2) - 1) * x / sqrt(dot(vector, vector)) for x in vector)

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

    Multiple roots of the equation are folds, but for those that are known. If a b_i is 0 at one omega, so are
    d_i = sigma + omega² I_i and k_i d_i: two rotations with k_i of two signs have one sigma, and their
    branches cross; or there is none, or one with k_i = 0. If two moments are equal, those are two points of a
    circle of rotations, along b_i and b_j.

    Raises
    ------
    ScopeError
        a number is not rational, or there are circles of rotations at every omega
    """
    moments, rotor = scene.body.moments, scene.body.gyrostatic_momentum
    if not all(isinstance(x, Rational) for x in (*moments, *rotor, *c)):
        raise ScopeError(f"inertia = {moments}, l = {rotor}, c = {c}: with a rotor the arcs are found if "
                         "all numbers are rational; round the others to decimals, or give one rate omega")
    b = tuple(x - OMEGA * y for x, y in zip(c, rotor))
    squares = {m: Add(*(y**2 for n, y in zip(moments, b) if n == m)).expand() for m in moments}
    known: dict[Expr, dict[Expr, bool]] = {S.Zero: {S.Zero: False}}            # all d_i are sigma there
    through = []
    for m in moments:
        for at in real_roots(squares[m], OMEGA) or ():
            if at != 0:
                crossing = proved_sign(_left(squares, m, at)) == 1
                known.setdefault(at, {})[-at**2 * m] = crossing
                through += [at] if crossing and moments.count(m) > 1 else []
    free = [m for m, square in squares.items() if square]
    d = {m: SIGMA + OMEGA**2 * m for m in free}
    equation = Add(*(squares[m] * Mul(*(d[n]**2 for n in free if n != m)) for m in free),
                   -Mul(*(d[m]**2 for m in free)))
    curve = RateCurve(scene, b, SIGMA, equation, tuple(y / d[m] if y else S.Zero for y, m in zip(b, moments)),
                      tuple(dict.fromkeys(through)))
    yield from ((curve, strand) for strand in strands(equation, SIGMA, OMEGA, known))
    for i, m in enumerate(moments):
        if not b[i] and not squares[m]:
            unknown = DIRECTION[i]
            equation = (OMEGA**4 * (unknown**2 - _left(squares, m, OMEGA))).expand()
            k = tuple(unknown if n == i else y / (OMEGA**2 * (moments[n] - m)) if y else S.Zero
                      for n, y in enumerate(b))
            curve = RateCurve(scene, b, unknown, equation, k)
            yield from ((curve, strand) for strand in strands(equation, unknown, OMEGA, {S.Zero: {}}))


def _left(squares: Mapping[Expr, Expr], m: Expr, omega: Expr) -> Expr:
    """Return what abs(k) = 1 leaves for the square of the parts with the moment m, at sigma = −omega² m."""
    return 1 - Add(*(evaluate(square, {OMEGA: omega}) / (omega**2 * (n - m)) ** 2
                     for n, square in squares.items() if n != m))
