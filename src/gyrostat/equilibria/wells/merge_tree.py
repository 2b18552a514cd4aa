"""Which wells join at which height: the sublevel sets of a function, from its critical points alone."""
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

WELL, ROUND, SUMMIT = "well", "round", "summit"


@dataclass(frozen=True)
class Outcome:
    """What a well meets first, by the numbers of the critical points.

    Parameters
    ----------
    passes : tuple of int
        what it touches at the height of its barrier
    kind : str
        "well": another minimum lies behind; "round": a saddle joins the well to itself; "summit": no saddle;
        "" if nothing is touched
    escape : int or None
        the saddle over which another minimum is reached first
    beyond : tuple of int
        the minima that are reached over it
    stopped : int or None
        where this ends, at a point of which the way down is not known: nothing below it is touched but passes
    tied : bool
        whether the passes are of different kinds, so that it matters whether their values are equal
    """

    passes: tuple[int, ...] = ()
    kind: str = ""
    escape: int | None = None
    beyond: tuple[int, ...] = ()
    stopped: int | None = None
    tied: bool = False


@dataclass(frozen=True)
class Join:
    """What becomes one at a height, by the numbers of the critical points.

    Parameters
    ----------
    over : tuple of int
        the points of index 1 over which it does
    wells : tuple of tuple of int
        the minima of each well that is joined to the others
    """

    over: tuple[int, ...]
    wells: tuple[tuple[int, ...], ...]


class Sublevels:
    """The components of {V < E} as E rises, each known by its minima.

    A sublevel set changes at critical values only: a minimum adds a component, a point of index 1 joins those
    of its two ends, one of a higher index joins none (Milnor, Morse Theory, 1963, section 3).

    Parameters
    ----------
    levels : sequence of sequence of int
        the critical points in classes of one value, from the lowest on
    indices : sequence of int or None
        of each the number of directions down; None if it is degenerate
    ends : callable
        to which minima paths lead down from a point: two from one of index 1, else one; None: not found
    """

    def __init__(self, levels: Sequence[Sequence[int]], indices: Sequence[int | None],
                 ends: Callable[[int], Sequence[int] | None]):
        self.indices, self.ends = indices, ends
        self.group = {n: n for level in levels for n in level if indices[n] == 0}

    def joined(self, n: int) -> int:
        """Return the minimum by which the component of another one is called."""
        while self.group[n] != n:
            n = self.group[n]
        return n

    def together(self, n: int) -> tuple[int, ...]:
        """Return the minima of the component of one of them."""
        return tuple(m for m in self.group if self.joined(m) == self.joined(n))

    def below(self, level: Sequence[int]) -> tuple[dict[int, set[int]], int | None]:
        """Return what lies below each point of a value but minima, and a point of which that is not known."""
        ways = {n: self.ends(n) if self.indices[n] else None for n in level if self.indices[n] != 0}
        lost = next((n for n, found in ways.items() if found is None), None)
        return {n: {self.joined(m) for m in found} for n, found in ways.items() if found is not None}, lost

    def join(self, classes: Iterable[int]) -> None:
        """Make one component of several."""
        first, *others = {self.joined(m) for m in classes}
        for other in others:
            self.group[other] = first


def outcome(minimum: int, levels: Sequence[Sequence[int]], indices: Sequence[int | None],
            ends: Callable[[int], Sequence[int] | None]) -> Outcome:
    """Return what the well of a minimum meets first; the other parameters are those of Sublevels."""
    parts = Sublevels(levels, indices, ends)
    passes: tuple[int, ...] = ()
    kind, above, tied = "", False, False
    for level in levels:
        above = above or minimum in level
        below, lost = parts.below(level)
        if above and lost is not None:
            return Outcome(passes, kind, stopped=lost, tied=tied)
        touched = tuple(n for n, classes in below.items() if parts.joined(minimum) in classes)
        ways_on = {(indices[n] == 1, len(below[n])) for n in touched}
        for classes in below.values():
            parts.join(classes)
        beyond = tuple(m for m in parts.together(minimum) if m != minimum)
        if touched and not passes:
            passes, tied = touched, len(ways_on) > 1
            kind = WELL if beyond else ROUND if any(indices[n] == 1 for n in touched) else SUMMIT
        if beyond:
            over = next(n for n in touched if indices[n] == 1)
            return Outcome(passes, kind, over, beyond, tied=tied)
    return Outcome(passes, kind, tied=tied)


def joins(levels: Sequence[Sequence[int]], indices: Sequence[int | None],
          ends: Callable[[int], Sequence[int] | None]) -> tuple[list[Join], int | None]:
    """Return how the wells become one, the lowest first, and a point above which that is not known.

    The parameters are those of Sublevels. What joins over points of one value is told apart.
    """
    parts, found = Sublevels(levels, indices, ends), list[Join]()
    for level in levels:
        below, lost = parts.below([n for n in level if indices[n] in (1, None)])    # no other joins any
        if lost is not None:
            return found, lost
        before = {m: parts.together(m) for classes in below.values() for m in classes}
        over = {n: classes for n, classes in below.items() if len(classes) > 1}
        for classes in over.values():
            parts.join(classes)
        for first in {parts.joined(n) for classes in over.values() for n in classes}:
            ways = tuple(n for n, classes in over.items() if parts.joined(min(classes)) == first)
            wells = {m for n in ways for m in over[n]}
            found.append(Join(ways, tuple(before[m] for m in sorted(wells))))
    return found, None
