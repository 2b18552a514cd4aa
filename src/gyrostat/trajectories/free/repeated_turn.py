"""The momentum and attitude of a free gyrostat: one turn of its momentum, in balls, repeated.

After a period the momentum is back, and the attitude is turned about it by an angle that is the same in each.
"""
import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from flint import arb

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.double_double import Twofold
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import own_precision
from ...algebra.rings.matrices import cross
from ...errors import AccuracyError
from ...stability.criteria.amended_form import dot
from ..periods import double, pair, reduced, turns
from .polhodes import Meeting, Polhode
from .taylor import Loop, Rates, loop
from .uniform_motion import CONSTANT, ROUNDING, Triple, cycles, frame, turned

# components of the vectors that are followed: M alone; M and the row x of the rotation
M_ONLY, ROWS = 3, 6
MOST_LOST = 512                                            # bits that nearness to a separatrix may cost
# bits to which a turn closes, for results in doubles; more for the rotation, whose angle is multiplied
CLOSED = {M_ONLY: 56, ROWS: 88}


@dataclass(frozen=True)
class RepeatedTurn:
    """The rotation R = Rz(common · t) R̃, where M and the rows of R̃ follow v̇ = v × Ω over a turn.

    After the turn M is the same, and R̃ is turned about M.

    Parameters
    ----------
    inertia, rotor, momentum : three Expr
        Iᵢ, lᵢ, and M at the time 0
    path : Polhode or Meeting
        gives the period
    """

    inertia: Triple
    rotor: Triple
    momentum: Triple
    path: Polhode | Meeting

    def size(self, bits: int) -> arb:
        """Return abs(M)."""
        M = [ball(x, bits) for x in self.momentum]
        return dot(M, M).sqrt()

    def common(self, bits: int) -> arb:
        """Return the rate at which the rows of R̃ are left behind.

        With it Ω is small for a body of nearly equal moments.
        """
        inverse = [1 / ball(x, bits) for x in self.inertia]
        return self.size(bits) * (max(inverse, key=float) + min(inverse, key=float)) / 2

    def rates(self, bits: int) -> Rates:
        """Return Ω as a function of M."""
        inertia, size, common = [ball(x, bits) for x in self.inertia], self.size(bits), self.common(bits)
        return Rates([size / x - common for x in inertia],
                     [-ball(y, bits) / x for x, y in zip(inertia, self.rotor)])

    def loops(self, components: int, bits: int = 0) -> tuple[Loop, Loop | None]:
        """Return a turn; on a separatrix all that follows, and all that went before in reversed time."""
        return _loops(self, components, bits or CLOSED[components if self.path.periodic else M_ONLY])

    @cached_property
    def angle(self) -> arb:
        """The angle by which R̃ is turned about M at the end of a turn."""
        with own_precision(CONSTANT):
            u, k = frame(self.momentum, CONSTANT)
            end = self.loops(ROWS)[0].end[3:]
            return arb.atan2(dot(end, cross(u, k)), dot(end, u))

    def rows(self, t: Array, components: int) -> tuple[Array, Array]:
        """Return M/abs(M) and the row x of R̃ at a row of times, and cycles.

        R̃ has been turned about M by these cycles besides.
        """
        forth, back = self.loops(components)
        if back is None:
            n, r = reduced(t, self._cycle)
            besides = turns(n - (r < 0), cycles(self.angle)) if components == ROWS else n
            return forth.values(r, self._cycle.high), besides
        found, cycle = np.empty((len(t), components)), np.zeros(len(t))
        for where, side, rates in ((t >= 0, forth, self.rates(CONSTANT)),
                                   (t < 0, back, self.rates(CONSTANT).reversed())):
            s, end, beyond = abs(t[where]), side.length, cycles(rates.about(side.end[:3]))
            found[where] = side.values(np.minimum(s, end))
            cycle[where] = np.where(s > end, turns(s, beyond) - turns(np.array([end]), beyond), 0)
        return found, cycle

    @cached_property
    def _cycle(self) -> Twofold:
        """The period in two doubles."""
        return pair(self.path.period(CONSTANT)[0])

    @cached_property
    def _length(self) -> float:
        """The length abs(M) in doubles."""
        with own_precision(CONSTANT):
            return double(self.size(CONSTANT))

    @cached_property
    def _common(self) -> Twofold:
        """The turns of the common rate in a unit of time."""
        with own_precision(CONSTANT):
            return cycles(self.common(CONSTANT))

    def values(self, t: Array) -> Array:
        """Return M at a row of times."""
        with own_precision(CONSTANT):
            return self._length * self.rows(t, M_ONLY)[0]

    def attitude(self, t: Array) -> Array:
        """Return R at a row of times."""
        with own_precision(CONSTANT):
            rows, cycle = self.rows(t, ROWS)
            return turned(np.roll(rows, 3, axis=1), turns(t, self._common) + cycle)

    def at(self, t: arb, bits: int, precision: int) -> list[arb]:
        """Return M at a time, to so many bits, from constants of a precision.

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
        """The period of M, None on a separatrix."""
        return double(self.path.period(CONSTANT)[0]) if self.path.periodic else None

    @cached_property
    def precession(self) -> float | None:
        """The angle gained about M in a period, that of φ of axis 3 if this axis is not along M.

        It is None on a separatrix.
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
        """The steps of a turn."""
        return len(self.loops(M_ONLY)[0].pieces)

    @property
    def error(self) -> float:
        """The error of M, in units of abs(M), estimated.

        It is the rounding of the time, and what the polynomials in doubles leave of the series.
        """
        turn, rates = self.loops(M_ONLY)[0], self.rates(CONSTANT)
        return ROUNDING * (8 + turn.length / rates.unit / 4) + turn.cut


@lru_cache(maxsize=32)
def _loops(repeated: RepeatedTurn, components: int, bits: int) -> tuple[Loop, Loop | None]:
    periodic, lost = repeated.path.periodic, bits + 64
    if periodic:
        with own_precision(64):
            lost = 2 * max(0, math.ceil(-float(repeated.path.period(64)[1].log()) / math.log(2)))
    if lost > MOST_LOST and periodic:
        raise AccuracyError(f"the turn of M is only 2^−{lost // 2} away from a separatrix, too close to be "
                            "integrated: give other numbers")
    for precision in (bits + lost + 16, bits + 2 * lost + 96, 2 * (bits + 2 * lost + 96)):
        with own_precision(precision + 64):
            u, k = frame(repeated.momentum, precision + 64)
            start, rates = [*k, *u][:components], repeated.rates(precision + 64)
            if not periodic:
                return loop(start, rates, precision, None), loop(start, rates.reversed(), precision, None)
            found = loop(start, rates, precision, repeated.path.period(precision)[0])
            if all(abs(x - y) < arb(2) ** -bits for x, y in zip(found.end, k)):
                return found, None
    raise AccuracyError(f"a turn of M does not close to {bits} bits: the motion is too close to a "
                        "separatrix; give other numbers")
