"""One look of stable, unstable and undecided for areas, lines and markers; axes and legends."""
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..errors import ArgumentError, optional, require
from ..notation import dimension_of
from ..printing.formats.linebreaks import width
from ..stability.decision import Decision, Verdict
from ..typesetting import typeset

DESTROYED = "destroyed by internal damping"            # what is stable, but not under it
LOOKS = {"stable": ("#dce9f4", ""), "undecided": ("#f4dfb6", "////"), "unstable": ("#47566b", ""),
         "no_equilibrium": ("#ffffff", "....")}
AREAS = {**LOOKS, DESTROYED: ("#efdcd6", "\\\\\\\\")}
INK = {"undecided": "#8a6d2f", "no_equilibrium": "#a0a0a0", DESTROYED: "#a23b2a"}    # of the hatches
DARK, BLUE, GREY = "#1f2933", "#1d5b96", "#8592a0"
LINES = {"stable": (BLUE, "-"), "unstable": (DARK, (0, (4, 2))), "undecided": (INK["undecided"], ":")}
MARKERS = {"stable": {"color": BLUE, "fillstyle": "full"}, "unstable": {"color": DARK, "fillstyle": "none"},
           "undecided": {"color": INK["undecided"], "fillstyle": "left", "markerfacecoloralt": "white"}}
SWATCH = 3.6                                           # line and gaps of a legend, in sizes of its letters


def line(verdict: Verdict) -> dict[str, Any]:
    """Stable: solid; unstable: dashed; undecided: dotted."""
    color, style = LINES[verdict.name.lower()]
    return {"color": color, "linestyle": style, "linewidth": 1.6}


def marker(verdict: Verdict) -> dict[str, Any]:
    """Stable: a filled circle; unstable: an open one; undecided: half filled."""
    look = MARKERS[verdict.name.lower()]
    return {"marker": "o", "linestyle": "none", "markersize": 6.5, "markeredgewidth": 1.4, **look,
            **({"markerfacecolor": "white", "fillstyle": "full", "markeredgecolor": look["color"]}
               if look["fillstyle"] == "none" else {})}


def meaning(verdict: Verdict, decisions: Sequence[Decision]) -> str:
    """What a legend calls the equilibria of a verdict: it says where they are stable modulo the spin only."""
    modulo = [bool(decision.modulo) for decision in decisions]
    if verdict is not Verdict.STABLE or not any(modulo):
        return verdict.name.lower()
    return "stable modulo the spin" if all(modulo) else "stable, tilted ones modulo the spin"


def axes_of(ax: Any, three: bool = False) -> Any:
    """The axes given, or new ones; three: those of mplot3d.

    Raises
    ------
    MissingExtraError
        pip install "gyrostat[plot]"
    ArgumentError
        the axes are flat, and the picture is not
    """
    optional("matplotlib", "plot")
    if ax is None:
        import matplotlib.pyplot as plt
        _, ax = plt.subplots(subplot_kw={"projection": "3d", "elev": 22, "azim": 40} if three else {})
    require(ax, optional("matplotlib.axes", "plot").Axes, "ax")
    if three and ax.name != "3d":
        raise ArgumentError(f"the axes are {ax.name}, the picture is a view of space: make them with "
                            "projection=\"3d\"")
    return ax


def label(name: str) -> str:
    """A name of the notation table as Matplotlib sets it."""
    return f"${typeset(name)}$"


def axis(name: str, dimension: tuple[int, int, int] | None = None) -> str:
    r"""A name for an axis, with its dimension in brackets: that of the table, or [M L²]ᵃ [T]⁻ᵇ [L]ᶜ.

    Examples
    --------
    >>> axis("omega"), axis("k3")
    ('$\\omega$ $[\\mathrm{T^{-1}}]$', '$k_3$')
    """
    return with_dimension(label(name), dimension or dimension_of(name))


def with_dimension(text: str, dimension: tuple[int, int, int] | None) -> str:
    """The text of an axis and a dimension; nothing after a pure number, or where none is known."""
    mass, rate, length = dimension or (0, 0, 0)
    powers = (("M", mass), ("L", 2 * mass + length), ("T", -rate))
    shown = r"\,".join(unit if power == 1 else f"{unit}^{{{power}}}" for unit, power in powers if power)
    return f"{text} $[\\mathrm{{{shown}}}]$" if shown else text


def legend(ax: Any, handles: Sequence[Any], columns: int | None = None, title: str = "") -> None:
    """A row, or columns, where no data are: above flat axes, below a view of space; above it a title."""
    columns, rows = _columns(ax, handles, columns or len(handles)), 0.0
    where: dict[str, Any] = {}
    if handles and ax.name == "3d":
        where = {"loc": "upper center", "bbox_to_anchor": (0.5, 0.03), "borderaxespad": 0.2}
    elif handles:
        ticks = ax.yaxis.get_major_formatter()
        ticks.format_ticks(ax.get_yticks())
        pad = 1.6 if ticks.get_offset() else 0.2       # room for a power of ten that the ticks have in common
        where = {"loc": "lower left", "bbox_to_anchor": (0, 1), "borderaxespad": pad}
    if handles:
        found = ax.legend(handles=handles, ncols=columns, frameon=False, columnspacing=1.2, handlelength=1.6,
                          **where)
        size = found.get_texts()[0].get_fontsize()
        if ax.name != "3d":
            rows = size * (1.65 * -(-len(handles) // columns) + pad)
    ax.set_title(title, pad=4 + rows, fontsize="medium", va="bottom")


def room(ax: Any) -> float:
    """The width of the axes in points, after the figure has laid them out."""
    figure = ax.get_figure(root=True)
    if layout := figure.get_layout_engine():
        layout.execute(figure)
    return float(ax.get_window_extent().width * 72 / figure.dpi)


def _columns(ax: Any, handles: Sequence[Any], most: int) -> int:
    """As many columns of a legend as the axes have room for."""
    size = optional("matplotlib", "plot").rcParams["legend.fontsize"]
    size = optional("matplotlib.font_manager", "plot").FontProperties(size=size).get_size_in_points()
    space = room(ax) / size
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
