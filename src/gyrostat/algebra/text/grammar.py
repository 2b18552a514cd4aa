"""Parses text by recursive descent through a whitelist grammar, never by evaluation.

sum     := product (('+' | '-') product)*
product := factor (('*' | '/') factor)*
factor  := ('+' | '-') factor | atom ['**' factor]
atom    := number | name | function '(' sum ['deg'] ')' | '(' sum ')'

The scanner reads ^ as **, x² as x**(2), √x as sqrt(x), ° as deg and Greek names as their words. Degrees stand
in sin, cos and tan alone.
"""
import operator
import re
from collections.abc import Sequence
from difflib import get_close_matches
from fractions import Fraction
from functools import reduce
from typing import Any

import sympy
from sympy import Add, Expr, Mul, Pow, Rational, log

from ...notation import Use, symbol
from ...registry import AUTONOMOUS, use_of
from . import bounded_parts, magnitudes
from .bounded_parts import DEGREE, FUNCTIONS, HYPERBOLIC, PARTIAL, Cost, Part
from .limits import Limited

_MEANT = {"ln": "log", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arcsinh": "asinh",
          "arccosh": "acosh", "arctanh": "atanh", "arsinh": "asinh", "arcosh": "acosh", "artanh": "atanh",
          "arctg": "atan", "tg": "tan", "sh": "sinh", "ch": "cosh", "th": "tanh"}
TRIGONOMETRIC = ("sin", "cos", "tan")                  # of an angle, which may be in degrees


