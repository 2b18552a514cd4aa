"""Sums of two doubles, the second below the last bit of the first: arithmetic of 106 bits on arrays."""
from typing import Any, NamedTuple

SPLITTER = 2.0**27 + 1


class Twofold(NamedTuple):
    """A number, or an array of numbers, as the sum of two doubles, 106 bits of it."""

    high: Any
    low: Any


class TwofoldArithmetic:
    """Sums of two doubles, for straight-line programs; relative errors of some 2⁻¹⁰⁴ where nothing cancels.

    References
    ----------
    Dekker, Numerische Mathematik 18 (1971) 224-242.

    Examples
    --------
    >>> import numpy as np
    >>> one, three = (Twofold(np.float64(n), np.float64(0)) for n in (1, 3))
    >>> third = Twofold(np.float64(1 / 3), np.float64(1 / 54043195528445952))
    >>> TwofoldArithmetic.subtract(TwofoldArithmetic.multiply(third, three), one)
    Twofold(high=np.float64(0.0), low=np.float64(0.0))
    """

    @staticmethod
    def add(a: Twofold, b: Twofold) -> Twofold:
        high, error = two_sum(a.high, b.high)
        low, rest = two_sum(a.low, b.low)
        high, error = _quick_two_sum(high, error + low)
        return _quick_two_sum(high, error + rest)

    @staticmethod
    def subtract(a: Twofold, b: Twofold) -> Twofold:
        return TwofoldArithmetic.add(a, TwofoldArithmetic.negative(b))

    @staticmethod
    def multiply(a: Twofold, b: Twofold) -> Twofold:
        high, error = two_product(a.high, b.high)
        return _quick_two_sum(high, error + (a.high * b.low + a.low * b.high))

    @staticmethod
    def negative(a: Twofold) -> Twofold:
        return Twofold(-a.high, -a.low)


def two_sum(a: Any, b: Any) -> Twofold:
    """a + b = s + e, exactly: Knuth's two-sum, s the rounded sum."""
    s = a + b
    t = s - a
    return Twofold(s, (a - (s - t)) + (b - t))


def two_product(a: Any, b: Any) -> Twofold:
    """a b = p + e, exactly: Dekker's product, p the rounded one."""
    p = a * b
    (a1, a2), (b1, b2) = _split(a), _split(b)
    return Twofold(p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2)


def scaled(x: Any, factor: Twofold) -> Twofold:
    """x factor for doubles x: the rounded product with high, and what it lacks, low included."""
    rounded, error = two_product(x, factor.high)
    return Twofold(rounded, error + x * factor.low)


def _quick_two_sum(a: Any, b: Any) -> Twofold:
    """The two-sum where abs(a) ≥ abs(b)."""
    s = a + b
    return Twofold(s, b - (s - a))


def _split(a: Any) -> tuple[Any, Any]:
    """a as the sum of two numbers of 26 bits, by Veltkamp's splitting."""
    c = SPLITTER * a
    high = c - (c - a)
    return high, a - high
