"""Decides satellites and vehicles between the two criteria, by a top's motion or by sets of equilibria.

No theorem does so for three degrees of freedom, except for a symmetric satellite, whose axis moves like a
top, and for closed curves of attitudes, which are stable as sets.
"""
from collections.abc import Callable, Mapping
from dataclasses import replace

from sympy import Expr, ImmutableMatrix, Symbol

from ...algebra.reals.exact import evaluate, proved_sign
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.parallel_directions import parallel
from ...mechanics.families.circular_orbit import by_gradient_alone, orbital_rate
from ...mechanics.families.orbital_precession import moving_axis
from ..decision import Decision, Rung, settled, undecided

HELD = ("gyroscopic forces stabilise it, and the second variation has both signs: no theorem decides with "
        "three degrees of freedom")
COUPLED = "the point lies between the two criteria, and there is no other for a field with a coupling β"
DEGENERATE = "the second variation is degenerate: terms of higher degree decide"
ON_CURVE = settled(True, "the energy is least on a closed curve of equilibria, and K is positive across it",
                   Rung.LEAST_ON_SET, locus="the closed curve of equilibria to which it belongs")
AXIS = "the axis moves in the orbital frame as k of a spherical gyrostat in one field does: "


def open_between(eq: Equilibrium) -> bool:
    """Tell whether nothing decides between the two criteria of its report, whatever the numbers.

    The exception is a degenerate K, if the satellite may lie on a closed curve (may_lie_on_curve).
    """
    return eq.system.coupled and not eq.system.linear_integrals and not parallel(eq)


def may_lie_on_curve(eq: Equilibrium) -> bool:
    """Tell whether it is a satellite in principal axes with a rotor along one of them (on_curve)."""
    body = eq.system.body
    along = [x for x in body.gyrostatic_momentum if x != 0]
    return by_gradient_alone(eq.system) and not isinstance(body.inertia, ImmutableMatrix) and len(along) == 1


def decide_in_frame(eq: Equilibrium, numbers: Mapping[Symbol, Expr], degenerate: bool,
                    point_decided: Callable[[Equilibrium], Decision]) -> Decision:
    """Return what the axis of a symmetric satellite decides; for any other UNDECIDED, with what is known.

    The last argument decides a body in one direction, as a point. Its C1 is minus the momentum along the axis
    of the satellite.

    Parameters
    ----------
    eq : Equilibrium
        of a scene in two directions
    numbers : mapping of Symbol to Expr
        exact
    degenerate : bool
        whether the second variation is degenerate
    point_decided : callable
        decides an equilibrium of a body in one direction, as a point

    Returns
    -------
    Decision
    """
    if axis := moving_axis(eq, lambda x: evaluate(x, numbers)):
        found = point_decided(axis)
        return replace(found, reason=f"{AXIS}{found.reason}", margins=(),
                       level=found.level and eq.system.linear_integrals)
    if degenerate:
        curve = on_curve(eq, numbers)
        return undecided(DEGENERATE) if curve is None else curve
    return undecided(HELD if len(eq.point) == 9 else COUPLED)


def on_curve(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Decision | None:
    """Return the decision on a satellite on a closed curve of attitudes that is stable, else None.

    With the rotor ω0 L along axis j, a = I_i − I_j, b = I_k − I_j and L² = 4ab the curve is I'_tt = 4 I'_rr,
    where I' = I − I_j, and I'_tn² = 4 (I'_nn I'_rr − I'_nr²) on it. So K has the invariants e3 = 0, e1 = ω0²
    (5 I'_nn + 9 I'_rr) and e2 = ω0⁴ (9 I'_nn I'_rr + 4 I'_nn² + 27 I'_nr²). Both are positive if a and b are,
    except if n is along axis j; the curve meets such an attitude if a = 4b or b = 4a. Otherwise the energy
    has a strict minimum on the curve, which is compact.

    References
    ----------
    Derived in docs/explanation/derivations/satellite.md, section 9.
    """
    if not may_lie_on_curve(eq):
        return None
    body = eq.system.body
    (rate,), moments, rotor, point = ([evaluate(eq.insert(x), numbers) for x in given] for given in (
        (orbital_rate(eq.system),), body.moments, body.gyrostatic_momentum, eq.point))
    axis = next((i for i in range(3) if rotor[i] != 0), 0)
    a, b = (moments[axis - i] - moments[axis] for i in (1, 2))
    n, r = (ImmutableMatrix(point[i:i + 3]) for i in (3, 6))
    above = ImmutableMatrix.diag(*(moment - moments[axis] for moment in moments))
    t = n.cross(r)
    for wanted, x in ((1, a), (1, b), (0, (rotor[axis] / rate)**2 - 4 * a * b),
                      (0, t.dot(above * t) - 4 * r.dot(above * r))):
        if proved_sign(evaluate(x, {})) != wanted:
            return None
    return ON_CURVE if proved_sign(a - 4 * b) and proved_sign(b - 4 * a) else None
