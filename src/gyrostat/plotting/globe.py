"""Draws a sphere seen from one side: outline, axes, and curves on it whose hidden part is faded."""
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array
from ..errors import optional
from .legends import named
from .looks import DARK

BACKGROUND, FADED = "#f4f7fb", 0.28
# of a number, from its point, in radii; points of its letters
OFF, NUMBERS = 0.12, 7.0
# half the width of a digit and of a mark, in radii; in which order directions are tried, from the first one
DIGIT, DOT = 0.03, 0.066
TURNS = np.radians([0, *(side * turn for turn in range(20, 180, 20) for side in (1, -1)), 180])
BESIDE = 0.12                                              # from the head of an axis to its name


def stage(ax: Any, radius: float, names: Sequence[str]) -> Array:
    """An empty sphere with its axes, undistorted; the direction towards the eye, shape (3,).

    The eye is where ax.view_init has put it; what is hidden is decided once, for that view.
    """
    ax.set_proj_type("ortho")
    ax.computed_zorder = False                         # front and back are known here
    ax.set_axis_off()
    ax.set(xlim=(-radius, radius), ylim=(-radius, radius), zlim=(-radius, radius))
    ax.set_box_aspect((1, 1, 1), zoom=1.2)
    eye = towards(ax)
    polygons(ax, [circle(eye, radius)], facecolor=BACKGROUND, edgecolor="none", zorder=0)
    ax.plot(*circle(eye, radius).T, color=DARK, linewidth=1.1, zorder=3)
    for axis, name in zip(np.eye(3), names):
        axis_through(ax, axis, radius, eye, name)
    return eye


def axis_through(ax: Any, axis: Array, radius: float, eye: Array, name: str) -> None:
    """An axis through the sphere, drawn from where it comes into sight.

    Not where it points to the eye, or away from it.
    """
    seen = axis - axis @ eye * eye
    length = float(np.linalg.norm(seen))
    if length < (0.05 if axis @ eye >= 0 else 0.35):
        return
    start = radius if axis @ eye >= 0 else radius / length
    end = _end(length, start / radius) * radius
    arrow(ax, axis, end, eye, start, linewidth=0.9, zorder=4 if axis @ eye >= 0 else 0)
    halo = optional("matplotlib.patheffects", "plot").withStroke(linewidth=3, foreground=BACKGROUND)
    ax.text(*(end * axis + BESIDE * radius / length * seen), name, ha="center", va="center", zorder=5,
            path_effects=[halo])


def _end(length: float, start: float) -> float:
    """How far an axis goes, so that its name does not lie over the outline, where 1 is the radius."""
    end = max(1.32, start + 0.3)
    if end * length + BESIDE >= 1.22:
        return end
    return min(end, (0.8 - BESIDE) / length) if length < 0.6 else (1.22 - BESIDE) / length


def arrow(ax: Any, along: Array, end: float, eye: Array, start: float = 0.0, **style: Any) -> None:
    """An arrow along a unit vector, its head turned to the eye; a point where it is seen end on."""
    aside = np.cross(along, eye)
    if not aside.any():
        return
    shaft, = ax.plot(*np.outer(along, (start, 0.97 * end)), color=DARK, solid_capstyle="butt", clip_on=False,
                     **style)
    head = end * (np.array([along, 0.92 * along, 0.92 * along]) + 0.022
                  * np.outer((0, 1, -1), aside / np.linalg.norm(aside)))
    tip = polygons(ax, [head], facecolor=DARK, edgecolor="none", zorder=style["zorder"], clip_on=False)
    for part in (shaft, tip):                          # their extent is known only once they are drawn
        part.set_in_layout(False)


def polygons(ax: Any, faces: Sequence[Array], **style: Any) -> Any:
    """Filled polygons in space, each of shape (n, 3), sorted by depth: a Poly3DCollection."""
    return ax.add_collection3d(optional("mpl_toolkits.mplot3d.art3d",
                                        "plot").Poly3DCollection(faces, **style), autolim=False)


def towards(ax: Any) -> Array:
    """The unit vector from the origin to the eye."""
    elevation, azimuth = np.radians([ax.elev, ax.azim])
    return np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth),
                     np.sin(elevation)])


def circle(axis: Array, radius: float, height: float = 0.0, n: int = 241) -> Array:
    """Points of a circle about a unit vector, at a height along it, shape (n, 3)."""
    first, second = across(axis)
    turn = np.linspace(0, 2 * np.pi, n)[:, None]
    return height * axis + radius * (np.cos(turn) * first + np.sin(turn) * second)


