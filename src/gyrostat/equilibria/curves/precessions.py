"""Cuts the regular precessions of a scene at a fixed axial momentum into arcs of one verdict."""
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
from flint import fmpq_mpoly
from sympy import Expr, Rational, S

from ...algebra.enclosures.floats import Array, in_floats
from ...algebra.reals.exact import Point, evaluate, sign_of_constant
from ...algebra.rings.polynomials import by_degree, by_factors
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.root_numbers import DIFFERENT
from ...algebra.solving.roots import in_order, real_roots
from ...algebra.solving.stations import between
from ...errors import ScopeError
from ...mechanics.equilibrium.reduction import K3, OMEGA, P, Reduction
from ...mechanics.families.named_families import POLES
from ...mechanics.scenes.system import System
from ...stability.decision import Verdict
from ..finders.revolution import revolution_forms
from ..relative_equilibrium import RelativeEquilibrium

# between two cuts; towards an end at which C1 is infinite
NODES, DECADES = 480, 13


@dataclass(frozen=True)
class Arc:
    """A branch of the rates between two cuts in k3, or the rates of one tilt between two cuts in them."""

    k3: Array
    omega: Array
    verdict: Verdict
    # the cuts, as exact numbers; None: there is none, or C1 is infinite
    ends: tuple[Any, Any]
    component: int                                         # of the curve of rates
    # sign of (2aW + b) b, or of 2aW + b if b = 0; the component is a W² + b W + c
    side: int = 0


class Precessions:
    """The regular precessions of a scene at given numbers, from which the curves are made."""

    def __init__(self, scene: System, numbers: Point, curve: PlaneCurve, margin: fmpq_mpoly):
        self.scene, self.curve = scene, curve
        self.given = {name.name: x for name, x in numbers.items() if name != P} | {
            "pi3_0": evaluate(P - scene.body.gyrostatic_momentum[2], numbers)}
        self.total, self.numbers = numbers[P], numbers
        self.I1 = evaluate(scene.body.moments[0], numbers)
        self.components = (*curve.components, *curve.lines)
        self.margins = [curve.common(part, margin) if divmod(margin, part)[1] != 0 else []
                        for part in self.components]

    def coefficients(self, n: int) -> list[Expr]:
        """Return c, b, a of a component a W² + b W + c, as products.

        Close to a pole of U an expanded sum has no digits left.
        """
        component, ring = self.components[n], self.curve.ring
        parts = (*by_degree(component, self.curve.place[1], self.curve.degree(component, 1)), ring.zero)[:3]
        return [by_factors(ring.expression(part)) for part in parts]

    def arcs(self, n: int) -> list[Arc]:
        """Return the branches of one component."""
        # at one tilt, k3 = 0, every rate is that of a precession
        if not self.curve.degree(self.components[n], 1):
            return self._at_every_rate(n)
        c, b, a = self.coefficients(n)
        infinite = self._zeros(*map(self.curve.ring.expression, self.curve.poles))
        if not a:
            return self._branch(n, 0, lambda k3: -_values(c, k3) / _values(b, k3), infinite | self._zeros(b),
                                set())
        double, steep = self._zeros(b**2 - 4 * a * c), self._zeros(a)
        known = [float(x) for x in double]

        # the numerator of the quadratic formula, with the sign at which nothing cancels
        def half(k3: Array) -> Array:
            square = np.where(np.isin(k3, known), 0.0, np.maximum(_values(b**2 - 4 * a * c, k3), 0.0))
            return -(_values(b, k3) + np.where(_values(b, k3) < 0, -1, 1) * np.sqrt(square)) / 2

        if not b:                                          # b = 0: both rates have one size
            slow = self._branch(n, 1, lambda k3: -half(k3) / _values(a, k3), infinite | steep, double)
        else:
            slow = self._branch(n, 1, lambda k3: _values(c, k3) / half(k3), infinite, double)
        return slow + self._branch(n, -1, lambda k3: half(k3) / _values(a, k3), infinite | steep, double)

    def _zeros(self, *expressions: Expr) -> set[Expr]:
        return {root for e in expressions for root in real_roots(e, K3, S.NegativeOne, S.One) or ()}

    def _branch(self, n: int, side: int, rate: Callable[[Array], Array], infinite: set[Expr],
                double: set[Expr]) -> list[Arc]:
        """Return one root over −1 < k3 < 1, cut where it ends or its verdict changes."""
        found: list[Arc] = []
        cuts = [S.NegativeOne, *in_order(list(infinite | double | {k3 for _, k3 in self.margins[n]})), S.One]
        for a, b in pairwise(cuts):
            middle = between(a, b)
            if not self._exists(self.components[n], middle):
                continue
            with np.errstate(invalid="ignore", divide="ignore"):
                omega = float(rate(np.array([float(middle)]))[0])
            if float(a) == float(b) or not np.isfinite(omega):      # no double lies between, or for the rate
                raise ScopeError(DIFFERENT)
            k3 = _nodes(float(a), float(b), a in infinite or a == -1, b in infinite or b == 1)
            verdict = self._verdict(middle, omega)
            ends = (None if a in infinite or a == -1 else a, None if b in infinite or b == 1 else b)
            arc = Arc(k3, rate(k3), verdict, ends, n, side)
            last = found[-1] if found else None
            if (
                last
                and last.verdict is arc.verdict
                and last.ends[1] is not None
                and last.ends[1] == a
                and a not in double
            ):
                found[-1] = replace(last, k3=np.append(last.k3, k3[1:]),
                                    omega=np.append(last.omega, arc.omega[1:]),
                                    ends=(last.ends[0], ends[1]))
            else:
                found.append(arc)
        return found

    def _at_every_rate(self, n: int) -> list[Arc]:
        """Return the arcs of k3 = 0 at p_psi = 0 if U' vanishes there: every rate is a precession's."""
        cuts = [None, *in_order([omega for omega, _ in self.margins[n]]), None]
        found = []
        for a, b in pairwise(cuts):
            middle = between(*_inside(a, b))
            level = self.I1 * Rational(middle.numerator, middle.denominator)
            forms = revolution_forms(self.scene, {**self.given, "C1": level})
            (verdict,) = [x.known().verdict for x in forms if x.k3 == 0 and not x.every]
            rates = _rates(a, b)
            found.append(Arc(np.zeros_like(rates), rates, verdict, (a, b), n))
        return found

    def _exists(self, component: fmpq_mpoly, k3: Fraction) -> bool:
        """Tell whether the rates of a component are real at a tilt."""
        placed = self.curve.ring.expression(component).xreplace({K3: Rational(k3.numerator, k3.denominator)})
        return bool(real_roots(placed, OMEGA))

    def _verdict(self, k3: Fraction, omega: float) -> Verdict:
        """Return the verdict of the precession at a tilt with a rate in doubles; rates are simple there."""
        found = revolution_forms(self.scene, {**self.given, "k3": k3})
        return min(found, key=lambda form: abs(float(form.omega) - omega)).known().verdict

    def ends_at(self, arc: Arc, omega: Expr, k3: Expr) -> bool:
        """Tell whether an arc has its end at a precession at which stability may change."""
        if (omega, k3) not in self.margins[arc.component]:
            return False
        if not self.curve.degree(self.components[arc.component], 1):
            return omega in arc.ends
        if k3 not in arc.ends or not arc.side:
            return k3 in arc.ends
        at = {K3: k3, OMEGA: omega}
        _, b, a = self.coefficients(arc.component)
        root, below = (sign_of_constant(evaluate(e, at)) for e in (2 * a * OMEGA + b, b))
        return root in (0, -arc.side if below == -1 else arc.side)

    def poles(self, motion: Reduction) -> list[tuple[float, float, RelativeEquilibrium]]:
        """Return E1 and E2 with their values."""
        found = []
        assert self.scene.potential is not None
        for side, family in POLES.items():
            for form in revolution_forms(self.scene, {**self.given, "C1": side * self.total}):
                if form.label == family.label:
                    at = (motion.axial + self.scene.potential.expression).xreplace(
                        {K3: S(side), **self.numbers}
                    )
                    found.append((float(side * self.total), float(in_floats(at, np, {})),
                                  RelativeEquilibrium(form)))
        return found


