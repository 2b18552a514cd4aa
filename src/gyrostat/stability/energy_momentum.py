"""Critical values of (C1, h) of a body of revolution in U(k3) at a fixed axial momentum.

E1, E2 and all regular precessions.
"""
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
from flint import fmpq_mpoly
from sympy import Expr, Rational, S

from ..algebra.exact import Point, evaluate, sign_of_constant
from ..algebra.floats import Array, in_floats
from ..algebra.plane_curves import PlaneCurve
from ..algebra.polynomials import by_degree, by_factors
from ..algebra.roots import in_order, real_roots
from ..algebra.stations import between
from ..errors import ScopeError
from ..mechanics.families import POLES
from ..mechanics.reduction import K3, OMEGA, P, Reduction, V, reduce
from ..mechanics.system import System
from ..notation import symbol
from .branch import Branch
from .branches import branches_at
from .decision import Verdict

# between two cuts; towards an end at which C1 is infinite
NODES, DECADES = 480, 13


@dataclass(frozen=True)
class CriticalCurve:
    """Values of (C1, h) on regular precessions of one verdict.

    Parameters
    ----------
    k3, omega, momentum, energy : arrays, shape (n,)
        tilt, rate about the vertical, C1 and h
    verdict : Verdict
        exact, between its ends
    """

    k3: Array
    omega: Array
    momentum: Array
    energy: Array
    verdict: Verdict


@dataclass(frozen=True)
class EnergyMomentum:
    """Critical values of (C1, h).

    Parameters
    ----------
    curves : list of CriticalCurve
    poles : list of (C1, h, Branch)
        E1 and E2
    cusps : list of (C1, h)
        where stability changes along the curves: two precessions fold on a level
    potential : Expr
        V(C1, k3)
    """

    curves: list[CriticalCurve]
    poles: list[tuple[float, float, Branch]]
    cusps: list[tuple[float, float]]
    potential: Expr


@dataclass(frozen=True)
class _Part:
    """A branch of the rates between two cuts in k3, or at a tilt of every rate between two cuts in the rate.
    """

    k3: Array
    omega: Array
    verdict: Verdict
    # the cuts, as exact numbers; None: there is none, or C1 is infinite
    ends: tuple[Any, Any]
    component: int                                         # of the curve of rates
    # sign of (2aW + b) b, or of 2aW + b if b = 0; the component is a W² + b W + c
    side: int = 0


def critical_values(scene: System, numbers: Point) -> EnergyMomentum:
    """Every critical value of (C1, h) at a fixed p_psi = π3 + l.

    The precessions are the curve I1 k3 W² − p_ψ W + U' = 0 in k3 and the rate W. It is cut, exactly, where
    the two rates of a tilt are one, where one is infinite, where U is, and where stability changes; the
    verdict between two cuts is that at a fraction.

    Parameters
    ----------
    scene : System
        a body of revolution in a U rational in k3
    numbers : Point
        for all its parameters, and p_psi

    Raises
    ------
    ScopeError
        U is not rational in k3, of too high a degree, or constant with p_psi = 0
    """
    assert scene.potential is not None
    field = replace(scene.potential, expression=by_factors(scene.potential.expression.xreplace(numbers)))
    motion = reduce(replace(scene, potential=field))
    level, height, margin = (e.xreplace(numbers) for e in on_precessions(motion))
    curve = PlaneCurve(motion.precession().xreplace(_jets(motion)).xreplace(numbers), K3, OMEGA, (margin,))
    if curve.lines and sign_of_constant(numbers[P]) == 0:
        raise ScopeError("U is constant and p_psi = 0: every tilt at rest has the same C1 and h; give "
                         "p_psi a value")
    here = _Precessions(scene, numbers, curve, curve.polynomial(margin))
    parts = [part for n in range(len(here.components)) for part in here.parts(n)]
    curves, cusps = [], []
    for part in parts:
        v, h = (np.broadcast_to(in_floats(e, np, {K3: part.k3, OMEGA: part.omega}), part.k3.shape)
                for e in (level, height))
        curves.append(CriticalCurve(part.k3, part.omega, v, h, part.verdict))
    for omega, k3 in dict.fromkeys(point for points in here.margins for point in points):
        met = {part.verdict for part in parts if here.ends_at(part, omega, k3)}
        if len(met) > 1:
            at = {K3: np.float64(float(k3)), OMEGA: np.float64(float(omega))}
            cusps.append((float(in_floats(level, np, at)), float(in_floats(height, np, at))))
    return EnergyMomentum(curves, here.poles(motion), cusps, motion.effective_potential().xreplace(numbers))


