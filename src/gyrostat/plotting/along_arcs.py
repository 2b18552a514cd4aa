"""The arcs of Staude's cone, and of the curve of a gyrostat, in doubles: k, omega and sigma along them."""
from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from sympy import Expr, oo

from ..algebra.enclosures.floats import Array, in_floats
from ..equilibria.curves.gyrostat_arcs import GyrostatArc
from ..equilibria.curves.staude_arcs import Piece, StaudeArc
from .globe import refined

ROUNDS, FIRST = 12, 33                                 # halvings; values of the parameter at first
Arc = StaudeArc | GyrostatArc


class Points(NamedTuple):
    """Permanent rotations: k of shape (n, 3), omega, and sigma of ∇U = omega² Ik + omega l + sigma k."""

    k: Array
    omega: Array
    sigma: Array


def moves(arc: Arc) -> bool:
    """Whether the direction changes along an arc."""
    return sum(x != 0 for x in (arc.curve.k if isinstance(arc, GyrostatArc) else arc.n)) > 1


def along(arc: Arc, values: Array) -> Points:
    """At values of the parameter; without a rotor those of positive omega."""
    if isinstance(arc, GyrostatArc):
        near = [arc.near(Fraction(x)) for x in values.tolist()]
        return Points(np.array([k for k, _ in near]).reshape(-1, 3), values, np.array([s for _, s in near]))
    here = {arc.parameter: values}
    n, tau = ([np.broadcast_to(in_floats(x, np, here), values.shape) for x in row]
              for row in (arc.n, (arc.tau,)))
    length = np.linalg.norm(n, axis=0)
    return Points(np.stack(n, axis=1) / length[:, None], np.sqrt(length), tau[0] * length)


def directions(arc: Arc, piece: Piece, step: float) -> Array:
    """k along a piece, its ends with it, none further from the next than a step; shape (n, 3)."""
    first, last = (floats(end.k) if at == own else along(arc, np.array([float(at)])).k[0]
                   for end, at, own in zip(arc.ends, (piece.low, piece.high), (arc.low, arc.high)))
    return halved(lambda t: along(arc, placed(arc, piece, t)).k, first, last, step)


def halved(place: Callable[[Array], Array], first: Array, last: Array, step: float) -> Array:
    """Places at values from 0 to 1, halved where two are further apart than a step."""
    t = np.linspace(0, 1, FIRST)
    return refined(place, t, np.vstack([first, place(t[1:-1]), last]), step, ROUNDS)


def placed(arc: Arc, piece: Piece, t: Array) -> Array:
    """Values of the parameter between the ends of a piece, for t between 0 and 1."""
    low, high, size = float(piece.low), float(piece.high), _size(arc)
    if piece.low == -oo and piece.high == oo:
        return size * np.tan(np.pi * (t - 0.5))
    if piece.low == -oo:
        return high - size * (1 - t) / t
    return low + size * t / (1 - t) if piece.high == oo else low + (high - low) * t


def _size(arc: Arc) -> float:
    """A usual value of the parameter: a moment for tau, for omega a rate."""
    body = arc.scene.body
    moment = sum(map(float, body.moments))
    if isinstance(arc, StaudeArc):
        return moment
    U = arc.scene.potential
    assert U is not None
    torque = sum(abs(float(U.value(x))) for x in U.gradient() if x)
    return float(np.sqrt(torque / moment)) + sum(abs(float(x)) for x in body.gyrostatic_momentum) / moment


def floats(k: tuple[Expr, ...]) -> Array:
    """A direction in doubles."""
    return np.array([float(x) for x in k])
