"""Critical values of (C1, h) of a body of revolution in U(k3) at a fixed axial momentum.

They are those of E1, E2 and all regular precessions, on a plane curve in k3 and the rate.
"""
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from sympy import Expr

from ...algebra.enclosures.floats import Array, in_floats
from ...algebra.reals.exact import Point, sign_of_constant
from ...algebra.rings.polynomials import by_factors
from ...algebra.solving.plane_curves import PlaneCurve
from ...errors import ScopeError
from ...mechanics.equilibrium.reduction import K3, OMEGA, P, Reduction, V, reduce
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...stability.decision import Verdict
from ..finders.rate_level_tilt import refuse_as_level
from ..relative_equilibrium import RelativeEquilibrium
from .precessions import Precessions


@dataclass(frozen=True, eq=False)
class CriticalCurve:
    """The values of (C1, h) on regular precessions of one verdict.

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
    """The critical values of (C1, h).

    Parameters
    ----------
    curves : list of CriticalCurve
    poles : list of (C1, h, RelativeEquilibrium)
        E1 and E2
    cusps : list of (C1, h)
        where stability changes along the curves: two precessions fold on a level
    potential : Expr
        V(C1, k3)
    """

    curves: list[CriticalCurve]
    poles: list[tuple[float, float, RelativeEquilibrium]]
    cusps: list[tuple[float, float]]
    potential: Expr


def critical_values(scene: System, numbers: Point) -> EnergyMomentum:
    """Return every critical value of (C1, h) at a fixed p_psi = π3 + l.

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
    refuse_as_level(scene, "C1")
    assert scene.potential is not None
    field = replace(scene.potential, expression=by_factors(scene.potential.expression.xreplace(numbers)))
    motion = reduce(replace(scene, potential=field))
    level, height, margin = (e.xreplace(numbers) for e in on_precessions(motion))
    curve = PlaneCurve(motion.precession().xreplace(_jets(motion)).xreplace(numbers), K3, OMEGA, (margin,))
    if curve.lines and sign_of_constant(numbers[P]) == 0:
        raise ScopeError("U is constant and p_psi = 0: every tilt at rest has the same C1 and h; give "
                         "p_psi a value")
    here = Precessions(scene, numbers, curve, curve.polynomial(margin))
    arcs = [arc for n in range(len(here.components)) for arc in here.arcs(n)]
    curves, cusps = [], []
    for arc in arcs:
        v, h = (np.broadcast_to(in_floats(e, np, {K3: arc.k3, OMEGA: arc.omega}), arc.k3.shape)
                for e in (level, height))
        curves.append(CriticalCurve(arc.k3, arc.omega, v, h, arc.verdict))
    for omega, k3 in dict.fromkeys(point for points in here.margins for point in points):
        met = {arc.verdict for arc in arcs if here.ends_at(arc, omega, k3)}
        if len(met) > 1:
            at = {K3: np.float64(float(k3)), OMEGA: np.float64(float(omega))}
            cusps.append((float(in_floats(level, np, at)), float(in_floats(height, np, at))))
    return EnergyMomentum(curves, here.poles(motion), cusps, motion.effective_potential().xreplace(numbers))


def on_precessions(motion: Reduction) -> tuple[Expr, Expr, Expr]:
    """Return C1, h, and what is positive if they are stable, on regular precessions in k3 and omega."""
    # motion.rate is omega there
    level = V - motion.twist + motion.system.body.moments[0] * OMEGA * motion.across
    return (
        level,
        motion.effective_potential().xreplace({V: level}),
        motion.restoring().xreplace(_jets(motion)),
    )


def _jets(motion: Reduction) -> dict[Any, Expr]:
    """Return U' and U'' of the scene."""
    potential = motion.system.potential
    assert potential is not None
    return {name: potential.value(name) for name in (symbol("dU"), symbol("d2U"))}
