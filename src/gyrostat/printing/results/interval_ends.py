"""Ends of intervals and other exact numbers, as they read best."""
from typing import Any

from sympy import Abs, CRootOf, Expr, Float, Pow

from ...algebra.enclosures.balls import Enclosed, accurate
from ...algebra.rings.readable import readable
from ..blocks import Word


def number(value: Expr) -> Any:
    """An end as it reads best: the root of a polynomial as a decimal, a fraction factored."""
    if has_no_closed_form(value):
        near = value if value.is_Float else Float(accurate(value, 110).mid().str(30, radius=False), 30)
        digits = str(near.n(12))
        return Word(f"{digits.replace('-', '−')}…", rf"{digits}\dots")
    return tidy(value)


def tidy(value: Expr) -> Expr:
    """A fraction of polynomials factored, anything else as it is."""
    rational = all(p.exp.is_Integer for p in value.atoms(Pow)) and not value.atoms(Abs)
    return readable(value) if value.free_symbols and rational else value


def has_no_closed_form(value: Expr) -> bool:
    """Whether it is the root of a polynomial, or known to some digits only."""
    return bool(value.has(CRootOf, Enclosed, Float))
