"""Evaluates arcs of permanent rotations in doubles: k, omega and sigma along them."""
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations, pairwise

import numpy as np
from sympy import Expr, oo

from ..algebra.enclosures.floats import Array
from ..algebra.reals.exact import is_identically_zero
from ..equilibria.curves.arc import Arc, Piece
from ..stability.decision import Verdict
from .globe import refined

ROUNDS, FIRST = 12, 33                                 # halvings; values of the parameter at first


def moves(arc: Arc) -> bool:
    """Whether the direction changes along an arc."""
    k = arc.k
    return any(is_identically_zero(a.diff(x) * b - a * b.diff(x)) is False
               for x in {s for a in k for s in a.free_symbols} for a, b in combinations(k, 2))


def changes_of(arc: Arc) -> list[tuple[Expr, str]]:
    """Return each value at which the verdict or its reason changes, and the two verdicts, stable first."""
    order, found = list(Verdict), []
    for one, two in pairwise(arc.pieces):
        if one.decision.reason != two.decision.reason:
            first, last = sorted((one.decision.verdict, two.decision.verdict), key=order.index)
            name = first.name.lower()
            found.append((two.low, f"{name}, other reason" if first is last
                          else f"{name} to {last.name.lower()}"))
    return found


def along(arc: Arc, values: Array) -> tuple[Array, Array, Array]:
    """Return k, shape (n, 3), omega and sigma at values of the parameter; without a rotor omega > 0."""
    near = [arc.near(Fraction(x)) for x in values.tolist()]
    k, omega, sigma = map(np.array, zip(*near)) if near else (np.zeros((0, 3)), values, values)
    return k, omega, sigma


def directions(arc: Arc, piece: Piece, step: float) -> Array:
    """Return k along a piece with its ends, shape (n, 3), no two neighbours further apart than a step."""
    first, last = (floats(end.k) if at == own else along(arc, np.array([float(at)]))[0][0]
                   for end, at, own in zip(arc.ends, (piece.low, piece.high), (arc.low, arc.high)))
    return halved(lambda t: along(arc, placed(arc, piece, t))[0], first, last, step)


def halved(place: Callable[[Array], Array], first: Array, last: Array, step: float) -> Array:
    """Return places at values from 0 to 1; between two that are further apart than a step, one more."""
    t = np.linspace(0, 1, FIRST)
    return refined(place, t, np.vstack([first, place(t[1:-1]), last]), step, ROUNDS)


def placed(arc: Arc, piece: Piece, t: Array) -> Array:
    """Map t between 0 and 1 to values of the parameter between the ends of a piece, finite or not."""
    low, high, size = float(piece.low), float(piece.high), _size(arc)
    if piece.low == -oo and piece.high == oo:
        return size * np.tan(np.pi * (t - 0.5))
    if piece.low == -oo:
        return high - size * (1 - t) / t
    return low + size * t / (1 - t) if piece.high == oo else low + (high - low) * t


def _size(arc: Arc) -> float:
    """Return a scale of the parameter: the sum of the moments for tau, a rate of the body for omega."""
    body = arc.scene.body
    moment = float(body.tensor.trace())
    if arc.both_ways:
        return moment
    U = arc.scene.potential
    assert U is not None
    torque = sum(abs(float(U.value(x))) for x in U.gradient() if x)
    return float(np.sqrt(torque / moment)) + sum(abs(float(x)) for x in body.gyrostatic_momentum) / moment


def floats(k: tuple[Expr, ...]) -> Array:
    """Return a direction in doubles."""
    return np.array([float(x) for x in k])
