"""Turns numbers and expressions of users into exact mathematics; a float counts as the fraction it is."""
import math
import numbers
from decimal import Decimal
from fractions import Fraction
from typing import Any

import mpmath
from sympy import CRootOf, Expr, Float, Rational, S

from ...errors import ExpressionError, ValuesError, brief
from ...notation import own, symbol
from ..enclosures.rationals import to_sympy
from ..rings.subexpressions import occurring
from .bounded_parts import enclosure
from .quantities import in_si, text_of

LONGEST = 2**17                                        # bits of a number that is no text
PRINTED = 14_000                                       # of one in a scene: Python prints up to 4300 digits
_UNDEFINED = (S.NaN, S.ComplexInfinity, S.Infinity, S.NegativeInfinity)
_NO_NUMBERS = frozenset({"nan", "inf", "infinity", "oo", "zoo"})


def shown(number: Any, digits: int = 40) -> str:
    """Return a number for a message: a short rational exactly, with the decimal that a double was.

    Any other number is rounded.

    Examples
    --------
    >>> shown(0.1), shown(Rational(1, 3))
    ('0.1 (3602879701896397/36028797018963968)', '1/3')
    """
    value = Rational(number) if isinstance(number, int | float) else number
    if value.has(*_UNDEFINED):
        return "infinite" if value.is_infinite else "undefined"
    short = isinstance(value, Rational) and max(abs(int(value.p)), int(value.q)).bit_length() <= 3.3 * digits
    if not short:
        return str(value.evalf(12))
    exact, decimal = f"{value.p}/{value.q}" if value.q != 1 else str(value.p), double(value)
    return f"{decimal} ({exact})" if decimal else exact


def double(value: Expr) -> str:
    """Return the decimal that a rational was, as far as can be told.

    It is told for a double that is longer as a fraction; "" is returned for any other number.
    """
    if not isinstance(value, Rational) or value.q.bit_count() != 1 or not 2**20 <= value.q < 2**1075:
        return ""
    near = value.p / value.q
    return repr(near) if Fraction(near) == Fraction(value) else ""


def exact_expression(value: Any, name: str = "value") -> Expr:
    """Return an expression in our symbols, matched by name, its floats the dyadic rationals they are.

    It may be an exact number. A text is read by the grammar, as on the command line.

    Examples
    --------
    >>> exact_expression("k1*k2 + m0*k3"), exact_expression(0.5)
    (k1*k2 + k3*m0, 1/2)
    >>> exact_expression("25 g m^2", "I1")
    1/40
    """
    if isinstance(value, str):
        return in_si(value, name)[0]
    if isinstance(value, Expr) and value.free_symbols:
        roots = occurring(value, CRootOf)
        if taken := [root for root in roots if root.poly.gen == symbol(root.poly.gen.name)]:
            raise ExpressionError(f"{name} contains {taken[0]}, the root of a polynomial in a name of its "
                                  "own: write it in another symbol")
        for number in value.atoms(Rational):
            _bounded(number, name, PRINTED)
        return own(value.xreplace({f: _dyadic(f, name) for f in value.atoms(Float)}))
    return _bounded(exact_number(value, name), name, PRINTED)


def exact_number(value: Any, name: str = "value") -> Expr:
    """Return the exact real number that a user means.

    It is a Rational, or a SymPy constant if it is irrational. int, Fraction, Decimal, SymPy numbers and
    strings are what they say; a float, or an mpmath.mpf, is the dyadic rational it is. An array of one number
    and no axis is that number. A text may have a unit, of the dimension of the name, and so may the quantity
    of a library of units: the number is that in SI.

    Examples
    --------
    >>> exact_number("0.1"), exact_number(0.5), exact_number("sqrt(3)/2")
    (1/10, 1/2, sqrt(3)/2)
    >>> exact_number("3000 rpm", "omega3_0"), exact_number("25 g m^2", "I1")
    (100*pi, 1/40)
    """
    # by far the most common kinds, first
    kind = type(value)
    if kind is str:
        return _text(value, name)
    if isinstance(value, Rational):
        return _bounded(value, name)
    if kind is Fraction or kind is int or kind is float and math.isfinite(value):
        return _bounded(to_sympy(value), name)
    if getattr(value, "shape", None) == () and hasattr(value, "item") and not getattr(value, "mask", False):
        value = value.item()
    value = text_of(value)
    if isinstance(value, str) or isinstance(value, Decimal) and value.is_finite():
        return _text(str(value), name)
    if isinstance(value, Float | mpmath.mpf) and mpmath.isfinite(value):
        return _dyadic(value, name)
    if isinstance(value, Expr):
        if value.free_symbols:
            raise ValuesError(f"{name} = {value} contains the names "
                              f"{', '.join(sorted(map(str, value.free_symbols)))}: give a number")
        # SymPy takes many seconds to tell a sum of nested roots from 0
        known = enclosure(value)
        if value.has(Float) or not (known is not None and known.is_finite() or value.is_finite
                                    and value.is_real):
            raise ValuesError(f"{name} = {value} is not an exact finite real number: give an integer, "
                              "fraction or closed form")
        return _bounded(value, name)
    if isinstance(value, bool | type) or not (isinstance(value, numbers.Real)
                                              or hasattr(value, "as_integer_ratio")):
        raise ValuesError(f"{name} = {brief(value)} is a {type(value).__name__}, not a real number: give "
                          "an int, Fraction, float, SymPy number or a string like '1/2'")
    if isinstance(value, numbers.Rational):
        return _bounded(Rational(int(value.numerator), int(value.denominator)), name)
    try:
        ratio = Rational(*map(int, value.as_integer_ratio()))
    except (OverflowError, ValueError, AttributeError):
        raise ValuesError(f"{name} = {value} is not finite: give a finite number") from None
    return _bounded(ratio, name)


def _text(text: str, name: str) -> Expr:
    """Return the number that a text stands for."""
    value, _ = in_si(text, name)
    if isinstance(value, Rational) or not value.free_symbols:
        return value
    names = sorted(s.name for s in value.free_symbols)
    if any(n.lower() in _NO_NUMBERS for n in names):
        raise ValuesError(f"{name} = {brief(text)[1:-1]} is not finite: give a finite number")
    raise ValuesError(f"{name} = {brief(text)[1:-1]} contains the names {brief(', '.join(names))[1:-1]}: "
                      "give a number")


def _dyadic(value: Any, name: str) -> Rational:
    """Return the number that a float of any precision is."""
    _, mantissa, exponent, bits = value._mpf_
    if abs(exponent) + bits > LONGEST:
        raise ValuesError(f"{name} = {value} is too long: numbers have up to {LONGEST} bits")
    return Rational(*map(int, mpmath.libmp.to_rational(value._mpf_)))


def _bounded(value: Expr, name: str, most: int = LONGEST) -> Expr:
    if isinstance(value, Rational) and (value.p.bit_length() > most or value.q.bit_length() > most):
        raise ValuesError(f"{name} = {shown(value)} is too long: numbers here have up to {most} bits")
    return value
