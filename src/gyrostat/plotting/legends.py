"""Puts legends and titles above flat axes, or the legend below a view of space, in columns that fit."""
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from ..errors import optional
from ..printing.formats.linebreaks import width
from .beside import Marks, written_beside

PART, SMALLEST = 0.24, 5.0                             # of a figure, the most; points of letters
EDGE, LEAST, ROUNDS = 0.01, 0.2, 3                     # of the figure: the margin, and axes at least
SWATCH = 3.6                                           # line and gaps of a legend, in sizes of its letters


def legend(ax: Any, handles: Sequence[Any], columns: int | None = None,
           title: Callable[[float], str] = lambda space: "", marks: Sequence[Marks] = ()) -> None:
    """Draw the legend and the title above it; names of marks stand beside them, where there is room.

    Parameters
    ----------
    ax : matplotlib Axes
    handles : sequence of artists
        what the legend names
    columns : int or None
        at most; None: all in a row
    title : callable
        gives the text that fits axes of a width in points
    marks : sequence of Marks
        those without room beside them are named in the legend
    """
    listed, beside = list(handles), list(marks)
    while True:
        _rows(ax, listed, columns, title)
        for _ in range(ROUNDS):                        # title and legend follow the width of the axes
            if _within(ax):
                _rows(ax, listed, columns, title)
        if not beside:
            return
        room(ax)                                       # names are placed on axes that leave room for the rows
        names, left = written_beside(ax, beside)
        if not left:
            return
        for name in names:
            name.remove()
        listed += [kind.handle for kind in left]
        beside = [kind for kind in beside if kind not in left]


def _rows(ax: Any, handles: Sequence[Any], columns: int | None, title: Callable[[float], str]) -> None:
    """The legend in columns, and the title above it, in the room that the axes have without a legend."""
    if ax.get_legend():
        ax.get_legend().remove()
    wide, rows, most = room(ax), 0.0, columns or len(handles)
    if handles and ax.name == "3d":
        _legend(ax, handles, most, wide, loc="upper center", bbox_to_anchor=(0.5, 0.03), borderaxespad=0.2)
    elif handles:
        ticks = ax.yaxis.get_major_formatter()
        ticks.format_ticks(ax.get_yticks())
        pad = 1.6 if ticks.get_offset() else 0.2       # room for a power of ten that the ticks have in common
        outside = _outside(ax)
        size, lines = _legend(ax, handles, most, wide * (1 + outside), loc="lower left",
                              bbox_to_anchor=(-outside, 1), borderaxespad=pad)
        rows = size * (1.65 * lines + pad)
    ax.set_title(title(wide), pad=4 + rows, fontsize="medium", va="bottom")


def _legend(ax: Any, handles: Sequence[Any], most: int, space: float, **where: Any) -> tuple[float, int]:
    """Put the legend, in letters so small that it takes no more than PART of the figure: their size, and its
    rows.
    """
    size = optional("matplotlib", "plot").rcParams["legend.fontsize"]
    size = optional("matplotlib.font_manager", "plot").FontProperties(size=size).get_size_in_points()
    figure, pixels = ax.get_figure(root=True).bbox, ax.get_figure(root=True).dpi / 72
    columns = _columns(handles, most, space / size)
    while True:
        found = ax.legend(handles=handles, ncols=columns, frameon=False, columnspacing=1.2, handlelength=1.6,
                          fontsize=size, **where)
        box = found.get_window_extent()
        if columns > 1 and box.width > space * pixels:     # letters are wider than was estimated
            columns -= 1
            continue
        if box.width * box.height <= PART * figure.width * figure.height or size <= SMALLEST:
            return size, -(-len(handles) // columns)
        size *= 0.9
        columns = _columns(handles, most, space / size)


def _within(ax: Any) -> bool:
    """Make axes smaller, so that all of them is on the figure if no layout does that; whether they are.

    savefig cuts off what is beyond its edge.
    """
    figure = ax.get_figure(root=True)
    if figure.get_layout_engine() is not None or ax.get_subplotspec() is None:
        return False
    drawn, (wide, high) = ax.get_tightbbox(), figure.bbox.size
    place = ax.get_position(original=True)
    left, below = max(0.0, EDGE - drawn.x0 / wide), max(0.0, EDGE - drawn.y0 / high)
    above = max(0.0, drawn.y1 / high - 1 + EDGE)
    width, height = place.width - left, place.height - below - above
    if not left + below + above or min(width, height) < LEAST:
        return False
    ax.set_position((place.x0 + left, place.y0 + below, width, height))
    return True


def room(ax: Any) -> float:
    """The width of the axes in points, after the figure has laid them out."""
    figure = ax.get_figure(root=True)
    if layout := figure.get_layout_engine():
        layout.execute(figure)
    return float(ax.get_window_extent().width * 72 / figure.dpi)


def _outside(ax: Any) -> float:
    """How far the label of the axis of flat axes, above which a legend begins, is beside them, in widths."""
    frame, label = ax.get_window_extent(), ax.yaxis.get_tightbbox()
    return max(0.0, float(frame.x0 - label.x0)) / frame.width if label else 0.0


def _columns(handles: Sequence[Any], most: int, space: float) -> int:
    """As many columns of a legend as there is room for, in sizes of its letters."""
    wide = [0.08 * width(handle.get_label().replace("$", "")) + SWATCH for handle in handles]
    for columns in range(min(most, len(handles)), 1, -1):
        # the first columns are the longer ones, as Matplotlib fills them
        if sum(map(max, np.array_split(wide, columns))) <= space:
            return columns
    return 1


def named(style: dict[str, Any], name: str) -> Any:
    """What stands in a legend for a line or a marker."""
    from matplotlib.lines import Line2D
    return Line2D([], [], label=name, **style)
