"""Draws the cones on which the angular velocity of a free body of revolution moves.

The body cone, which is fixed in the body, rolls on the space cone, which is fixed in space.
"""
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array, row
from ..arguments import checked
from ..errors import ScopeError
from ..mechanics.classical.free_precession import free_precession
from .captions import headed
from .globe import across, arrow, circle, polygons, towards
from .headings import number, numbers
from .looks import BLUE, INK, LOOKS, axes_of, label


@dataclass(frozen=True)
class Cone:
    """A right circular cone with its tip at the origin.

    Parameters
    ----------
    axis : array, shape (3,)
        unit vector
    angle : float
        half-angle
    """

    axis: Array
    angle: float

    def rim(self) -> Array:
        """Return the end points of its generators of length 1, shape (121, 3)."""
        return circle(self.axis, np.sin(self.angle), np.cos(self.angle), 121)

    def outline(self, eye: Array) -> Array:
        """Return the end points of the generators that are its outline, as it is seen, shape (2 or 0, 3)."""
        first, second = across(self.axis)
        along, x, y = self.axis @ eye, first @ eye, second @ eye
        steep, aside = np.tan(self.angle) * along, np.hypot(x, y)
        if abs(steep) >= aside:
            return np.empty((0, 3))
        turn = np.arctan2(y, x) + np.array([1, -1]) * np.arccos(steep / aside)
        edge = np.cos(turn)[:, None] * first + np.sin(turn)[:, None] * second
        return np.cos(self.angle) * self.axis + np.sin(self.angle) * edge


def cones(inertia: Sequence[Any], transverse: Any, axial: Any) -> tuple[Cone, Cone, dict[str, Array]]:
    """The space cone about M, the body cone about e3, and the unit vectors M, omega, e3, in one plane, M
    upwards.

    Parameters
    ----------
    inertia, transverse, axial
        as in gyrostat.mechanics.free_precession

    Examples
    --------
    >>> space, body, vectors = cones((2, 1), 1, 1)
    >>> bool(np.isclose(space.angle + body.angle,
    ...                 np.arccos(vectors["M"] @ vectors["e3"])))      # the body cone rolls outside
    True
    """
    motion = free_precession(inertia, transverse, axial)
    if transverse == 0 or motion.space_cone == 0:
        raise ScopeError(f"inertia = {tuple(inertia)}, transverse = {transverse}, axial = {axial}: ω lies "
                         "along M, there is no space cone; "
                         "give two different moments, and two rates that are not 0")
    tilt, space, body = row([motion.tilt, motion.space_cone, motion.body_cone], "the angles").tolist()
    side = 1 if space + body < tilt + 1e-9 else -1         # ω between M and e3, or beyond M
    vectors = {"M": np.array([0.0, 0.0, 1.0]), "omega": _tilted(side * space), "e3": _tilted(tilt)}
    return Cone(vectors["M"], space), Cone(vectors["e3"], body), vectors


def _tilted(angle: float) -> Array:
    return np.array([0.0, np.sin(angle), np.cos(angle)])


@checked
def draw_cones(inertia: Sequence[Any], transverse: Any, axial: Any, ax: Any = None, **kwargs: Any) -> Any:
    r"""Draw the cones of a free body of revolution, seen as ax.view_init says.

    The body cone rolls on the space cone, and they touch along ω. The body cone lies outside if I1 > I3, and
    around the space cone if I1 < I3.

    Parameters
    ----------
    inertia : (I1, I3)
        transverse and axial moment [M L²]
    transverse, axial : number
        √(ω1² + ω2²) and ω3 [1/T]
    ax : axes of mplot3d
        new ones where they are left out
    **kwargs : Any
        of the surfaces: of Poly3DCollection

    Returns
    -------
    axes of mplot3d

    Raises
    ------
    BodyError
        there are not two moments, or one is not positive
    ScopeError
        ω lies along M
    ArgumentError
        the axes are flat
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Taylor, Classical Mechanics (2005), §10.8; Landau & Lifshitz, Mechanics, §33.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> space = Figure().add_subplot(projection="3d")
    >>> ax = gs.plotting.draw_cones((2, 1), 1, 2, ax=space)
    >>> [text.get_text() for text in ax.texts]
    ['$M$', '$\\omega$', '$e_{3}$']
    """
    space, body, vectors = cones(inertia, transverse, axial)
    ax = axes_of(ax, three=True)
    from matplotlib.patches import Patch
    ax.set_proj_type("ortho")
    ax.computed_zorder = False
    ax.set_axis_off()
    eye, handles = towards(ax), []
    for cone, name, face, edge in ((space, "space cone", LOOKS["undecided"][0], INK["undecided"]),
                                   (body, "body cone", "#c9ddef", BLUE)):
        rim = cone.rim()
        wedges = [np.stack([np.zeros(3), a, b]) for a, b in zip(rim, rim[1:])]
        polygons(ax, wedges, **{"facecolor": face, "edgecolor": "none", "alpha": 0.55, "zorder": 1, **kwargs})
        ax.plot(*rim.T, color=edge, linewidth=1.2, zorder=2)
        for end in cone.outline(eye):
            ax.plot(*np.outer(end, (0, 1)), color=edge, linewidth=1.2, zorder=2)
        handles.append(Patch(facecolor=face, edgecolor=edge, label=name))
    for name, vector in vectors.items():
        length = 1.3 if name != "omega" else 1.15
        arrow(ax, vector, length, eye, linewidth=1.5, zorder=3)
        ax.text(*(vector * (length + 0.1)), label(name), ha="center", va="center", zorder=4)
    points = np.concatenate([space.rim(), body.rim(), np.zeros((1, 3)),
                             *([1.3 * v] for v in vectors.values())])
    low, high = points.min(axis=0), points.max(axis=0)
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set_box_aspect(high - low, zoom=1.2)
    rates = [rf"$\omega_\perp = {number(transverse)}$", rf"$\omega_3 = {number(axial)}$"]
    headed(ax, "Cones on which the angular velocity of a free body of revolution moves",
           ([], [*numbers(dict(zip(("I1", "I3"), inertia))), *rates]), handles)
    return ax
