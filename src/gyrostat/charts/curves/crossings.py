"""Finds where a sign changes in a grid: the edges in the order of curves, and the zeros on them.

The edges are found by marching squares, the zeros by bisection.
"""
from collections.abc import Callable, Sequence

import numpy as np

from ...algebra.enclosures.floats import Array
from ...errors import optional

Sign = Callable[[Array, Array], Array]                 # gives the sign at points, from their x and y
# a zero that is closer to 0 than this share of its edge is at 0
NOTHING = 2.0**-100


def edges(signs: Array) -> tuple[Array, tuple[Array, ...], tuple[Array, ...]]:
    """Return where there is no edge, and the ends of the edges on which the sign changes.

    They are given by row and column, in the order of the lines that cross the edges, with a gap between two
    lines. The first end is the one at which the sign is 1.
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
    """Return vertices (column, row) half-way on the edges on which the sign changes.

    A row of NaN is between two lines.
    """
    contourpy = optional("contourpy", "charts")
    sides = np.where(np.isnan(signs), np.nan, np.where(signs > 0, 1.0, -1.0))
    lines = contourpy.contour_generator(z=sides, corner_mask=False,
                                        line_type="ChunkCombinedNan").lines(0.0)[0][0]
    return np.empty((0, 2)) if lines is None else lines


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
