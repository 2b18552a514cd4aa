"""The momentum of a free body of three different moments, in Jacobi's functions.

The period of M in every free gyrostat follows from the elliptic curve of a pencil of quadrics.
"""
from dataclasses import dataclass
from functools import lru_cache
from itertools import permutations
from typing import Any

import numpy as np
from flint import arb
from sympy import Expr, Integer

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.double_double import Twofold
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import own_precision
from ...errors import AccuracyError
from ..elliptic import argument, jacobi, jacobi_ball, quarter_period
from ..periods import double, pair, reduced
from .uniform_motion import CONSTANT, CYCLIC, ROUNDING, Triple, accurate, decided

SMALLEST = 1e-300                                          # the smallest m1 that doubles hold with room


@dataclass(frozen=True)
class Polhode:
    """The momentum M_a = A_a cn u, M_b = A_b sn u, M_c = A_c dn u, with u = rate · t + phase.

    c is the axis about which M goes around, b that of the intermediate moment. On the separatrix m1 = 0, and
    c is that of the largest.

    Parameters
    ----------
    inertia, momentum : three Expr
        Iᵢ, and M at the time 0
    axes : (a, b, c)
        a permutation of 0, 1, 2
    signs : (1 or −1, ...)
        the signs of A_a, A_b, A_c
    periodic : bool
        whether M is not on the separatrix

    References
    ----------
    Landau & Lifshitz, Mechanics, §37, the constants (37.8)-(37.11) written as sums of positive terms.
    """

    inertia: Triple
    momentum: Triple
    axes: tuple[int, int, int]
    signs: tuple[int, int, int]
    periodic: bool

    def period(self, bits: int) -> list[arb]:
        """Return the period and m1, which says how near the separatrix is."""
        *_, rate, complement, _ = constants(self, bits)
        with own_precision(bits + 64):
            return [4 * quarter_period(complement) / rate, complement]

    @property
    def error(self) -> float:
        """The error of M, in units of abs(M), estimated: the rounding of u."""
        *_, rate, _, _ = constants(self, CONSTANT)
        return ROUNDING * (8 + (float(rate * self.period(CONSTANT)[0]) if self.periodic else 0))

    @cached_property
    def _rounded(self) -> list[float]:
        """The constants in doubles."""
        return [double(x) for x in constants(self, CONSTANT)]

    @cached_property
    def _half(self) -> Twofold | None:
        """Half the period in two doubles; after it M_a and M_b have the other sign."""
        if not self.periodic:
            return None
        whole = pair(self.period(CONSTANT)[0])
        return Twofold(whole.high / 2, whole.low / 2)

    def values(self, t: Array) -> Array:
        """Return M at a row of times."""
        *sizes, rate, complement, phase = self._rounded
        if self.periodic and complement < SMALLEST:
            raise AccuracyError(f"m1 = {complement}: the motion is too near a separatrix for doubles; give "
                                "other numbers, or a precision")
        sign: Any = 1.0
        if self._half:
            n, t = reduced(t, self._half)
            sign = 1 - 4 * np.abs(n / 2 - np.rint(n / 2))
        sn, cn, dn = jacobi(rate * t + phase, complement)
        M = np.empty((len(t), 3))
        for axis, size, part in zip(self.axes, sizes, (sign * cn, sign * sn, dn)):
            np.multiply(size, part, out=M[:, axis])
        return M

    def at(self, t: arb, _: int, precision: int) -> list[arb]:
        """Return M at a time, from constants of a precision."""
        *sizes, rate, complement, phase = constants(self, precision)
        sn, cn, dn = jacobi_ball(rate * t + phase, complement)
        parts = dict(zip(self.axes, (size * part for size, part in zip(sizes, (cn, sn, dn)))))
        return [parts[axis] for axis in range(3)]


def polhode(inertia: Triple, momentum: Triple) -> Polhode:
    """Return the motion of a free body of three different moments, M not at rest.

    Examples
    --------
    >>> from sympy import Integer, Rational
    >>> moments = tuple(map(Integer, (1, 2, 3)))
    >>> M = Rational(3, 10), Rational(1, 5), Rational(9, 10)
    >>> polhode(moments, M).axes
    (0, 1, 2)
    """
    low, middle, high = order = next((i, j, k) for i, j, k in permutations(range(3)) if all(
        decided(inertia[b] - inertia[a], "a difference of moments") > 0 for a, b in ((i, j), (j, k))))
    I, M = inertia, momentum
    gap = M[high] ** 2 * (1 - I[middle] / I[high]) - M[low] ** 2 * (I[middle] / I[low] - 1)
    side = decided(gap, "M² − 2 E I for the intermediate moment")
    a, b, c = axes = order if side >= 0 else (high, middle, low)
    # the way around: Ṁ_b ∝ M_c M_a (1/I_a − 1/I_c)
    turn = 1 if (axes in ((0, 1, 2), (1, 2, 0), (2, 0, 1))) == (side >= 0) else -1
    first, second, third = (decided(M[i], f"M{i + 1}") for i in axes)
    if side == 0:
        second = turn * first * third
    second = second or 1
    return Polhode(inertia, momentum, axes, (turn * second * third, second, third), side != 0)


