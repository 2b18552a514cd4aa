"""What decides a permanent rotation of a body in a field: inertia, rotor, ∇U and D²U in a direction."""
from collections.abc import Sequence
from typing import Any, NamedTuple

from sympy import Expr, S, zeros

from ...algebra.reals.exact import evaluate
from ...algebra.rings.matrices import cross
from ...mechanics.equilibrium.near_pole import near_pole, refuse_rough
from ...mechanics.scenes.system import System
from ...stability.criteria.amended_form import dot
from .heavy_polynomials import DIRECTION


class Data(NamedTuple):
    """Of a scene at numbers, in a direction: of the body, and of U; exact, or in balls."""

    inertia: list[list[Any]]
    rotor: list[Any]
    gradient: list[Any]
    hessian: list[list[Any]]


def data_at(scene: System, k: Sequence[Expr]) -> Data:
    """The same of a scene."""
    U = scene.potential
    assert U is not None
    at = dict(zip(DIRECTION, k))
    if near := near_pole(U, k[2]):
        refuse_rough("a rotation about axis 3", U, near, (), near.positive)
        slope = [S.Zero, S.Zero, near.derivative(1)]
        curved = zeros(3).tolist()                         # across k nothing is asked of the curvature
        return Data(scene.body.tensor.tolist(), list(scene.body.gyrostatic_momentum), slope, curved)
    slopes = U.gradient()
    rows = slopes, *(U.following(d) if d else (S.Zero,) * 3 for d in slopes)
    first, *second = ([evaluate(U.value(d), at) if d else S.Zero for d in row] for row in rows)
    return Data(scene.body.tensor.tolist(), list(scene.body.gyrostatic_momentum), first, second)


def unreached(inertia: Sequence[Sequence[Any]], rotor: Sequence[Any], gradient: Sequence[Any],
              curved: Sequence[Sequence[Any]], k: Sequence[Any], omega: Any) -> list[Any]:
    """M × k, and D²U − k·∇U between vectors across k."""
    M, along = [omega * dot(row, k) + l for row, l in zip(inertia, rotor)], dot(gradient, k)
    rows = [[x - along * (n == m) for m, x in enumerate(row)] for n, row in enumerate(curved)]
    columns = zip(*(cross(row, k) for row in rows))
    return [*cross(M, k), *(x for column in columns for x in cross(column, k))]
