"""The attitude in a circular orbit that wheels can hold: the body is turned about the normal of the orbit."""
from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, ImmutableMatrix, S, Symbol, atan, pi, sqrt

from ...algebra.reals.exact import proved_sign
from ...errors import ScopeError
from ...notation import symbol
from ..scenes.functions_on_sphere import lowest
from .circular_orbit import along_velocity

# the moments t·I t, n·I n, r·I r and the products t·I n, r·I n of an attitude that wheels hold
NAMES = tuple(map(symbol, ("I1", "I2", "I3", "I12", "I23")))


@dataclass(frozen=True)
class HeldAttitude:
    """An attitude that wheels hold: the tensor in its axes, the angle of the turn, l across n over ω0."""

    numbers: Mapping[Symbol, Expr]
    turn: Expr
    across: ImmutableMatrix


def turned_to_rest(I: ImmutableMatrix, n: ImmutableMatrix, r: ImmutableMatrix) -> HeldAttitude:
    """Return the attitude that wheels can hold, turned about n by the least angle φ that makes t·I r 0.

    t turns to t cos φ + r sin φ with tan 2φ = 2 t·I r/(t·I t − r·I r). The conditions have the products of
    inertia t·I n and r·I n in their squares only, so that their signs do not matter. A ScopeError is raised
    if the gravity gradient leaves that turn free.
    """
    t = along_velocity(n, r)
    across, up, coupled = t.dot(I * t), r.dot(I * r), t.dot(I * r)
    u, v = t.dot(I * n), r.dot(I * n)
    width = sqrt((across - up)**2 + 4 * coupled**2)
    if not any(map(proved_sign, (width, u, v))):
        raise ScopeError("t·I t = r·I r, and no product of inertia is there: the gravity gradient leaves the "
                         "turn about the normal free at every speed, and no verdict is proved by its form; "
                         "ask for a verdict at given numbers")
    if proved_sign(across - up) == -1:
        width = -width
    square, product = S.One, S.Zero                    # cos² φ, cos φ sin φ
    turn = S.Zero
    if proved_sign(coupled):
        square, product = (1 + (across - up) / width) / 2, coupled / width
        turn = (atan(2 * coupled / (across - up)) if proved_sign(across - up)
                else proved_sign(coupled) * pi / 2) / 2
    other = 1 - square
    along_t = (square * u + product * v) * t + (product * u + other * v) * r
    along_r = (other * u - product * v) * t + (square * v - product * u) * r
    sizes = (square * u**2 + 2 * product * u * v + other * v**2,
             other * u**2 - 2 * product * u * v + square * v**2)
    moments = (across + up + width) / 2, n.dot(I * n), (across + up - width) / 2
    values = (*moments, *(sqrt(lowest(x)) for x in sizes))
    return HeldAttitude(dict(zip(NAMES, map(lowest, values))), turn, -along_t - 4 * along_r)
