"""Which wells join at which height: the sublevel sets of a function, from its critical points alone."""
from collections.abc import Callable, Sequence
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


def outcome(minimum: int, levels: Sequence[Sequence[int]], indices: Sequence[int | None],
            ends: Callable[[int], Sequence[int] | None]) -> Outcome:
    """Return what the well of a minimum meets first.

    A sublevel set changes at critical values only: a minimum adds a component, a point of index 1 joins those
    of its two ends, one of a higher index joins none (Milnor, Morse Theory, 1963, section 3).

    Parameters
    ----------
    minimum : int
    levels : sequence of sequence of int
        the critical points in classes of one value, from the lowest on
    indices : sequence of int or None
        of each the number of directions down; None if it is degenerate
    ends : callable
        to which minima paths lead down from a point: two from one of index 1, else one; None: not found
    """
    group = {n: n for level in levels for n in level if indices[n] == 0}

    def joined(n: int) -> int:
        while group[n] != n:
            n = group[n]
        return n

    passes: tuple[int, ...] = ()
    kind, above, tied = "", False, False
    for level in levels:
        above = above or minimum in level
        ways = {n: ends(n) if indices[n] else None for n in level if indices[n] != 0}
        lost = next((n for n, found in ways.items() if found is None), None)
        if above and lost is not None:
            return Outcome(passes, kind, stopped=lost, tied=tied)
        below = {n: {joined(m) for m in found} for n, found in ways.items() if found is not None}
        touched = tuple(n for n, classes in below.items() if joined(minimum) in classes)
        ways_on = {(indices[n] == 1, len(below[n])) for n in touched}
        for classes in below.values():
            first, *others = {joined(m) for m in classes}
            for other in others:
                group[other] = first
        beyond = tuple(m for m in group if m != minimum and joined(m) == joined(minimum))
        if touched and not passes:
            passes, tied = touched, len(ways_on) > 1
            kind = WELL if beyond else ROUND if any(indices[n] == 1 for n in touched) else SUMMIT
        if beyond:
            over = next(n for n in touched if indices[n] == 1)
            return Outcome(passes, kind, over, beyond, tied=tied)
    return Outcome(passes, kind, tied=tied)
