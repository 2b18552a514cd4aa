"""Draws the amended potential on the sphere of directions: level curves, critical points, verdicts."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import Expr

from ..algebra.enclosures.floats import Array, in_floats
from ..arguments import checked
from ..equilibria.curves.amended_potential import CriticalPoint, amended_potential
from ..equilibria.doubles import nearest
from ..errors import optional
from ..mechanics.scenes.potential import DIRECTIONS
from ..mechanics.scenes.system import System
from ..stability.decision import Verdict
from .captions import BEHIND, headed
from .globe import across, circle, curves_of, dots_of, numbers_on, stage
from .headings import of_scene
from .looks import BLUE, DARK, axes_of, label, line, marker
from .scene_numbers import numbers_of

CURVES, CELLS = 14, 96                                     # levels; cells along an edge of the cube
# along a separatrix; its start, off the saddle; its longest length; for a difference; of levels, for the same
STEP, START, LONGEST, NEAR, SAME = 0.01, 1e-3, 60.0, 1e-5, 1e-9
ROUNDS, CLOSE = 30, 1e-15                                  # of Newton's method; of the values, when it ends
SHAPES = {"minimum": "v", "saddle": "D", "maximum": "^", "degenerate": "o"}


@checked
def draw_amended_potential(scene: System, values: Mapping[str, Any] | None = None, ax: Any = None,
                           **kwargs: Any) -> Any:
    """Draw U + (C1 − l·k)²/(2 k·Ik) on the sphere abs(k) = 1, seen as ax.view_init says.

    Along a level curve the amended potential is constant, and the curves through saddles are heavy. Marks are
    its critical points, the permanent rotations on that level of C1: triangles point down at minima and up at
    maxima, and diamonds are saddles. A filled mark is stable, an open one unstable, a half-filled one
    undecided. Its number is that in the list of relative_equilibria at C1, and in the table of gyrostat
    decide. What is behind is faded.

    Parameters
    ----------
    scene : System
        any body in a field, not of revolution in it
    values : mapping of name to number, or None
        rational, for every name of the scene, and C1
    ax : axes of mplot3d
        new ones where they are left out
    **kwargs : Any
        of the level curves: of Axes3D.plot

    Returns
    -------
    axes of mplot3d

    Raises
    ------
    ScopeError
        there is no field, the body is one of revolution in it, or not all rotations are found
    ValuesError
        C1 or another name is missing or unknown, or a number is not admissible
    ArgumentError
        the axes are flat
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Simo, Lewis & Marsden, Arch. Rational Mech. Anal. 115 (1991) 15-59.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), U)
    >>> sphere = Figure().add_subplot(projection="3d")
    >>> ax = gs.plotting.draw_amended_potential(scene, {"C1": 5}, sphere)
    >>> [text.get_text() for text in ax.get_legend().get_texts()][:3]
    ['level curve', 'through a saddle', 'minimum, stable']
    """
    amended = amended_potential(scene)
    points = amended.critical_points(values or {})
    potential = _Field.of(amended.expression, numbers_of(scene, values or {}, ("C1",)))
    ax = axes_of(ax, three=True)
    eye = stage(ax, 1.0, [label(f"k{n}") for n in (1, 2, 3)])
    style = {"color": BLUE, "linewidth": 0.7, **kwargs}
    handles = curves_of(ax, _level_curves(potential), style, "level curve", eye)
    heavy = {"color": DARK, "linewidth": 1.8}
    saddles = [point for point in points if point.kind == "saddle" and not point.rotation.locus]
    through = _separatrices(potential, np.array([_place(point) for point in saddles]))
    handles += curves_of(ax, through, heavy, "through a saddle", eye)
    numbers_on(ax, [(n, _place(point)) for n, point in enumerate(points, 1)], eye)
    headed(ax, "Amended potential on the sphere of directions", of_scene(scene, values or {}),
           [*handles, *_marked(ax, points, eye)], after=BEHIND)
    return ax


def _marked(ax: Any, points: Sequence[CriticalPoint], eye: Array) -> list[Any]:
    """Draw the critical points by kind and verdict; what stands in the legend for them."""
    handles: list[Any] = []
    for point in points:
        if point.rotation.locus:
            verdict = point.rotation.decision.verdict
            what = "circle" if point.rotation.form.curve is None else "curve"
            handles += curves_of(ax, _continuum(point), line(verdict), f"{what}, {verdict.name.lower()}", eye)
    for kind, shape in SHAPES.items():
        for verdict in Verdict:
            places = [_place(point) for point in points if point.kind == kind
                      and not point.rotation.locus and point.rotation.decision.verdict is verdict]
            handles += dots_of(ax, places, {**marker(verdict), "marker": shape},
                               f"{kind}, {verdict.name.lower()}", eye)
    return handles


def _continuum(point: CriticalPoint) -> list[Array]:
    """The circle on which a critical point lies, or the pieces of another curve."""
    if point.rotation.form.curve is not None:
        return _level_curves(_Field.of(point.rotation.form.curve, {}), np.zeros(1))
    k, axis = _place(point), np.array([float(x) for x in point.rotation.form.circle or ()])
    axis = axis / np.linalg.norm(axis)
    return [circle(axis, float(np.linalg.norm(np.cross(k, axis))), float(k @ axis))]


def _place(point: CriticalPoint) -> Array:
    return np.array(nearest(point.rotation.directions[0]))


@dataclass(frozen=True)
class _Field:
    """U_c at numbers and its gradient, in floats."""

    expression: Expr
    slopes: tuple[Expr, ...]

    @classmethod
    def of(cls, expression: Expr, numbers: Mapping[Any, Expr]) -> "_Field":
        placed = expression.xreplace(dict(numbers))
        return cls(placed, tuple(placed.diff(k) for k in DIRECTIONS))

    def value(self, k: Array) -> Array:
        return self._at(self.expression, k)

    def slope(self, k: Array) -> Array:
        """Along the sphere."""
        full = np.stack([self._at(x, k) for x in self.slopes], axis=-1)
        return full - (full * k).sum(axis=-1, keepdims=True) * k

    def _at(self, expression: Expr, k: Array) -> Array:
        found = in_floats(expression, np, {x: k[..., n] for n, x in enumerate(DIRECTIONS)})
        return np.broadcast_to(found, k.shape[:-1])

    def onto(self, k: Array, level: Array) -> Array:
        """Points next to their levels moved along the gradient; where it vanishes they stay."""
        for _ in range(ROUNDS):
            excess = (level - self.value(k))[..., None]
            if np.abs(excess).max() <= CLOSE * np.abs(level).max():
                break
            slope = self.slope(k)
            square = (slope**2).sum(axis=-1, keepdims=True)
            step = np.divide(excess * slope, square, out=np.zeros_like(k), where=square > 0)
            k = _unit(k + step / np.maximum(1, np.linalg.norm(step, axis=-1, keepdims=True) / STEP))
        return k


def _level_curves(potential: _Field, levels: Array | None = None) -> list[Array]:
    """Curves of levels, in pieces, each on a face of a cube.

    Default: levels that divide the sphere into equal areas.
    """
    tangent = np.tan(np.linspace(-np.pi / 4, np.pi / 4, CELLS + 1))
    x, y = np.meshgrid(tangent, tangent)
    faces = []
    for axis in (*np.eye(3), *-np.eye(3)):
        first, second = across(axis)
        k = axis + x[..., None] * first + y[..., None] * second
        faces.append((axis, first, second, _unit(k)))
    heights = [potential.value(k) for *_, k in faces]
    if levels is None:
        levels = np.quantile(heights, (np.arange(CURVES) + 0.5) / CURVES)
    found = []
    for (axis, first, second, _), height in zip(faces, heights):
        lines = optional("contourpy", "plot").contour_generator(x, y, height)
        for level in levels:
            for flat in lines.lines(level):
                k = axis + flat[:, :1] * first + flat[:, 1:] * second
                found.append(potential.onto(_unit(k), level))
    return found


def _separatrices(potential: _Field, saddles: Array) -> list[Array]:
    """The level curves through saddles, each from one saddle to one of the same level."""
    if not len(saddles):
        return []
    first = np.repeat(saddles, 2, axis=0)
    ways = np.concatenate([_ways_out(potential, saddle) for saddle in saddles])
    heights = potential.value(saddles)
    levels = np.repeat(heights, 2)
    ends = np.abs(heights - levels[:, None]) < SAME * np.abs(heights).max()
    k = potential.onto(_unit(first + START * ways), levels)
    curves = [[saddle, start] for saddle, start in zip(first, k)]
    open_ends = np.arange(len(k))
    for n in range(int(LONGEST / STEP)):
        half = _unit(k + STEP / 2 * _ahead(potential, k))
        k = potential.onto(_unit(k + STEP * _ahead(potential, half)), levels[open_ends])
        off = np.linalg.norm(k[:, None] - saddles, axis=2)
        off[~ends[open_ends]] = np.inf
        here = (off.min(axis=1) < STEP) & (n > 2)
        for curve, at, ended, saddle in zip(open_ends, k, here, off.argmin(axis=1)):
            curves[curve].append(saddles[saddle] if ended else at)
        k, open_ends = k[~here], open_ends[~here]
        if not len(k):
            break
    return [np.array(curve) for curve in curves]


def _ahead(potential: _Field, k: Array) -> Array:
    """Unit vectors along the level curves."""
    return _unit(np.cross(k, potential.slope(k)))


def _unit(vectors: Array) -> Array:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.divide(vectors, length, out=np.zeros_like(vectors), where=length > 0)


def _ways_out(potential: _Field, saddle: Array) -> Array:
    """The two directions in which k' = k × ∇U_c leaves a saddle."""
    first, second = across(saddle)
    plane = np.array([first, second])
    bend = np.array([potential.slope(_unit(saddle + NEAR * e)) - potential.slope(_unit(saddle - NEAR * e))
                     for e in plane]) @ plane.T
    rates, ways = np.linalg.eig(np.array([[0, -1], [1, 0]]) @ (bend + bend.T))
    out = ways[:, np.argmax(rates.real)].real @ plane
    return np.array([out, -out])
