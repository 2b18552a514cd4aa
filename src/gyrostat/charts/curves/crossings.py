"""Finds where a sign changes in a grid: the edges in the order of curves, and the zeros on them.

The edges are found by marching squares (Lorensen & Cline, Computer Graphics 21 (1987) 163-169), the zeros by
bisection.
"""
from collections.abc import Callable, Sequence

import numpy as np

from ...algebra.enclosures.floats import Array
from ..signs.grid_signs import UNKNOWN

Places = tuple[Array, Array]                           # rows and columns
Sign = Callable[[Array, Array], Array]                 # gives the sign at points, from their x and y
# a zero that is closer to 0 than this share of its edge is at 0
NOTHING = 2.0**-100


def edges(signs: Array) -> tuple[Array, Places, Places]:
    """Return where there is no edge, and the ends of the edges on which the sign changes.

    They are given by row and column, in the order of the lines that cross the edges, the side of sign 1 on
    the left, with a gap between two lines. A closed line ends with the edge that it begins with. The first
    end is the one at which the sign is 1.

    Parameters
    ----------
    signs : array of int8, shape (rows, columns)
        −1, 0, 1, or UNKNOWN, beside which there is no line

    Returns
    -------
    gaps, good, bad : array of bool, and pairs of arrays of int, shape (edges,) each
    """
    rows, columns = signs.shape
    flat = signs.ravel()
    good, bad = _changing(signs)
    # the line goes on through the cell ahead: from (good, bad) a quarter turn to the left
    (row, column), step = np.divmod(good, columns), bad - good
    right, down = np.where(abs(step) == 1, step, 0), np.where(abs(step) == columns, np.sign(step), 0)
    inside = (0 <= row + right) & (row + right < rows) & (0 <= column - down) & (column - down < columns)
    ahead = np.where(inside, right * columns - down, 0)
    beside_good, beside_bad = flat[good + ahead], flat[bad + ahead]
    inside &= (beside_good != UNKNOWN) & (beside_bad != UNKNOWN)
    # it leaves around the good end, if it can: in a cell with two good corners the lines part them
    around_good, around_bad = beside_good != 1, (beside_good == 1) & (beside_bad == 1)
    one = np.where(around_good, good, np.where(around_bad, bad, good) + ahead)
    other = np.where(around_bad, bad, np.where(around_good, good, bad) + ahead)
    keys = _key(good, bad)
    order = np.argsort(keys)
    following = np.full(len(good), -1)
    following[inside] = order[np.searchsorted(keys, _key(one[inside], other[inside]), sorter=order)]
    lines = _lines(following)
    gaps = lines < 0
    first, second = (np.divmod(end[lines] if len(end) else end, columns) for end in (good, bad))
    return gaps, first, second


def _changing(signs: Array) -> tuple[Array, Array]:
    """Return the places of the two ends of each edge on which the sign changes, that of sign 1 first."""
    columns = signs.shape[1]
    positive = signs == 1
    along, up = (np.flatnonzero(positive[:, 1:] != positive[:, :-1]),
                 np.flatnonzero(positive[1:] != positive[:-1]))
    low = np.concatenate([along + along // max(columns - 1, 1), up])
    high = low + np.repeat([1, columns], [len(along), len(up)])
    first, flat = positive.ravel()[low], signs.ravel()
    good, bad = np.where(first, low, high), np.where(first, high, low)
    known = flat[bad] != UNKNOWN
    return good[known], bad[known]


def _key(one: Array, other: Array) -> Array:
    """Return a number for each edge, by which it is found from its ends."""
    return 2 * np.minimum(one, other) + (abs(one - other) == 1)


def _lines(following: Array) -> Array:
    """Return the edges in the order of their lines, −1 between two lines; a line has two edges at least."""
    begins = np.ones(len(following), bool)
    begins[following[following >= 0]] = False
    starts = [*np.flatnonzero(begins & (following >= 0)).tolist(), *np.flatnonzero(~begins).tolist()]
    successor, seen, found = following.tolist(), bytearray(len(following)), list[int]()
    for start in starts:
        at = start
        while at >= 0 and not seen[at]:
            seen[at] = 1
            found.append(at)
            at = successor[at]
        if found and found[-1] >= 0:
            found += [at, -1] if at >= 0 else [-1]         # closed: the edge that it begins with
    return np.array(found[:-1], dtype=np.int64)


def zeros(sign: Sign, good: Array, bad: Array) -> Array:
    """Return where the sign stops being 1 between the two ends of each edge, shape (2, edges) each.

    It does so where the sign is 0 or −1, and where there is none.
    """
    along = good[0] != bad[0]                          # the edge lies along x
    p, q = np.where(along, good[0], good[1]), np.where(along, bad[0], bad[1])
    other = np.where(along, good[1], good[0])
    nothing = np.maximum(abs(p), abs(q)) * NOTHING
    while True:
        # bisection towards a zero at 0 would go on until powers underflow, a thousand steps
        beside = (p == 0) | (q == 0)
        at_zero = beside & (abs(p + q) <= nothing)
        p, q = np.where(at_zero, 0.0, p), np.where(at_zero, 0.0, q)
        middle = np.where(np.sign(p) * np.sign(q) < 0, 0.0,
                          np.where(beside, (p + q) * NOTHING, p + (q - p) / 2))
        open_ = (middle != p) & (middle != q)
        if not open_.any():
            break
        found = sign(np.where(along, middle, other), np.where(along, other, middle))
        p = np.where(open_ & (found >= 0), middle, p)
        q = np.where(open_ & ~(found > 0), middle, q)
    return np.array([np.where(along, q, other), np.where(along, other, q)])


def pieces(points: Array) -> Array:
    """Return points with one NaN between two pieces, none at the ends."""
    gap = np.isnan(points[0])
    kept = ~(gap & np.concatenate([[True], gap[:-1]]))
    points = points[:, kept]
    return points[:, :-1] if points.shape[1] and np.isnan(points[0, -1]) else points


def joined(curves: Sequence[Array]) -> Array:
    """Return curves, shape (coordinates, points) each, as one with NaN between two."""
    found = [curve for curve in curves if curve.shape[1]]
    if not found:
        return curves[0] if curves else np.empty((2, 0))
    gap = np.full((len(found[0]), 1), np.nan)
    return np.concatenate([part for curve in found for part in (curve, gap)][:-1], axis=1)
