"""Arrays of balls in doubles: midpoints, real or complex, and radii that hold every error of rounding."""
from typing import Any

import numpy as np
from flint import fmpq

from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.rationals import to_flint

# bounds of the relative error of a sum, of a product or square root, of a quotient; and of what underflows
SUM, PRODUCT, QUOTIENT, TINY = 2.0**-52, 2.0**-51, 2.0**-48, 2.0**-900
OUTWARD = 1 + 2.0**-48                                     # a radius is computed in doubles too


class BallArray:
    """Balls about numbers, one for each point; what is not enclosed has an infinite radius.

    Parameters
    ----------
    middle : array or number
        real or complex
    radius : array, or None
        None if the numbers are exact

    References
    ----------
    Brent, Percival & Zimmermann, Math. Comp. 76 (2007) 1469-1481: complex products; Rump, Acta Numerica 19
    (2010) 287-449: midpoint and radius.

    Examples
    --------
    >>> third = 1 / BallArray(np.array([3.0]))
    >>> bool(third.radius[0] < 1e-14), (3 * third - 1).excludes_zero().tolist()
    (True, [False])
    """

    __slots__ = ("middle", "radius")
    __hash__ = None                                        # type: ignore[assignment]
    __array_ufunc__ = None                                 # a NumPy number leaves the operation to this class

    def __init__(self, middle: Any, radius: Any = None):
        self.middle = np.asarray(middle, dtype=None if np.iscomplexobj(middle) else float)
        self.radius = np.zeros(self.middle.shape) if radius is None else radius

    def __add__(self, other: Any) -> "BallArray":
        other = _ball(other)
        middle = self.middle + other.middle
        return BallArray(middle, OUTWARD * (self.radius + other.radius + SUM * abs(middle)) + TINY)

    __radd__ = __add__

    def __neg__(self) -> "BallArray":
        return BallArray(-self.middle, self.radius)

    def __sub__(self, other: Any) -> "BallArray":
        return self + -_ball(other)

    def __rsub__(self, other: Any) -> "BallArray":
        return -self + other

    def __mul__(self, other: Any) -> "BallArray":
        other = _ball(other)
        one, two = abs(self.middle), abs(other.middle)
        error = PRODUCT * one * two + one * other.radius + self.radius * (two + other.radius)
        return BallArray(self.middle * other.middle, OUTWARD * error + TINY)

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> "BallArray":
        found = BallArray(1.0)
        for _ in range(exponent):
            found = found * self
        return found

    def __truediv__(self, other: Any) -> "BallArray":
        return self * (1 / _ball(other))

    def __rtruediv__(self, other: Any) -> "BallArray":
        size = abs(self.middle) * (1 - SUM)                # rounded down: abs of a complex number is inexact
        apart = size - self.radius
        with np.errstate(all="ignore"):
            middle = 1 / self.middle
            error = self.radius / (size * apart) + QUOTIENT * abs(middle)
        inside = apart > TINY
        found = BallArray(np.where(inside, middle, 0), np.where(inside, OUTWARD * error + TINY, np.inf))
        return found if isinstance(other, int) and other == 1 else found * other

    def __eq__(self, other: object) -> bool:
        """Tell whether every number is exactly 0."""
        return isinstance(other, int) and other == 0 and not (self.middle.any() or self.radius.any())

    def sqrt(self) -> "BallArray":
        """Return the roots of real numbers; the radius is infinite where a number may be 0 or negative."""
        inside = self.middle > 2 * self.radius + TINY
        middle = np.sqrt(np.where(inside, self.middle, 1))
        error = self.radius / middle + PRODUCT * middle
        return BallArray(middle, np.where(inside, OUTWARD * error + TINY, np.inf))

    def conjugate(self) -> "BallArray":
        """Return the complex conjugates."""
        return BallArray(self.middle.conjugate(), self.radius)

    @property
    def real(self) -> "BallArray":
        """The real parts."""
        return BallArray(self.middle.real, self.radius)

    def turned(self) -> "BallArray":
        """Return i times real numbers."""
        return BallArray(1j * self.middle, self.radius)

    def excludes_zero(self) -> Array:
        """Return where no number of the ball is 0."""
        return np.asarray(abs(self.middle) * (1 - SUM) > self.radius)

    def where(self, known: Array) -> "BallArray":
        """Return the balls where something is known, and infinite radii elsewhere."""
        return BallArray(np.broadcast_to(self.middle, known.shape), np.where(known, self.radius, np.inf))

    def sign(self) -> Array:
        """Return the sign of real numbers: 1 or −1 where all of the ball have it, else 0."""
        return self.positive().astype(np.int8) - (-self).positive()

    def positive(self) -> Array:
        """Return where every number of the ball is positive."""
        return np.asarray(self.middle > self.radius)


def near(doubles: Any, exact: bool) -> BallArray:
    """Return balls about numbers that are doubles, or whose rounding these are."""
    return BallArray(doubles, None if exact else np.asarray(abs(doubles) * SUM + TINY))


def _ball(x: Any) -> BallArray:
    """Return a number as a ball; a fraction that is no double with what is lost."""
    if isinstance(x, BallArray):
        return x
    if isinstance(x, fmpq):
        value = int(x.p) / int(x.q)
        return near(value, to_flint(value) == x)
    return BallArray(float(x) if not isinstance(x, complex) else x)
