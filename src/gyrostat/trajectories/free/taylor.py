"""Integrates a turn of M in any free gyrostat by Taylor's method, in whole numbers.

The turn is looked up mod the period.
"""
import math
from collections.abc import Sequence
from dataclasses import dataclass
from operator import mul

import numpy as np
from flint import arb

from ..._cached import cached_property
from ...algebra.enclosures.floats import Array
from ...errors import AccuracyError
from ...stability.criteria.amended_form import dot
from .uniform_motion import CYCLIC

# the order of polynomials in doubles; the steps in radii, planned and at most: e⁻⁴⁰ of the first term is left
ORDER, STEP, FARTHEST = 24, math.exp(-1.8), math.exp(-1.6)
# the longest step in units of time: if M nearly rests, small coefficients are lost, and noise grows
LONGEST = 16
STEPS = 4000                                               # a turn that takes more is refused

Vector = Sequence[arb]


@dataclass(frozen=True)
class Rates:
    """The rates in v̇ = v × (spread · M + constant), for M, of length 1, and any vector fixed in space.

    Parameters
    ----------
    spread : three enclosures
        abs(M) / Iᵢ less a common part, which turns everything about M [1/T]
    constant : three enclosures
        −lᵢ / Iᵢ [1/T]
    """

    spread: Vector
    constant: Vector

    @cached_property
    def unit(self) -> float:
        """The time in which little happens: the inverse of the sum of all rates."""
        return 1 / math.fsum(abs(float(x)) for x in (*self.spread, *self.constant))

    def about(self, M: Vector) -> arb:
        """Return the rate of turning about M."""
        return dot([d * x + c for d, x, c in zip(self.spread, M, self.constant)], M)

    def reversed(self) -> "Rates":
        """Return the rates of the motion in reversed time."""
        return Rates([-x for x in self.spread], [-x for x in self.constant])


@dataclass(frozen=True)
class Piece:
    """A step: its start, its length, and the coefficients of its series.

    The series is in the part of the step that has passed; coefficients are times 2^precision.
    """

    start: float
    length: arb
    coefficients: list[list[int]]


@dataclass(frozen=True)
class Loop:
    """Pieces of a motion from time 0 on, one after the other."""

    pieces: list[Piece]
    precision: int

    @cached_property
    def end(self) -> list[arb]:
        """The vectors at the end of the last piece."""
        return [arb(sum(row)) * arb(2) ** -self.precision for row in self.pieces[-1].coefficients]

    @cached_property
    def length(self) -> float:
        """The time from the first piece to the end of the last."""
        return self.pieces[-1].start + float(self.pieces[-1].length)

    @cached_property
    def cut(self) -> float:
        """What the polynomials in doubles leave of the series."""
        return max(sum(map(abs, row[ORDER + 1:])) / (1 << self.precision) for piece in self.pieces
                   for row in piece.coefficients)

    def at(self, t: arb) -> list[arb]:
        """Return the vectors at a time from 0 to the end."""
        piece = [piece for piece in self.pieces if piece.start == 0 or t > piece.start][-1]
        part = (t - piece.start) / piece.length
        found = []
        for row in piece.coefficients:
            value = arb(0)
            for c in reversed(row):
                value = value * part + c
            found.append(value * arb(2) ** -self.precision)
        return found

    @cached_property
    def table(self) -> tuple[Array, Array, Array]:
        """The starts, lengths, and coefficients from the highest down, in doubles."""
        unit = 1 << self.precision
        rows = [[[c / unit for c in row[ORDER::-1]] for row in piece.coefficients] for piece in self.pieces]
        return (np.array([piece.start for piece in self.pieces]),
                np.array([float(piece.length) for piece in self.pieces]),
                np.ascontiguousarray(np.array(rows).T))

    def values(self, t: Array, period: float = 0.0) -> Array:
        """Return the vectors at a row of times from 0 to the end.

        If the motion is periodic, times go from minus half a period.
        """
        starts, lengths, coefficients = self.table
        if period:
            starts = np.concatenate([starts - period, starts])
        place = np.clip(np.searchsorted(starts, t, side="right") - 1, 0, None)
        piece = place % len(lengths)
        part = (t - starts[place]) / lengths[piece]
        value = coefficients[0].take(piece, axis=1)
        for row in coefficients[1:]:
            value *= part
            value += row.take(piece, axis=1)
        return value.T


