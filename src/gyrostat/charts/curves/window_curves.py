"""Follows the curves in windows, where gyroscopic forces stabilise a maximum: resonances, and D4 = 0.

A resonance is the zero of a polynomial; a zero of D4 is enclosed between two points at which D4, in balls,
has proved signs.
"""
from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np
from sympy import Expr, Symbol

from ...algebra.enclosures.floats import Array
from ...algebra.solving.margins import Signs
from ...stability.criteria.conditions import Condition
from ...stability.decision import Rung
from ...stability.normal_forms.local_motion import data_of
from ...stability.normal_forms.windows import resonance_margin
from ...stability.report.report import Report
from ..codes import CURVES, RUNGS
from ..grids import Grid
from ..signs.ball_arrays import SUM, BallArray
from ..signs.grid_signs import UNKNOWN
from ..signs.stabilized_points import Twists, leaf, twist_times_pole, twists
from ..signs.verdict_arrays import grid_for
from ..signs.verdicts_in_blocks import Decided, signs_in_row
from .contours import sign_of, signs_of
from .crossings import edges, joined, pieces, zeros

WITHIN = 2.0**-12                                      # the share of an edge in which D4 = 0 is enclosed
STEPS = 30                                             # the most steps of the search on an edge
TWISTS = Rung.TWIST_POSITIVE, Rung.TWIST_NEGATIVE
HELD = [RUNGS[rung] for rung in (*TWISTS, Rung.SIXTH_ORDER, Rung.RESONANCE, Rung.INTEGRAL, Rung.NOTHING)]
Axis = tuple[Symbol, Array]


class Plane(NamedTuple):
    """A report over two axes, each strictly monotonic, and the other numbers."""

    report: Report
    numbers: Mapping[Symbol, Expr]
    x: Axis
    y: Axis

    def grid(self, x: Array, y: Array) -> Grid:
        """Return points in a row as a grid."""
        return grid_for(self.report, {s.name: value for s, value in (*self.numbers.items(), (self.x[0], x),
                                                                     (self.y[0], y))})


def window_curves(plane: Plane, rungs: Array) -> Array:
    """Return x, y and code of points of the curves, shape (3, points), with NaN between pieces.

    A resonance is a zero of its margin, found as the boundary is. On D4 = 0 each point is the middle of a
    part of an edge, 2⁻¹² of it at most, at the ends of which D4 is proved to have opposite signs, while the
    resonance 1:2, its pole, is excluded in all of it.

    Parameters
    ----------
    plane : Plane
    rungs : array of int8, shape (len(y), len(x))
        what decided each point

    Returns
    -------
    array, shape (3, points)
    """
    eq = plane.report.equilibrium
    p, q = data_of(eq)[-1]
    if not {s for x in (p, q) for s in x.free_symbols} <= {*plane.numbers, plane.x[0], plane.y[0]}:
        return np.empty((3, 0))
    held = _beside(np.isin(rungs, HELD))
    margins = {name: resonance_margin(p, q, *pair).xreplace(dict(plane.numbers))
               for name, pair in (("resonance_1_2", (1, 2)), ("resonance_1_3", (1, 3)))}
    factors = {name: Signs.over([margin]).normal_form(margin) for name, margin in margins.items()}
    positive, nonzero = Signs.over([p]).normal_form(p)
    oscillates = Condition(positive, True, "p", nonzero, eq.at)
    found = [_coded(_resonance(plane, oscillates, factor, held), CURVES[name])
             for name, (odd, even) in factors.items() for factor in (odd, *even)]
    double = signs_of(factors["resonance_1_2"][0], plane.x, plane.y)
    twist = np.select([abs(double) != 1, *(rungs == RUNGS[rung] for rung in TWISTS)],
                      [UNKNOWN, double, -double], UNKNOWN).astype(np.int8)
    return joined([*found, _coded(_untwisted(plane, twist), CURVES["D4_zero"])])


def _beside(where: Array) -> Array:
    """Return where it is so, or is so at a neighbour."""
    wide = np.pad(where, 1)
    rows, columns = where.shape
    return np.any([wide[i:i + rows, j:j + columns] for i in range(3) for j in range(3)], axis=0)


