"""Draws permanent rotations on the sphere of directions: arcs with their verdicts, and their changes."""
from collections.abc import Mapping
from typing import Any

import numpy as np
from sympy import S, oo

from ..algebra.enclosures.floats import Array
from ..arguments import checked
from ..equilibria.curves.staude import staude_cone
from ..mechanics.scenes.system import System
from ..stability.decision import Verdict
from .along_arcs import along, changes_of, directions, floats, moves
from .captions import BEHIND, headed
from .globe import curves_of, dots_of, numbers_on, stage
from .headings import of_scene
from .looks import DARK, GREY, axes_of, label, line

STEP = 0.02                                            # radians between points
OPPOSITE = {"color": GREY, "linewidth": 0.8}
CHANGE = {"marker": "D", "linestyle": "none", "markersize": 4.5, "color": DARK}
# how much of a diamond is full, by what changes there
FILLS = {"stable to unstable": "full", "stable to undecided": "left", "unstable to undecided": "right",
         "stable, other reason": "top", "unstable, other reason": "bottom", "undecided, other reason": "none"}
REST = {"marker": "X", "linestyle": "none", "markersize": 6.5, "color": DARK, "markeredgecolor": "white"}
FOLD = {"marker": "o", "linestyle": "none", "markersize": 3.5, "color": DARK, "markerfacecolor": "white"}
ANY = {"marker": "s", "linestyle": "none", "markersize": 5.5, "color": GREY}


@checked
def draw_staude_cone(scene: System, values: Mapping[str, Any] | None = None, ax: Any = None,
                     **kwargs: Any) -> Any:
    """Draw the directions of the permanent rotations of a heavy body, seen as ax.view_init says.

    On the sphere abs(k) = 1 the picture has the admissible arcs of Staude's cone, whose points have one
    omega² > 0 each, in the look of their verdict. The directions −k are grey: about them there is no
    rotation. With a rotor it has the curve of the directions, whose points have one omega each, and at
    circles two rotations of one omega become one. An arc has its number in the list of staude_cone(…).arcs,
    which is that of gyrostat decide. At diamonds the verdict or its reason changes, crosses are ±c, at rest,
    and squares are axes of rotations of every rate. If an arc goes to a principal axis, omega → ±∞ there. If
    c and l are in a principal plane, arcs in that plane cover each other. What is behind is faded.

    Parameters
    ----------
    scene : System
        with U = c·k; with a rotor, of rational numbers
    values : mapping of name to number, or None
        for every name of the scene
    ax : axes of mplot3d
        new ones where they are left out
    **kwargs : Any
        of the arcs: of Axes3D.plot

    Returns
    -------
    axes of mplot3d

    Raises
    ------
    ScopeError
        U is not c·k, every direction, or every one of a circle, is that of a
        permanent rotation; with a rotor, a number is not rational
    ValuesError
        a name is missing or unknown, or a number is not admissible
    ArgumentError
        the axes are flat
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Staude, J. reine angew. Math. 113 (1894) 318-334; Kharlamov (1965), for gyrostats.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U)
    >>> sphere = Figure().add_subplot(projection="3d")
    >>> ax = gs.plotting.draw_staude_cone(scene, ax=sphere)
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['stable', 'unstable', 'no rotation', 'stable to unstable', 'at rest']
    """
    arcs = staude_cone(scene).arcs(values or {})
    ax = axes_of(ax, three=True)
    eye = stage(ax, 1.0, [label(f"k{n}") for n in (1, 2, 3)])
    moving = [arc for arc in arcs if moves(arc)]
    curves = [(n, piece.decision.verdict, directions(arc, piece, STEP)) for n, arc in enumerate(arcs, 1)
              if moves(arc) for piece in arc.pieces]
    opposite = [-curve for *_, curve in curves] if arcs[0].both_ways else []
    without = curves_of(ax, opposite, OPPOSITE, "no rotation", eye)
    handles: list[Any] = []
    for verdict in Verdict:
        own = [curve for _, found, curve in curves if found is verdict]
        style = {**line(verdict), "linewidth": 2.0, **kwargs}
        handles += curves_of(ax, own, style, verdict.name.lower(), eye)
    handles += without
    changes = [(along(arc, np.array([float(x)]))[0][0], said) for arc in moving
               for x, said in changes_of(arc)]
    for said, fill in FILLS.items():
        handles += dots_of(ax, [k for k, what in changes if what == said], change(fill), said, eye)
    folds = [floats(end.k) for arc in moving for end in arc.ends if end.omega not in (0, oo, -oo)]
    rest = [floats(end.k) for arc in moving for end in arc.ends if end.omega == 0]
    rest += [floats(arc.rotation(S.Zero).directions[0]) for arc in moving if not arc.both_ways
             and arc.low < 0 < arc.high]
    still = [floats(arc.ends[0].k) for arc in arcs if not moves(arc)]
    for points, style, name in ((folds, FOLD, "fold"), (rest, REST, "at rest"), (still, ANY, "every rate")):
        handles += dots_of(ax, points, style, name, eye)
    longest = {n: curve for n, _, curve in sorted(curves, key=lambda piece: _length(piece[-1]))}
    middles = {n: len(curve) // 2 for n, curve in longest.items()}
    numbers_on(ax, [(n, longest[n][at]) for n, at in middles.items()], eye,
               ways=[np.cross(longest[n][at], _unit(longest[n][at + 1] - longest[n][at - 1]))
                     for n, at in middles.items()])
    numbers_on(ax, [(n, floats(arc.ends[0].k)) for n, arc in enumerate(arcs, 1) if not moves(arc)], eye)
    headed(ax, "Permanent rotations on the sphere of directions", of_scene(scene, values or {}), handles,
           after=BEHIND)
    return ax


def _unit(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))


def _length(curve: Array) -> float:
    return float(np.linalg.norm(np.diff(curve, axis=0), axis=1).sum())


def change(fill: str) -> dict[str, Any]:
    """The look of a change: a diamond, full on one of its sides."""
    return {**CHANGE, "fillstyle": fill, "markerfacecoloralt": "white"}
