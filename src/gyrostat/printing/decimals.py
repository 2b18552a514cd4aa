"""Writes polynomials with long coefficients in decimals: the first digits, and … for those that follow."""
from collections.abc import Iterable
from dataclasses import replace
from decimal import ROUND_DOWN
from typing import Any

from sympy import Add, Expr, Float, Rational, S
from sympy.printing.latex import LatexPrinter

from ..algebra.rings.polynomials import Ring
from ..stability.criteria.conditions import Condition
from .blocks import Block, Display, Rows, Sentence
from .numbers import ALONE, in_sentence, is_long, long_decimal


class DecimalPrinter(LatexPrinter):
    """Prints the first digits of a decimal in LaTeX, and dots for those that follow."""

    def _print_Float(self, expr: Float) -> str:
        digits, _, power = str(expr).partition("e")
        return rf"{digits.rstrip('.')}\dots" + (rf" \cdot 10^{{{int(power)}}}" if power else "")


def in_decimals(expression: Expr, scale: bool = False) -> Expr:
    """Return a polynomial with its coefficients as decimals, divided by the first one's size if asked.

    A quotient of polynomials is returned as it is.
    """
    ring = Ring([expression])
    top, bottom = ring.fraction(expression)
    if ring.expression(bottom).free_symbols:
        return expression
    parts = [(ring.monomial(kind), ring.expression(c) / ring.expression(bottom))
             for kind, c in ring.coefficients(ring.reduce(top), expression.free_symbols).items()]
    if scale:
        size = abs(max(parts, key=lambda part: _degrees(part[0]))[1])
        parts = [(x, c / size) for x, c in parts]
    return Add(*(x * _decimal(c) for x, c in parts))


def compared(condition: Condition) -> Display:
    """Write a condition with long coefficients: x > −18.8153… if it is linear in one name."""
    scaled = in_decimals(condition.margin, scale=True)
    names = scaled.free_symbols
    less, greater = ("<", ">") if condition.strict else ("≤", "≥")
    if len(names) == 1 and scaled.diff(*names).is_number:
        slope, (x,) = condition.margin.diff(*names), names
        value = in_sentence(-condition.margin.xreplace({x: S.Zero}) / slope)
        return Display(x, value, condition.at, greater if slope.is_positive else less)
    terms = Add.make_args(scaled)
    left = [term for term in terms if not term.could_extract_minus_sign()]
    return Display(Add(*left), Add(*(-term for term in terms if term not in left)), condition.at, greater)


def with_decimals(blocks: Iterable[Block]) -> list[Block]:
    """Write the formulas of blocks in decimals, as far as they have long coefficients."""
    return [replace(b, name=_short(b.name), value=_short(b.value)) if isinstance(b, Display)
            else replace(b, parts=tuple(map(_short, b.parts))) if isinstance(b, Sentence)
            else replace(b, rows=tuple((tuple(map(_short, a)), tuple(map(_short, c))) for a, c in b.rows))
            if isinstance(b, Rows) else b for b in blocks]


def _short(part: Any) -> Any:
    return in_decimals(part) if is_long(part) and part.free_symbols else part


def _degrees(monomial: Expr) -> tuple[Expr, Expr]:
    """Return the degree of a monomial, and that in the names that may have either sign."""
    powers = monomial.as_powers_dict()
    return (Add(*(n for x, n in powers.items() if x.free_symbols)),
            Add(*(n for x, n in powers.items() if x.free_symbols and not x.is_positive)))


def _decimal(value: Expr) -> Expr:
    """Return a short rational as it is, and the first digits of any other number."""
    if isinstance(value, Rational) and not is_long(value):
        return value
    decimal = long_decimal(value)
    places = ALONE - 1 - decimal.adjusted()
    return Float(str(decimal.quantize(decimal.__class__(1).scaleb(-places), ROUND_DOWN)), ALONE)
