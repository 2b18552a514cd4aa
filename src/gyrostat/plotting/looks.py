"""One look of stable, unstable and undecided for areas, lines and markers; axes and legends."""
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from ..algebra.floats import Array
from ..errors import ArgumentError, optional
from ..notation import typeset
from ..stability.report import Decision, Verdict

DESTROYED = "destroyed by internal damping"            # what is stable, but not under it
LOOKS = {"stable": ("#dce9f4", ""), "undecided": ("#f4dfb6", "////"), "unstable": ("#47566b", ""),
         "no_equilibrium": ("#ffffff", "....")}
AREAS = {**LOOKS, DESTROYED: ("#efdcd6", "\\\\\\\\")}
INK = {"undecided": "#8a6d2f", "no_equilibrium": "#a0a0a0", DESTROYED: "#a23b2a"}    # of the hatches
DARK, BLUE, GREY = "#1f2933", "#1d5b96", "#8592a0"
LINES = {"stable": (BLUE, "-"), "unstable": (DARK, (0, (4, 2))), "undecided": (INK["undecided"], ":")}
MARKERS = {"stable": {"color": BLUE, "fillstyle": "full"}, "unstable": {"color": DARK, "fillstyle": "none"},
           "undecided": {"color": INK["undecided"], "fillstyle": "left", "markerfacecoloralt": "white"}}


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
    if three and ax.name != "3d":
        raise ArgumentError(f"the axes are {ax.name}, the picture is a view of space: make them with "
                            "projection=\"3d\"")
    return ax


def label(name: str) -> str:
    """A name of the notation table as Matplotlib sets it."""
    return f"${typeset(name)}$"


def legend(ax: Any, handles: Sequence[Any], columns: int | None = None) -> None:
    """A row, or columns, where no data are: above flat axes, below a view of space."""
    where = (
        {"loc": "upper center", "bbox_to_anchor": (0.5, 0.03)}
        if ax.name == "3d"
        else {"loc": "lower left", "bbox_to_anchor": (0, 1)}
    )
    ax.legend(handles=handles, ncols=columns or len(handles), fontsize="small", frameon=False,
              borderaxespad=0.2, columnspacing=1.2,
              handlelength=1.6, **where)


def named(style: dict[str, Any], name: str) -> Any:
    """What stands in a legend for a line or a marker."""
    from matplotlib.lines import Line2D
    return Line2D([], [], label=name, **style)


def runs(values: Array) -> Iterator[slice]:
    """Slices of neighbours that are equal.

    Examples
    --------
    >>> [(run.start, run.stop) for run in runs(np.array([1, 1, -1, -1, -1, 1]))]
    [(0, 2), (2, 5), (5, 6)]
    """
    cuts = [0, *(np.flatnonzero(values[1:] != values[:-1]) + 1), len(values)]
    return (slice(int(a), int(b)) for a, b in zip(cuts, cuts[1:]))
