"""Unit vectors in parameters: by stereographic projection, or any unit vector, checked at numbers."""
from collections.abc import Sequence

from sympy import Expr

from ...algebra.text.grammar import parse
from ...notation import symbol
from .derived_once import once
from .equilibrium import Equilibrium

STEREOGRAPHIC = "stereographic"                       # the word for it


def stereographic() -> tuple[Expr, Expr, Expr]:
    """Return a direction k by its stereographic coordinates u1, u2: every direction but −e3.

    It is exactly a unit vector: k = (2 u1, 2 u2, 1 − u1² − u2²)/(1 + u1² + u2²), the projection from −e3 onto
    the plane k3 = 0.

    Returns
    -------
    tuple of Expr, shape (3,)
        rational in u1 and u2; e3 is (0, 0), abs(u) = 1 where k3 = 0

    Examples
    --------
    >>> import gyrostat as gs
    >>> at = {gs.symbol("u1"): 1, gs.symbol("u2"): 2}
    >>> [x.subs(at) for x in gs.stereographic()]
    [1/3, 2/3, -2/3]
    """
    u1, u2 = symbol("u1"), symbol("u2")
    square = u1**2 + u2**2
    return 2 * u1 / (1 + square), 2 * u2 / (1 + square), (1 - square) / (1 + square)


@once
def in_any_direction(eq: Equilibrium) -> bool:
    """Tell whether k1, k2, k3 are names of a family: any unit vector.

    That it is a unit vector is checked at numbers.
    """
    return eq.system.potential is not None and eq.point[3:] == eq.system.space.coordinates[3:]


def direction_in(texts: Sequence[str]) -> tuple[Expr, ...]:
    """Return the direction that three expressions name, or the word "stereographic"."""
    return stereographic() if list(texts) == [STEREOGRAPHIC] else tuple(map(parse, texts))
