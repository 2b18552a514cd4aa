"""The motion of a body of revolution about any axis: that of the standard scene, turned."""
from collections.abc import Sequence

import numpy as np
from flint import arb
from sympy import Expr, trigsimp

from ..algebra.algebraic import is_algebraic
from ..algebra.balls import ball
from ..algebra.floats import Array
from ..algebra.precision import own_precision
from ..mechanics.recognition import Recognition, recognise
from ..mechanics.spherical import lowest
from ..mechanics.system import System
from .top.level import Level
from .top.motion import AxialMotion

GUARD = 32                                             # bits of the rotation beyond those of the motion


class TurnedMotion:
    """A body of revolution about another axis than the third from a state on, a route of
    gyrostat.trajectories.motion.

    x = Rᵀ x' for π and k, with R the rotation to the standard scene; body to space, the rotation is that of
        the standard scene times R,
    turned about the vertical to φ = 0 at t = 0. Period, gains and limits are those of the standard scene.

    Parameters
    ----------
    found : Recognition
    state : sequence of six Expr
        exact numbers, in the axes of the scene; abs(k) > 0
    bits : int
        of the states in balls; 53 for doubles
    """

    enclosed = True

    def __init__(self, found: Recognition, state: Sequence[Expr], bits: int):
        R = found.rotation
        turned = [lowest(sum(R[i, j] * v[j] for j in range(3))) for v in (state[:3], state[3:])
                  for i in range(3)]
        self._standard = AxialMotion(Level(found.standard, tuple(turned)), bits)
        self._exact, self._R = R, np.array(R.tolist(), dtype=float)
        self.name, self.recognised, self.axis = self._standard.name, found.sentence, self._R[2]
        first = self._standard.attitude(np.zeros(()))[..., :, :] @ self._R
        across = np.hypot(first[2, 0], first[2, 1])
        phi = np.arctan2(first[0, 2], -first[1, 2]) if across else np.arctan2(first[1, 0], first[0, 0])
        c, s = np.cos(phi), np.sin(phi)
        self._upright = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])

    def state(self, t: Array) -> Array:
        """(π, k) at times of any shape, shape (..., 6)."""
        x = self._standard.state(t)
        return (x.reshape(*x.shape[:-1], 2, 3) @ self._R).reshape(x.shape)

    def attitude(self, t: Array) -> Array:
        """R from body to space, shape (..., 3, 3)."""
        return self._upright @ self._standard.attitude(t) @ self._R

    def ball_state(self, t: arb, bits: int) -> list[arb]:
        """(π, k) at a time, to as many bits as the motion was built for."""
        x, precision = self._standard.ball_state(t, bits), self._standard.exact.precision + GUARD
        entries = [[ball(entry, precision) for entry in row] for row in self._exact.T.tolist()]
        with own_precision(precision):
            return [sum((a * b for a, b in zip(row, v)), arb(0)) for v in (x[:3], x[3:]) for row in entries]

    def exact_period(self, bits: int) -> arb | None:
        """Of the nutation, as exact as the motion was built."""
        return self._standard.exact_period(bits)

    def exact_angles(self, bits: int) -> tuple[arb, arb]:
        """What precession and spin say, as exact as the motion was built."""
        return self._standard.exact_angles(bits)

    @property
    def period(self) -> float | None:
        """Of the nutation [T]; None at rest and on a separatrix."""
        return self._standard.period

    @property
    def precession(self) -> float:
        """What the axis gains about the vertical in a period, or its rate."""
        return self._standard.precession

    @property
    def spin(self) -> float:
        """What the body gains about its axis in a period, or its rate."""
        return self._standard.spin

    @property
    def limits(self) -> tuple[float, float]:
        """Lowest and highest component of k along the axis."""
        return self._standard.limits

    @property
    def nodes(self) -> int:
        """Values of the integrands that were taken."""
        return self._standard.nodes

    @property
    def error(self) -> float:
        """Of a state in doubles, estimated: that of the standard scene, and the rounding of the turn."""
        return 2 * self._standard.error


def of_revolution(scene: System, state: Sequence[Expr]) -> Recognition | None:
    """What a scene in numbers is on the sphere of k on which a state moves."""
    square = sum(x**2 for x in state[3:])
    return recognise(scene, lowest(square) if is_algebraic(square) else trigsimp(square))
