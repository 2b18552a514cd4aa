"""Places expressions at a point of a family: symbol by symbol, each found once, ∇h and the field."""
from collections.abc import Callable, Sequence
from typing import Any

from sympy import Expr, ImmutableMatrix, Symbol

from ...algebra.rings.matrices import applied, solved
from ..scenes.lie_poisson import LiePoisson
from ..scenes.system import System


def replaced(expression: Any, known: dict[Symbol, Expr], of: Callable[[Symbol], Expr]) -> Any:
    """Return an expression or matrix with what each of its symbols becomes, which is found once.

    Parameters
    ----------
    expression : Expr or ImmutableMatrix, any shape
    known : dict of Symbol to Expr
        what was found; it is added to
    of : callable
        tells what a symbol becomes

    Returns
    -------
    Expr or ImmutableMatrix, of the same shape
    """
    for name in (free := expression.free_symbols) - known.keys():
        known[name] = of(name)
    rule = {name: known[name] for name in free if known[name] is not name}
    return expression.xreplace(rule) if rule else expression


def gradient_at(scene: System, place: Callable[[Expr], Expr]) -> tuple[Expr, ...]:
    """Return ∇h at a point: ω, then ∇U.

    A tensor with products of inertia has a long inverse, and ω is short: Iω = π is solved at the point.

    Parameters
    ----------
    scene : System
    place : callable
        inserts the point into an expression

    Returns
    -------
    tuple of Expr
    """
    gradient = scene.energy_gradient.flat()
    if scene.coupled or not isinstance(scene.body.inertia, ImmutableMatrix):
        return tuple(map(place, gradient))
    tensor = [list(map(place, row)) for row in scene.body.inertia.tolist()]
    return *solved(tensor, list(map(place, scene.space.coordinates[:3]))), *map(place, gradient[3:])


def field_at(space: LiePoisson, gradient: Sequence[Expr], place: Callable[[Expr], Expr]
             ) -> list[tuple[Symbol, Expr]]:
    """Return each coordinate with its rate at a point, B ∇h, by ∇h there."""
    tensor = [list(map(place, row)) for row in space.tensor.tolist()]
    return list(zip(space.coordinates, applied(tensor, gradient)))
