"""Draws the path of the axis of the body on the sphere of directions: precession and nutation."""
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array, row
from ..arguments import checked
from ..errors import ValuesError
from ..trajectories import Motion
from .captions import BEHIND, headed
from .globe import circle, curve_on, dots_on, stage
from .headings import of_motion
from .legends import named
from .looks import BLUE, DARK, GREY, axes_of, label

WIDEST = 0.5                                               # of a chord of the unit sphere: 29°


@checked
def draw_nutation(motion: Motion, times: Any, ax: Any = None, **kwargs: Any) -> Any:
    """Draw the path of the axis of the body in space, on the unit sphere, seen as ax.view_init says.

    The axis is e3, unless the scene was recognised as of revolution about another. Upwards is the vertical,
    for a free body the direction of M. Between two limits of its height the axis nods: its path is a wave,
    has loops, or has cusps, as the rate φ̇ keeps its sign, changes it, or vanishes at a limit. What is behind
    is faded.

    Parameters
    ----------
    motion : Motion
        of gyrostat.trajectories.motion
    times : array, shape (n,)
        increasing, close enough for a smooth curve [T]
    ax : axes of mplot3d
        new ones where they are left out
    **kwargs : Any
        of the path: of Axes3D.plot

    Returns
    -------
    axes of mplot3d

    Raises
    ------
    ArgumentError
        no motion is given, or flat axes
    ValuesError
        the times are so far apart that the path between them is lost
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Goldstein, Classical Mechanics, §5.7, fig. 5.9.

    Examples
    --------
    >>> import gyrostat as gs
    >>> import numpy as np
    >>> from matplotlib.figure import Figure
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> released = gs.trajectories.motion(top, (0, 0, 3, "0.6", 0, "0.8"),
    ...                                   {"I1": 1, "I3": 1, "l": 0, "m0": 1})
    >>> ax = gs.plotting.draw_nutation(released, np.linspace(0, 10, 500),
    ...                                Figure().add_subplot(projection="3d"))
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['axis of the body', 'limits of $k_3$']
    """
    path = axis_path(motion, times)
    ax = axes_of(ax, three=True)
    eye = stage(ax, 1.0, [label("x"), label("y"), label("z")])
    style = {"color": BLUE, "linewidth": 1.4, **kwargs}
    limit = {"color": DARK, "linewidth": 0.9, "linestyle": (0, (6, 2))}
    curve_on(ax, circle(np.array([0.0, 0.0, 1.0]), 1.0), eye, color=GREY, linewidth=0.6)
    length = float(np.linalg.norm([float(x) for x in motion.state[3:]])) or 1.0
    # of the axis on the unit sphere
    limits = [height / length for height in motion.limits or () if abs(height) < length]
    for height in limits:
        curve_on(ax, circle(np.array([0.0, 0.0, 1.0]), float(np.sqrt(1 - height**2)), height), eye, **limit)
    curve_on(ax, path, eye, **style)
    dots_on(ax, path[:1], eye, color=style["color"], marker="o", linestyle="none", markersize=5)
    named_height = label("k3") if motion.axis[2] == 1 else "its height"
    headed(ax, "Path of the axis of the body on the sphere of directions", of_motion(motion),
           [named(style, "axis of the body"),
            *([named(limit, f"limits of {named_height}")] if limits else [])], after=BEHIND)
    return ax


def axis_path(motion: Motion, times: Any) -> Array:
    """Return the axis of the body in space, shape (n, 3): that of revolution, or e3."""
    return close_enough(motion.attitude(row(times, "the times")) @ motion.axis)


def close_enough(path: Array) -> Array:
    """Return a path on the unit sphere; it is refused if its points are too far apart to show it.

    Raises
    ------
    ValuesError
        two points in a row are further apart than WIDEST
    """
    if (worst := widest(path)) > WIDEST:
        angle = float(np.degrees(2 * np.arcsin(min(worst / 2, 1))))
        raise ValuesError(f"between two of the times the axis moves by up to {angle:.3g}°, and its path "
                          "would be lost between them: give "
                          f"about {int(np.ceil(len(path) * worst / WIDEST * 2))} times, or an earlier last "
                          "one")
    return path


def widest(path: Array) -> float:
    """Return the longest chord of a path."""
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).max(initial=0.0))
