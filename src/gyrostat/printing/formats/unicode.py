"""Writes formulas in one line of Unicode, and matrices as aligned rows."""
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

from flint import fmpq
from sympy import Add, Expr, Float, Mul, Pow, Symbol
from sympy.printing.str import StrPrinter

from ...notation import jet_name
from ...typesetting import SUPERSCRIPTS, typeset
from ..order import ordered_factors, ordered_terms, over, signed


class _Unicode(StrPrinter):
    def __init__(self, at: Any = None):
        super().__init__()
        self.at = at

    def _print_Symbol(self, expr: Symbol) -> str:
        return typeset(expr.name, self.at, "text")

    def _print_Pow(self, expr: Pow, rational: bool = False) -> str:
        base, exponent = expr.args
        if exponent.is_Rational and exponent < 0:
            return "1/" + self._factor(Pow(base, -exponent))
        if exponent.is_Rational and exponent.q == 2 and exponent.p == 1:
            inner = self._print(base)
            return f"√{inner}" if base.is_Symbol or base.is_Integer and base >= 0 else f"√({inner})"
        inner = self._print(base)
        plain = base.is_Symbol and not inner.endswith(tuple("⁰)")) or base.is_Integer and base >= 0
        inner = inner if plain else f"({inner})"
        return inner + (str(exponent).translate(SUPERSCRIPTS) if exponent.is_Integer
                        else f"^({self._print(exponent)})")

    def _print_Mul(self, expr: Mul) -> str:
        if expr.could_extract_minus_sign():
            return "−" + self._print(-expr)
        top, bottom = over(expr)
        if bottom == 1:
            return " ".join(map(self._factor, ordered_factors(top)))
        above = " ".join(map(self._factor, ordered_factors(top))) or "1"
        below = list(map(self._factor, ordered_factors(bottom)))
        return f"{above}/{below[0]}" if len(below) == 1 else f"{above}/({' '.join(below)})"

    def _factor(self, factor: Expr) -> str:
        return f"({self._print(factor)})" if factor.is_Add else self._print(factor)

    def _print_Add(self, expr: Add, order: Any = None) -> str:
        return signed([self._print(term) for term in ordered_terms(expr)], "−")

    def _print_Abs(self, expr: Expr) -> str:
        return f"|{self._print(expr.args[0])}|"

    def _print_Exp1(self, expr: Expr) -> str:
        return "e"

    def _print_Pi(self, expr: Expr) -> str:
        return "π"

    def _print_Rational(self, expr: Expr) -> str:
        """Write a rational number of any length; Python refuses to print more than 4300 digits."""
        return str(fmpq(int(expr.p), int(expr.q))).replace("-", "−")

    _print_Integer = _print_Rational

    def _print_Float(self, expr: Float) -> str:
        """Write the first digits of a number, and … for those that follow."""
        digits, _, power = str(expr).partition("e")
        ten = f"·10{str(int(power)).translate(SUPERSCRIPTS)}" if power else ""
        return f"{digits.rstrip('.').replace('-', '−')}…{ten}"

    def _print_Derivative(self, expr: Any) -> str:
        variables = "".join(str(v)[-1] * n for v, n in expr.variable_count)
        return typeset(jet_name(len(variables), variables if len(expr.expr.args) > 1 else ""), style="text")


@lru_cache(maxsize=1024)
def unicode(expression: Expr, at: Any = None) -> str:
    """Write an expression in one line; derivatives of U take their argument from at.

    Examples
    --------
    >>> import gyrostat as gs
    >>> unicode((gs.symbol("pi3_0") + gs.symbol("l"))**2 - 4*gs.symbol("I1")*gs.symbol("dU"), at=1)
    '(π₃⁰ + l)² − 4 I₁ U′(1)'
    """
    return _Unicode(at)._print(expression)


def matrix_lines(rows: Sequence[Sequence[Expr]], at: Any = None) -> list[str]:
    """Write the rows of a matrix in brackets, with aligned columns."""
    cells = [[unicode(entry, at) for entry in row] for row in rows]
    widths = [max(len(row[j]) for row in cells) for j in range(len(cells[0]))]
    last = len(cells) - 1
    ends = ["()"] if last == 0 else ["⎛⎞", *["⎜⎟"] * (last - 1), "⎝⎠"]
    return [f"{e[0]} {'   '.join(c.center(w) for c, w in zip(row, widths))} {e[1]}"
            for e, row in zip(ends, cells)]
