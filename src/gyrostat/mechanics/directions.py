"""Unit vectors in parameters."""
from sympy import Expr

from ..notation import symbol


def stereographic() -> tuple[Expr, Expr, Expr]:
    """A direction k by its stereographic coordinates u1, u2: every one but −e3, each exactly a unit vector.

    k = (2 u1, 2 u2, 1 − u1² − u2²)/(1 + u1² + u2²), the projection from −e3 onto the plane k3 = 0.

    Returns
    -------
    tuple of Expr, shape (3,)
        rational in u1 and u2; e3 is (0, 0), abs(u) = 1 where k3 = 0

    Examples
    --------
    >>> import gyrostat as gs
    >>> k = gs.stereographic()
    >>> [x.subs({gs.symbol("u1"): 1, gs.symbol("u2"): 2}) for x in k]
    [1/3, 2/3, -2/3]
    """
    u1, u2 = symbol("u1"), symbol("u2")
    square = u1**2 + u2**2
    return 2 * u1 / (1 + square), 2 * u2 / (1 + square), (1 - square) / (1 + square)
