"""Interval arithmetic on arrays, rounded outward after every operation."""
import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from flint import arb
from sympy import Expr

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.double_double import two_sum
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.rationals import to_sympy
from ...algebra.reals.exact import sign_of_constant

# bits of the enclosures that are rounded to float64: more than its 53, so that few roundings are doubtful
PRECISION = 64


@dataclass(frozen=True, eq=False)
class Enclosure:
    """The bounds of a quantity, an entry for each box; (−∞, ∞) if nothing is known, never NaN.

    Sums and products are rounded outward, unless a sum, or a product of short numbers, is exact.

    Parameters
    ----------
    low, high : array, shape (boxes,) or ()
        floats, low ≤ high

    References
    ----------
    Moore, Kearfott & Cloud, Introduction to Interval Analysis (2009), chapters 2 and 3.

    Examples
    --------
    >>> from sympy import Rational
    >>> one = enclosed(Rational(3)) * enclosed(Rational(1, 3))
    >>> bool(one.low < 1 < one.high)
    True
    """

    low: Array
    high: Array

    @cached_property
    def short(self) -> Array:
        """Whether both ends are numbers of single precision: their products are exact in double precision."""
        low, high = np.asarray(self.low), np.asarray(self.high)
        return (low.astype(np.float32) == low) & (high.astype(np.float32) == high)

    @property
    def apart(self) -> Array:
        """The boxes on which 0 is excluded, as an array of booleans."""
        return (self.low > 0) | (self.high < 0)

    def where(self, known: Array) -> "Enclosure":
        """Return the same bounds where something is known, and the whole line elsewhere."""
        return Enclosure(np.where(known, self.low, -np.inf), np.where(known, self.high, np.inf))

    def __and__(self, other: "Enclosure") -> "Enclosure":
        """Return what two enclosures of one quantity say together."""
        return Enclosure(np.maximum(self.low, other.low), np.minimum(self.high, other.high))

    def __add__(self, other: "Enclosure") -> "Enclosure":
        (low, low_exact), (high, high_exact) = _sum(self.low, other.low), _sum(self.high, other.high)
        return outward(low, high, low_exact, high_exact)

    def __neg__(self) -> "Enclosure":
        return Enclosure(-self.high, -self.low)

    def __sub__(self, other: "Enclosure") -> "Enclosure":
        return self + -other

    def __mul__(self, other: "Enclosure") -> "Enclosure":
        """Return the product; if it is one quantity with itself, the square, which is not negative."""
        exact = self.short & other.short
        if self is other:
            ends = self.low * self.low, self.high * self.high
            square = outward(np.minimum(*ends), np.maximum(*ends), exact, exact)
            return Enclosure(np.where(self.apart, np.maximum(square.low, 0), 0.0), square.high)
        products = self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high
        low, high = (bound(bound(*products[:2]), bound(*products[2:])) for bound in (np.minimum, np.maximum))
        return outward(low, high, exact, exact)

    def reciprocal(self) -> "Enclosure":
        """Return 1/x, the whole line where 0 is not excluded."""
        return outward(1 / self.high, 1 / self.low).where(self.apart)


def outward(low: Array, high: Array, low_exact: Array | bool = False,
             high_exact: Array | bool = False) -> Enclosure:
    """Return bounds that were rounded to nearest, moved by one float unless they are exact.

    They are the whole line where an operation was undefined.
    """
    low = np.where(low_exact, low, np.nextafter(low, -np.inf))
    high = np.where(high_exact, high, np.nextafter(high, np.inf))
    return Enclosure(np.where(np.isnan(low), -np.inf, low), np.where(np.isnan(high), np.inf, high))


def _sum(a: Array, b: Array) -> tuple[Array, Array]:
    """Return a + b, and whether it is exact: its error, which Knuth's two-sum gives, is 0.

    An overflow gives NaN as its error, which is not 0.
    """
    total, error = two_sum(a, b)
    return total, error == 0


@lru_cache(maxsize=4096)
def rounded(number: Expr) -> tuple[float, float]:
    """Return the greatest float not above an exact real number, and the least not below it.

    They are infinite beyond the range.

    Examples
    --------
    >>> from sympy import Rational, S, sqrt
    >>> rounded(S.Half), rounded(sqrt(2))
    ((0.5, 0.5), (1.414213562373095, 1.4142135623730951))
    >>> rounded(Rational(10)**400)
    (1.7976931348623157e+308, inf)
    """
    low, high = bounds_of(ball(number, 2 * PRECISION), ball(number, 2 * PRECISION))
    # the ball leaves a few floats at most between both; if it leaves more, the bounds are only wider
    for _ in range(4):
        if _not_below(number, above := math.nextafter(low, math.inf)):
            low = above
        if _not_below(-number, above := math.nextafter(-high, math.inf)):
            high = -above
    return low + 0.0, high + 0.0                           # 0, not -0


def _not_below(number: Expr, bound: float) -> bool:
    return math.isfinite(bound) and sign_of_constant(number - to_sympy(bound)) in (0, 1)


def enclosed(constant: Expr) -> Enclosure:
    """Return the enclosure of an exact constant, between neighbouring floats."""
    low, high = rounded(constant)
    return Enclosure(np.asarray(low), np.asarray(high))


def bounds_of(low: arb, high: arb) -> tuple[float, float]:
    """Return floats below one ball and above the other; the whole line if one is not finite."""
    if not (low.is_finite() and high.is_finite()):
        return -np.inf, np.inf
    return math.nextafter(float(low.lower()), -math.inf), math.nextafter(float(high.upper()), math.inf)
