"""Double-double arithmetic on numbers and arrays: a number is the sum of two doubles, 106 bits of it."""
from dataclasses import dataclass
from typing import Any

SPLITTER = 2.0**27 + 1


@dataclass(frozen=True)
class Twofold:
    """A number, or an array of numbers, as the sum of two doubles, 106 bits of it.

    Sums and products have relative errors of some 2⁻¹⁰⁴ if nothing cancels.

    References
    ----------
    Dekker, Numerische Mathematik 18 (1971) 224-242.

    Examples
    --------
    >>> third = Twofold(1 / 3, 1 / 54043195528445952)
    >>> third * Twofold(3.0, 0.0) - Twofold(1.0, 0.0)
    Twofold(high=0.0, low=0.0)
    """

    high: Any
    low: Any

    def __add__(self, other: "Twofold") -> "Twofold":
        high, error = two_sum(self.high, other.high)
        low, rest = two_sum(self.low, other.low)
        high, error = _quick_two_sum(high, error + low)
        return Twofold(*_quick_two_sum(high, error + rest))

    def __neg__(self) -> "Twofold":
        return Twofold(-self.high, -self.low)

    def __sub__(self, other: "Twofold") -> "Twofold":
        return self + -other

    def __mul__(self, other: "Twofold") -> "Twofold":
        high, error = two_product(self.high, other.high)
        return Twofold(*_quick_two_sum(high, error + (self.high * other.low + self.low * other.high)))


def two_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """Return (s, e) with a + b = s + e exactly, where s is the rounded sum (Knuth's two-sum)."""
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def two_product(a: Any, b: Any) -> tuple[Any, Any]:
    """Return (p, e) with a b = p + e exactly, where p is the rounded product (Dekker)."""
    p = a * b
    (a1, a2), (b1, b2) = _split(a), _split(b)
    return p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2


def scaled(x: Any, factor: Twofold) -> tuple[Any, Any]:
    """Return x·factor for doubles x: the rounded product with the high part, and what it lacks."""
    rounded, error = two_product(x, factor.high)
    return rounded, error + x * factor.low


def _quick_two_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """Return the two-sum of a and b if abs(a) ≥ abs(b) (Dekker's fast two-sum)."""
    s = a + b
    return s, b - (s - a)


def _split(a: Any) -> tuple[Any, Any]:
    """Return a as the sum of two numbers of 26 bits (Veltkamp's splitting)."""
    c = SPLITTER * a
    high = c - (c - a)
    return high, a - high
