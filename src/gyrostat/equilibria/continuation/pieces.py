"""The records of what is found along a name: pieces of one verdict, and a Continuation of them with marks."""
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...algebra.enclosures.floats import Array
from ...stability.decision import Verdict
from .mark import Mark

INFINITE = "U is infinite"


@dataclass(frozen=True, eq=False)
class Piece:
    """Relative equilibria over part of a range, of one verdict.

    Parameters
    ----------
    label : str
        that of the RelativeEquilibrium
    parameter : array, shape (n,)
        n = 1: an isolated point
    verdict : Verdict
        exact, between its ends; for E3 modulo the spin
    k3 : array, shape (n,), or None
        None for a free body
    k : array, shape (n, 3), or None
        for a body in a field that is not of revolution; on a circle of rotations one of them
    momentum : array, shape (n, 3), or None
        for a free body: M; on a circle of rotations one of them
    nu : array, shape (n,), or None
        for a free body: ω = ν M
    sigma : array, shape (n,), or None
        if there is a k: ∇U = omega M + sigma k
    n, r : array, shape (n, 3), or None
        for a satellite: the normal of the orbit and the vertical, in body axes

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> found = gs.continuation(scene, "omega", (1, "3/2"), {})
    >>> for piece in found.pieces:
    ...     print(piece.verdict.name, *piece.parameter[[0, -1]])
    STABLE 1.0 1.5
    UNSTABLE 1.0 1.5
    """

    label: str
    parameter: Array
    verdict: Verdict
    k3: Array | None = None
    k: Array | None = None
    momentum: Array | None = None
    nu: Array | None = None
    sigma: Array | None = None
    n: Array | None = None
    r: Array | None = None


def joined(parts: Sequence[Piece]) -> Piece:
    """Return one piece from pieces that go on from one to the next."""
    first, *rest = parts
    arrays = {name: np.concatenate([value, *(getattr(piece, name)[1:] for piece in rest)])
              for name, value in vars(first).items() if isinstance(value, np.ndarray)}
    return Piece(first.label, verdict=first.verdict, **arrays)


@dataclass(frozen=True, eq=False)
class Continuation:
    """Relative equilibria over a range of one name, and what happens on them.

    Parameters
    ----------
    pieces : list of Piece
        each of one verdict; a piece of permanent rotations ends at a value at which two of them meet
    marks : list of Mark
        every change of stability, every meeting and every end, exact and by value; if a rotation changes
        where others meet, or at an end of the range, the meeting alone

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> numbers = {"I1": 2, "I3": 1, "l": 0, "m0": 1}
    >>> found = gs.continuation(top, "omega", (1, 3), numbers)
    >>> len(found.pieces) > 2
    True
    >>> rotor = "1/20", "1/10", gs.symbol("l3")
    >>> spun_up = gs.assemble(gs.Gyrostat((1, 2, 3), rotor))
    >>> found = gs.continuation(spun_up, "l3", (0, 1), {"M": 1})
    >>> [(mark.kind, round(float(mark.value), 4)) for mark in found.marks]
    [('fold', 0.2036)]
    >>> for piece in found.pieces:
    ...     if piece.parameter[-1] == 1:
    ...         print(piece.verdict.name)
    STABLE
    UNSTABLE
    STABLE
    STABLE
    """

    pieces: list[Piece]
    marks: list[Mark]
