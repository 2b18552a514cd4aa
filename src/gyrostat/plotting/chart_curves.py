"""Draws curves of charts: boundaries, resonances and D4 = 0 in windows, contours of what is survived."""
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array
from ..charts.codes import SURVIVED
from .looks import BLUE, DESTROYED, INK, with_dimension

# curves in windows, by their flag
WINDOW = {"resonance_1_2": (INK[DESTROYED], "--", "resonance 1:2"),
          "resonance_1_3": (INK[DESTROYED], ":", "resonance 1:3"),
          "D4_zero": (BLUE, "-.", "$D_4 = 0$")}


def curves(ax: Any, ds: Any, dims: tuple[str, ...], edges: Sequence[Array]) -> list[Any]:
    """The boundary and the curves in windows, each that has a point between the ends; what the legend has."""
    drawn = []
    if points := _points(ds, "boundary", dims):
        drawn += _line(ax, *_off_the_frame(points[0], points[1], edges), edges, "black", "-", "boundary")
    if points := _points(ds, "curve", dims):
        codes = dict(zip(ds.curve.attrs["flag_meanings"].split(), ds.curve.attrs["flag_values"]))
        for name, look in WINDOW.items():
            x, y = (np.where(ds.curve == codes[name], values, np.nan) for values in points)
            drawn += _line(ax, x, y, edges, *look)
    return drawn


def contours(ax: Any, seen: Any, si: bool) -> list[Any]:
    """Of the kick that a stable point survives, or of its barrier, if a chart has it; what the legend has."""
    name = next((name for name in SURVIVED if name in seen), "")
    if not name or min(seen[name].shape) < 2 or not np.isfinite(seen[name]).any():
        return []
    from matplotlib.lines import Line2D
    y, x = (seen[dim].values for dim in seen[name].dims)
    lines = ax.contour(x, y, seen[name].values, colors=BLUE, linewidths=0.7)
    ax.clabel(lines, fmt="%g", fontsize="x-small")
    _, dimension, unit = SURVIVED[name]
    said = f"safe {name} [{unit}]" if si else with_dimension(f"safe {name}", dimension)
    return [Line2D([], [], color=BLUE, linewidth=0.7, label=said)]


def _points(ds: Any, name: str, dims: tuple[str, ...]) -> list[Array]:
    """x and y of curves, if the dataset has them, of these two axes."""
    if f"{name}_x" not in ds:
        return []
    points = {ds[f"{name}_{axis}"].attrs["parameter"]: ds[f"{name}_{axis}"].values for axis in "xy"}
    return [points[dim] for dim in reversed(dims)] if set(points) == set(dims) else []


def _line(ax: Any, x: Array, y: Array, edges: Sequence[Array], color: str, style: str,
          name: str) -> list[Any]:
    """A curve, if there is a point of it between the ends: the dataset may be a part of a chart."""
    (left, right), (bottom, top) = ((ends[0], ends[-1]) for ends in edges)
    if not ((left <= x) & (x <= right) & (bottom <= y) & (y <= top)).any():
        return []
    return ax.plot(x, y, color=color, linestyle=style, linewidth=1.2, label=name)


def _off_the_frame(x: Array, y: Array, edges: Sequence[Array]) -> tuple[Array, Array]:
    """The curves without what runs along the frame in the outermost cells, where the frame itself is seen."""
    if not len(x):
        return x, y
    along = np.zeros(len(x) - 1, dtype=bool)
    for values, ends in zip((x, y), edges):
        outer = (values < ends[1]) | (values > ends[-2])
        still = np.abs(np.diff(values)) <= 1e-9 * (ends[-1] - ends[0])
        along |= outer[:-1] & outer[1:] & still
    gone = np.isnan(np.diff(x)) | along
    before, after = np.append(False, along), np.append(along, False)
    hidden = np.append(True, gone) & np.append(gone, True) & (before | after)
    return np.where(hidden, np.nan, x), np.where(hidden, np.nan, y)
