"""Draws relative equilibria against a parameter, with their stability and the points where they meet.

Upwards is the tilt for a body in a field, and M along an axis, or ν, for a free gyrostat.
"""
from collections.abc import Callable, Mapping
from itertools import pairwise
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array
from ..algebra.text.numbers import exact_number
from ..arguments import checked
from ..equilibria.continuation.bifurcation_kinds import precessions_leave, tilt_leaves
from ..equilibria.continuation.continuation import continuation
from ..equilibria.continuation.heavy_changes import FREQUENCIES, SINGULAR
from ..equilibria.continuation.mark import Mark
from ..equilibria.continuation.pieces import INFINITE, Continuation, Piece
from ..equilibria.finders.free import LENGTH
from ..mechanics.families.named_families import E1, E2, E3
from ..mechanics.scenes.kind import Kind
from ..mechanics.scenes.system import System
from ..notation import symbol
from ..printing.letters import letters_of
from ..stability.decision import Verdict
from .beside import Marks
from .captions import headed
from .globe import dots_of
from .headings import of_scene, of_sphere
from .legends import named
from .looks import DARK, axes_of, axis, label, line, marker, with_dimension
from .scene_numbers import in_own_axes

CHANGES = {"fold on a level": "o", precessions_leave(E1): "s", precessions_leave(E2): "p",
           SINGULAR: "o", FREQUENCIES: "s"}
MEETINGS = {tilt_leaves(E1): "^", tilt_leaves(E2): "v", "fold at fixed rate": "D",
            "pitchfork at fixed rate": "P", "crossing at fixed rate": "X", INFINITE: "x"}
ROTATIONS = {"fold": "D", "pitchfork": "P", "umbilic": "X", "crossing": "x", "circle leaves an axis": "o",
             "circle at this value alone": "s", "sphere at this value alone": "*"}
SHAPES = {**MEETINGS, **ROTATIONS, **CHANGES}
MOMENTUM, RATE = (1, 1, 0), (0, 1, 0)                      # dimensions
NUMBERS, WIDTH = 1.17, 0.06                                # of the numbers of attitudes: height, least width
CLEARANCE = 0.11                                           # of the names, in k3


@checked
def draw_bifurcation_diagram(scene: System, name: str, ends: tuple[Any, Any], values: Mapping[str, Any],
                             ax: Any = None, **kwargs: Any) -> Any:
    """Draw every relative equilibrium against one parameter, with its stability.

    For a body of revolution in a field it draws k3 of E1, E2 and E3 at a fixed rotor and rate about the
    vertical. Solid is stable, dashed unstable, dotted undecided; E3 is stable modulo the spin about the axis
    of the body. At a full mark stability changes: "fold on a level" of E3, "precessions leave E1". At an open
    mark branches meet at this rotor and rate, and stability does not change: branches of E3 fold, or come to
    E1 or E2. An E3 that is alone at its value is a circle, as in the other pictures.

    For any other body in a field it draws k3 of the permanent rotations at omega. At a full mark the form is
    singular, or two frequencies meet.

    For a satellite in a circular orbit it draws the attitudes in which it rests, by the component of the
    normal n along the axis of the component of the rotor that is free, or along axis 3. Above stands how many
    attitudes there are between two values at which this number changes.

    For a free gyrostat it draws the permanent rotations on a momentum sphere: M along an axis against the
    component of the rotor along this axis, or ν with ω = ν M against any other parameter. A mark stands where
    rotations meet; lines without a mark cross in the picture only.

    The name of each kind of mark stands beside one of them, or in the legend if there is no room.

    Parameters
    ----------
    scene : System
        body of revolution in a U rational in k3, any body without a field or in a U of degree 1 or 2, or a
        satellite in a circular orbit
    name : str
        what is free: "omega", or another one of these names
    ends : pair of numbers
        of its range
    values : mapping of name to number
        the moments, l, the parameters of U and omega, of a free gyrostat M, without it
    ax : matplotlib Axes
        a new one where it is left out
    **kwargs : Any
        of the branches: of Axes.plot

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ScopeError
        the body is not of revolution; U is unspecified, not rational in k3, or of too high a degree
    ValuesError
        numbers are missing, unknown or not admissible, or the range is empty
    MissingExtraError
        pip install "gyrostat[plot]"

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> values = {"I1": 2, "I3": 1, "l": 0, "m0": -1}
    >>> ax = gs.plotting.draw_bifurcation_diagram(
    ...     top, "omega", (0, 3), values, Figure().subplots())
    >>> sorted(text.get_text() for text in ax.texts)
    ['E1', 'E2', 'E3', 'E3 leaves E1', 'precessions leave E2']
    """
    given, all_values = scene, values
    scene, values, k3, about = in_own_axes(scene, values)
    found = continuation(scene, name, ends, values)
    ax, free, rotor = axes_of(ax), scene.kind is Kind.FREE, scene.body.gyrostatic_momentum
    entry, orbit = rotor.index(symbol(name)) if symbol(name) in rotor else None, scene.kind is Kind.ORBIT

    def height(of: Piece | Mark) -> Any:
        if orbit:
            return np.array(of.n, float).T[2 if entry is None else entry]
        return of.k3 if not free else of.nu if entry is None else np.array(of.momentum).T[entry]

    for piece in found.pieces:
        alone = len(piece.parameter) == 1
        ax.plot(piece.parameter, height(piece), **{**(marker if alone else line)(piece.verdict),
                                                   "clip_on": False, **({} if alone else kwargs)})
    handles, marks = _verdicts(found, kwargs), _marks_of(found, ax, height)
    low, high = (float(exact_number(end, name)) for end in ends)
    ax.set(xlim=(low, high), xlabel=axis(name))
    if free:
        letters, length = letters_of(scene), name == LENGTH.name
        ax.set_ylabel(axis(letters.of("nu"), RATE) if entry is None
                      else axis(letters.of(f"M{entry + 1}"), MOMENTUM))
        if length:
            ax.set_xlabel(with_dimension("$|M|$", MOMENTUM))
        said = of_scene(scene, values) if length else of_sphere(scene, values, values[LENGTH.name])
    else:
        tilt = f"${k3}$" if not orbit else label(f"n{3 if entry is None else entry + 1}")
        ax.set(ylim=(-1.3, 1.3), ylabel=tilt)
        above, numbers = of_scene(given, all_values)
        said = [*above, *about], numbers
    if orbit:
        _count(found, low, high, ax)
    if scene.kind is Kind.REVOLUTION:
        _name(found, high, ax)
    what = ("permanent rotations of a free gyrostat" if free else
            "attitudes of a satellite in orbit" if orbit else "relative equilibria")
    headed(ax, f"Bifurcation diagram of the {what} against {label(name)}", said, handles, 3, marks,
           "Stability changes at filled marks, and at open ones branches meet" if marks else "")
    return ax


