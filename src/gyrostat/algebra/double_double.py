"""Sums of two doubles, the second below the last bit of the first: arithmetic of 106 bits on arrays."""
from typing import Any

Twofold = tuple[Any, Any]
_SPLIT = 2.0**27 + 1


class TwofoldArithmetic:
    """Sums of two doubles, for straight-line programs; relative errors of some 2⁻¹⁰⁴ where nothing cancels.

    Examples
    --------
    >>> import numpy as np
    >>> one, three = ((np.float64(n), np.float64(0)) for n in (1, 3))
    >>> third = np.float64(1 / 3), np.float64(1 / 54043195528445952)
    >>> TwofoldArithmetic.subtract(TwofoldArithmetic.multiply(third, three), one)
    (np.float64(0.0), np.float64(0.0))
    """

    @staticmethod
    def add(a: Twofold, b: Twofold) -> Twofold:
        high, error = _sum(a[0], b[0])
        low, rest = _sum(a[1], b[1])
        high, error = _quick(high, error + low)
        return _quick(high, error + rest)

    @staticmethod
    def subtract(a: Twofold, b: Twofold) -> Twofold:
        return TwofoldArithmetic.add(a, (-b[0], -b[1]))

    @staticmethod
    def multiply(a: Twofold, b: Twofold) -> Twofold:
        high, error = _product(a[0], b[0])
        return _quick(high, error + (a[0] * b[1] + a[1] * b[0]))

    @staticmethod
    def negative(a: Twofold) -> Twofold:
        return -a[0], -a[1]


def _sum(a: Any, b: Any) -> Twofold:
    """a + b = s + e, exactly."""
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def _quick(a: Any, b: Any) -> Twofold:
    """The same where abs(a) ≥ abs(b)."""
    s = a + b
    return s, b - (s - a)


def _product(a: Any, b: Any) -> Twofold:
    """a b = p + e, exactly."""
    p = a * b
    (a1, a2), (b1, b2) = _halves(a), _halves(b)
    return p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2


def _halves(a: Any) -> Twofold:
    """a as the sum of two numbers of 26 bits."""
    c = _SPLIT * a
    high = c - (c - a)
    return high, a - high