def on_precessions(motion: Reduction) -> tuple[Expr, Expr, Expr]:
    """C1, h, and what is positive where they are stable, of regular precessions in k3 and the rate omega."""
    # motion.rate is omega there
    level = V - motion.twist + motion.system.body.inertia[0] * OMEGA * motion.across
    return (
        level,
        motion.effective_potential().xreplace({V: level}),
        motion.restoring().xreplace(_jets(motion)),
    )


def _jets(motion: Reduction) -> dict[Any, Expr]:
    """U' and U'' of the scene."""
    potential = motion.system.potential
    assert potential is not None
    return {name: potential.value(name) for name in (symbol("dU"), symbol("d2U"))}


class _Precessions:
    """The precessions of a scene at numbers: what the curves are made of."""

    def __init__(self, scene: System, numbers: Point, curve: PlaneCurve, margin: fmpq_mpoly):
        self.scene, self.curve = scene, curve
        self.given = {name.name: x for name, x in numbers.items() if name != P} | {
            "pi3_0": evaluate(P - scene.body.gyrostatic_momentum[2], numbers)}
        self.total, self.numbers = numbers[P], numbers
        self.I1 = evaluate(scene.body.inertia[0], numbers)
        self.components = (*curve.components, *curve.lines)
        self.margins = [curve.common(part, margin) if divmod(margin, part)[1] != 0 else []
                        for part in self.components]

    def coefficients(self, n: int) -> list[Expr]:
        """c, b, a of a component a W² + b W + c, as products.

        Close to a pole of U what is multiplied out has no digits left.
        """
        component, ring = self.components[n], self.curve.ring
        parts = (*by_degree(component, self.curve.place[1], self.curve.degree(component, 1)), ring.zero)[:3]
        return [by_factors(ring.expression(part)) for part in parts]

    def parts(self, n: int) -> list[_Part]:
        """The branches of one component."""
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

        # of what the quadratic formula has on top, without cancellation
        def half(k3: Array) -> Array:
            square = np.where(np.isin(k3, known), 0.0, np.maximum(_values(b**2 - 4 * a * c, k3), 0.0))
            return -(_values(b, k3) + np.where(_values(b, k3) < 0, -1, 1) * np.sqrt(square)) / 2

        if not b:                                          # of one size
            slow = self._branch(n, 1, lambda k3: -half(k3) / _values(a, k3), infinite | steep, double)
        else:
            slow = self._branch(n, 1, lambda k3: _values(c, k3) / half(k3), infinite, double)
        return slow + self._branch(n, -1, lambda k3: half(k3) / _values(a, k3), infinite | steep, double)

    def _zeros(self, *expressions: Expr) -> set[Expr]:
        return {root for e in expressions for root in real_roots(e, K3, S.NegativeOne, S.One) or ()}

    def _branch(self, n: int, side: int, rate: Callable[[Array], Array], infinite: set[Expr],
                double: set[Expr]) -> list[_Part]:
        """One root over −1 < k3 < 1, cut where it ends or its verdict changes."""
        found: list[_Part] = []
        for a, b in pairwise([S.NegativeOne,
                              *in_order(list(infinite | double | {k3 for _, k3 in self.margins[n]})), S.One]):
            middle = between(a, b)
            if not self._exists(self.components[n], middle):
                continue
            k3 = _nodes(float(a), float(b), a in infinite or a == -1, b in infinite or b == 1)
            verdict = self._verdict(middle, float(rate(np.array([float(middle)]))[0]))
            ends = (None if a in infinite or a == -1 else a, None if b in infinite or b == 1 else b)
            part = _Part(k3, rate(k3), verdict, ends, n, side)
            last = found[-1] if found else None
            if (
                last
                and last.verdict is part.verdict
                and last.ends[1] is not None
                and last.ends[1] == a
                and a not in double
            ):
                found[-1] = replace(last, k3=np.append(last.k3, k3[1:]),
                                    omega=np.append(last.omega, part.omega[1:]),
                                    ends=(last.ends[0], ends[1]))
            else:
                found.append(part)
        return found

    def _at_every_rate(self, n: int) -> list[_Part]:
        """k3 = 0 at p_psi = 0 where U' vanishes."""
        cuts = [None, *in_order([omega for omega, _ in self.margins[n]]), None]
        found = []
        for a, b in pairwise(cuts):
            low = b - 1 if a is None and b is not None else S.NegativeOne if a is None else a
            high = a + 1 if b is None and a is not None else S.One if b is None else b
            middle = between(low, high)
            branches = branches_at(self.scene,
                                           {**self.given, "C1": self.I1
                                            * Rational(middle.numerator, middle.denominator)})
            (verdict,) = [x.decision.verdict for x in branches if x.k3 == 0]
            steps = np.concatenate([[0], np.geomspace(1e-4, 10.0**(DECADES / 2), NODES)])
            inner = np.linspace(float(low), float(high), NODES) if a is not None and b is not None else (
                float(low) + steps if a is not None else float(high) - steps[::-1] if b is not None
                else np.append(-steps[:0:-1], steps))
            found.append(_Part(np.zeros_like(inner), inner, verdict, (a, b), n))
        return found

    def _exists(self, component: fmpq_mpoly, k3: Fraction) -> bool:
        """Whether the rates of a component are real at a tilt."""
        placed = self.curve.ring.expression(component).xreplace({K3: Rational(k3.numerator, k3.denominator)})
        return bool(real_roots(placed, OMEGA))

    def _verdict(self, k3: Fraction, omega: float) -> Verdict:
        """Of the precession at a tilt whose rate is that, in doubles; the rates there are simple."""
        found = branches_at(self.scene, {**self.given, "k3": k3})
        return min(found, key=lambda branch: abs(float(branch.omega or 0) - omega)).decision.verdict

    def ends_at(self, part: _Part, omega: Expr, k3: Expr) -> bool:
        """Whether a part has its end at a precession where stability may change."""
        if (omega, k3) not in self.margins[part.component]:
            return False
        if not self.curve.degree(self.components[part.component], 1):
            return omega in part.ends
        if k3 not in part.ends or not part.side:
            return k3 in part.ends
        at = {K3: k3, OMEGA: omega}
        _, b, a = self.coefficients(part.component)
        root, below = (sign_of_constant(evaluate(e, at)) for e in (2 * a * OMEGA + b, b))
        return root in (0, -part.side if below == -1 else part.side)

    def poles(self, motion: Reduction) -> list[tuple[float, float, Branch]]:
        """E1 and E2 with their values."""
        found = []
        assert self.scene.potential is not None
        for side, family in POLES.items():
            for branch in branches_at(self.scene, {**self.given, "C1": side * self.total}):
                if branch.label == family.label:
                    at = (motion.axial + self.scene.potential.expression).xreplace(
                        {K3: S(side), **self.numbers}
                    )
                    found.append((float(side * self.total), float(in_floats(at, np, {})), branch))
        return found


def _values(expression: Expr, k3: Array) -> Array:
    return np.broadcast_to(np.asarray(in_floats(expression, np, {K3: k3}), dtype=float), k3.shape)


def _nodes(a: float, b: float, first: bool, last: bool) -> Array:
    """From one cut to another, closer together at the ends.

    An end at which C1 or h is infinite is approached, not reached.
    """
    inner = (a + b) / 2 - (b - a) / 2 * np.cos(np.pi * np.arange(1, NODES) / NODES)
    tail = np.geomspace(10.0**-DECADES, inner[0] - a, NODES // 2)
    return np.unique(np.concatenate([a + tail if first else [a], inner, b - tail if last else [b]]))
