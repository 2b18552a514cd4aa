"""Exact arithmetic with the two eigenvalues λ1, λ2 of a Hamiltonian matrix, in a quotient of ℚ[x, m]."""
from math import prod
from typing import Any

from flint import fmpq, fmpq_poly


class Ring:
    """The ring ℚ[x, m] modulo a polynomial in x, and modulo m² − square.

    Parameters
    ----------
    modulus : fmpq_poly
    square : fmpq
    """

    def __init__(self, modulus: fmpq_poly, square: fmpq):
        self.modulus, self.square = modulus, square

    def element(self, plain: list[Any], with_m: list[Any] | None = None) -> "Element":
        """Return a polynomial in x plus m times another."""
        return Element(self, fmpq_poly(plain), fmpq_poly(with_m or [0]))


class Element:
    """A number a + b m, where a and b are polynomials in x.

    Examples
    --------
    >>> one, two = eigenvalues_of(fmpq(5), fmpq(4))
    >>> a, b = one * one, two * two
    >>> (a + b).rational(), (1 / (a * b)).rational()
    (-5, 1/4)
    """

    __slots__ = ("a", "b", "ring")

    def __init__(self, ring: Ring, a: fmpq_poly, b: fmpq_poly):
        self.ring, self.a, self.b = ring, a, b

    def __add__(self, other: Any) -> "Element":
        if isinstance(other, Element):
            return Element(self.ring, self.a + other.a, self.b + other.b)
        return Element(self.ring, self.a + other, self.b)

    __radd__ = __add__

    def __neg__(self) -> "Element":
        return Element(self.ring, -self.a, -self.b)

    def __sub__(self, other: Any) -> "Element":
        return self + -other

    def __mul__(self, other: Any) -> "Element":
        if not isinstance(other, Element):
            return Element(self.ring, self.a * other, self.b * other)
        f, square = self.ring.modulus, self.ring.square
        return Element(self.ring, (self.a * other.a + square * (self.b * other.b)) % f,
                       (self.a * other.b + self.b * other.a) % f)

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> "Element":
        return prod([self] * exponent, start=self.ring.element([1]))

    def __truediv__(self, other: Any) -> "Element":
        return self * (1 / other)

    def __rtruediv__(self, other: Any) -> "Element":
        f = self.ring.modulus
        common, inverse, _ = self._norm().xgcd(f)
        if common != 1:
            raise ZeroDivisionError("a divisor of zero has no inverse")
        return Element(self.ring, self.a * inverse % f, -self.b * inverse % f) * other

    def __eq__(self, other: object) -> bool:
        return isinstance(other, int) and self.a == other and not self.b

    __hash__ = None                                        # type: ignore[assignment]

    def invertible(self) -> bool:
        """Tell whether the number is 0 at none of the roots of the modulus, and so has an inverse.

        If the modulus has factors, the number may be 0 at some of its roots and not at others.
        """
        return bool(self._norm().gcd(self.ring.modulus) == 1)

    def _norm(self) -> fmpq_poly:
        """Return the norm, the product with a − b m."""
        return (self.a * self.a - self.ring.square * (self.b * self.b)) % self.ring.modulus

    def conjugate(self) -> "Element":
        """Return the number with −λ1 and −λ2 for λ1 and λ2, the complex conjugate if these are imaginary."""
        return Element(self.ring, _reflected(self.a), _reflected(self.b))

    def rational(self) -> fmpq:
        """Return the rational number that this number is.

        Raises
        ------
        ArithmeticError
            the number is not rational
        """
        if self.b or self.a.degree() > 0:
            raise ArithmeticError("a number of eigenvalues is not rational")
        return self.a[0]


def eigenvalues_of(p: fmpq, q: fmpq) -> tuple[Element, Element]:
    """Return λ1 and λ2 for the polynomial λ⁴ + p λ² + q with q ≠ 0: its roots are ±λ1 and ±λ2."""
    ring = Ring(fmpq_poly([q, 0, p, 0, 1]), q)             # x = λ1, m = λ1 λ2
    return ring.element([0, 1]), ring.element([0], [0, -p / q, 0, -1 / q])


def in_ratio(square: fmpq, ratio: int) -> tuple[Element, Element]:
    """Return λ1 and λ2 with λ1 = ratio λ2 and λ2² = square."""
    ring = Ring(fmpq_poly([-square, 0, 1]), fmpq(0))
    return ring.element([0, ratio]), ring.element([0, 1])


def _reflected(a: fmpq_poly) -> fmpq_poly:
    return fmpq_poly([c if n % 2 == 0 else -c for n, c in enumerate(a.coeffs())])
