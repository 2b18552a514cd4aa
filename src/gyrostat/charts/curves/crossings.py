"""Where a sign changes in a grid: the edges in the order of curves, and the zeros on them."""
from collections.abc import Callable, Sequence

import numpy as np

from ...algebra.enclosures.floats import Array
from ...errors import optional

Sign = Callable[[Array, Array], Array]                 # at points, from their x and y
# of an edge: a zero that is no further from 0 is at 0
NOTHING = 2.0**-100


def edges(signs: Array) -> tuple[Array, tuple[Array, ...], tuple[Array, ...]]:
    """The edges where the sign changes in the order of the lines that cross them, by row and column of the
    end where it is 1, and of the other; first where between two lines there is none.
    """
    vertices = _marched(signs)
    gaps = np.isnan(vertices[:, 0])
    low = np.floor(np.where(gaps[:, None], 0, vertices)).astype(np.int64)
    high = np.ceil(np.where(gaps[:, None], 0, vertices)).astype(np.int64)
    ends = [(low[:, 1], low[:, 0]), (high[:, 1], high[:, 0])]
    first = signs[ends[0]] > 0
    good, bad = (tuple(np.where(first, a, b) for a, b in zip(*pair)) for pair in (ends, ends[::-1]))
    return gaps, good, bad


def _marched(signs: Array) -> Array:
    """Vertices (column, row) half-way on the edges where the sign changes, a row of NaN between two lines."""
    contourpy = optional("contourpy", "charts")
    sides = np.where(np.isnan(signs), np.nan, np.where(signs > 0, 1.0, -1.0))
    lines = contourpy.contour_generator(z=sides, corner_mask=False,
                                        line_type="ChunkCombinedNan").lines(0.0)[0][0]
    return np.empty((0, 2)) if lines is None else lines


def zeros(sign: Sign, good: Array, bad: Array) -> Array:
    """Where the sign stops being 1 between two ends of an edge, shape (2, edges) each.

    So it does where there is none.
    """
    along = good[0] != bad[0]                          # the edge lies along x
    p, q = np.where(along, good[0], good[1]), np.where(along, bad[0], bad[1])
    other = np.where(along, good[1], good[0])
    nothing = np.maximum(abs(p), abs(q)) * NOTHING
    while True:
        # a zero at 0 would be halved towards for long, until powers underflow
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
    """One NaN between two pieces, none at the ends."""
    gap = np.isnan(points[0])
    kept = ~(gap & np.concatenate([[True], gap[:-1]]))
    points = points[:, kept]
    return points[:, :-1] if points.shape[1] and np.isnan(points[0, -1]) else points


def joined(curves: Sequence[Array]) -> Array:
    """Curves, shape (coordinates, points) each, with NaN between two."""
    found = [curve for curve in curves if curve.shape[1]]
    if not found:
        return curves[0] if curves else np.empty((2, 0))
    gap = np.full((len(found[0]), 1), np.nan)
    return np.concatenate([part for curve in found for part in (curve, gap)][:-1], axis=1)