class Parser(Limited):
    """A recursive descent through the grammar.

    A language with more names and functions extends named and call.
    """

    def whole(self) -> Part:
        """Parse the whole text."""
        part = self.sum()
        if self.peek():
            self.fail(f"{self.peek()!r} comes where an operator or the end should be",
                      "write * between factors, and check the parentheses")
        return part

    def sum(self) -> Part:
        summands, terms = [self.product()], 0
        while sign := self.take("+", "-"):
            part = self.product()
            summands.append(part if sign == "+" else self.negative(part))
            if (terms := terms + part.cost.terms) > self.TERMS:
                self.checked(Cost(terms))
        if len(summands) == 1:
            return summands[0]
        ball = reduce(magnitudes.added, [part.ball for part in summands])
        cost = bounded_parts.of_sum([part.cost for part in summands])
        return self.bounded(self.total([part.value for part in summands]), cost,
                            max(part.nesting for part in summands), ball)

    def total(self, values: Sequence[Any]) -> Any:
        """Return the sum of some values, taken at once."""
        return Add(*values)

    def product(self) -> Part:
        left = self.factor()
        while sign := self.take("*", "/"):
            right = self.factor()
            if sign == "/":
                right = self.power(right, Rational(-1))
            left = self.times(left, right)
        return left

    def times(self, left: Part, right: Part) -> Part:
        for one, other in ((left, right), (right, left)):
            if one.doubtful and other.ball is None:
                self.fail("a factor cannot be told from 0", "simplify the constants")
        cost = self.checked(bounded_parts.of_product([left.cost, right.cost]))
        ball = magnitudes.multiplied(left.ball, right.ball)
        return self.bounded(self.made(operator.mul, left.value, right.value), cost,
                            max(left.nesting, right.nesting), ball)

    def factor(self) -> Part:
        self.deeper()
        if sign := self.take("+", "-"):
            part = self.factor()
            result = part if sign == "+" else self.negative(part)
        else:
            result = self.atom()
            if self.take("**"):
                exponent = self.factor().value
                if not isinstance(exponent, Rational):
                    power = str(Mul(exponent, log(result.value, evaluate=False), evaluate=False))[:60]
                    self.fail(f"the exponent {str(exponent)[:60]} is not a rational number",
                              f"put a number in its place, or write exp({power}), of a positive base")
                result = self.power(result, exponent)
        self.depth -= 1
        return result

    def negative(self, part: Part) -> Part:
        return Part(-part.value, part.cost, part.nesting, magnitudes.negated(part.ball))

    def power(self, base: Part, exponent: Rational) -> Part:
        times, root = abs(int(exponent.p)), int(exponent.q)
        if root > 12 or times > DEGREE and base.value not in (0, 1, -1):
            self.fail(f"the exponent {str(exponent)[:20]} is too large",
                      f"exponents go up to {DEGREE}, roots up to the 12th")
        if base.value == 0 and exponent < 0:
            self.fail("it divides by zero", "check the denominators")
        if base.doubtful and (exponent < 0 or root > 1):
            self.fail("a denominator or what is under a root cannot be told from 0", "simplify the constants")
        if isinstance(base.value, Rational) and abs(base.value) in (0, 1):
            times = min(times, 2 - times % 2)                               # so that (-1)**10**9 is no work
        self.moderate(bounded_parts.factored(base, root))
        small = Rational(times if exponent > 0 else -times, root)
        ball, nesting = magnitudes.raised(base.ball, small), base.nesting + (root > 1)
        cost = self.checked(bounded_parts.of_power(base.cost, small))
        self.finite(ball)
        value = self.made(pow, base.value, exponent)
        if root > 1 and not (isinstance(value, Pow) and value.base == base.value):
            return self.remade(value, nesting, ball)
        return self.bounded(value, cost, nesting, ball)

    def atom(self) -> Part:
        kind, token = self.tokens[self.place]
        self.place += 1
        if kind == "number":
            return self.number(token)
        if kind == "name":
            return self.call(token) if self.peek() == "(" else self.named(token)
        if token == "(":
            return self.closed(self.sum())
        self.fail(f"{token!r} stands where a number or a name should be" if token else "it ends too early",
                  "complete the expression")

    def closed(self, part: Part) -> Part:
        if not self.take(")"):
            self.fail("a closing parenthesis is missing", "close what you opened")
        return part

    def number(self, token: str) -> Part:
        if len(token) > 400 or abs(int(re.split("[eE]", token)[1]) if re.search("[eE]", token) else 0) > 400:
            self.fail(f"the number {token[:20]}... is too long", "numbers have up to 400 digits")
        return bounded_parts.constant(Rational(Fraction(token)))

    def named(self, token: str) -> Part:
        if token in FUNCTIONS:
            kind, after = self.tokens[self.place]
            argument = after if kind in ("name", "number") else "..."
            self.fail(f"the function {token} has no argument", f"write {token}({argument})")
        if token == "pi":
            return Part(sympy.pi, ball=bounded_parts.enclosure(sympy.pi))
        return Part(symbol(token), Cost(degree=1))

    def call(self, token: str) -> Part:
        if token not in FUNCTIONS:
            self.fail(*self.no_function(token))
        self.called()
        if token not in TRIGONOMETRIC:
            return self.apply(token, self.atom())
        self.take("(")
        angle = self.sum()
        if self.take("deg"):
            degree = sympy.pi / 180
            angle = self.times(angle, Part(degree, ball=bounded_parts.enclosure(degree)))
        return self.apply(token, self.closed(angle))

    def no_function(self, token: str) -> tuple[str, str]:
        """Return why a name is no function, and what to write: of the time, of k, or another one."""
        _, argument = self.tokens[self.place + 1]
        if use_of(argument) is Use.TIME:
            why, todo = AUTONOMOUS.split(": ")
            return f"{token}({argument}) is a function of the time, and {why}", todo
        if token in ("U", "V", "W") and argument in ("k1", "k3"):
            return (f"{token} is not a function of the grammar", f"give a formula in {argument}; U(k3), or "
                    "U(k1, k2, k3), as the whole potential stands for any one")
        return f"{token} is not a function of the grammar", self.guess(token, list(FUNCTIONS))

    def guess(self, token: str, functions: Sequence[str]) -> str:
        """Return what may have been meant."""
        near = [_MEANT[token.lower()]] if token.lower() in _MEANT else get_close_matches(token, functions, 1)
        meant = f"did you mean {near[0]}?" if near else f"write {token}*(...) for a product;"
        return f"{meant} the functions are {', '.join(functions)}"

    def apply(self, token: str, inner: Part) -> Part:
        """Apply an elementary function to a part."""
        if token == "sqrt":
            return self.power(inner, Rational(1, 2))
        ball, nesting = magnitudes.applied(token, inner.ball), self.nested(inner.nesting + 1)
        if token in HYPERBOLIC and ball is None and inner.cost.partial > PARTIAL:
            self.fail(f"{token} is applied to powers or sums of functions that are not real everywhere",
                      f"such an argument has up to {PARTIAL} terms and degree {PARTIAL}")
        self.finite(ball)
        self.moderate(bounded_parts.factored_by(token, inner))
        cost = self.checked(bounded_parts.of_function(token, inner.cost) if ball is None
                            else Cost(degree=1, bits=inner.cost.bits))
        value = self.made(FUNCTIONS[token], inner.value)
        if isinstance(value, FUNCTIONS[token]) and value.args == (inner.value,):  # type: ignore[arg-type]
            return self.bounded(value, cost, nesting, ball)
        return self.remade(value, nesting, ball)


def parse(text: str) -> Expr:
    """Return the expression that a text stands for, its names in our symbols.

    Parameters
    ----------
    text : str
        names, numbers (read exactly), + - * / and ^ or **, parentheses, elementary functions, pi; what the
        library prints is read as well: k₃², π₃⁰, I₁, √2, −

    Returns
    -------
    Expr

    Raises
    ------
    ExpressionError
        anything outside the grammar, division by zero, complex numbers, input made to be slow

    Examples
    --------
    >>> parse("m0*k3 + 0.5*k3**2")
    k3**2/2 + k3*m0
    >>> parse("m₀·k₃ − √2·k₃^2/3")
    -sqrt(2)*k3**2/3 + k3*m0
    >>> parse("9**9**9")  # doctest: +NORMALIZE_WHITESPACE
    Traceback (most recent call last):
    gyrostat.errors.ExpressionError: cannot read '9**9**9': the exponent
    387420489 is too large; exponents go up to 100, roots up to the 12th
    """
    return Parser(text).whole().value
