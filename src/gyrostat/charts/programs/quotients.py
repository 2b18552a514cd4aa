"""Writes fractions as steps of a program without division, for the sake of their signs.

What is divided by is positive, so that its powers need only be counted: they change no sign.
"""
from collections.abc import Mapping
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from flint import fmpq_mpoly
from sympy import Expr, Integer, Rational

from ...algebra.rings.polynomials import Ring, cancel
from ...algebra.rings.readable import readable

Term = tuple[int, bool]                                # a step, and whether it counts negatively
Writer = Any                                           # of straightline, which imports this module


class Quotient:
    """A number scale · term · Π stepⁿ: a fraction, a step, and whole powers of steps that are positive.

    A sum takes out the lower of both powers, a product adds them, and nothing is reduced. Beside other
    quotients it takes Python's integers and fractions, and is 0 only as one of these. It is divided only by
    numbers that are positive at every point at which the sign is asked, as k·Ik and det I are.

    Parameters
    ----------
    writer : Writer
        the program to which steps are added
    scale : Fraction
        not 0
    term : Term or None
        None for 1
    powers : mapping of step to int
        of either sign
    """

    __slots__ = ("powers", "scale", "term", "writer")

    def __init__(self, writer: Writer, scale: Fraction, term: Term | None = None,
                 powers: Mapping[int, int] | None = None):
        self.writer, self.scale, self.term, self.powers = writer, scale, term, powers or {}

    def __add__(self, other: Any) -> Any:
        if other == 0:
            return self
        other = self._like(other)
        common = {step: min(self.powers.get(step, 0), other.powers.get(step, 0))
                  for step in (*self.powers, *other.powers)}
        bottom = lcm(self.scale.denominator, other.scale.denominator)
        one, two = (int(x.scale * bottom) for x in (self, other))
        top = gcd(one, two)
        term, other_term = self._over(one // top, common), other._over(two // top, common)
        if term == (other_term[0], not other_term[1]):
            return 0
        return Quotient(self.writer, Fraction(top, bottom), self.writer.sum(term, other_term), common)

    __radd__ = __add__

    def __neg__(self) -> "Quotient":
        return Quotient(self.writer, -self.scale, self.term, self.powers)

    def __sub__(self, other: Any) -> Any:
        return self + -other

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if other == 0:
            return 0
        one, two = self._counted(), self._like(other)._counted()
        terms = [x.term for x in (one, two) if x.term is not None]
        term = self.writer.product(*terms) if len(terms) == 2 else terms[0] if terms else None
        return Quotient(self.writer, one.scale * two.scale, term,
                        {step: one.powers.get(step, 0) + two.powers.get(step, 0)
                         for step in (*one.powers, *two.powers)})

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> Any:
        return self * self**(exponent - 1) if exponent > 1 else self if exponent else Fraction(1)

    def __truediv__(self, other: Any) -> Any:
        return self * (1 / other if isinstance(other, Quotient) else Fraction(1, other))

    def __rtruediv__(self, other: Any) -> Any:
        powers = {step: -n for step, n in self.powers.items()}
        scale = 1 / self.scale
        if self.term is not None:
            step, negative = self.term
            if negative != (scale < 0):                    # the number is positive, not this step
                step = self.writer.step("negative", (step,))
            self.writer.positive.add(step)
            scale, powers[step] = abs(scale), powers.get(step, 0) - 1
        return Quotient(self.writer, scale, None, powers) * other

    def signed(self) -> Term:
        """Return a step that has the sign of the number."""
        step, negative = self.term or self.writer.write(Integer(1))
        return step, negative != (self.scale < 0)

    def _counted(self) -> "Quotient":
        """Return the same with a term that has proved to be positive among the powers."""
        if self.term is None or self.term[0] not in self.writer.positive:
            return self
        step, negative = self.term
        return Quotient(self.writer, -self.scale if negative else self.scale, None,
                        {**self.powers, step: self.powers.get(step, 0) + 1})

    def _like(self, other: Any) -> "Quotient":
        return other if isinstance(other, Quotient) else Quotient(self.writer, Fraction(other))

    def _over(self, factor: int, common: Mapping[int, int]) -> Term:
        """Return factor · term · Π stepⁿ without the scale and the common powers."""
        terms = [*([self.term] if self.term is not None else []),
                 *((self.writer.power(step, self.powers.get(step, 0) - n), False)
                   for step, n in common.items() if self.powers.get(step, 0) > n)]
        if abs(factor) != 1 or not terms:
            terms.append(self.writer.write(Integer(abs(factor))))
        step, negative = self.writer.fold(terms, self.writer.product)
        return step, negative != (factor < 0)


def quotient(expression: Expr, writer: Writer) -> Any:
    """Return a fraction of polynomials as a quotient, or as a Fraction if it is a rational number.

    A factor of the denominator that is not plainly positive is replaced by its square.
    """
    if isinstance(expression, Rational):
        return Fraction(int(expression.p), int(expression.q))
    powers: dict[int, int] = {}
    ring = Ring([expression])
    top, bottom = ring.fraction(expression)
    top, bottom = cancel(ring.reduce(top), ring.reduce(bottom))
    content, factors = bottom.factor()
    scale = 1 / Fraction(int(content.p), int(content.q))
    for factor, n in factors:
        if not plainly_positive(ring, factor):
            top, factor, n = (top * factor if n % 2 else top), factor**2, -(-int(n) // 2)
        factor, whole = _whole(factor)
        step, negative = writer.write(readable(ring.expression(factor)))
        step = writer.step("negative", (step,)) if negative else step
        writer.positive.add(step)
        powers[step], scale = powers.get(step, 0) - int(n), scale * whole**int(n)
    top, whole = _whole(top)
    return Quotient(writer, scale / whole, writer.write(readable(ring.expression(top))), powers)


def _whole(polynomial: fmpq_mpoly) -> tuple[fmpq_mpoly, int]:
    """Return the polynomial times a number by which all coefficients are whole, and the number."""
    number = lcm(1, *(int(c.q) for c in polynomial.coeffs()))
    return polynomial * number, number


def plainly_positive(ring: Ring, polynomial: fmpq_mpoly) -> bool:
    """Tell whether no term can be negative, and one is positive everywhere."""
    positive = [g.is_Symbol and bool(g.is_positive) for g in ring.generators]
    terms = polynomial.to_dict()
    return all(c > 0 and all(p or n % 2 == 0 for p, n in zip(positive, exponents))
               for exponents, c in terms.items()) and any(
        all(p or n == 0 for p, n in zip(positive, exponents)) for exponents in terms)
