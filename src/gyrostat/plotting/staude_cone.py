"""Staude's cone on the sphere of directions: admissible arcs with their verdicts, and where these change."""
from collections.abc import Mapping
from typing import Any

import numpy as np
from sympy import Expr, oo

from ..algebra.floats import Array, in_floats
from ..mechanics.system import System
from ..stability.report import Verdict
from ..stability.staude import staude_cone
from ..stability.staude_arcs import Piece, StaudeArc
from .globe import curve_on, dots_on, stage
from .headings import heading, of_scene
from .looks import DARK, GREY, axes_of, label, legend, line, named

STEP, ROUNDS, FIRST = 0.02, 12, 33                     # radians between points; halvings; points at first
OPPOSITE = {"color": GREY, "linewidth": 0.8}
CHANGE = {"marker": "D", "linestyle": "none", "markersize": 4.5, "color": DARK}
REST = {"marker": "X", "linestyle": "none", "markersize": 6.5, "color": DARK, "markeredgecolor": "white"}
ANY = {"marker": "s", "linestyle": "none", "markersize": 5.5, "color": GREY}


def draw_staude_cone(scene: System, values: Mapping[str, Any] | None = None, ax: Any = None,
                     **kwargs: Any) -> Any:
    """Draw the directions of the permanent rotations of a heavy body, seen as ax.view_init says.

    On the sphere abs(k) = 1 the admissible arcs of Staude's cone, each point of one omega² > 0, in the look
    of its verdict; grey: the directions −k, of no rotation. Diamonds: changes of the verdict; crosses: ±c, at
    rest; squares: an axis of rotations of every rate. What is behind is faded. At a principal axis that an
    arc goes to, omega → ∞.

    Parameters
    ----------
    scene : System
        a body without a rotor, in principal axes, and U = c·k
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
        there is a rotor, U is not c·k, the axes are not principal, or every direction is one of a permanent
        rotation
    ValuesError
        a name is missing or unknown, or a number is not admissible
    ArgumentError
        the axes are flat
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Staude, J. reine angew. Math. 113 (1894) 318-334.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> ax = gs.plotting.draw_staude_cone(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U),
    ...                                   ax=Figure().add_subplot(projection="3d"))
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['stable', 'unstable', 'undecided', 'no rotation', 'change', 'at rest']
    """
    arcs = staude_cone(scene).arcs(values or {})
    ax = axes_of(ax, three=True)
    eye = stage(ax, 1.0, [label(f"k{n}") for n in (1, 2, 3)])
    curves = [(piece.decision.verdict, _curve(arc, piece)) for arc in arcs if _moves(arc)
              for piece in arc.pieces]
    for _, curve in curves:
        curve_on(ax, -curve, eye, **OPPOSITE)
    handles = []
    for verdict in Verdict:
        style = {**line(verdict), "linewidth": 2.0, **kwargs}
        own = [curve for found, curve in curves if found is verdict]
        for curve in own:
            curve_on(ax, curve, eye, **style)
        handles += [named(style, verdict.name.lower())] if own else []
    handles += [named(OPPOSITE, "no rotation")] if curves else []
    changes = [_at(arc, np.array([float(x)]))[0] for arc in arcs if _moves(arc) for x in arc.boundaries]
    rest = [_floats(end.k) for arc in arcs if _moves(arc) for end in arc.ends
            if end.omega_squared == 0]
    still = [_floats(arc.ends[0].k) for arc in arcs if not _moves(arc)]
    for points, style, name in ((changes, CHANGE, "change"), (rest, REST, "at rest"),
                                (still, ANY, "every rate")):
        if points:
            dots_on(ax, np.array(points), eye, **style)
            handles.append(named(style, name))
    legend(ax, handles, title=heading(ax, *of_scene(scene, values or {})))
    return ax


def _moves(arc: StaudeArc) -> bool:
    """Whether its direction changes along it."""
    return sum(x != 0 for x in arc.n) > 1


def _curve(arc: StaudeArc, piece: Piece) -> Array:
    """The directions along a piece, its ends with it, shape (n, 3)."""
    first, last = (_floats(end.k) if at == own else _at(arc, np.array([float(at)]))[0] for end, at, own in
                   zip(arc.ends, (piece.low, piece.high), (arc.low, arc.high)))
    t = np.linspace(0, 1, FIRST)
    for _ in range(ROUNDS):
        k = np.vstack([first, _at(arc, _placed(arc, piece, t[1:-1])), last])
        wide = np.flatnonzero(np.linalg.norm(np.diff(k, axis=0), axis=1) > STEP)
        t = np.insert(t, wide + 1, (t[wide] + t[wide + 1]) / 2)
    return k


def _placed(arc: StaudeArc, piece: Piece, t: Array) -> Array:
    """Values of the parameter between the ends of a piece, for t between 0 and 1."""
    moments = [float(x) for x in arc.scene.body.moments]
    low, high, size = float(piece.low), float(piece.high), sum(moments)
    if piece.low == -oo and piece.high == oo:
        return size * np.tan(np.pi * (t - 0.5))
    if piece.low == -oo:
        return high - size * (1 - t) / t
    return low + size * t / (1 - t) if piece.high == oo else low + (high - low) * t


def _at(arc: StaudeArc, values: Array) -> Array:
    """k at values of the parameter, shape (n, 3)."""
    parts = [np.broadcast_to(in_floats(x, np, {arc.parameter: values}), values.shape) for x in arc.n]
    n = np.stack(parts, axis=1)
    return n / np.linalg.norm(n, axis=1)[:, None]


def _floats(k: tuple[Expr, ...]) -> Array:
    return np.array([float(x) for x in k])
