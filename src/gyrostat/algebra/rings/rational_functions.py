"""Rational functions over ℚ in lowest terms, as numbers to compute with."""
from typing import Any

from flint import fmpq_mpoly

from .polynomials import cancel


class RationalFunction:
    """The fraction top/bottom in lowest terms; the leading coefficient of bottom is 1.

    Parameters
    ----------
    top, bottom : fmpq_mpoly
        of one ring

    Examples
    --------
    >>> from flint import Ordering, fmpq_mpoly_ctx
    >>> generators = fmpq_mpoly_ctx.get(("x", "y"), Ordering.lex).gens()
    >>> x, y = (RationalFunction(g, g**0) for g in generators)
    >>> found = (1 / x + 1 / y) * (x * y)**2
    >>> found.top, found.bottom
    (x^2*y + x*y^2, 1)
    """

    __slots__ = ("bottom", "top")
    __hash__ = None                                        # type: ignore[assignment]

    def __init__(self, top: fmpq_mpoly, bottom: fmpq_mpoly):
        if not bottom.is_one():
            top, bottom = cancel(top, bottom)
            scale = bottom.leading_coefficient()
            top, bottom = top / scale, bottom / scale
        self.top, self.bottom = top, bottom

    def __add__(self, other: Any) -> "RationalFunction":
        if not isinstance(other, RationalFunction):
            return RationalFunction(self.top + self.bottom * other, self.bottom)
        if self.bottom == other.bottom:
            return RationalFunction(self.top + other.top, self.bottom)
        return RationalFunction(self.top * other.bottom + other.top * self.bottom, self.bottom * other.bottom)

    __radd__ = __add__

    def __neg__(self) -> "RationalFunction":
        return RationalFunction(-self.top, self.bottom)

    def __sub__(self, other: Any) -> "RationalFunction":
        return self + -1 * other

    def __rsub__(self, other: Any) -> "RationalFunction":
        return -self + other

    def __mul__(self, other: Any) -> "RationalFunction":
        if not isinstance(other, RationalFunction):
            return RationalFunction(self.top * other, self.bottom)
        return RationalFunction(self.top * other.top, self.bottom * other.bottom)

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> "RationalFunction":
        return RationalFunction(self.top**exponent, self.bottom**exponent)

    def __truediv__(self, other: Any) -> "RationalFunction":
        if not isinstance(other, RationalFunction):
            return RationalFunction(self.top / other, self.bottom)
        return RationalFunction(self.top * other.bottom, self.bottom * other.top)

    def __rtruediv__(self, other: Any) -> "RationalFunction":
        return RationalFunction(self.bottom * other, self.top)

    def __eq__(self, other: object) -> bool:
        return bool(self.top == self.bottom * other) if isinstance(other, int) else NotImplemented
