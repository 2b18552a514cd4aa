"""What a body looks like: a top, or a box with the moments of inertia of the body."""
import numpy as np

from ..body import Gyrostat
from ..grids import Array
from ..system import System
from .levels import floats

SIDES = 24                                                 # of the top
LIGHT, MIDDLE, DEEP, ACCENT = "#dce9f4", "#a9c6e0", "#5f93c2", "#e0b04c"

Face = tuple[Array, str]


def solid(scene: System) -> list[Face]:
    """Faces in body axes, each a polygon of shape (n, 3) and its colour, inside the unit sphere.

    A body of revolution in a field is a top on its tip, anything else the box of constant density that has its moments of inertia.
    """
    return _top() if scene.potential is not None and scene.body.is_of_revolution() else _box(scene.body)


def _top() -> list[Face]:
    """A cone and a dome, in sectors of two colours that show the spin, and a stem."""
    turn = np.linspace(0, 2 * np.pi, SIDES + 1)
    rings = [np.stack([r * np.cos(turn), r * np.sin(turn), np.full(SIDES + 1, z)], axis=1)
             for r, z in ((0.0, 0.0), (0.42, 0.52), (0.36, 0.66), (0.05, 0.72), (0.05, 0.98), (0.0, 0.98))]
    return [(np.stack([low[n], low[n + 1], high[n + 1], high[n]]), (MIDDLE, DEEP)[n * 6 // SIDES % 2])
            for low, high in zip(rings, rings[1:]) for n in range(SIDES)]


def _box(body: Gyrostat) -> list[Face]:
    """Edges with b² + c² proportional to I1, and so on; flat where the moments break the triangle inequality. One face stands out."""
    inertia = floats(body.inertia)
    edges = np.sqrt(np.maximum(inertia.sum() / 2 - inertia, 0.004 * inertia.sum()))
    edges = 0.9 * edges / np.linalg.norm(edges)
    faces = []
    for axis, color in enumerate((LIGHT, MIDDLE, DEEP)):
        for side in (1, -1):
            corners = np.zeros((4, 3))
            corners[:, axis] = side
            corners[:, axis - 1], corners[:, axis - 2] = (1, 1, -1, -1), (1, -1, -1, 1)
            faces.append((corners * edges, ACCENT if (axis, side) == (2, 1) else color))
    return faces
