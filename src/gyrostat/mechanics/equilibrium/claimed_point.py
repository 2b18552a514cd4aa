"""Makes an equilibrium of a point that a user claims, with the relations that hold on it."""
from collections.abc import Sequence
from itertools import chain, repeat
from typing import Any

from sympy import Expr

from ...algebra.text.numbers import exact_expression
from ...arguments import checked
from ...notation import jet, symbol
from ..scenes.system import System
from .equilibrium import Equilibrium


@checked
def equilibrium(scene: System, point: Sequence[Any], *, relations: Sequence[tuple[Any, Any]] = (),
                domain: Sequence[Expr] = (), label: str = "E") -> Equilibrium:
    """Return an equilibrium at a point you claim; construction checks that the field vanishes there.

    Parameters
    ----------
    scene : System
    point : sequence, shape (n,)
        numbers or expressions: momenta [M L²/T], then k [1]
    relations : pairs (symbol, value)
        what holds on the family, such as (dU, …)
    domain : sequence of Expr
        positive on the family
    label : str

    Returns
    -------
    Equilibrium

    Raises
    ------
    EquilibriumError
        a component of the field does not vanish; the message names it

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> gs.equilibrium(top, (0, 0, 0, 1, 0, 0))  # doctest: +NORMALIZE_WHITESPACE
    Traceback (most recent call last):
    gyrostat.errors.EquilibriumError: E is not an equilibrium:
    dpi2/dt = -m0. Check the point, or in Python pass the relation that makes
    these vanish as relations=((symbol, value),).
    """
    given = scene.potential is not None and scene.potential.given
    pairs = tuple((symbol(str(name)), exact_expression(value, str(name))) for name, value in relations)
    coordinates = chain(map(str, scene.space.coordinates), repeat("the point"))
    return Equilibrium(label, scene, tuple(map(exact_expression, point, coordinates)), pairs,
                       tuple(map(exact_expression, domain)),
                       tuple(name.name for name, _ in pairs if not (given and jet(name.name))))