@lru_cache(maxsize=64)
def constants(motion: Polhode, bits: int) -> list[arb]:
    """Return A_a, A_b, A_c, rate, m1 and phase."""
    (Ia, Ma), (Ib, Mb), (Ic, Mc) = ((motion.inertia[i], motion.momentum[i]) for i in motion.axes)
    squares = (Ma**2 + Mb**2 * (Ia * (Ic - Ib) / (Ib * (Ic - Ia))),
               Mb**2 + Ma**2 * (Ib * (Ic - Ia) / (Ia * (Ic - Ib))),
               Mc**2 + Mb**2 * (Ic * (Ib - Ia) / (Ib * (Ic - Ia))), (1 / Ib - 1 / Ic) * (1 / Ia - 1 / Ic))
    # M² − 2 E I_b up to a factor, as a sum in which only this difference can cancel
    gap = (Mc**2 * (1 - Ib / Ic) - Ma**2 * (Ib / Ia - 1)) * ((Ic - Ia) / (Ic - Ib))
    lead = Mb**2 * (1 - Ia / Ib) + Mc**2 * (1 - Ia / Ic)

    def compute(precision: int) -> list[arb]:
        *sizes, rate = (ball(square, precision).sqrt() for square in squares)
        complement = ball(gap / lead, precision) if motion.periodic else arb(0)
        A, B, C = (sign * size for sign, size in zip(motion.signs, sizes))
        phase = argument(ball(Mb, precision) / B, ball(Ma, precision) / A, complement)
        return [A, B, C, rate * sizes[2], complement, phase]

    return accurate(compute, bits)


def invariants(inertia: Triple, rotor: Triple, momentum: Triple) -> tuple[Expr, Expr, Expr]:
    """Return the invariants g2, g3 and g2³ − 27 g3² of the curve y² = det(B − λ A).

    A is the quadric abs(M)² = m², and B is Σ (Mᵢ − lᵢ)²/Iᵢ = 2 h. M moves along the intersection of the two,
    and the curve has the same real period.
    """
    e, square = [1 / moment for moment in inertia], sum(x**2 for x in momentum)
    factor = [sum(y * x * (2 * z - x) for x, y, z in zip(momentum, e, rotor)), square]
    p = _product(factor, [e[0], -1], [e[1], -1], [e[2], -1])
    for j, k, i in CYCLIC:
        lower = _product([(rotor[i] * e[i]) ** 2], [e[j], -1], [e[k], -1])
        p[:3] = [x - y for x, y in zip(p, lower)]
    a, b, c, d, f = p[4], p[3] / 4, p[2] / 6, p[1] / 4, p[0]
    g2 = a * f - 4 * b * d + 3 * c**2
    g3 = a * c * f + 2 * b * c * d - a * d**2 - b**2 * f - c**3
    return g2, g3, g2**3 - 27 * g3**2


def _product(*factors: list[Expr]) -> list[Expr]:
    result = [Integer(1)]
    for factor in factors:
        result = [sum(result[i] * factor[n - i] for i in range(len(result)) if 0 <= n - i < len(factor))
                  for n in range(len(result) + len(factor) - 1)]
    return result


@dataclass(frozen=True)
class Meeting:
    """The real period of y² = 4 x³ − g2 x − g3, from invariants that are exact.

    Parameters
    ----------
    g2, g3, discriminant : Expr
    sign : int
        of the discriminant g2³ − 27 g3²
    """

    g2: Expr
    g3: Expr
    discriminant: Expr
    sign: int

    @property
    def periodic(self) -> bool:
        """Whether the period is finite.

        It is not if a double root is larger than the third one: then g3 = −8 e³ is negative.
        """
        return self.sign != 0 or decided(self.g3, "the invariant g3") > 0

    def period(self, bits: int) -> list[arb]:
        """Return the period π / agm(√u, √v) and v/u, which says how near the separatrix is.

        For three real roots u = e1 − e3 and v = e1 − e2. For one real root e, u = H and v = H/2 + 3 e/4,
        where H² = 3 e² − g2/4.

        References
        ----------
        Abramowitz & Stegun, 18.9; Viète's and Cardano's roots.
        """
        return accurate(self._period, bits)

    def _period(self, precision: int) -> list[arb]:
        g2, g3 = ball(self.g2, precision), ball(self.g3, precision)
        d = ball(self.discriminant, precision) if self.sign else arb(0)
        if self.sign >= 0:
            angle = arb.atan2(d.sqrt(), -g3 * arb(27).sqrt())
            u, v = g2.sqrt() * ((2 * arb.pi() - angle) / 3).sin(), g2.sqrt() * (angle / 3).sin()
        else:
            w = (abs(g3) + (-d / 27).sqrt()).root(3) / (2 if g3 > 0 else -2)
            e = w + g2 / (12 * w)
            u = (3 * e * e - g2 / 4).sqrt()
            v = u / 2 + 3 * e / 4
        return [arb.pi() / u.sqrt().agm(v.sqrt()), v / u]


def meeting(inertia: Triple, rotor: Triple, momentum: Triple) -> Meeting:
    """Return the period of M in a gyrostat, decided exactly.

    Raises
    ------
    ValuesError
        whether M moves on a separatrix, is undecided
    """
    g2, g3, discriminant = invariants(inertia, rotor, momentum)
    return Meeting(g2, g3, discriminant, decided(discriminant,
                                                 "the discriminant of the pencil of |M|² and the energy"))
