"""Text and numbers from users become exact mathematics, through a whitelist grammar and never by evaluation.

    sum     := product (('+' | '-') product)*
    product := factor (('*' | '/') factor)*
    factor  := ('+' | '-') factor | atom ['**' factor]
    atom    := number | name | function '(' sum ')' | '(' sum ')'

What would be slow is refused before it is computed: each part carries a bound on its expanded size.
"""
import math
import numbers
import re
from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any, NoReturn

import mpmath
import sympy
from sympy import CRootOf, Expr, Float, Rational

from .errors import ExpressionError, ValuesError
from .notation import own, symbol

FUNCTIONS: dict[str, Callable[[Expr], Expr]] = {name: getattr(sympy, name) for name in (
    "sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh")}
LENGTH, DEPTH, CALLS, NESTING, TERMS, DEGREE, BITS = 5000, 40, 30, 4, 1000, 100, 4000
_TOKEN = re.compile(r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[A-Za-z][A-Za-z0-9_]*)"
                    r"|(?P<sign>\*\*|[-+*/()]))", re.ASCII)


@dataclass(frozen=True)
class Part:
    """A parsed part and bounds on what expanding it could cost."""

    value: Expr
    terms: int = 1
    degree: int = 0
    bits: int = 1
    nesting: int = 0


class Parser:
    """Recursive descent through the grammar; a language with more names and functions extends named and call."""

    TOKEN = _TOKEN
    HINT = "allowed are names, numbers, + - * / ** and parentheses"

    def __init__(self, text: str):
        self.text, self.place, self.depth, self.calls = text, 0, 0, 0
        if len(text) > LENGTH:
            raise ExpressionError(f"an expression of {len(text)} characters is longer than the {LENGTH} allowed: shorten it")
        self.tokens = self._scan()

    def _scan(self) -> list[tuple[str, str]]:
        tokens, place, end = [], 0, len(self.text.rstrip())
        while place < end:
            match = self.TOKEN.match(self.text, place)
            if match is None:
                rest = self.text[place:].lstrip()
                hint = "write ** for powers" if rest[0] == "^" else self.HINT
                self.fail(f"{rest[:12]!r} at character {len(self.text) - len(rest) + 1} is not part of the grammar", hint)
            tokens.append((str(match.lastgroup), match[str(match.lastgroup)]))
            place = match.end()
        return tokens

    def fail(self, why: str, todo: str) -> NoReturn:
        shown = self.text if len(self.text) <= 60 else self.text[:57] + "..."
        raise ExpressionError(f"cannot read {shown!r}: {why}; {todo}") from None

    def peek(self) -> str:
        return self.tokens[self.place][1] if self.place < len(self.tokens) else ""

    def take(self, *wanted: str) -> str:
        if (token := self.peek()) and token in wanted:
            self.place += 1
            return token
        return ""

    def whole(self) -> Expr:
        part = self.sum()
        if self.peek():
            self.fail(f"{self.peek()!r} comes where an operator or the end should be", "check the operators and parentheses")
        return part.value

    def sum(self) -> Part:
        left = self.product()
        while sign := self.take("+", "-"):
            right = self.product()
            value = left.value + right.value if sign == "+" else left.value - right.value
            left = self.bounded(value, left.terms + right.terms, max(left.degree, right.degree),
                                max(left.bits, right.bits) + 1, max(left.nesting, right.nesting))
        return left

    def product(self) -> Part:
        left = self.factor()
        while sign := self.take("*", "/"):
            right = self.factor()
            if sign == "/":
                right = self.power(right, Rational(-1))
            left = self.bounded(left.value * right.value, left.terms * right.terms, left.degree + right.degree,
                                left.bits + right.bits, max(left.nesting, right.nesting))
        return left

    def factor(self) -> Part:
        self.depth += 1
        if self.depth > DEPTH:
            self.fail(f"it is nested more than {DEPTH} deep", "write it flatter")
        if sign := self.take("+", "-"):
            part = self.factor()
            result = part if sign == "+" else Part(-part.value, part.terms, part.degree, part.bits, part.nesting)
        else:
            result = self.atom()
            if self.take("**"):
                exponent = self.factor().value
                if not isinstance(exponent, Rational):
                    self.fail(f"the exponent {exponent} is not a rational number", "write a**x as exp(x*log(a))")
                result = self.power(result, exponent)
        self.depth -= 1
        return result

    def power(self, base: Part, exponent: Rational) -> Part:
        size = abs(int(exponent.p))
        if exponent.q > 12 or size > DEGREE and base.value not in (0, 1, -1):
            self.fail(f"the exponent {str(exponent)[:20]} is too large", f"exponents go up to {DEGREE}, roots up to the 12th")
        if base.value == 0 and exponent < 0:
            self.fail("it divides by zero", "check the denominators")
        terms = math.comb(size + base.terms - 1, size) if base.terms <= TERMS else TERMS + 1
        return self.bounded(base.value**exponent, terms, base.degree * size, base.bits * max(size, 1), base.nesting)

    def bounded(self, value: Expr, terms: int, degree: int, bits: int, nesting: int) -> Part:
        if terms > TERMS or degree > DEGREE or bits > BITS:
            self.fail(f"expanded, it could have {min(terms, 10**9)} terms, degree {degree} or numbers of {bits} bits",
                      f"the limits are {TERMS} terms, degree {DEGREE}, {BITS} bits")
        if not value.free_symbols and (value.is_finite is False or value.is_real is False):
            self.fail("a part of it is not a finite real number", "check divisions, roots, logarithms and inverse functions")
        return Part(value, terms, degree, bits, nesting)

    def atom(self) -> Part:
        kind, token = self.tokens[self.place] if self.place < len(self.tokens) else ("end", "")
        self.place += 1
        if kind == "number":
            return self.number(token)
        if kind == "name":
            return self.call(token) if self.peek() == "(" else self.named(token)
        if token == "(":
            part = self.sum()
            if not self.take(")"):
                self.fail("a closing parenthesis is missing", "close what you opened")
            return part
        self.fail(f"{token!r} stands where a number or a name should be" if token else "it ends too early",
                  "complete the expression")

    def number(self, token: str) -> Part:
        if len(token) > 400 or abs(int(re.split("[eE]", token)[1]) if re.search("[eE]", token) else 0) > 400:
            self.fail(f"the number {token[:20]}... is too long", "numbers have up to 400 digits")
        value = Rational(Fraction(token))
        return Part(value, bits=max(int(value.p).bit_length(), int(value.q).bit_length(), 1))

    def named(self, token: str) -> Part:
        if token in FUNCTIONS:
            self.fail(f"the function {token} has no argument", f"write {token}(...)")
        return Part(sympy.pi) if token == "pi" else Part(symbol(token), degree=1)

    def call(self, token: str) -> Part:
        if token not in FUNCTIONS:
            self.fail(f"{token} is not a function of the grammar", "the functions are " + ", ".join(FUNCTIONS))
        self.calls += 1
        argument = self.atom()
        if self.calls > CALLS or argument.nesting >= NESTING:
            self.fail(f"it has more than {CALLS} functions, or functions nested more than {NESTING} deep", "simplify it")
        return self.bounded(FUNCTIONS[token](argument.value), 1, 1, argument.bits, argument.nesting + 1)


