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
from ...algebra.solving.plane_branches import Span, Strand
from ...algebra.solving.roots import in_order, real_roots
from ...mechanics.scenes.system import System
from ...notation import Stored, symbol
from ...stability.criteria.amended_form import amended_form, dot
from ...stability.normal_forms.d4_along_family import cuts_in_windows
from ...stability.normal_forms.local_motion import LocalMotion
from ..finders.heavy import OMEGA
from ..finders.heavy_form import HeavyForm

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

    With ∇U = omega² Ik + sigma k and tau = sigma/omega², n_i = c_i/(tau + I_i): the parameter is tau. If c_i
    = 0, k has any component along axis i at tau = −I_i: the parameter is rho, n_i. Derived in
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
            length = sum((x**2 for x in n), start=arb(0)).sqrt()
            return Near(tuple(float((x / length).mid()) for x in n), float(length.sqrt().mid()),
                        float((tau * length).mid()))

    def end(self, span: Span, at: Expr, root: Expr | None, side: int) -> End:
        """Return a limit of the arc: a principal axis, omega → ∞, or ±c, omega → 0."""
        if self.parameter == RHO:
            return End(tuple(-side * x.diff(RHO) for x in self.n), oo)
        c = [x * (TAU + m) for x, m in zip(self.n, self.scene.body.moments)]
        if far := at in (oo, -oo):
            along = [-side * x for x in c]
        else:
            along = [side * x if m == -at else S.Zero for x, m in zip(c, self.scene.body.moments)]
        return End(tuple(x / sqrt(dot(along, along)) for x in along), S.Zero if far else oo)

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
        gradient = [evaluate((m + self.tau / scale) * y, {}) for m, y in zip(body.moments, self.n)]
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
        M = tuple(m * y for m, y in zip(self.scene.body.moments, self.n))
        motion = LocalMotion(tuple(map(tuple, self.scene.body.inverse.tolist())), (S.Zero,) * 3, self.n, M,
                             U.expression, lambda: (S.Zero, S.Zero), dot(self.n, self.n))
        found = cuts_in_windows(motion, self.parameter, None, None)
        return ([], None) if found is None else (found, True)


def cone_curves(scene: System, c: Sequence[Expr]) -> Iterator[tuple[ConeCurve, Strand]]:
    """Yield the curve and the strand of every arc of a body without a rotor in U = c·k, at numbers."""
    moments = scene.body.moments
    none = [proved_sign(x) == 0 for x in c]
    n = tuple(S.Zero if zero else x / (TAU + m) for x, m, zero in zip(c, moments, none))
    poles = in_order(list({-m for m, zero in zip(moments, none) if not zero}))
    curve = ConeCurve(scene, TAU, n, TAU)
    for low, high in pairwise([-oo, *poles, oo]):
        yield curve, Strand((Span(low, high, 0),), None, None)
    for i in range(3):
        if none[i] and -moments[i] not in poles:
            beside = tuple(RHO if m == i else S.Zero if none[m] else c[m] / (moments[m] - moments[i])
                           for m in range(3))
            yield ConeCurve(scene, RHO, beside, -moments[i]), Strand((Span(-oo, oo, 0),), None, None)
