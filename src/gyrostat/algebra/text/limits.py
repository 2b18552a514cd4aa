"""Refuses what would be slow, before it is computed.

Each part of a text carries bounds on what expanding it could cost, and each constant an enclosure, so that
SymPy is never asked for the sine of a number with 10⁵⁰ digits.
"""
from collections.abc import Callable
from typing import Any

from sympy import Expr, Rational

from ...errors import ExpressionError
from . import bounded_parts, magnitudes
from .bounded_parts import BITS, DEGREE, NESTING, TERMS, Cost, Part
from .scanner import Scanner

LENGTH, DEPTH, CALLS = 5000, 40, 30


class Limited(Scanner):
    """A text of which no part may cost more than the limits, nor be anything but a finite real number."""

    TERMS = TERMS

    def __init__(self, text: str):
        if len(text) > LENGTH:
            raise ExpressionError(f"an expression of {len(text)} characters is longer than the {LENGTH} "
                                  "allowed: shorten it")
        super().__init__(text)
        self.depth, self.calls = 0, 0

    def deeper(self) -> None:
        """Count one level more, and refuse the text if these are too many."""
        self.depth += 1
        if self.depth > DEPTH:
            self.fail(f"it is nested more than {DEPTH} deep", "write it flatter")

    def called(self, todo: str = "write it shorter") -> None:
        """Count one function more, and refuse the text if these are too many."""
        self.calls += 1
        if self.calls > CALLS:
            self.fail(f"it has more than {CALLS} functions", todo)

    def nested(self, nesting: int) -> int:
        """Return the number of functions and roots inside one another, if it is within the limit."""
        if nesting > NESTING:
            self.fail(f"its functions and roots are nested more than {NESTING} deep", "simplify it")
        return nesting

    def moderate(self, bits: int) -> None:
        """Refuse a root for which SymPy would factor too long a number."""
        if bits > BITS:
            self.fail(f"for a root in it a number of {min(bits, 10**9)} bits is factored",
                      f"the limit is {BITS} bits: shorten the numbers")

    def made(self, function: Callable[..., Any], *arguments: Any) -> Any:
        """Return what SymPy makes of a part.

        Its comparisons and factors fail at some numbers that are too large for them.
        """
        try:
            return function(*arguments)
        except (ArithmeticError, AttributeError, RecursionError, TypeError, ValueError) as error:
            self.fail(f"SymPy cannot evaluate a part of it ({str(error)[:60]})", "simplify it")

    def remade(self, value: Expr, nesting: int, ball: Any) -> Part:
        """Return the part that SymPy made of a root or a function.

        It may be another one, such as exp(2*log(x)) = x**2.
        """
        if bounded_parts.foreign(value := bounded_parts.rewritten(value)):
            self.fail("a part of it is not a finite real number, or not an elementary function",
                      "check roots, logarithms and inverse functions")
        return self.bounded(value, bounded_parts.of_expression(value), nesting, ball)

    def checked(self, cost: Cost) -> Cost:
        """Return the cost, if it is within the limits."""
        if not cost.fits(self.TERMS):
            terms, degree, bits = (min(n, 10**9) for n in (cost.terms, cost.degree, cost.bits))
            self.fail(f"expanded, it could have {terms} terms, degree {degree} or numbers of {bits} bits",
                      f"the limits are {self.TERMS} terms, degree {DEGREE}, {BITS} bits")
        return cost

    def finite(self, ball: Any) -> None:
        """Refuse a constant that is not proved to be a finite real number of a moderate size."""
        if ball is None:
            return
        if not ball.is_finite():
            self.fail("a part of it is not a finite real number",
                      "check divisions, roots, logarithms and inverse functions")
        if max(abs(end or 0) for end in magnitudes.extent(ball)) > BITS:
            self.fail("a part of it is too large, or too close to 0",
                      f"numbers lie between 2**-{BITS} and 2**{BITS} in size")

    def bounded(self, value: Any, cost: Cost, nesting: int, ball: Any) -> Part:
        """Return a part, if it is within all limits."""
        if isinstance(value, Rational):
            part = bounded_parts.constant(value)
            self.checked(part.cost)
            return part
        self.finite(ball)
        self.nested(nesting)
        if ball is not None:
            high, low = magnitudes.extent(ball)
            cost = cost._replace(bits=max(cost.bits, abs(high), abs(low or 0)), size=high)
        return Part(value, self.checked(cost), nesting, ball)
