"""Decides a body with a direction k on which no torque acts, because U is constant on abs(k) = 1.

Its momentum M is fixed in space, and moves in the body as that of a free body.
"""
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from sympy import Dummy, Expr, Symbol

from ...algebra.reals.exact import evaluate, sign_of_constant
from ...algebra.rings.matrices import cross
from ...algebra.rings.polynomials import Ring
from ...mechanics.equilibrium.claimed_point import equilibrium
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.system import assemble
from ..decision import Decision, Rung, settled, undecided

A, B = Dummy("a", real=True), Dummy("b", real=True)


def decide_without_torque(eq: Equilibrium, numbers: Mapping[Symbol, Expr],
                          free: Callable[[Equilibrium], Decision]) -> Decision:
    """Return the decision on an equilibrium on e(3)* in a field that exerts no torque, by that on so(3)*.

    M moves by itself on so(3)*, and M and k are both fixed in space. If M ≠ 0 lies along k, k stays beside
    it: stable as the free gyrostat is. At rest with k not along M, a gyrostat that turns ever so slowly about
    M carries k away: unstable. What the free gyrostat divides out is divided out here: M and k turn together,
    for k stays along M.

    Parameters
    ----------
    eq : Equilibrium
    numbers : mapping of Symbol to Expr
        exact
    free : callable
        decides equilibria of the free gyrostat, on so(3)*

    Returns
    -------
    Decision

    References
    ----------
    Derived: M·k, abs(M)² and abs(k)² are conserved.
    """
    body = eq.system.body.changed(lambda x: evaluate(eq.insert(x), numbers))
    point = [evaluate(eq.insert(x), numbers) for x in eq.point]
    total = [p + l for p, l in zip(point, body.gyrostatic_momentum)]
    rests, across = _all_zero(point[:3]), cross(total, point[3:])
    if _all_zero(total):
        if rests:
            return settled(False, "no torque acts and l = 0: a body that turns, however slowly, carries k "
                           "away", Rung.NO_TORQUE)
        return undecided("no torque acts and M = 0: no theorem tells which way k goes")
    if rests and not _all_zero(across):
        if not any(map(sign_of_constant, across)):
            return undecided("no torque acts, and whether k is along M is not proved")
        return settled(False, "no torque acts and k is not along M = l: a gyrostat that turns slowly about M "
                       "carries k away", Rung.NO_TORQUE)
    found = free(equilibrium(assemble(body), point[:3]))
    return replace(found, reason="no torque acts, k is along M, and M is that of a free gyrostat: "
                   f"{found.reason}", margins=(),
                   rung=found.rung if found.rung is Rung.NOTHING else Rung.NO_TORQUE)


def without_torque(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> bool:
    """Tell whether its field exerts no torque: U is proved to be constant on abs(k) = 1."""
    potential = eq.system.potential
    if potential is None or not potential.given:
        return False
    # k = (2a, 2b, 1 − a² − b²)/(1 + a² + b²) is every direction but one, and U is continuous there
    below = 1 + A**2 + B**2
    k = eq.system.space.coordinates[3:]
    sphere = dict(zip(k, (2 * A / below, 2 * B / below, (1 - A**2 - B**2) / below)))
    placed = eq.insert(potential.expression.xreplace(sphere)).xreplace(dict(numbers))
    ring = Ring([slope := placed.diff(A), other := placed.diff(B)])
    return not any(map(ring.numerator, (slope, other)))


def _all_zero(numbers: Sequence[Expr]) -> bool:
    return all(sign_of_constant(x) == 0 for x in numbers)
