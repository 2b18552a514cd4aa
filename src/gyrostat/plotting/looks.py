"""Gives stable, unstable and undecided one look each, for areas, lines and markers; labels axes."""
import re
from collections.abc import Sequence
from typing import Any

from ..errors import ArgumentError, optional, require
from ..notation import dimension_of
from ..printing.formats.si_units import unit_of
from ..stability.decision import Decision, Verdict
from ..typesetting import SUPERSCRIPTS, typeset

DESTROYED = "destroyed by internal damping"            # what is stable, but not under it
LOOKS = {"stable": ("#dce9f4", ""), "undecided": ("#f4dfb6", "////"), "unstable": ("#47566b", ""),
         "no_equilibrium": ("#ffffff", "....")}
AREAS = {**LOOKS, DESTROYED: ("#efdcd6", "\\\\\\\\")}
INK = {"undecided": "#8a6d2f", "no_equilibrium": "#a0a0a0", DESTROYED: "#a23b2a"}    # of the hatches
PLAIN = {raised: plain for plain, raised in SUPERSCRIPTS.items()}
MARKER = 6.5                                           # points across
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
    return {"marker": "o", "linestyle": "none", "markersize": MARKER, "markeredgewidth": 1.4, **look,
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


def si_unit(name: str) -> str:
    r"""The unit in SI of a quantity, as Matplotlib sets it; "" for a pure number or a parameter of the user.

    Examples
    --------
    >>> si_unit("omega0"), si_unit("l"), si_unit("k3")
    ('\\mathrm{rad/s}', '\\mathrm{kg\\,m^{2}\\,s^{-1}}', '')
    """
    unit = unit_of(name).translate(PLAIN)
    raised = re.sub(r"(-?[0-9]+)", r"^{\1}", unit).replace(" ", r"\,")
    return rf"\mathrm{{{raised}}}" if unit else ""


def with_dimension(text: str, dimension: tuple[int, int, int] | None) -> str:
    """The text of an axis and a dimension; nothing after a pure number, or where none is known."""
    mass, rate, length = dimension or (0, 0, 0)
    powers = (("M", mass), ("L", 2 * mass + length), ("T", -rate))
    shown = r"\,".join(unit if power == 1 else f"{unit}^{{{power}}}" for unit, power in powers if power)
    return f"{text} $[\\mathrm{{{shown}}}]$" if shown else text
