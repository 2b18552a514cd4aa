"""Draws marks that nearly coincide one around the other, so that none is covered."""
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array
from ..errors import optional

NEAR = 0.55                                            # of a mark: closer than that, one covers the other
EXTENT_FREE = ("None", "none", "", ".", ",")           # dots, and no marks at all
SAME = 0.5                                             # pixels: the same mark twice
WIDER = 5.0                                            # points across, from one to the one around it


def nest(ax: Any) -> None:
    """Enlarge each mark that is below another one, if they nearly coincide; their places stay.

    The axes have to be laid out. Dots, numbers and marks along a line are left as they are.
    """
    marks = [(line, n, place) for line in sorted(ax.lines, key=lambda line: -line.get_zorder())
             if _is_of_marks(line) for n, place in enumerate(_places(ax, line)) if np.isfinite(place).all()]
    pixels = ax.get_figure(root=True).dpi / 72
    levels: list[int] = []
    halo = optional("matplotlib.patheffects", "plot").withStroke(linewidth=2.5, foreground="white")
    for line, _, place in marks:
        near = NEAR * line.get_markersize() * pixels
        above = [(level, upper) for level, (upper, _, other) in zip(levels, marks)
                 if np.hypot(*(place - other)) < near
                 and (upper is not line or np.hypot(*(place - other)) > SAME)]
        levels.append(max((level + 1 for level, _ in above), default=0))
        for _, upper in above:                         # parts it from what is around it
            upper.set_path_effects([halo])
    for line in {line: None for (line, _, _), level in zip(marks, levels) if level}:
        _parted(ax, line, np.array([level for (own, _, _), level in zip(marks, levels) if own is line]))


def _is_of_marks(line: Any) -> bool:
    """Tell whether a line consists of marks alone, which have an extent."""
    marker = str(line.get_marker())
    return line.get_linestyle() == "None" and "$" not in marker and marker not in EXTENT_FREE


def _places(ax: Any, line: Any) -> Array:
    """Return where the marks of a line are, in pixels, shape (n, 2)."""
    if ax.name != "3d":
        return np.asarray(line.get_transform().transform(line.get_xydata()))
    project = optional("mpl_toolkits.mplot3d.proj3d", "plot").proj_transform
    across, up, _ = project(*line.get_data_3d(), ax.get_proj())
    return np.asarray(ax.transData.transform(np.stack([across, up], axis=1)))


def _parted(ax: Any, line: Any, levels: Array) -> None:
    """Leave in a line its marks of level 0, and draw the others in lines of their own, beneath them."""
    at = np.array(line.get_data_3d() if ax.name == "3d" else line.get_data())
    for level in sorted(set(levels.tolist()) - {0}):
        other, = ax.plot(*at[:, levels == level])
        other.update_from(line)
        other.set(markersize=line.get_markersize() + WIDER * level, zorder=line.get_zorder() - 0.01 * level)
    kept = at[:, levels == 0]
    if ax.name == "3d":
        line.set_data_3d(*kept)
    else:
        line.set_data(*kept)
    if not kept.size:
        line.remove()
