"""Free motions that are uniform: rest, permanent rotation, bodies of revolution, three equal moments.

Here are also frames, and the signs that decide which motion it is.
"""
import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from flint import arb
from sympy import Expr, Integer, sqrt

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.double_double import Twofold
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import doubled, own_precision
from ...algebra.reals.exact import proved_sign
from ...algebra.rings.matrices import cross
from ...algebra.text.numbers import shown
from ...errors import AccuracyError, ValuesError
from ...stability.criteria.amended_form import dot
from ..circle import circle
from ..periods import double, pair, turns

Triple = tuple[Expr, Expr, Expr]
CONSTANT = 192                                             # bits of constants for results in doubles
# bits at which one gives up a number that is known not to be zero
MOST = 16384
ROUNDING = 2.0**-52
CYCLIC = ((0, 1, 2), (1, 2, 0), (2, 0, 1))
AXES = tuple((Integer(k == 0), Integer(k == 1), Integer(k == 2)) for k in range(3))


def decided(constant: Expr, what: str) -> int:
    """Return the sign of a constant on which it depends what the motion is.

    Raises
    ------
    ValuesError
        it is not proved: the number is transcendental and 0, or very nearly
    """
    return proved_sign(constant, lambda: ValuesError(
        f"the sign of {what}, about {shown(constant)}, is undecided: give rational or algebraic numbers"))


def accurate(compute: Callable[[int], list[arb]], bits: int) -> list[arb]:
    """Return enclosures of at least so many correct bits each, by doubling the working precision."""
    for precision in doubled(bits + 64, MOST):
        with own_precision(precision):
            found = compute(precision)
        if all(x == 0 or x.rel_accuracy_bits() >= bits for x in found):
            return found
    raise AccuracyError(f"{MOST} bits do not give {bits} correct ones: the motion is too close to a "
                        "separatrix; give other numbers")


def cycles(rate: arb) -> Twofold:
    """Return the full turns in a unit of time."""
    return pair(rate / (2 * arb.pi()))


def frame(up: Triple, bits: int) -> tuple[list[arb], list[arb]]:
    """Return the space axes x and z in body components at the time 0.

    z is the upward direction, and x is chosen so that φ = 0, and also ψ = 0 if z is ± axis 3.
    """
    z = [ball(x, bits) for x in up]
    k = [x / dot(z, z).sqrt() for x in z]
    if decided(up[0], "M1") == decided(up[1], "M2") == 0:
        return [arb(1), arb(0), arb(0)], k
    across = (k[0] * k[0] + k[1] * k[1]).sqrt()
    return [k[1] / across, -k[0] / across, arb(0)], k


def turned(rows: Array, cycle: Array) -> Array:
    """Return Rz(2π cycle) R, at a row of cycles, from the rows x and z of R."""
    x, z = rows[:, :3], rows[:, 3:]
    y = np.cross(z, x)
    c, s = (part[:, None] for part in circle(cycle))
    return np.stack([c * x - s * y, s * x + c * y, z], axis=1)


@dataclass(frozen=True)
class Steady:
    """The uniform rotation R = Rz(rate · t) R(0) Rot(axis, about · t).

    ω is the sum of two parts: one is fixed in space, the other in the body. A body at rest or in permanent
    rotation (about = 0), a body of revolution with l on its axis, and a body with three equal moments move in
    this way.

    Parameters
    ----------
    momentum, up, axis : three Expr
        M at the time 0; the space z axis and a unit vector, in body components
    rate, about : Expr
        the rates about z and about the axis [1/T]
    """

    momentum: Triple
    up: Triple
    rate: Expr
    axis: Triple
    about: Expr

    nodes, error = 0, 8 * ROUNDING

    @cached_property
    def constants(self) -> tuple[Array, Array, Array, Twofold, Twofold]:
        """In doubles M, the rows x and z of R(0), the axis; cycles about z and about the axis."""
        with own_precision(CONSTANT):
            M, n = (np.array([double(ball(x, CONSTANT)) for x in v]) for v in (self.momentum, self.axis))
            rows = np.array([[double(x) for x in v] for v in frame(self.up, CONSTANT)])
            return M, rows, n, cycles(ball(self.rate, CONSTANT)), cycles(ball(self.about, CONSTANT))

    def seen(self, vectors: Array, t: Array) -> Array:
        """Return body components of vectors that are fixed in space, shape (times, vectors, 3).

        The vectors are given by their body components at the time 0; the times are a row.
        """
        _, _, n, _, cycle = self.constants
        cosine, sine = (part[:, None, None] for part in circle(turns(t, cycle)))
        along = (vectors @ n)[:, None] * n
        return along + cosine * (vectors - along) + sine * np.cross(vectors, n)

    def values(self, t: Array) -> Array:
        """Return M at a row of times."""
        return self.seen(self.constants[0][None], t)[:, 0]

    def attitude(self, t: Array) -> Array:
        """Return R at a row of times."""
        return turned(self.seen(self.constants[1], t).reshape(-1, 6), turns(t, self.constants[3]))

    def at(self, t: arb, _: int, precision: int) -> list[arb]:
        """Return M at a time, from constants of a precision."""
        M, n = ([ball(x, precision) for x in v] for v in (self.momentum, self.axis))
        angle = ball(self.about, precision) * t
        return [dot(M, n) * y + angle.cos() * (x - dot(M, n) * y) + angle.sin() * z
                for x, y, z in zip(M, n, cross(M, n))]

    @cached_property
    def period(self) -> float | None:
        """The period of M, None if it rests."""
        return None if self.about == 0 else 2 * math.pi / abs(float(self.about))

    @cached_property
    def precession(self) -> float:
        """The angle gained about M in a period, or in a unit of time if M rests."""
        return float(self.rate) * (self.period or 1.0)


def steady(inertia: Triple, rotor: Triple, M: Triple) -> Steady | None:
    """Return the motion from M at the time 0, if it is uniform; else None.

    Examples
    --------
    >>> from sympy import Integer
    >>> one, two, zero = map(Integer, (1, 2, 0))
    >>> motion = steady((one, one, two), (zero, zero, one), (one, zero, two))
    >>> motion.rate, motion.about
    (sqrt(5), -3/2)
    """
    I, l, size = inertia, rotor, sqrt(sum(x**2 for x in M))
    omega = ((M[0] - l[0]) / I[0], (M[1] - l[1]) / I[1], (M[2] - l[2]) / I[2])
    if not any(decided(M[i] * omega[j] - M[j] * omega[i], "a component of M × ω") for i, j, _ in CYCLIC):
        up = next((v for v in (M, omega) if any(decided(x, "a component of M or ω") for x in v)), AXES[2])
        return Steady(M, up, sum(x * y for x, y in zip(up, omega)) / sqrt(sum(x**2 for x in up)), AXES[2],
                      Integer(0))
    equal = [decided(I[i] - I[j], "a difference of moments") == 0 for i, j, _ in CYCLIC]
    if all(equal):
        turning = sqrt(sum(x**2 for x in l))
        return Steady(M, M, size / I[0], (l[0] / turning, l[1] / turning, l[2] / turning), -turning / I[0])
    for same, (i, j, k) in zip(equal, CYCLIC):
        if same and decided(l[i], "l") == decided(l[j], "l") == 0:
            return Steady(M, M, size / I[i], AXES[k], omega[k] - M[k] / I[i])
    return None
