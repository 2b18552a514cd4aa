"""A rotor whose rate is given in turns: π in l, and in abs(M)."""
from collections.abc import Callable
from typing import TypeVar

from sympy import Expr, Matrix, S, pi

from ..algebra.algebraic import is_algebraic
from ..errors import ScopeError
from ..mechanics.body import Gyrostat

Found = TypeVar("Found")


def without_pi(vector: Matrix, radius: Expr) -> tuple[Matrix, Expr, Expr]:
    """A vector along with l, and abs(M), both divided by abs(M) where that is not algebraic; and the divisor.

    ν is the same where both have π.
    """
    unit = S.One if radius.free_symbols or is_algebraic(radius) else radius
    return (vector / unit).expand(), radius / unit, unit


def explained(solve: Callable[[], Found], body: Gyrostat, radius: Expr) -> Found:
    """What solves an equation of the rotations; a refusal is in words of the body where π is in one of l and
    abs(M).
    """
    try:
        return solve()
    except ScopeError:
        if not any(x.has(pi) for x in (*body.gyrostatic_momentum, radius)):
            raise
    rotor = ", ".join(map(str, body.gyrostatic_momentum))
    raise ScopeError(f"l = ({rotor}) and M = {radius}: with pi in one of them only, as a rate in rpm "
                     "brings it, the rotations are roots of a polynomial of degree 6 that is not algebraic, "
                     "and are not found: give M as a multiple of pi too, 20*pi, or the wheel by its "
                     "momentum in N m s")
