"""Parametrises Staude's cone: the permanent rotations of a heavy body without a rotor as rational curves."""
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from flint import arb
from sympy import Expr, Rational, S, Symbol, oo, sqrt, zeros

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.precision import own_precision
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.rings.matrices import applied
from ...algebra.solving.plane_branches import Span, Strand
from ...algebra.solving.roots import in_order, real_roots
from ...errors import ScopeError
from ...mechanics.scenes.system import System
from ...notation import Stored, symbol
from ...stability.criteria.amended_form import amended_form, dot
from ...stability.normal_forms.d4_along_family import cuts_in_windows
from ...stability.normal_forms.local_motion import LocalMotion
from ..finders.heavy import OMEGA
from ..finders.heavy_form import HeavyForm
from .inertia_axes import InertiaAxes

TAU, RHO = symbol("tau"), symbol("rho")
PRECISION = 192                                        # bits of what becomes doubles


class End(NamedTuple):
    """What an arc goes to: a direction, and the rate there, which may be infinite."""

    k: tuple[Expr, ...]
    omega: Expr


class Near(NamedTuple):
    """A rotation in doubles: k, omega, and sigma of ∇U = omega² Ik + omega l + sigma k."""

    k: tuple[float, ...]
    omega: float
    sigma: float


@dataclass(frozen=True)
class ConeCurve(Stored):
    """Permanent rotations without a rotor: k = n/abs(n) and omega² = abs(n) along a parameter.

    With ∇U = omega² Ik + sigma k and tau = sigma/omega², n = (tau + I)⁻¹ c: the parameter is tau. If c is
    across the axis e of a moment m, n has any part along e at tau = −m: the parameter is rho, n = n(−m) + rho
    e. In principal axes n_i = c_i/(tau + I_i), and rho is n_i. Derived in
    docs/explanation/derivations/amended-potential.md, section 7.

    Parameters
    ----------
    scene : System
        at given numbers
    parameter : Symbol
        tau or rho
    n : tuple of Expr, shape (3,)
        in the parameter
    tau : Expr
        sigma/omega²
    """

    scene: System
    parameter: Symbol
    n: tuple[Expr, ...]
    tau: Expr
    through = ()

    @property
    def k(self) -> tuple[Expr, ...]:
        """The direction n/omega²."""
        return tuple(x / OMEGA**2 for x in self.n)

    @cached_property
    def omega_squared(self) -> Expr:
        """The square of the rate, abs(n), in the parameter [1/T²]."""
        return sqrt(dot(self.n, self.n))

    def at(self, span: Span, value: Expr) -> HeavyForm:
        """Return the rotation of positive rate."""
        n = [evaluate(x, {self.parameter: value}) for x in self.n]
        length = sqrt(dot(n, n))
        return HeavyForm(self.scene, tuple(evaluate(x / length, {}) for x in n), sqrt(length))

    def near(self, span: Span, value: Fraction) -> Near:
        """Return the rotation of positive rate in doubles."""
        with own_precision(PRECISION):
            here = {self.parameter: ball(Rational(value.numerator, value.denominator), PRECISION)}
            *n, tau = (ball(x, PRECISION, here) for x in (*self.n, self.tau))
            length = sum((x * x for x in n), start=arb(0)).sqrt()
            return Near(tuple(float((x / length).mid()) for x in n), float(length.sqrt().mid()),
                        float((tau * length).mid()))

    def end(self, span: Span, at: Expr, root: Expr | None, side: int) -> End:
        """Return a limit of the arc: a principal axis, omega → ∞, or ±c, omega → 0."""
        c = uniform(self.scene)
        if self.parameter == TAU and at not in (oo, -oo):
            return End(tuple(side * x for x in InertiaAxes(self.scene.body).direction(-at, c)), oo)
        far = self.parameter == TAU
        along = c if far else tuple(x.diff(RHO) for x in self.n)
        return End(tuple(-side * x / sqrt(dot(along, along)) for x in along), S.Zero if far else oo)

    @cached_property
    def _momentum(self) -> tuple[Expr, ...]:
        return tuple(applied(self.scene.body.tensor.tolist(), self.n))

    @cached_property
    def folds(self) -> list[Expr]:
        """The values at which omega is greatest or least, exact."""
        return real_roots(dot(self.n, self.n).diff(self.parameter), self.parameter) or []

    @cached_property
    def critical(self) -> list[Expr]:
        """The zeros of k·adj(K)k, p and p² − 4q, exact.

        They are powers of omega times rational functions of the parameter, so that no zero is missed.
        """
        body, x = self.scene.body, self.parameter
        scale = dot(self.n, self.n)
        gradient = [evaluate(x + self.tau / scale * y, {}) for x, y in zip(self._momentum, self.n)]
        form = amended_form(body.tensor.tolist(), (S.Zero,) * 3, gradient, zeros(3).tolist(), self.n, S.One)
        margins = form.determinant, form.p, form.p**2 - 4 * form.q
        return in_order(list({root for margin in margins for root in real_roots(margin, x) or ()}))

    @cached_property
    def cuts(self) -> tuple[list[Expr], bool | None]:
        """The zeros of D4 and of the margins of resonances, in order, and True; None at irrational numbers.

        With k and M times n/k, which is abs(n), and its square root, h is rational in the parameter.
        """
        U = self.scene.potential
        assert U is not None
        motion = LocalMotion(tuple(map(tuple, self.scene.body.inverse.tolist())), (S.Zero,) * 3, self.n,
                             self._momentum, U.expression, lambda: (S.Zero, S.Zero), dot(self.n, self.n))
        found = cuts_in_windows(motion, self.parameter, None, None)
        return ([], None) if found is None else (found, True)


def uniform(scene: System) -> tuple[Expr, ...]:
    """Return the c of U = c·k."""
    U = scene.potential
    assert U is not None
    c = tuple(U.value(d) if d else S.Zero for d in U.gradient())
    if not U.given or any(x.free_symbols for x in c):
        raise ScopeError(f"U = {U.expression} is not c·k, and the arcs are found in a uniform field only; in "
                         "this one give a direction k1, k2, k3 to relative_equilibria")
    return c


def cone_curves(scene: System, c: Sequence[Expr]) -> Iterator[tuple[ConeCurve, Strand]]:
    """Yield the curve and the strand of every arc of a body without a rotor in U = c·k, at numbers."""
    axes, c = InertiaAxes(scene.body), [x if proved_sign(x) else S.Zero for x in c]
    without = [m for m in axes.moments if not axes.is_along(m, c)]
    curve = ConeCurve(scene, TAU, axes.divided(c, TAU, S.One), TAU)
    poles = in_order([-m for m in axes.moments if m not in without])
    for low, high in pairwise([-oo, *poles, oo]):
        yield curve, Strand((Span(low, high, 0),), None, None)
    for m in without:
        beside = tuple(evaluate(x, {TAU: -m}) + RHO * y for x, y in zip(curve.n, axes.axis(m)))
        yield ConeCurve(scene, RHO, beside, -m), Strand((Span(-oo, oo, 0),), None, None)