def _coded(curve: Array, code: int) -> Array:
    return np.concatenate([curve, np.where(np.isnan(curve[:1]), np.nan, code)])


def _on_edges(plane: Plane, signs: Array, zeros_between: Callable[[Array, Array], Array]) -> Array:
    """Return what is found between the ends of the edges on which a sign changes, shape (2, points)."""
    gaps, good, bad = edges(signs)
    points = np.full((2, len(gaps)), np.nan)
    if not gaps.all():
        points[:, ~gaps] = zeros_between(*(np.array([plane.x[1][c[~gaps]], plane.y[1][r[~gaps]]])
                                           for r, c in (good, bad)))
    return pieces(points)


def _resonance(plane: Plane, oscillates: Condition, factor: Expr, held: Array) -> Array:
    """Return the zeros of a resonance between the two criteria.

    Those with p = q = 0, where both frequencies vanish, are not among them.
    """
    def zeros_between(good: Array, bad: Array) -> Array:
        found = zeros(sign_of(factor, plane.x[0], plane.y[0]), good, bad)
        grid = plane.grid(*found)
        with np.errstate(all="ignore"):
            inside = np.broadcast_to(Decided(plane.report, grid, "numpy").open(grid.whole), grid.merged)[0]
            return np.where(inside & (signs_in_row(oscillates, grid) == 1), found, np.nan)

    return _on_edges(plane, np.where(held, signs_of(factor, plane.x, plane.y), np.nan), zeros_between)


def _untwisted(plane: Plane, signs: Array) -> Array:
    """Return the zeros of D4 times the margin of 1:2, which has no pole, where that margin is not 0."""
    def zeros_between(good: Array, bad: Array) -> Array:
        with np.errstate(all="ignore"):
            middle, half = _near_zero(plane, good, bad), abs(bad - good) * WITHIN / 2
            wide = 2 * half + SUM * abs(middle)
            D4, double = (x.reshape(3, -1) for x in _twists(
                plane, np.concatenate([middle - half, middle + half, middle], axis=1),
                np.concatenate([0 * half, 0 * half, wide], axis=1)))
        return np.where((D4[0] * D4[1] < 0) & (double[2] != 0), middle, np.nan)

    return _on_edges(plane, signs, zeros_between)


def _near_zero(plane: Plane, good: Array, bad: Array) -> Array:
    """Return about where D4 times the margin is 0 on edges, by false position with bisections."""
    t, s = np.ones(good.shape[1]), np.zeros(good.shape[1])
    value, old = np.split(_product(plane, np.concatenate([bad, good], axis=1)), 2)
    left = np.arange(len(t))
    for step in range(STEPS):
        following = (t + s)[left] / 2 if step % 3 == 2 else (t - value * (t - s) / (value - old))[left]
        here = _product(plane, good[:, left] + (bad - good)[:, left] * following)
        # the value of an end that stays is halved, or false position would creep (Illinois)
        turned, moved = here * value[left] < 0, abs(following - t[left])
        s[left], old[left] = np.where(turned, t[left], s[left]), np.where(turned, value[left], old[left] / 2)
        t[left], value[left] = following, here
        left = left[moved > WITHIN / 16]
        if not left.size:
            break
    return np.asarray(good + (bad - good) * np.clip(t, WITHIN, 1 - WITHIN))


def _product(plane: Plane, at: Array) -> Array:
    return twist_times_pole(plane.report, _balls(plane, at, np.zeros_like(at)), at.shape[1])


def _twists(plane: Plane, at: Array, wide: Array) -> Twists:
    """Return the signs of D4 and of the margin of 1:2 over boxes about points."""
    return twists(plane.report, _balls(plane, at, wide), at.shape[1])


def _balls(plane: Plane, at: Array, wide: Array) -> dict[Symbol, BallArray]:
    grid = plane.grid(*at)
    return {s: leaf(grid, s) for s in grid.values} | {
        name: BallArray(*ball) for name, ball in zip((plane.x[0], plane.y[0]), zip(at, wide))}
