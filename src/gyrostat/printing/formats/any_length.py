"""Integers and fractions of any length in LaTeX: Python refuses to print more than 4300 digits."""
from flint import fmpz
from sympy import Rational
from sympy.printing.latex import LatexPrinter


class AnyLength(LatexPrinter):
    """SymPy's printer, with the digits of python-flint."""

    def _print_Integer(self, expr: Rational) -> str:
        return str(fmpz(int(expr.p)))

    def _print_Rational(self, expr: Rational) -> str:
        return rf"{'- ' if expr.p < 0 else ''}\frac{{{fmpz(abs(int(expr.p)))}}}{{{fmpz(int(expr.q))}}}"