def _values(expression: Expr, k3: Array) -> Array:
    return np.broadcast_to(np.asarray(in_floats(expression, np, {K3: k3}), dtype=float), k3.shape)


def _inside(a: Expr | None, b: Expr | None) -> tuple[Expr, Expr]:
    """Return a range between two cuts in the rate, or beside one if there is no other."""
    if a is not None:
        return a, a + 1 if b is None else b
    if b is not None:
        return b - 1, b
    return S.NegativeOne, S.One


def _rates(a: Expr | None, b: Expr | None) -> Array:
    """Return the rates from one cut to another, or far beyond."""
    steps = np.concatenate([[0], np.geomspace(1e-4, 10.0**(DECADES / 2), NODES)])
    if a is not None and b is not None:
        return np.linspace(float(a), float(b), NODES)
    if a is not None:
        return float(a) + steps
    if b is not None:
        return float(b) - steps[::-1]
    return np.append(-steps[:0:-1], steps)


def _nodes(a: float, b: float, first: bool, last: bool) -> Array:
    """Return values from one cut to another, closer together at the ends.

    An end at which C1 or h is infinite is approached, not reached.
    """
    inner = (a + b) / 2 - (b - a) / 2 * np.cos(np.pi * np.arange(1, NODES) / NODES)
    tail = np.geomspace(10.0**-DECADES, inner[0] - a, NODES // 2)
    return np.unique(np.concatenate([a + tail if first else [a], inner, b - tail if last else [b]]))
