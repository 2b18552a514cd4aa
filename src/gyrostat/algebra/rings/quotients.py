"""Fractions of polynomials in algebraic variables, reduced modulo the relations that these satisfy.

What would be too much work is refused.
"""
from functools import reduce

from flint import fmpq_mpoly

WORK, DEGREE = 200_000, 5000                             # products of terms; of a polynomial
SMALL = 2500                                             # products of terms in a common factor
Fraction = tuple[fmpq_mpoly, fmpq_mpoly]


class Quotients:
    """Sums, products and powers of fractions, each reduced by the relations g^q = ….

    They raise OverflowError beyond the bounds of work.

    Examples
    --------
    >>> from flint import Ordering, fmpq_mpoly_ctx
    >>> g = fmpq_mpoly_ctx.get(("g",), Ordering.lex).gens()[0]
    >>> quotients = Quotients()
    >>> quotients.relate(0, 2, g**2 - 2)
    >>> quotients.power((g + 1, g**0), 2)
    (2*g + 3, 1)
    """

    def __init__(self) -> None:
        self._relations: list[tuple[int, int, fmpq_mpoly]] = []

    def relate(self, place: int, degree: int, relation: fmpq_mpoly) -> None:
        """Enter the relation of one more variable, over those that have relations already.

        Its leading term is a power of that variable alone.
        """
        self._relations.insert(0, (place, degree, relation))

    def sum(self, a: Fraction, b: Fraction) -> Fraction:
        common = _common(a[1], b[1])
        above, below = a[1] / common, b[1] / common
        return self.times(a[0], below) + self.times(b[0], above), self.times(a[1], below)

    def product(self, a: Fraction, b: Fraction) -> Fraction:
        first, second = _common(a[0], b[1]), _common(b[0], a[1])
        return self.times(a[0] / first, b[0] / second), self.times(a[1] / second, b[1] / first)

    def power(self, a: Fraction, n: int) -> Fraction:
        return self.raised(a[0], n), self.raised(a[1], n)

    def raised(self, a: fmpq_mpoly, n: int) -> fmpq_mpoly:
        result = a.context().constant(1)
        while n:
            result = self.times(result, a) if n % 2 else result
            n //= 2
            a = self.times(a, a) if n else a
        return result

    def times(self, a: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
        if len(a) * len(b) > WORK or a and b and max(a.total_degree() + b.total_degree(), 0) > DEGREE:
            raise OverflowError
        return reduce(_remainder, self._relations, a * b)


def _remainder(polynomial: fmpq_mpoly, relation: tuple[int, int, fmpq_mpoly]) -> fmpq_mpoly:
    place, degree, divisor = relation
    if polynomial and polynomial.degrees()[place] >= degree:
        return divmod(polynomial, divisor)[1]
    return polynomial


def _common(a: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
    """Return a common factor, the greatest one if it is soon found."""
    if a == b:
        return a
    simple = a.is_constant() or b.is_constant() or len(a) * len(b) > SMALL
    return a.context().constant(1) if simple else a.gcd(b)
