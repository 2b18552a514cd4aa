"""The motion of a free gyrostat, momentum and attitude, at any time.

Constants once in enclosures, then time mod the period.
"""
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from flint import arb

from ...algebra.balls import ball
from ...algebra.floats import Array
from ...algebra.numbers import exact_number
from ...algebra.precision import own_precision
from ...errors import AccuracyError, ScopeError, ValuesError, require
from ...mechanics.system import System
from ..periods import double, pair, reduced, turns
from .polhodes import Meeting, Polhode, meeting, polhode
from .taylor import Loop, Rates, loop
from .uniform import CONSTANT, ROUNDING, Steady, Triple, cross, cycles, decided, dot, frame, steady, turned

BLOCK = 16384                                              # times at once, so that they fit a cache
# components of the vectors that are followed: M; M and the row x
M_ONLY, ROWS = 3, 6
MOST_LOST = 512                                            # bits that nearness to a separatrix may cost
# bits to which a turn closes, for results in doubles; its angle is multiplied
CLOSED = {M_ONLY: 64, ROWS: 88}


@dataclass(frozen=True)
class Turning:
    """R = Rz(common · t) R̃, where M and the rows of R̃ follow v̇ = v × Ω over a turn, which ends with R̃
    turned about M.

    Parameters
    ----------
    inertia, rotor, momentum : three Expr
        Iᵢ, lᵢ, and M at the time 0
    path : Polhode or Meeting
        what knows the period
    """

    inertia: Triple
    rotor: Triple
    momentum: Triple
    path: Polhode | Meeting

    def size(self, bits: int) -> arb:
        """abs(M)."""
        M = [ball(x, bits) for x in self.momentum]
        return dot(M, M).sqrt()

    def common(self, bits: int) -> arb:
        """The rate at which the rows of R̃ are left behind.

        With it Ω is small for a body of nearly equal moments.
        """
        inverse = [1 / ball(x, bits) for x in self.inertia]
        return self.size(bits) * (max(inverse, key=float) + min(inverse, key=float)) / 2

    def rates(self, bits: int) -> Rates:
        """Ω."""
        inertia, size, common = [ball(x, bits) for x in self.inertia], self.size(bits), self.common(bits)
        return Rates([size / x - common for x in inertia],
                     [-ball(y, bits) / x for x, y in zip(inertia, self.rotor)])

    def loops(self, components: int, bits: int = 0) -> tuple[Loop, Loop | None]:
        """A turn; on a separatrix all that follows, and all that went before in reversed time."""
        return _loops(self, components, bits or CLOSED[components if self.path.periodic else M_ONLY])

    @cached_property
    def angle(self) -> arb:
        """By which R̃ is turned about M at the end of a turn."""
        with own_precision(CONSTANT):
            u, k = frame(self.momentum, CONSTANT)
            end = self.loops(ROWS)[0].end[3:]
            return arb.atan2(dot(end, cross(u, k)), dot(end, u))

    def rows(self, t: Array, components: int) -> tuple[Array, Array]:
        """M/abs(M) and the row x of R̃ at a row of times, and the cycles by which R̃ has been turned about M
        besides.
        """
        forth, back = self.loops(components)
        if back is None:
            period = pair(self.path.period(CONSTANT)[0])
            n, r = reduced(t, period)
            return forth.values(r, period.high), turns(
                n - (r < 0), cycles(self.angle)
            ) if components == ROWS else n
        found, cycle = np.empty((len(t), components)), np.zeros(len(t))
        for where, side, rates in ((t >= 0, forth, self.rates(CONSTANT)),
                                   (t < 0, back, self.rates(CONSTANT).reversed())):
            s, end, beyond = abs(t[where]), side.length, cycles(rates.about(side.end[:3]))
            found[where] = side.values(np.minimum(s, end))
            cycle[where] = np.where(s > end, turns(s, beyond) - turns(np.array([end]), beyond), 0)
        return found, cycle

    def values(self, t: Array) -> Array:
        """M at a row of times."""
        with own_precision(CONSTANT):
            return double(self.size(CONSTANT)) * self.rows(t, M_ONLY)[0]

    def attitude(self, t: Array) -> Array:
        """R at a row of times."""
        with own_precision(CONSTANT):
            rows, cycle = self.rows(t, ROWS)
            return turned(np.roll(rows, 3, axis=1), turns(t, cycles(self.common(CONSTANT))) + cycle)

    def at(self, t: arb, bits: int, precision: int) -> list[arb]:
        """M at a time, to so many bits, from constants of a precision.

        The radii are estimated, from how well the turn closes.
        """
        side, back = self.loops(M_ONLY, 32 * math.ceil((bits + 8) / 32))
        if back is None:
            period = self.path.period(precision)[0]
            t = t - period * (t / period).mid().floor()
        else:
            side = back if t < 0 else side
            t = min(abs(t), arb(side.length), key=float)
        return [self.size(precision) * (x + arb(0, 1) * arb(2) ** -bits) for x in side.at(t)]

    @cached_property
    def period(self) -> float | None:
        """Of M, None on a separatrix."""
        return double(self.path.period(CONSTANT)[0]) if self.path.periodic else None

    @cached_property
    def precession(self) -> float | None:
        """The angle gained about M in a period: φ of axis 3, where that is not along M.

        None on a separatrix.
        """
        if self.period is None:
            return None
        turn = self.loops(ROWS)[0]
        starts, lengths, _ = turn.table
        rows = turn.values(np.append((starts[:, None] + lengths[:, None] * np.arange(16) / 16).ravel(),
                                     self.period))
        phi = np.unwrap(np.arctan2(rows[:, 5], rows[:, 1] * rows[:, 3] - rows[:, 0] * rows[:, 4]))
        whole = round((phi[-1] - phi[0] - double(self.angle)) / (2 * math.pi))
        with own_precision(CONSTANT):
            return double(self.common(CONSTANT) * self.path.period(CONSTANT)[0] + self.angle + 2 * arb.pi()
                          * whole)

    @property
    def nodes(self) -> int:
        """Steps of a turn."""
        return len(self.loops(M_ONLY)[0].pieces)

    @property
    def error(self) -> float:
        """Of M, in units of abs(M), estimated.

        The rounding of the time, and what the polynomials in doubles leave of the series.
        """
        turn, rates = self.loops(M_ONLY)[0], self.rates(CONSTANT)
        return ROUNDING * (8 + turn.length / rates.unit / 4) + turn.cut


