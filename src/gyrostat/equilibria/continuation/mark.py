"""The record of a value of a name at which relative equilibria meet or change."""
from dataclasses import dataclass

from sympy import Expr

from ..._display import Shown
from ...notation import Stored


@dataclass(frozen=True, repr=False)
class Mark(Shown, Stored):
    """A value of the free name at which relative equilibria meet or change, and where.

    Its kind says what happens. If branches meet between the poles "at fixed rate" or "on a level", it starts
    with "fold", "pitchfork", "crossing" or "isolated". For permanent rotations it is the kind of the
    degenerate one: "fold", "pitchfork", "umbilic" (a fold and a pitchfork in one), "circle leaves an axis"
    for a body of revolution, "circle at this value alone" or "sphere at this value alone". If a rotation in a
    field changes its stability and meets no other, it is "singular form", as where C1 turns along omega, or
    "frequencies meet". For a satellite it is "fold", "pitchfork", "crossing", or "singular form" where an
    attitude goes on although K is singular, as on a closed curve of attitudes that exists at this value.

    Parameters
    ----------
    kind : str
    name : str
        the one that is free
    value : Expr
        exact
    k3 : Expr or None
        None for a free gyrostat and a satellite; as nu, momentum and k it is exact, unless stability changes
        without a meeting
    nu : Expr or None
        for a free gyrostat: ω = ν M
    momentum : tuple of Expr, shape (3,), or None
        for a free gyrostat: M
    k : tuple of Expr, shape (3,), or None
        for a body in a field that is not of revolution
    n, r : tuple of Expr, shape (3,), or None
        for a satellite, to five decimals
    numbers : (int, int) or None
        for a satellite: how many attitudes there are before and after this value, exact
    changes : bool or None
        whether stability changes along a branch; where U is infinite it may, with no equilibrium between;
        None if it was not asked, as where rotations meet

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> numbers = {"I1": 1, "l": 0, "m0": 1}
    >>> point = gs.bifurcation_points(top, "pi3_0", numbers)[0]
    >>> point.kind, point.value, point.k3
    ('precessions leave E1', -2, 1)
    """

    kind: str
    name: str
    value: Expr
    k3: Expr | None = None
    nu: Expr | None = None
    momentum: tuple[Expr, ...] | None = None
    k: tuple[Expr, ...] | None = None
    n: tuple[Expr, ...] | None = None
    r: tuple[Expr, ...] | None = None
    numbers: tuple[int, int] | None = None
    changes: bool | None = None
