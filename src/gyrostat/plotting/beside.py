"""Writes names beside marks, where they cover neither a curve nor a mark nor another name."""
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ..algebra.enclosures.floats import Array
from ..errors import optional

GAPS = (2.0, 5.0, 9.0)                                 # points between the edge of a mark and its name
STEP = 2.0                                             # pixels between the points of a curve that count
SIDES = ((1, 0), (1, 1), (-1, 0), (-1, 1), (1, -1), (-1, -1), (0, 1), (0, -1))

Place = tuple[float, float] | Array


class Marks(NamedTuple):
    """Marks of one kind: what stands for them in a legend, and their places in the data of the axes."""

    handle: Any
    places: Sequence[Place]


def written_beside(ax: Any, marks: Sequence[Marks]) -> tuple[list[Any], list[Marks]]:
    """Write the name of each kind beside one of its marks: the names, and the kinds that have no room.

    The mark that is farthest from those of other kinds comes first. The figure has to be laid out.
    """
    names, left = [], []
    taken = _obstacles(ax)
    for kind in marks:
        name = _text(ax, kind.handle.get_label(), kind.places[0])
        others = [ax.transData.transform(place) for other in marks if other is not kind
                  for place in other.places]
        places = sorted(kind.places, key=lambda place: -_distance(ax.transData.transform(place), others))
        if (box := _put(ax, name, places, kind.handle.get_markersize(), taken)) is None:
            name.remove()
            left.append(kind)
        else:
            names.append(name)
            taken = np.concatenate([taken, box])
    return names, left


def written_at(ax: Any, texts: Sequence[tuple[str, Place]], size: float) -> list[Any]:
    """Write a text beside each place, a mark of a size in points: where there is room, else right above it.

    Return the texts.
    """
    taken, names = _obstacles(ax), []
    for said, place in texts:
        names.append(name := _text(ax, said, place))
        if (box := _put(ax, name, [place], size, taken)) is None:
            name.set(position=(size / 2, size / 2), ha="left", va="bottom")
        else:
            taken = np.concatenate([taken, box])
    return names


def _text(ax: Any, said: str, place: Place) -> Any:
    """A text at a place in the data, in the letters of a legend."""
    return ax.annotate(said, place, xytext=(0, 0), textcoords="offset points",
                       fontsize=optional("matplotlib", "plot").rcParams["legend.fontsize"])


def _distance(place: Array, others: Sequence[Array]) -> float:
    """How far it is to the nearest of others; infinite if there are none."""
    return min((float(np.linalg.norm(place - other)) for other in others), default=np.inf)


def _put(ax: Any, name: Any, places: Sequence[Place], size: float, taken: Array) -> Array | None:
    """Move a name to the first free box beside one of its marks; points on the box, or None."""
    pixels = ax.get_figure(root=True).dpi / 72
    name.xy = places[0]
    extent, frame = name.get_window_extent(), ax.get_window_extent()
    shape = np.array([extent.width, extent.height])
    for gap in GAPS:
        for place in places:
            middle = ax.transData.transform(place)
            for side in SIDES:
                off = (size / 2 + gap) * pixels / max(1.0, float(np.hypot(*side)))
                low = middle + np.array(side) * (off + shape / 2) - shape / 2
                inside = (low >= frame.min + 2).all() and (low + shape <= frame.max - 2).all()
                if inside and not ((low - 2 < taken) & (taken < low + shape + 2)).all(axis=1).any():
                    name.xy = place
                    name.set(ha="left", va="bottom")
                    name.set_position((low - middle) / pixels)
                    return _grid(low, low + shape)
    return None


def _obstacles(ax: Any) -> Array:
    """Points in pixels, on curves, marks and texts of the axes, so close that no letter fits between them."""
    pixels, frame = ax.get_figure(root=True).dpi / 72, ax.get_window_extent()
    low, high = frame.min - frame.size, frame.max + frame.size
    found = [np.empty((0, 2))]
    for line in ax.lines:
        points = np.clip(line.get_transform().transform(line.get_xydata()), low, high)
        if line.get_linestyle() != "None":
            found.append(_along(points))
        if line.get_marker() != "None":
            half = line.get_markersize() * pixels / 2
            found += [_grid(point - half, point + half) for point in points if np.isfinite(point).all()]
    for collection in ax.collections:
        if isinstance(collection, optional("matplotlib.collections", "plot").LineCollection):
            found += [_along(np.clip(ax.transData.transform(piece), low, high))
                      for piece in collection.get_segments() if len(piece)]     # none: not finite
    for text in ax.texts:
        box = text.get_window_extent()
        found.append(_grid(box.min, box.max))
    return np.concatenate(found)


def _along(points: Array) -> Array:
    """Points of a curve no further from each other than STEP."""
    points = np.asarray(points, dtype=float)
    if len(points) < 2:
        return points[np.isfinite(points).all(axis=1)]
    length = np.nan_to_num(np.linalg.norm(np.diff(points, axis=0), axis=1))
    counts = np.ceil(length / STEP).astype(int) + 1
    at = np.concatenate([n + np.linspace(0, 1, count, endpoint=False) for n, count in enumerate(counts)])
    whole = at.astype(int)
    part = (at - whole)[:, None]
    found = (1 - part) * points[whole] + part * points[whole + 1]
    return np.concatenate([found[np.isfinite(found).all(axis=1)], points[np.isfinite(points).all(axis=1)]])


def _grid(low: Array, high: Array) -> Array:
    """Points that fill a box."""
    x, y = (np.linspace(a, b, max(2, int((b - a) / STEP) + 1)) for a, b in zip(low, high))
    return np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