@lru_cache(maxsize=32)
def _loops(turning: Turning, components: int, bits: int) -> tuple[Loop, Loop | None]:
    periodic, lost = turning.path.periodic, bits + 64
    if periodic:
        with own_precision(64):
            lost = 2 * max(0, math.ceil(-float(turning.path.period(64)[1].log()) / math.log(2)))
    if lost > MOST_LOST and periodic:
        raise AccuracyError(f"the turn of M is only 2^−{lost // 2} away from a separatrix, too close to be "
                            "integrated: give other numbers")
    for precision in (bits + lost + 32, bits + 2 * lost + 96, 2 * (bits + 2 * lost + 96)):
        with own_precision(precision + 64):
            u, k = frame(turning.momentum, precision + 64)
            start, rates = [*k, *u][:components], turning.rates(precision + 64)
            if not periodic:
                return loop(start, rates, precision, None), loop(start, rates.reversed(), precision, None)
            found = loop(start, rates, precision, turning.path.period(precision)[0])
            if all(abs(x - y) < arb(2) ** -bits for x, y in zip(found.end, k)):
                return found, None
    raise AccuracyError(f"a turn of M does not close to {bits} bits: the motion is too close to a "
                        "separatrix; give other numbers")


def path_of(inertia: Triple, rotor: Triple, M: Triple) -> Steady | Polhode | Turning:
    """The motion of a gyrostat whose angular momentum is M at the time 0."""
    if uniform := steady(inertia, rotor, M):
        return uniform
    distinct = all(decided(inertia[i] - inertia[j], "a difference of moments")
                   for i, j in ((0, 1), (1, 2), (2, 0)))
    if distinct and not any(decided(x, "l") for x in rotor):
        return polhode(inertia, M)
    return Turning(inertia, rotor, M, meeting(inertia, rotor, M))


