"""Makes a solid that stands for a body: a top, or a box with the moments of inertia of the body."""
import numpy as np
from sympy import Add

from ..algebra.enclosures.floats import Array
from ..algebra.reals.exact import sign_of_constant
from ..mechanics.scenes.body import Gyrostat
from ..mechanics.scenes.system import System
from .energy_levels import floats

SIDES = 24                                                 # of the top
LIGHT, MIDDLE, DEEP, ACCENT = "#dce9f4", "#a9c6e0", "#5f93c2", "#e0b04c"

Face = tuple[Array, str]


def solid(scene: System) -> list[Face]:
    """Faces in body axes, each a polygon of shape (n, 3) and its colour, inside the unit sphere.

    A body of revolution in a field is a top on its tip, anything else the box of constant density that has
    its moments of inertia; where no rigid body has them, three bars along the axes.
    """
    if scene.potential is not None and scene.body.is_of_revolution():
        return _top()
    return _box(scene.body) if rigid(scene.body) else _bars()


def rigid(body: Gyrostat) -> bool:
    """Whether a rigid body has the moments: none exceeds the sum of the others."""
    return all(sign_of_constant(Add(*body.moments) - 2 * moment) != -1 for moment in body.moments)


def _top() -> list[Face]:
    """A cone and a dome, in sectors of two colours that show the spin, and a stem."""
    turn = np.linspace(0, 2 * np.pi, SIDES + 1)
    rings = [np.stack([r * np.cos(turn), r * np.sin(turn), np.full(SIDES + 1, z)], axis=1)
             for r, z in ((0.0, 0.0), (0.42, 0.52), (0.36, 0.66), (0.05, 0.72), (0.05, 0.98), (0.0, 0.98))]
    return [(np.stack([low[n], low[n + 1], high[n + 1], high[n]]), (MIDDLE, DEEP)[n * 6 // SIDES % 2])
            for low, high in zip(rings, rings[1:]) for n in range(SIDES)]


def _box(body: Gyrostat) -> list[Face]:
    """Edges with b² + c² proportional to I1, and so on.

    A plate has none across, and is drawn with a thin one. One face stands out.
    """
    inertia = floats(body.moments)
    edges = np.sqrt(np.maximum(inertia.sum() / 2 - inertia, 0.004 * inertia.sum()))
    edges = 0.9 * edges / np.linalg.norm(edges)
    return [(corners * edges, ACCENT if (axis, side) == (2, 1) else (LIGHT, MIDDLE, DEEP)[axis])
            for axis, side, corners in _sides()]


def _bars() -> list[Face]:
    """A bar along each axis, the ends that are positive in a colour of their own."""
    faces = []
    for axis, color in enumerate((LIGHT, MIDDLE, DEEP)):
        edges = np.full(3, 0.06)
        edges[axis] = 0.9
        faces += [(corners * edges, ACCENT if (n, side) == (axis, 1) else color)
                  for n, side, corners in _sides()]
    return faces


def _sides() -> list[tuple[int, int, Array]]:
    """The six squares of a cube: axis, side and corners."""
    found = []
    for axis in range(3):
        for side in (1, -1):
            corners = np.zeros((4, 3))
            corners[:, axis] = side
            corners[:, axis - 1], corners[:, axis - 2] = (1, 1, -1, -1), (1, -1, -1, 1)
            found.append((axis, side, corners))
    return found
