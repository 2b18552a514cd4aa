"""Writes an exact number for JSON: its minimal polynomial and an interval with no other root of that."""
from decimal import Context, Decimal
from fractions import Fraction
from typing import Any

from sympy import Expr, Float, Poly, Symbol

from ...algebra.reals.minimal_polynomial import algebraic_number
from .exact_text import exact_text

WORKING = Context(prec=10**5)


def exact_data(number: Expr) -> dict[str, Any] | None:
    """Return the polynomial in x and the ends of the interval.

    For a transcendental number it is the expression; None if only digits of the number are known.

    Examples
    --------
    >>> from sympy import Rational, pi, sqrt
    >>> exact_data(sqrt(2) / 2)
    {'polynomial': '2*x**2 - 1', 'interval': ['0.707106781186547524', '0.707106781186547525']}
    >>> exact_data(Rational(-2, 3))
    {'polynomial': '3*x + 2', 'interval': ['-2/3', '-2/3']}
    >>> exact_data(pi / 2), exact_data(Float("0.1", 30))
    ({'expression': 'pi/2'}, None)
    """
    if number.has(Float):
        return None
    if (found := algebraic_number(number)) is None:
        return {"expression": exact_text(number)}
    coefficients = [int(c) for c in reversed(found.polynomial.coeffs())]
    return {"polynomial": str(Poly(coefficients, Symbol("x")).as_expr()),
            "interval": [_text(found.low), _text(found.high)]}


def _text(end: Fraction) -> str:
    """Write a decimal, or a fraction if it is none."""
    rest = end.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    if rest != 1 or end.denominator == 1:
        return str(end)
    return f"{WORKING.divide(Decimal(end.numerator), Decimal(end.denominator)):f}"