class FreeMotion:
    """A free gyrostat from a state on.

    The momentum to any number of periods, and the attitude, M upwards in space.

    Uniform turning at rest, at a permanent rotation, and for bodies of revolution with l on the axis;
    Jacobi's functions for a free body of three moments; else, and for the attitude of that, a turn by Taylor
    series, repeated.

    Parameters
    ----------
    scene : System
        without a potential, all numbers
    start : (π1, π2, π3)
        exact numbers

    Raises
    ------
    ScopeError
        the scene has a potential
    ValuesError
        it has symbols; or it is undecided which motion it is, of transcendental numbers
    AccuracyError
        the motion is too close to a separatrix

    Examples
    --------
    >>> from gyrostat import Gyrostat, assemble
    >>> motion = FreeMotion(assemble(Gyrostat((3, 5, 9), (0, 0, 0))), (0, 2, "0.01"))
    >>> motion.name, round(motion.period / 4, 10)
    ('free body', 29.5277217616)
    """

    enclosed, recognised, axis, limits, spin = True, "", (0.0, 0.0, 1.0), None, None

    def __init__(self, scene: System, start: Sequence[Any]):
        require(scene, System, "the scene")
        body = scene.body
        if scene.potential is not None:
            raise ScopeError(f"U = {scene.potential.expression}: a free gyrostat is in no field; leave the "
                             "potential out")
        if names := sorted({s.name for x in (*body.inertia, *body.gyrostatic_momentum)
                            for s in x.free_symbols}):
            raise ValuesError(f"the body contains the names {', '.join(names)}: give numbers for them")
        if len(start) != 3:
            raise ValuesError(f"the state has {len(start)} components: give pi1, pi2, pi3")
        self.rotor: Triple = tuple(body.gyrostatic_momentum)
        M = tuple(exact_number(x, f"pi{i}") + y for i, (x, y) in enumerate(zip(start, self.rotor), 1))
        self.path = path_of(tuple(body.inertia), self.rotor, M)
        self.size = math.hypot(*map(float, M)) + math.hypot(*map(float, self.rotor))
        self.fastest = self.size / min(map(float, body.inertia))
        resting = isinstance(self.path, Steady) and self.path.about == 0
        self.turning = (
            Turning(tuple(body.inertia), self.rotor, M, self.path)
            if isinstance(self.path, Polhode)
            else self.path
        )
        self.period = self.turning.period                  # of M; None where it rests, and on a separatrix
        self.name = "equilibrium" if resting else "free gyrostat" if any(self.rotor) else "free body"

    def state(self, t: Array) -> Array:
        """π at an array of times, along a last axis."""
        return _in_blocks(self.path.values, t, (3,)) - np.array(
            [double(ball(x, CONSTANT)) for x in self.rotor]
        )

    def attitude(self, t: Array) -> Array:
        """R from body to space at an array of times, z along M.

        Where M = 0, along ω. At the time 0 the Euler angle φ is 0.
        """
        return _in_blocks(self.turning.attitude, t, (3, 3))

    def ball_state(self, t: arb, bits: int) -> list[arb]:
        """π at a time, enclosures of about so many bits; estimated ones where a turn is integrated."""
        precision = bits + 64 + math.ceil(math.log2(1 + abs(float(t)) * self.fastest))
        with own_precision(precision + 64):
            return [x - ball(y, precision) for x, y in zip(self.path.at(t, bits, precision), self.rotor)]

    def exact_period(self, bits: int) -> arb | None:
        """Of M, to so many bits; None where it rests, and on a separatrix."""
        if self.period is None:
            return None
        if not isinstance(self.turning, Steady):
            return self.turning.path.period(bits)[0]
        with own_precision(bits + 64):
            return 2 * arb.pi() / abs(ball(self.turning.about, bits + 64))

    def exact_angles(self, _: int) -> tuple[float | None, None]:
        """That about M, in doubles."""
        return self.precession, None

    @property
    def precession(self) -> float | None:
        """The angle gained about M in a period; where M rests, in a unit of time; None on a separatrix."""
        return self.turning.precession

    @property
    def nodes(self) -> int:
        """Steps by which a turn of M is integrated; 0 for closed forms."""
        return 0 if isinstance(self.path, Polhode) else self.path.nodes

    @property
    def error(self) -> float:
        """Of π, estimated."""
        return self.path.error * self.size


def _in_blocks(values: Callable[[Array], Array], t: Array, shape: tuple[int, ...]) -> Array:
    t = np.asarray(t, dtype=float)
    found = np.empty((t.size, *shape))
    for i in range(0, t.size, BLOCK):
        found[i:i + BLOCK] = values(t.ravel()[i:i + BLOCK])
    return found.reshape(*t.shape, *shape)
