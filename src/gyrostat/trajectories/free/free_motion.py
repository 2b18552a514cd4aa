"""The motion of a free gyrostat, momentum and attitude, at any time.

Its constants are computed once in enclosures; then times are reduced mod the period.
"""
import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from flint import arb

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import own_precision
from ...algebra.text.numbers import exact_number
from ...errors import ScopeError, ValuesError, require
from ...mechanics.scenes.system import System
from ..equidistant import filled
from ..periods import double
from .polhodes import Polhode, meeting, polhode
from .repeated_turn import RepeatedTurn
from .uniform_motion import CONSTANT, Steady, Triple, decided, steady


def path_of(inertia: Triple, rotor: Triple, M: Triple) -> Steady | Polhode | RepeatedTurn:
    """Return the motion of a gyrostat whose angular momentum is M at the time 0."""
    if uniform := steady(inertia, rotor, M):
        return uniform
    distinct = all(decided(inertia[i] - inertia[j], "a difference of moments")
                   for i, j in ((0, 1), (1, 2), (2, 0)))
    if distinct and not any(decided(x, "l") for x in rotor):
        return polhode(inertia, M)
    return RepeatedTurn(inertia, rotor, M, meeting(inertia, rotor, M))


class FreeMotion:
    """A free gyrostat from a state on: momentum and attitude at any time, M upwards in space.

    The motion is uniform at rest, at a permanent rotation, and for bodies of revolution with l on the axis.
    The momentum of a free body with three different moments follows Jacobi's functions. Any other momentum,
    and the attitude of that body, comes from one turn by Taylor series, which is repeated.

    Parameters
    ----------
    scene : System
        without a potential, at given numbers
    start : (π1, π2, π3)
        exact numbers [M L²/T]

    Raises
    ------
    ScopeError
        the scene has a potential
    ValuesError
        it has symbols; or which motion it is, is undecided, as its numbers are transcendental
    AccuracyError
        the motion is too close to a separatrix

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.assemble(gs.Gyrostat((3, 5, 9), (0, 0, 0)))
    >>> motion = FreeMotion(body, (0, 2, "0.01"))
    >>> motion.name, round(motion.period / 4, 10)
    ('free body', 29.5277217616)
    """

    enclosed, recognised, axis, limits, spin = True, "", (0.0, 0.0, 1.0), None, None

    def __init__(self, scene: System, start: Sequence[Any]):
        require(scene, System, "the scene")
        self._given = scene, tuple(start)
        body = scene.body
        if scene.potential is not None:
            raise ScopeError(f"U = {scene.potential.expression}: a free gyrostat is in no field; leave the "
                             "potential out")
        if names := sorted({s.name for x in (*body.moments, *body.gyrostatic_momentum)
                            for s in x.free_symbols}):
            raise ValuesError(f"the body contains the names {', '.join(names)}: give numbers for them")
        if len(start) != 3:
            raise ValuesError(f"the state has {len(start)} components: give pi1, pi2, pi3")
        self.rotor: Triple = tuple(body.gyrostatic_momentum)
        M = tuple(exact_number(x, f"pi{i}") + y for i, (x, y) in enumerate(zip(start, self.rotor), 1))
        moments = tuple(body.moments)
        self.path = path = path_of(moments, self.rotor, M)
        self.size = math.hypot(*map(float, M)) + math.hypot(*map(float, self.rotor))
        self.fastest = self.size / min(map(float, moments))
        resting = isinstance(path, Steady) and path.about == 0
        # a polhode knows M alone; for the attitude a turn of it is integrated
        self.rotation = RepeatedTurn(moments, self.rotor, M, path) if isinstance(path, Polhode) else path
        self.period = self.rotation.period                  # of M; None if it rests, and on a separatrix
        self.name = "equilibrium" if resting else "free gyrostat" if any(self.rotor) else "free body"

    def __reduce__(self) -> tuple[Any, ...]:
        return FreeMotion, self._given                     # python-flint's balls are not pickled

    def state(self, t: Array) -> Array:
        """Return π at an array of times, along a last axis."""
        def state(x: Array, t: Any) -> None:
            x[:] = self.path.values(np.reshape(t, -1)).reshape(x.shape)
            x -= self._rotor

        return filled(state, np.asarray(t, dtype=float), (3,))

    @cached_property
    def _rotor(self) -> Array:
        """The rotor l in doubles."""
        return np.array([double(ball(x, CONSTANT)) for x in self.rotor])

    def attitude(self, t: Array) -> Array:
        """Return R from body to space at an array of times, z along M.

        If M = 0, z is along ω. At the time 0 the Euler angle φ is 0.
        """
        def attitude(R: Array, t: Any) -> None:
            R[:] = self.rotation.attitude(np.reshape(t, -1)).reshape(R.shape)

        return filled(attitude, np.asarray(t, dtype=float), (3, 3))

    def ball_state(self, t: arb, bits: int) -> list[arb]:
        """Return π at a time, enclosures of about so many bits; estimated ones if a turn is integrated."""
        precision = bits + 64 + math.ceil(math.log2(1 + abs(float(t)) * self.fastest))
        with own_precision(precision + 64):
            return [x - ball(y, precision) for x, y in zip(self.path.at(t, bits, precision), self.rotor)]

    def exact_period(self, bits: int) -> arb | None:
        """Return the period of M, to so many bits; None if it rests, and on a separatrix."""
        if self.period is None:
            return None
        if not isinstance(self.rotation, Steady):
            return self.rotation.path.period(bits)[0]
        with own_precision(bits + 64):
            return 2 * arb.pi() / abs(ball(self.rotation.about, bits + 64))

    def exact_angles(self, _: int) -> tuple[float | None, None]:
        """Return the angle about M, in doubles, and None for the spin."""
        return self.precession, None

    @property
    def precession(self) -> float | None:
        """The angle gained about M in a period; if M rests, in a unit of time; None on a separatrix."""
        return self.rotation.precession

    @property
    def nodes(self) -> int:
        """The steps by which a turn of M is integrated; 0 for closed forms."""
        return 0 if isinstance(self.path, Polhode) else self.path.nodes

    @property
    def error(self) -> float:
        """The error of π, estimated."""
        return self.path.error * self.size