def parse(text: str) -> Expr:
    """Expression that a text stands for, its names in our symbols.

    Parameters
    ----------
    text : str      names, numbers (read exactly), + - * / **, parentheses, elementary functions, pi

    Returns
    -------
    Expr

    Raises
    ------
    ExpressionError  anything outside the grammar, division by zero, complex numbers, input made to be slow

    Examples
    --------
    >>> parse("m0*k3 + 0.5*k3**2")
    k3**2/2 + k3*m0
    >>> parse("9**9**9")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    gyrostat.errors.ExpressionError: cannot read '9**9**9': the exponent 387420489 is too large; exponents go up to 100, ...
    """
    return Parser(text).whole()


def shown(number: Any, digits: int = 40) -> str:
    """A number in a message: a rational exactly if it is short, anything else rounded."""
    value = Rational(number) if isinstance(number, int) else number
    short = isinstance(value, Rational) and max(abs(int(value.p)), int(value.q)).bit_length() <= 3.3 * digits
    if short:
        return f"{value.p}/{value.q}" if value.q != 1 else str(value.p)
    return str(value.evalf(12))


def exact_expression(value: Any, name: str = "value") -> Expr:
    """An expression in our symbols, matched by name, its floats the dyadic rationals they are; or an exact number."""
    if isinstance(value, Expr) and value.free_symbols:
        if taken := [root for root in value.atoms(CRootOf) if root.poly.gen == symbol(root.poly.gen.name)]:
            raise ExpressionError(f"{name} contains {taken[0]}, the root of a polynomial in a name of its own: write it in another symbol")
        return own(value.xreplace({f: Rational(f) for f in value.atoms(Float)}))
    return exact_number(value, name)


def exact_number(value: Any, name: str = "value") -> Expr:
    """The exact real number a user means: a Rational, or a SymPy constant where it is irrational.

    int, Fraction, Decimal, SymPy numbers and strings are what they say; a float, or an mpmath.mpf, is the dyadic rational it is.

    Examples
    --------
    >>> exact_number("0.1"), exact_number(0.5), exact_number("sqrt(3)/2")
    (1/10, 1/2, sqrt(3)/2)
    """
    if type(value) in (int, Fraction):                     # by far the most
        return Rational(value.numerator, value.denominator)
    if isinstance(value, str) or isinstance(value, Decimal) and value.is_finite():
        value = parse(str(value))
    if isinstance(value, Float) or isinstance(value, mpmath.mpf) and mpmath.isfinite(value):
        value = Rational(*map(int, mpmath.libmp.to_rational(value._mpf_)))
    if isinstance(value, Expr):
        if value.free_symbols:
            raise ValuesError(f"{name} = {value} contains the names {', '.join(sorted(map(str, value.free_symbols)))}: give a number")
        if value.has(Float) or not (value.is_finite and value.is_real):
            raise ValuesError(f"{name} = {value} is not an exact finite real number: give an integer, fraction or closed form")
        return value
    if isinstance(value, bool) or not (isinstance(value, numbers.Real) or hasattr(value, "as_integer_ratio")):
        raise ValuesError(f"{name} = {value!r} is a {type(value).__name__}, not a real number: give an int, Fraction, "
                          "float, SymPy number or a string like '1/2'")
    if isinstance(value, numbers.Rational):
        return Rational(int(value.numerator), int(value.denominator))
    try:
        return Rational(*value.as_integer_ratio())
    except (OverflowError, ValueError, AttributeError):
        raise ValuesError(f"{name} = {value} is not finite: give a finite number") from None
