"""What is found along a name: pieces of one verdict, and marks where something happens, a Continuation."""
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
        as of a RelativeEquilibrium
    parameter : array, shape (n,)
        n = 1: an isolated point
    verdict : Verdict
        exact, between its ends; of E3 modulo the spin
    k3 : array, shape (n,), or None
        None of a free body
    k : array, shape (n, 3), or None
        of a body in a field that is not of revolution; of a circle of rotations one of them
    momentum : array, shape (n, 3), or None
        of a free body: M; of a circle of rotations one of them
    nu : array, shape (n,), or None
        of a free body: ω = ν M
    sigma : array, shape (n,), or None
        where there is a k: ∇U = omega M + sigma k

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> for piece in gs.continuation(scene, "omega", (1, "3/2"), {}).pieces:
    ...     print(piece.verdict.name, piece.parameter[0], piece.parameter[-1])
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


def joined(parts: Sequence[Piece]) -> Piece:
    """Of pieces that go on from one to the next."""
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
        each of one verdict; of permanent rotations none goes on through a value where two of them meet
    marks : list of Mark
        every change of stability, every meeting and every end, exact and by value; of a rotation that changes
        where others meet, or at an end of the range, the meeting alone

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> found = gs.continuation(top, "omega", (1, 3), {"I1": 2, "I3": 1, "l": 0, "m0": 1})
    >>> len(found.pieces) > 2
    True
    >>> spun_up = gs.assemble(gs.Gyrostat((1, 2, 3), ("1/20", "1/10", gs.symbol("l3"))))
    >>> found = gs.continuation(spun_up, "l3", (0, 1), {"M": 1})
    >>> [(mark.kind, round(float(mark.value), 4)) for mark in found.marks]
    [('fold', 0.2036)]
    >>> [piece.verdict.name for piece in found.pieces if piece.parameter[-1] == 1]
    ['STABLE', 'UNSTABLE', 'STABLE', 'STABLE']
    """

    pieces: list[Piece]
    marks: list[Mark]
