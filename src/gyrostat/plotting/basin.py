"""Fills the part of the unit sphere round a point on which a function is negative, with polygons."""
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..algebra.enclosures.floats import Array
from .globe import across

CELLS, HALVINGS = 40, 45                                   # on an edge of the cube; of a cut
SAMPLES = np.linspace(0, 1, 9)                             # along an edge of a cell
NECK = 1e-3                                                # below it a neck at the height 0 is closed


@dataclass(frozen=True)
class Filled:
    """A part of the sphere.

    Parameters
    ----------
    faces : list of array, shape (3 or 4, 3)
        polygons with their vertices on the sphere
    rim : array, shape (n, 3)
        the pieces of its boundary, NaN between them
    """

    faces: list[Array]
    rim: Array


class Basin:
    """The points at which a function is negative, as far as they are joined to a start.

    Parameters
    ----------
    height : callable
        of unit vectors, shape (..., 3); at the start about −1
    start : array, shape (3,)
    """

    def __init__(self, height: Callable[[Array], Array], start: Array) -> None:
        self.height = height
        self.points, self.cells = _grid()
        self.triangles = np.concatenate([self.cells[:, [0, 1, 2]], self.cells[:, [0, 2, 3]]])
        pairs = np.concatenate([self.triangles[:, [a, b]] for a, b in ((0, 1), (1, 2), (2, 0))])
        self.edges = np.unique(np.sort(pairs, axis=1), axis=0)
        self.values = height(self.points)
        self.edges = self.edges[(self.values[self.edges] < 0).all(axis=1)]
        a, b = (self.points[self.edges[:, n], None] for n in (0, 1))
        self.highest = height(_unit(a + SAMPLES[:, None] * (b - a))).max(axis=1)
        self.inside = self._joined(start)

    def _joined(self, start: Array) -> Array:
        """Which points are in it: those well below 0 that are joined, then those a little below 0."""
        reached = np.zeros(len(self.points), dtype=bool)
        reached[np.argmax(np.where(self.values < -NECK, self.points @ start, -2))] = True
        for limit in (-NECK, 0.0):
            ways = self.edges[self.highest < limit]
            while True:
                more = ways[reached[ways].any(axis=1)]
                if reached[more].all():
                    break
                reached[more] = True
                if limit == 0:                             # one step, as a neck may be narrower than a cell
                    break
        return reached

    def below(self, level: float = 0.0) -> Filled:
        """Return the part of it that is below a level, of at most 0."""
        inside = self.inside & (self.values < level)
        whole = inside[self.cells].all(axis=1)
        faces = list(self.points[self.cells[whole]])
        count = inside[self.triangles].sum(axis=1)
        alone = ~np.tile(whole, 2)
        faces += list(self.points[self.triangles[(count == 3) & alone]])
        cut = self.triangles[(count > 0) & (count < 3)]
        odd = inside[cut] == (inside[cut].sum(axis=1) == 1)[:, None]     # the corner that is alone
        turned = np.take_along_axis(cut, (np.argmax(odd, axis=1)[:, None] + np.arange(3)) % 3, axis=1)
        tip, left, right = turned.T
        ends = [self._crossing(tip, other, inside, level) for other in (left, right)]
        for n, one in enumerate(inside[tip]):
            first, second = ends[0][n], ends[1][n]
            faces.append(np.array([self.points[tip[n]], first, second] if one else
                                  [first, self.points[left[n]], self.points[right[n]], second]))
        gap = np.full_like(ends[0], np.nan)
        return Filled(faces, np.stack([*ends, gap], axis=1).reshape(-1, 3))

    def _crossing(self, one: Array, other: Array, inside: Array, level: float) -> Array:
        """The last points below the level on the ways from a point inside to one that is not."""
        swap = inside[other]
        a, b = (self.points[np.where(swap, x, y)] for x, y in ((other, one), (one, other)))
        over = self.height(_unit(a[:, None] + SAMPLES[:, None] * (b - a)[:, None])) - level
        first = np.where((over >= 0).any(axis=1), np.argmax(over >= 0, axis=1), np.argmax(over, axis=1))
        low, high = SAMPLES[np.maximum(first - 1, 0)], SAMPLES[first]
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            up = self.height(_unit(a + middle[:, None] * (b - a))) >= level
            low, high = np.where(up, low, middle), np.where(up, middle, high)
        return _unit(a + low[:, None] * (b - a))


def _grid() -> tuple[Array, Array]:
    """The points of a grid on a cube, drawn onto the sphere, and the four corners of each cell."""
    tangent = np.tan(np.linspace(-np.pi / 4, np.pi / 4, CELLS + 1))
    x, y = np.meshgrid(tangent, tangent)
    faces = [axis + x[..., None] * first + y[..., None] * second
             for axis in (*np.eye(3), *-np.eye(3)) for first, second in [across(axis)]]
    points = _unit(np.stack(faces)).reshape(-1, 3)
    number = np.arange(len(points)).reshape(6, CELLS + 1, CELLS + 1)
    corners = [number[:, i:i + CELLS, j:j + CELLS] for i, j in ((0, 0), (0, 1), (1, 1), (1, 0))]
    _, first, same = np.unique(points.round(9) + 0.0, axis=0, return_index=True, return_inverse=True)
    return points[first], same.reshape(-1)[np.stack(corners, axis=-1).reshape(-1, 4)]


def _unit(vectors: Array) -> Array:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
