"""Turns motions into other axes: those of a body of revolution, or of a free body, in its own axes."""
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from flint import arb
from sympy import Expr, ImmutableMatrix, Matrix, trigsimp

from .._cached import cached_property
from ..algebra.enclosures.algebraic import is_algebraic
from ..algebra.enclosures.balls import ball
from ..algebra.enclosures.floats import Array
from ..algebra.enclosures.precision import own_precision
from ..mechanics.equilibrium.recognition import Recognition, recognise
from ..mechanics.scenes.functions_on_sphere import lowest
from ..mechanics.scenes.principal_axes import principal_axes
from ..mechanics.scenes.system import System, assemble
from .columns import euler
from .free.free_motion import FreeMotion
from .free.uniform_motion import CONSTANT
from .periods import double
from .top.level import Level
from .top.top_motion import AxialMotion

GUARD = 32                                             # more bits for the rotation than for the motion


class TurnedMotion:
    """A motion in axes that are not the standard ones, as a route of gyrostat.trajectories.motion.

    The body is one of revolution about another axis than the third, or a free one in axes that are not
    principal. x = Rᵀ x' for π and k, with R the rotation to the standard scene. The rotation from body to
    space is that of the standard scene times R, turned about the vertical so that φ = 0 at t = 0. Period,
    gains and limits are those of the standard scene.

    Parameters
    ----------
    standard : AxialMotion or FreeMotion
        the motion in the standard scene
    R : ImmutableMatrix, shape (3, 3)
        the rotation to its axes, exact
    precision : int
        bits of the states in balls
    recognised : str
        what the scene is; "" for a free body
    """

    enclosed = True

    def __init__(self, standard: AxialMotion | FreeMotion, R: ImmutableMatrix, precision: int,
                 recognised: str = ""):
        self._standard, self._exact, self._precision = standard, R, precision
        self._R = np.array([[double(ball(x, CONSTANT)) for x in row] for row in R.tolist()])
        self.name, self.recognised = standard.name, recognised
        self.axis = self._R[2] if recognised else standard.axis

    @cached_property
    def _upright(self) -> Array:
        """The turn about the vertical with which φ = 0 at t = 0."""
        phi = euler(self._standard.attitude(np.zeros(())) @ self._R)[0]
        c, s = np.cos(phi), np.sin(phi)
        return np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])

    def state(self, t: Array) -> Array:
        """Return (π, k) at times of any shape, shape (..., 6)."""
        x = self._standard.state(t)
        return (x.reshape(*x.shape[:-1], -1, 3) @ self._R).reshape(x.shape)

    def attitude(self, t: Array) -> Array:
        """Return R from body to space, shape (..., 3, 3)."""
        return self._upright @ self._standard.attitude(t) @ self._R

    def ball_state(self, t: arb, bits: int) -> list[arb]:
        """Return (π, k) at a time, to as many bits as the motion was built for."""
        x = self._standard.ball_state(t, bits)
        precision = max(bits, self._precision) + GUARD
        entries = [[ball(entry, precision) for entry in row] for row in self._exact.T.tolist()]
        with own_precision(precision):
            return [sum((a * b for a, b in zip(row, x[n:n + 3])), arb(0)) for n in range(0, len(x), 3)
                    for row in entries]

    def exact_period(self, bits: int) -> arb | None:
        """Return the period of the nutation, as exact as the motion was built."""
        return self._standard.exact_period(bits)

    def exact_angles(self, bits: int) -> tuple[arb, arb]:
        """Return what precession and spin say, as exact as the motion was built."""
        return self._standard.exact_angles(bits)

    @property
    def period(self) -> float | None:
        """The period of the nutation [T]; None at rest and on a separatrix."""
        return self._standard.period

    @property
    def precession(self) -> float | None:
        """The angle that the axis gains about the vertical in a period, or its rate."""
        return self._standard.precession

    @property
    def spin(self) -> float | None:
        """The angle that the body gains about its axis in a period, or its rate; None for a free body."""
        return self._standard.spin

    @property
    def limits(self) -> tuple[float, float] | None:
        """The lowest and highest component of k along the axis; None for a free body."""
        return self._standard.limits

    @property
    def nodes(self) -> int:
        """The number of values of the integrands that were taken."""
        return self._standard.nodes

    @property
    def error(self) -> float:
        """The error of a state in doubles, estimated: twice that of the standard scene, for the turn."""
        return 2 * self._standard.error


def turned_top(found: Recognition, state: Sequence[Expr], bits: int) -> TurnedMotion:
    """Return the motion of a scene that was recognised from a state on, with abs(k) > 0."""
    R = found.rotation
    turned = [lowest(sum(R[i, j] * v[j] for j in range(3))) for v in (state[:3], state[3:]) for i in range(3)]
    standard = AxialMotion(Level(found.standard, tuple(turned)), bits)
    return TurnedMotion(standard, R, standard.exact.precision, found.sentence)


def turned_free(scene: System, state: Sequence[Expr]) -> TurnedMotion:
    """Return the motion of a free body whose tensor is given in any axes, in principal ones."""
    standard, R = _in_principal_axes(scene)
    return TurnedMotion(FreeMotion(standard, list(R * Matrix(state))), R, CONSTANT)


@lru_cache(maxsize=64)
def _in_principal_axes(scene: System) -> tuple[System, ImmutableMatrix]:
    """Return the scene of the same free body in principal axes, and the rotation to them."""
    body, R = principal_axes(scene.body)
    return assemble(body), R


def of_revolution(scene: System, state: Sequence[Expr]) -> Recognition | None:
    """Return what a scene in numbers is on the sphere of k on which a state moves; None in two directions."""
    if scene.coupled:
        return None
    square = sum(x**2 for x in state[3:])
    return recognise(scene, lowest(square) if is_algebraic(square) else trigsimp(square))
