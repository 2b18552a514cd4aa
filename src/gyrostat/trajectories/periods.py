"""Reduces times of any length by periods and turns in two doubles: no error grows with their number."""
from contextlib import suppress

import numpy as np
from flint import arb
from sympy import Expr, Rational

from ..algebra.enclosures.balls import accurate
from ..algebra.enclosures.double_double import Twofold, scaled
from ..algebra.enclosures.floats import Array
from ..algebra.enclosures.precision import own_precision
from ..errors import AccuracyError, ValuesError

# the most periods: their number is exact in doubles, and so is its product with a turn, mod 1
LONGEST = 2.0**49
DOUBLE = 64                                                # bits of a number that is rounded to a double


def pair(x: arb) -> Twofold:
    """Return the two doubles nearest to the middle of an enclosure, one after the other.

    Examples
    --------
    >>> pair(arb(1) / 3).high == 1 / 3
    True
    """
    with own_precision(256):
        high = double(x)
        return Twofold(high, double(x - arb(high)))


def double(x: arb) -> float:
    """Return the middle of an enclosure, correctly rounded; float(arb) truncates.

    Raises
    ------
    AccuracyError
        the enclosure is not finite, or beyond doubles
    """
    if not x.is_finite():
        raise AccuracyError("a constant of the motion is not enclosed at this precision: ask for fewer "
                            "digits, or give other numbers")
    mantissa, exponent = map(int, x.mid().man_exp())
    try:
        return mantissa / (1 << -exponent) if exponent < 0 else float(mantissa << exponent)
    except OverflowError:
        raise AccuracyError("a constant of the motion is above 1.8e308, beyond doubles: give the numbers in "
                            "other units") from None


def nearest(number: Expr) -> float:
    """Return the double nearest to an exact number.

    Examples
    --------
    >>> from sympy import Rational, sqrt
    >>> nearest(Rational(1, 3)) == 1 / 3, nearest(sqrt(10**40 + 1) - 10**20)
    (True, 5e-21)
    """
    if isinstance(number, Rational):
        with suppress(OverflowError):
            return int(number.p) / int(number.q)
    enclosure = accurate(number, DOUBLE)
    return double(enclosure) if enclosure.is_finite() else float(number)


def reduced(t: Array, period: Twofold) -> tuple[Array, Array]:
    """Return (n, r) with t = n · period + r, abs(r) at most half a period, to the last bits of r.

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
    whole, rest = scaled(n, period)
    return n, (t - whole) - rest


def turns(x: Array, delta: Twofold) -> Array:
    """Return x · delta mod 1, between −1/2 and 1/2."""
    whole, rest = scaled(x, delta)
    part = (whole - np.rint(whole)) + rest
    return part - np.rint(part)
