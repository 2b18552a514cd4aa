"""Writes captions for a paper, as LaTeX: what a picture shows, of which scene, and what its looks mean."""
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from ..arguments import checked
from ..errors import ArgumentError, optional, require
from .beside import Marks
from .headings import heading
from .legends import legend
from .looks import BLUE, DARK, DESTROYED, GREY, INK
from .nested import nest

COLOURS = {"blue": BLUE, "dark": DARK, "grey": GREY, "brown": INK["undecided"], "red": INK[DESTROYED],
           "black": "black", "white": "white", "light blue": "#dce9f4", "light grey": "#dfe3e8",
           "sand": "#f4dfb6", "pink": "#efdcd6", "slate": "#47566b", "green": "green", "orange": "orange"}
DASHES = {"-": "solid", "--": "dashed", ":": "dotted", "-.": "dash-dotted"}
SHAPES = {"o": "circles", "D": "diamonds", "s": "squares", "p": "pentagons", "^": "upward triangles",
          "v": "downward triangles", "P": "broad pluses", "X": "broad crosses", "x": "crosses",
          "+": "pluses", "1": "tripods", "*": "stars", ".": "dots"}
FILLS = {"full": "filled"}
BEHIND = "What is behind the sphere is faded"
THIN = 1.0                                                 # points
LINES_ALONE = ("x", "+", "1")                              # shapes without an inside


@dataclass(frozen=True)
class Caption:
    """What a caption is made of.

    Parameters
    ----------
    what : str
        the kind of picture
    above, shown : sequences of str
        the field, and the numbers, as in the title
    handles : sequence of artists
        each look with its name
    after : str
        one more sentence, or nothing
    """

    what: str
    above: Sequence[str]
    shown: Sequence[str]
    handles: Sequence[Any]
    after: str


def headed(ax: Any, what: str, said: tuple[Sequence[str], Sequence[str]], handles: Sequence[Any],
           columns: int | None = None, marks: Sequence[Marks] = (), after: str = "") -> None:
    """Draw legend and title, nest marks that nearly coincide, and keep what a caption says.

    what, said and after are as in Caption.
    """
    legend(ax, handles, columns, partial(heading, *said), marks)
    nest(ax)
    ax.gyrostat_caption = Caption(what, *said, [*handles, *(kind.handle for kind in marks)], after)


@checked
def caption(ax: Any) -> str:
    r"""Return the caption of a picture for a paper, as LaTeX text.

    It says what is drawn, of which field, at which numbers, and what each look means. It does not depend on
    the title, which a paper leaves out: ax.set_title("").

    Parameters
    ----------
    ax : matplotlib Axes
        that a function of gyrostat.plotting has returned

    Returns
    -------
    str
        for \caption{…}; it needs no package but amsmath

    Raises
    ------
    ArgumentError
        no function of gyrostat.plotting has drawn on the axes

    Examples
    --------
    >>> import gyrostat as gs
    >>> import textwrap
    >>> from matplotlib.figure import Figure
    >>> body = gs.assemble(gs.Gyrostat((1, 2, 3)))
    >>> values, axes = {"l3": 0, "M": 1}, Figure().subplots()
    >>> ax = gs.plotting.draw_rotor_set(body, values, axes)
    >>> print(textwrap.fill(gs.plotting.caption(ax), 68))
    Bifurcation set of a free gyrostat: $l_3 = 0$, $I_1 = 1$, $I_2 = 2$,
    $I_3 = 3$, $|M| = 1$. Solid dark lines: fold; dash-dotted blue
    lines: pitchfork. The number in each region is that of the permanent
    rotations.
    """
    require(ax, optional("matplotlib.axes", "plot").Axes, "ax")
    if (kept := getattr(ax, "gyrostat_caption", None)) is None:
        raise ArgumentError("no draw_ function has drawn on these axes, and there is nothing to say of them: "
                            "give axes that one has returned")
    said = ", ".join([*kept.above, *kept.shown])
    text = f"{kept.what}: {said}" if said else kept.what
    looks = "; ".join(f"{_look(handle)}: {handle.get_label()}" for handle in kept.handles)
    return " ".join(f"{part[0].upper()}{part[1:]}." for part in (text, looks, kept.after) if part)


def _look(handle: Any) -> str:
    """What a line, a marker or an area looks like, in words."""
    from matplotlib.colors import to_hex
    if not hasattr(handle, "get_marker"):
        hatch = handle.get_hatch() or ""
        how = "" if not hatch else "dotted " if "." in hatch else "hatched "
        return f"{how}{_colour(handle.get_facecolor())} areas"
    marker, style = str(handle.get_marker()), str(handle.get_linestyle())
    if marker in ("None", "none", ""):
        thin = "thin " if handle.get_linewidth() < THIN else ""
        return f"{thin}{DASHES.get(style, 'dashed')} {_colour(handle.get_color())} lines"
    if marker.startswith("$"):
        return f"number {marker.strip('$')}"
    shape = SHAPES.get(marker, "marks")
    if marker not in LINES_ALONE:
        fill = handle.get_fillstyle()
        white = fill == "none" or to_hex(handle.get_markerfacecolor()) == "#ffffff"
        shape = f"{'open' if white else FILLS.get(fill, f'{fill}-filled')} {shape}"
    also = "" if style == "None" else f" and {DASHES.get(style, 'dashed')} lines"
    return f"{_colour(handle.get_color())} {shape}{also}"


def _colour(colour: Any) -> str:
    """The name of the colour that is nearest."""
    from matplotlib.colors import to_rgb
    there = np.array(to_rgb(colour))
    return min(COLOURS, key=lambda name: float(np.linalg.norm(there - to_rgb(COLOURS[name]))))