def _marks_of(found: Continuation, ax: Any, height: Callable[[Mark], Any]) -> list[Marks]:
    """Draw the marks, by kind: full ones where stability changes, open ones where it does not."""
    drawn: list[Marks] = []
    for kind, shape in SHAPES.items():
        if marks := [mark for mark in found.marks if mark.kind == kind]:
            style = {"color": DARK, "marker": shape, "markersize": 6, "linestyle": "none",
                     "markerfacecolor": DARK if kind in CHANGES else "white"}
            places = [(float(mark.value), float(height(mark))) for mark in marks]
            handle, = dots_of(ax, places, style, kind, clip_on=False)
            drawn.append(Marks(handle, places))
    return drawn


def _verdicts(found: Continuation, kwargs: Mapping[str, Any]) -> list[Any]:
    """What stands in the legend for the lines and the isolated points."""
    handles = []
    for verdict in Verdict:
        labels = {piece.label for piece in found.pieces if piece.verdict is verdict}
        text = verdict.name.lower() + (f" ({E3.label}: modulo the spin)" if verdict is Verdict.STABLE
                                       and E3.label in labels else "")
        if labels:
            handles.append(named({**line(verdict), **kwargs}, text))
        if any(piece.verdict is verdict and len(piece.parameter) == 1 for piece in found.pieces):
            handles.append(named(marker(verdict), f"{E3.label} at this value alone, {verdict.name.lower()}"))
    return handles


def _count(found: Continuation, low: float, high: float, ax: Any) -> None:
    """Write how many attitudes there are above each part of the range that is wide enough."""
    changes = {float(mark.value) for mark in found.marks if mark.numbers and len({*mark.numbers}) == 2}
    for a, b in pairwise([low, *sorted(changes), high]):
        middle = (a + b) / 2
        if b - a > WIDTH * (high - low):
            count = sum(piece.parameter[0] < middle < piece.parameter[-1] for piece in found.pieces)
            ax.annotate(f"{count}", (middle, NUMBERS), ha="center", va="center")


def _name(found: Continuation, high: float, ax: Any) -> None:
    """The branches that come to the right side, there, none over another; or the longest piece of E3."""
    ends = [(piece.label, float(_k3(piece)[-1])) for piece in found.pieces if len(piece.parameter) > 1
            and piece.parameter[-1] == high]
    names: list[tuple[str, float]] = []
    for name, height in sorted(ends):                      # E1 and E2 first
        if all(abs(height - other) > CLEARANCE for _, other in names):
            names.append((name, height))
            ax.annotate(name, (1, height), xytext=(4, 0), xycoords=ax.get_yaxis_transform(),
                        textcoords="offset points", va="center")
    tilted = [piece for piece in found.pieces if piece.label == E3.label]
    if tilted and all(name != E3.label for name, _ in names):
        piece = max(tilted, key=lambda piece: float(np.ptp(piece.parameter) + np.ptp(_k3(piece))))
        n = int(np.argmin(np.abs(piece.parameter - piece.parameter.mean())))
        above = _k3(piece)[n] < 0                          # away from E1 and E2
        ax.annotate(piece.label, (piece.parameter[n], _k3(piece)[n]), xytext=(5, 5 if above else -5),
                    textcoords="offset points", va="bottom" if above else "top")


def _k3(piece: Piece) -> Array:
    assert piece.k3 is not None
    return piece.k3
