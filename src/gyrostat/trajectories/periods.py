"""Times of any length: periods and turns in two doubles, so that nothing grows with the number of periods."""
from typing import NamedTuple

import numpy as np
from flint import arb

from ..algebra.floats import Array
from ..algebra.precision import own_precision
from ..errors import AccuracyError, ValuesError

# periods: their number is exact, and so is their product with a turn, mod 1
LONGEST = 2.0**49
SPLIT = 2.0**27 + 1


class Pair(NamedTuple):
    """A number as the sum of two doubles, 106 bits of it."""

    high: float
    low: float


def pair(x: arb) -> Pair:
    """The two doubles nearest to the middle of an enclosure, one after the other.

    Examples
    --------
    >>> pair(arb(1) / 3)[0] == 1 / 3
    True
    """
    with own_precision(256):
        high = double(x)
        return Pair(high, double(x - arb(high)))


def double(x: arb) -> float:
    """The middle of an enclosure, correctly rounded; float(arb) truncates.

    Raises
    ------
    AccuracyError
        it encloses nothing: it is not finite
    """
    if not x.is_finite():
        raise AccuracyError("a constant of the motion is not enclosed at this precision: ask for fewer "
                            "digits, or give other numbers")
    mantissa, exponent = map(int, x.mid().man_exp())
    return mantissa / (1 << -exponent) if exponent < 0 else float(mantissa << exponent)


def product(x: Array, factor: Pair) -> tuple[Array, Array]:
    """x · factor as the rounded product with high and what it lacks, low included.

    References
    ----------
    Dekker, Numerische Mathematik 18 (1971) 224-242.
    """
    rounded = x * factor.high
    upper = x * SPLIT
    upper = upper - (upper - x)
    head = factor.high * SPLIT
    head = head - (head - factor.high)
    lower, tail = x - upper, factor.high - head
    return rounded, ((upper * head - rounded) + upper * tail + lower * head) + lower * tail + x * factor.low


def reduced(t: Array, period: Pair) -> tuple[Array, Array]:
    """(n, r) with t = n · period + r, abs(r) at most half a period, to the last bits of r.

    Raises
    ------
    ValuesError
        t is more than 5·10¹⁴ periods, or not finite

    Examples
    --------
    >>> with own_precision(128):
    ...     pi = arb.pi()
    >>> n, r = reduced(np.array([1e15]), pair(pi))
    >>> bool(abs(np.sin(1e15) - (-1)**n * np.sin(r))[0] < 1e-15)
    True
    """
    n = np.rint(t / period.high)
    if not (np.abs(n) <= LONGEST).all():
        worst = t[~(np.abs(n) <= LONGEST)].flat[0]
        raise ValuesError(f"t = {worst} is not within {LONGEST:.0e} periods of {period.high}: give a "
                          "finite, smaller time")
    whole, rest = product(n, period)
    return n, (t - whole) - rest


def turns(x: Array, delta: Pair) -> Array:
    """x · delta mod 1, between −1/2 and 1/2."""
    whole, rest = product(x, delta)
    part = (whole - np.rint(whole)) + rest
    return part - np.rint(part)