def whole(x: arb, precision: int) -> int:
    """Return the middle of an enclosure times 2^precision, rounded down."""
    return int((x.mid() * arb(2) ** precision).mid().floor().unique_fmpz())


def series(start: Sequence[int], spread: Sequence[int], constant: Sequence[int], order: int,
           precision: int) -> list[list[int]]:
    """Return the Taylor coefficients of v̇ = v × (spread · M + constant), M being the first vector.

    Every number is times 2^precision.
    """
    rows = [[x] for x in start]
    (x, y, z), others = rows[:3], [rows[i:i + 3] for i in range(3, len(rows), 3)]
    a, b, c = spread[2] - spread[1], spread[0] - spread[2], spread[1] - spread[0]
    p, q, r = constant
    turning = [[(d * x >> precision) + c] for d, x, c in zip(spread, start, constant)]
    for n in range(1, order + 1):
        # M_j M_k is one product, not two
        yz, zx, xy = (sum(map(mul, u, reversed(v))) >> precision for u, v in ((y, z), (z, x), (x, y)))
        u, v, w = x[-1], y[-1], z[-1]
        new = [(a * yz + v * r - w * q) // n >> precision, (b * zx + w * p - u * r) // n >> precision,
               (c * xy + u * q - v * p) // n >> precision]
        for other in others:
            new += [(sum(map(mul, other[j], reversed(turning[k])))
                     - sum(map(mul, other[k], reversed(turning[j])))) // n >> precision
                    for _, j, k in CYCLIC]
        for row, value in zip(rows, new):
            row.append(value)
        if others:
            for omega, d, value in zip(turning, spread, new):
                omega.append(d * value >> precision)
    return rows


def loop(start: Vector, rates: Rates, precision: int, end: arb | None) -> Loop:
    """Return the motion from a start, M and then other vectors, for a time, or until M rests.

    If the time is None, it is followed until M rests to half the precision. Each step is about e^1.8 times
    shorter than the radius of convergence, estimated from the coefficients of orders 23 and 24: those of the
    step before, from which it differs by that step at most; one that turns out too long is taken again.

    Raises
    ------
    AccuracyError
        more than 4000 steps are needed

    References
    ----------
    Jorba & Zou, Experimental Mathematics 14 (2005) 99-117.
    """
    order = max(math.ceil(0.45 * precision), ORDER)
    vectors, now, found = [whole(x, precision) for x in start], 0.0, list[Piece]()
    planned = rates.unit

    def moved(length: arb, degree: int) -> list[list[int]]:
        spread, constant = ([whole(x * length, precision) for x in part]
                            for part in (rates.spread, rates.constant))
        return series(vectors, spread, constant, degree, precision)

    while len(found) < STEPS:
        after = now + planned
        last = end is not None and not after < end
        length = end - now if last and end is not None else arb(after) - now
        rows = moved(length, order)
        radius = min(2.0 ** ((precision - math.log2(max(abs(row[n]) for row in rows) or 1)) / n)
                     for n in (ORDER - 1, ORDER))
        planned = min(radius * STEP * float(length), LONGEST * rates.unit)
        if radius * FARTHEST < 1:
            continue
        found.append(Piece(now, length, rows))
        if last or end is None and max(abs(row[1]) for row in rows[:3]) < 1 << precision // 2 + 32:
            return Loop(found, precision)
        vectors, now = [sum(row) for row in rows], after
    raise AccuracyError(f"a turn of M takes more than {STEPS} steps, up to the time {now}: integrate the "
                        "equations of motion instead")
