"""A rotor whose rate is given in turns: π in l, and in abs(M)."""
from sympy import Expr, Matrix, S

from ...algebra.enclosures.algebraic import is_algebraic


def without_pi(vector: Matrix, radius: Expr) -> tuple[Matrix, Expr, Expr]:
    """A vector along with l, and abs(M), both divided by abs(M) where that is not algebraic; and the divisor.

    ν is the same, and algebraic where both have π.
    """
    unit = S.One if radius.free_symbols or is_algebraic(radius) else radius
    return (vector / unit).expand(), radius / unit, unit
