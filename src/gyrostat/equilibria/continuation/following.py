"""Follows the equilibria of a curve over a range, from one station to the next, for every kind of scene."""
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Protocol

from sympy import Expr

from .mark import Mark
from .pieces import Continuation, Piece, joined

Pieces = Sequence[Piece]


class Curve(Protocol):
    """The interface of the equilibria of a scene over a range of one name.

    A station is a value at which some may meet, appear or vanish, or their stability may change.
    """

    @property
    def stations(self) -> Sequence[Expr]:
        """All stations in the range, its ends among them or not; exact and in order."""

    def between(self, low: Expr, high: Expr) -> list[Piece]:
        """Return every equilibrium between two stations and its verdict, in a piece from one to the other."""

    def through(self, station: Expr, before: Pieces, after: Pieces) -> Iterable[tuple[int, int]]:
        """Yield which of the pieces before a station go on after it as which, and meet no others."""

    def alone(self, station: Expr) -> Iterable[Piece]:
        """Yield the equilibria at a station without others beside them."""

    def marks(self, station: Expr, before: Pieces | None, after: Pieces | None) -> Iterable[Mark]:
        """Yield what happens at a station; before or after is None beyond an end of the range."""


def follow(curve: Curve, low: Expr, high: Expr) -> Continuation:
    """Return every equilibrium as pieces of one verdict, by label, and the marks, by value."""
    inner = [t for t in curve.stations if t not in (low, high)]
    spans = [curve.between(a, b) for a, b in pairwise([low, *inner, high])]
    going = [[piece] for piece in spans[0]]
    found = list(going)
    for t, before, after in zip(inner, spans, spans[1:]):
        onward = {j: going[i] for i, j in curve.through(t, before, after)
                  if before[i].verdict is after[j].verdict}
        found += (begun := {j: [piece] for j, piece in enumerate(after) if j not in onward}).values()
        for j, parts in onward.items():
            parts.append(after[j])
        going = [{**onward, **begun}[j] for j in range(len(after))]
    pieces = [*map(joined, found), *(piece for t in curve.stations for piece in curve.alone(t))]
    sides = dict(zip(inner, pairwise(spans))) | {low: (None, spans[0]), high: (spans[-1], None)}
    return Continuation(sorted(pieces, key=lambda piece: piece.label),
                        [mark for t in curve.stations for mark in curve.marks(t, *sides[t])])
