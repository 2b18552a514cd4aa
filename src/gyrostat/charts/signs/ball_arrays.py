"""Arrays of balls in doubles: midpoints, and radii that hold every error of rounding."""
from typing import Any

import numpy as np

from ...algebra.enclosures.floats import Array

# bounds of the relative error of a sum, of a product, of a quotient; and of what underflows
SUM, PRODUCT, QUOTIENT, TINY = 2.0**-52, 2.0**-51, 2.0**-48, 2.0**-900
OUTWARD = 1 + 2.0**-48                                     # a radius is computed in doubles too


class BallArray:
    """Balls about numbers, one for each point; what is not enclosed has an infinite radius.

    Parameters
    ----------
    middle : array or number
    radius : array, or None
        None if the numbers are exact

    References
    ----------
    Rump, Acta Numerica 19 (2010) 287-449: midpoint and radius.

    Examples
    --------
    >>> three = BallArray(np.array([3.0]))
    >>> third = three.inverse()
    >>> bool(third.radius[0] < 1e-14), (three * third - BallArray(1.0)).excludes_zero().tolist()
    (True, [False])
    """

    __slots__ = ("middle", "radius")

    def __init__(self, middle: Any, radius: Any = None):
        self.middle = np.asarray(middle, dtype=float)
        self.radius = np.zeros(self.middle.shape) if radius is None else radius

    def __add__(self, other: "BallArray") -> "BallArray":
        middle = self.middle + other.middle
        return BallArray(middle, OUTWARD * (self.radius + other.radius + SUM * abs(middle)) + TINY)

    def __neg__(self) -> "BallArray":
        return BallArray(-self.middle, self.radius)

    def __sub__(self, other: "BallArray") -> "BallArray":
        return self + -other

    def __mul__(self, other: "BallArray") -> "BallArray":
        one, two = abs(self.middle), abs(other.middle)
        error = PRODUCT * one * two + one * other.radius + self.radius * (two + other.radius)
        return BallArray(self.middle * other.middle, OUTWARD * error + TINY)

    def inverse(self) -> "BallArray":
        """Return 1 over the numbers; the radius is infinite where one may be 0."""
        size = abs(self.middle)
        apart = size - self.radius
        with np.errstate(all="ignore"):
            middle = 1 / self.middle
            error = self.radius / (size * apart) + QUOTIENT * abs(middle)
        inside = apart > TINY
        return BallArray(np.where(inside, middle, 0), np.where(inside, OUTWARD * error + TINY, np.inf))

    def excludes_zero(self) -> Array:
        """Return where no number of the ball is 0."""
        return np.asarray(abs(self.middle) > self.radius)

    def sign(self) -> Array:
        """Return the sign of real numbers: 1 or −1 where all of the ball have it, else 0."""
        return self.positive().astype(np.int8) - (-self).positive()

    def positive(self) -> Array:
        """Return where every number of the ball is positive."""
        return np.asarray(self.middle > self.radius)


def near(doubles: Any, exact: bool) -> BallArray:
    """Return balls about numbers that are doubles, or whose rounding these are."""
    return BallArray(doubles, None if exact else np.asarray(abs(doubles) * SUM + TINY))