def across(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors that make a right-handed triad with a third."""
    first = np.cross(np.eye(3)[np.argmin(np.abs(axis))], axis)
    first = first / np.linalg.norm(first)
    return first, np.cross(axis, first)


def parted(curve: Array, eye: Array) -> tuple[Array, Array]:
    """The visible and the hidden part of a curve on the sphere, each with NaN where the other is.

    Parameters
    ----------
    curve : array, shape (n, 3)
        NaN between its pieces
    eye : array, shape (3,)

    Examples
    --------
    >>> front, back = parted(np.array([[1.0, 0, 0], [0, 0, 1], [-1, 0, 0]]), np.array([0.6, 0, 0.8]))
    >>> front.round(2).tolist()[2], bool(np.isnan(back[0, 0]))
    ([-0.8, 0.0, 0.6], True)
    """
    depth = curve @ eye
    with np.errstate(invalid="ignore"):
        at = np.flatnonzero(depth[:-1] * depth[1:] < 0)
    part = (depth[at] / (depth[at] - depth[at + 1]))[:, None]
    limb = curve[at] + part * (curve[at + 1] - curve[at])
    limb *= (np.linalg.norm(curve[at], axis=1) / np.linalg.norm(limb, axis=1))[:, None]
    points, depth = np.insert(curve, at + 1, limb, axis=0), np.insert(depth, at + 1, 0.0)
    return np.where((depth >= 0)[:, None], points, np.nan), np.where((depth <= 0)[:, None], points, np.nan)


def refined(place: Callable[[Array], Array], t: Array, found: Array, step: float, rounds: int) -> Array:
    """Places at values t, with those halfway where two are further apart than a step, as often as that."""
    for _ in range(rounds):
        wide = np.flatnonzero(np.linalg.norm(np.diff(found, axis=0), axis=1) > step)
        if not len(wide):
            break
        middle = (t[wide] + t[wide + 1]) / 2
        found, t = np.insert(found, wide + 1, place(middle), axis=0), np.insert(t, wide + 1, middle)
    return found


def curve_on(ax: Any, curve: Array, eye: Array, **style: Any) -> None:
    """A curve on the sphere, its hidden part faded."""
    front, back = parted(curve, eye)
    given = {"solid_capstyle": "round", **style}
    ax.plot(*back.T, **{**given, "alpha": FADED, "zorder": 1})
    ax.plot(*front.T, **{"zorder": 2, **given})


def dots_on(ax: Any, points: Array, eye: Array, **style: Any) -> None:
    """Markers on the sphere, the hidden ones faded."""
    seen = points @ eye >= -1e-9
    for some, look in ((points[~seen], {"alpha": FADED, "zorder": 1}), (points[seen], {"zorder": 4})):
        if len(some):
            ax.plot(*some.T, **{**style, **look})


def numbers_on(ax: Any, points: Sequence[tuple[int, Array]], eye: Array, radius: float = 1.0,
               ways: Sequence[Array] | None = None, others: Sequence[Array] = ()) -> None:
    """Write its number beside each point of a sphere, where no mark and no other number is; hidden are faded.

    A way is the direction from the point to its number, if there is room; None: beside the axis through the
    point. Others are marks without a number.
    """
    halo = optional("matplotlib.patheffects", "plot").withStroke(linewidth=2, foreground=BACKGROUND)
    sight = np.stack([(right := np.cross((0, 0, 1), eye) / np.hypot(*eye[:2])), np.cross(eye, right)])
    taken = [(sight @ point / radius, np.full(2, DOT)) for point in [*(p for _, p in points), *others]]
    for (number, point), way in zip(points, ways or [_aside(point, eye) for _, point in points]):
        hidden = point @ eye < -1e-9
        if np.linalg.norm(way - way @ eye * eye) < 0.6:    # seen end on, the number would be on the point
            way = _aside(point, eye)
        extent = DIGIT * np.array([len(str(number)), 1.4])
        start = np.arctan2(*(sight @ way)[::-1])
        spots = [sight @ point / radius + (OFF + extent - extent[1]) * (np.cos(turn), np.sin(turn))
                 for turn in start + TURNS]
        room = [min(np.max(abs(spot - place) / (extent + half)) for place, half in taken) for spot in spots]
        best = next((n for n, x in enumerate(room) if x >= 1), int(np.argmax(room)))
        taken.append((spots[best], extent))
        place = point + (spots[best] * radius - sight @ point) @ sight
        ax.text(*place, str(number), ha="center", va="center", fontsize=NUMBERS, zorder=5,
                path_effects=[] if hidden else [halo], alpha=0.5 if hidden else 1)


def _aside(point: Array, eye: Array) -> Array:
    """A direction in sight that is rather across than along that from the middle to a point."""
    seen = point - point @ eye * eye
    if np.linalg.norm(seen) < 1e-6 * np.linalg.norm(point):           # the eye looks along it
        seen = across(eye)[0]
    outwards = seen / np.linalg.norm(seen)
    return (outwards + 2 * np.cross(eye, outwards)) / np.sqrt(5)


def curves_of(ax: Any, curves: Sequence[Array], style: dict[str, Any], name: str,
              eye: Array | None = None) -> list[Any]:
    """Curves of one look, in a plane or on the sphere; what stands in the legend for them, if anything."""
    for curve in curves:
        if eye is None:
            ax.plot(*curve.T, **style)
        else:
            curve_on(ax, curve, eye, **style)
    return [named(style, name)] if len(curves) else []


def dots_of(ax: Any, points: Sequence[Any], style: dict[str, Any], name: str, eye: Array | None = None,
            **more: Any) -> list[Any]:
    """The same of markers; more is for those in a plane."""
    if not len(points):
        return []
    if eye is None:
        ax.plot(*np.array(points).T, zorder=4, **style, **more)
    else:
        dots_on(ax, np.array(points), eye, **style)
    return [named(style, name)]
