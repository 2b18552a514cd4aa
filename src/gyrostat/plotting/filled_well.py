"""Draws the well of a stable motion, filled up to its lowest pass."""
import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array
from ..arguments import checked
from ..equilibria.doubles import nearest
from ..equilibria.relative_equilibrium import RelativeEquilibrium
from ..equilibria.wells.well import Well
from ..errors import ScopeError, optional
from ..mechanics.scenes.kind import Kind
from ..stability.decision import Verdict
from .basin import Basin
from .captions import BEHIND, headed
from .globe import curve_on, dots_of, polygons, stage
from .looks import BLUE, INK, axes_of, label, marker
from .well_of_tilts import WATER, four, said, tilts

BLUES, SAND = (WATER, "#e4edf6", BLUE), ("#f4dfb6", "#f9efda", INK["undecided"])   # near, behind, rim
DEPTHS = (-0.25, -0.5, -0.75)                              # of the inner curves, in barriers
OPEN = marker(Verdict.UNSTABLE)
TURNS, AROUND = (np.linspace(0, 2 * np.pi, n, endpoint=False) for n in (5, 16))
NEWTON = 5
LOWEST, STEEPEST, ASIDE = 26, 45, 20                       # of a view; it is no symmetric one [°]


@checked
def draw_well(rotation: RelativeEquilibrium, ax: Any = None, **kwargs: Any) -> Any:
    """Draw the well of a stable motion, filled up to its lowest pass.

    Of a body in a field the vertical k stays in the filled part of the sphere, seen from the body, at every
    energy below that of the pass; of a free body M does, of a satellite the vertical r and the normal n of
    the orbit. Inner curves are where a quarter, a half and three quarters of the barrier are left. Of a body
    of revolution the effective potential is drawn over k3, its tilt. A triangle that points down is a
    minimum, one that points up a maximum, and a diamond is a saddle. What is behind is faded.

    Parameters
    ----------
    rotation : RelativeEquilibrium
        of relative_equilibria, stable by the energy
    ax : axes of mplot3d; of a body of revolution matplotlib Axes
        new ones where they are left out, which face the well
    **kwargs : Any
        of the filled parts: of Poly3DCollection; of a body of revolution of the curve: of Axes.plot

    Returns
    -------
    axes of mplot3d; of a body of revolution matplotlib Axes

    Raises
    ------
    ScopeError
        it has no well, or no barrier is known
    ArgumentError
        the axes are flat, or should be
    MissingExtraError
        pip install "gyrostat[plot]"

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), U)
    >>> rotation = gs.relative_equilibria(scene, {"C1": "5/2"})[0]
    >>> ax = gs.plotting.draw_well(rotation, Figure().add_subplot(projection="3d"))
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['well', 'minimum', 'pass']
    """
    found: Well = rotation.well
    if found.barrier_double is None:
        raise ScopeError(f"there is no well to draw: {found.reason}")
    if found.line is not None:
        return tilts(found, ax, kwargs)
    new, ax = ax is None, axes_of(ax, three=True)
    if new:
        ax.view_init(*facing(rotation))
    drawn = _attitudes if rotation.scene.kind is Kind.ORBIT else _on_sphere
    return drawn(found, ax, kwargs)


def facing(rotation: RelativeEquilibrium) -> tuple[float, float]:
    """Return elevation and azimuth [°] from which a motion is seen, and its first pass, if there is room."""
    directions = [v for e in (rotation, rotation, *rotation.well.passes[:1]) for v in _places(e)]
    x, y, z = np.sum(directions, axis=0)
    up = math.degrees(math.atan2(z, math.hypot(x, y)))
    return math.copysign(min(max(abs(up), LOWEST), STEEPEST), up), math.degrees(math.atan2(y, x)) + ASIDE


def _on_sphere(found: Well, ax: Any, given: Mapping[str, Any]) -> Any:
    """The well of k on its sphere, or of M."""
    assert found.paths is not None
    rotation, free = found.rotation, found.rotation.scene.kind is Kind.FREE
    M = np.array(nearest(rotation.momentum))
    radius = float(np.linalg.norm(M)) if free else 1.0

    [here], letter = _places(rotation), "M" if free else "k"
    eye = stage(ax, radius, [label(f"{letter}{n}") for n in (1, 2, 3)])
    basin = Basin(_height(found, found.paths.landscape.floats, here), here)
    handles = _water(ax, basin, eye, radius, BLUES, "well", given)
    handles += _marks(ax, found, eye, radius)
    level = f"$|M| = {four(radius)}$" if free else f"{label('C1')[:-1]} = {four(float(M @ here))}$"
    headed(ax, "Well of the energy on the momentum sphere" if free else
           "Well of the amended potential on the sphere of the vertical", said(found, [level]), handles,
           after=BEHIND)
    return ax


def _attitudes(found: Well, ax: Any, given: Mapping[str, Any]) -> Any:
    """Where the vertical may go at all, and where the normal of the orbit may, in the body."""
    assert found.paths is not None
    land, rotation = found.paths.landscape, found.rotation
    n, r = _places(rotation)
    eye, handles = stage(ax, 1.0, [label(f"e{i}") for i in (1, 2, 3)]), []
    for start, look, name, V in (
            (n, SAND, "normal of the orbit", lambda x, y: land.of_directions(_parts(x, y))),
            (r, BLUES, "vertical", lambda x, y: land.of_directions(_parts(y, x)))):
        basin = Basin(_height(found, partial(_least, V), start), start)
        handles += _water(ax, basin, eye, 1.0, look, name, given)
    handles += _marks(ax, found, eye)
    headed(ax, "Where the vertical and the normal of the orbit stay in the body", said(found, []), handles,
           after=BEHIND)
    return ax


def _height(found: Well, V: Callable[[Array], Array], here: Array) -> Callable[[Array], Array]:
    """V in barriers, above the pass: −1 at the minimum and 0 at the pass."""
    bottom, barrier = float(V(here)), found.barrier_double
    assert barrier is not None
    return lambda x: (V(x) - bottom) / barrier - 1


def _parts(n: Array, r: Array) -> list[Array]:
    return [v[..., i] for v in (n, r) for i in range(3)]


def _least(V: Callable[[Array, Array], Array], x: Array) -> Array:
    """The least V(x, y) over the unit vectors y across x, for V of degree 2 in y."""
    aside = np.eye(3)[np.argmin(np.abs(x), axis=-1)]
    first = np.cross(aside, x)
    first = first / np.linalg.norm(first, axis=-1, keepdims=True)
    second = np.cross(x, first)
    y = np.cos(TURNS)[:, None] * first[..., None, :] + np.sin(TURNS)[:, None] * second[..., None, :]
    values = V(np.broadcast_to(x[..., None, :], y.shape), y)             # waves of degree 2 at most
    waves, mean = np.fft.rfft(values, axis=-1)[..., 1:] / len(TURNS) * 2, values.mean(axis=-1)
    sampled = (waves @ np.exp(1j * np.outer((1, 2), AROUND))).real
    least = (sampled <= np.roll(sampled, 1, axis=-1)) & (sampled <= np.roll(sampled, -1, axis=-1))
    lowest = np.argsort(np.where(least, sampled, np.inf), axis=-1)[..., :2]       # it has two minima at most
    turn, waves, order = AROUND[lowest], waves[..., None, :], np.array([1, 2])
    for _ in range(NEWTON):
        phase = waves * np.exp(1j * order * turn[..., None])
        slope, bend = (-(phase.imag * order).sum(axis=-1), -(phase.real * order**2).sum(axis=-1))
        turn = turn - np.divide(slope, bend, out=np.zeros_like(slope), where=bend > 0)
    found: Array = mean + (waves * np.exp(1j * order * turn[..., None])).real.sum(axis=-1).min(axis=-1)
    return found


def _water(ax: Any, basin: Basin, eye: Array, radius: float, look: Sequence[str], name: str,
           given: Mapping[str, Any]) -> list[Any]:
    """The filled part, its rim and the curves inside; what stands in the legend for it."""
    near, behind, ink = look
    whole = basin.below()
    seen = np.array([face.mean(axis=0) @ eye >= 0 for face in whole.faces])
    for part, colour, order in ((~seen, behind, 0.5), (seen, near, 0.7)):
        if part.any():
            faces = [radius * face for face, here in zip(whole.faces, part) if here]
            polygons(ax, faces, **{"facecolor": colour, "edgecolor": colour, "linewidth": 0.4,
                                   "zorder": order, **given})
    for depth in DEPTHS:
        curve_on(ax, radius * basin.below(depth).rim, eye, color=ink, linewidth=0.6)
    curve_on(ax, radius * whole.rim, eye, color=ink, linewidth=1.6)
    return [optional("matplotlib.patches", "plot").Patch(facecolor=near, edgecolor=ink, label=name)]


def _places(e: RelativeEquilibrium) -> list[Array]:
    """The direction of k or of M; of a satellite those of n and r."""
    if e.directions:
        return [np.array(nearest(v)) for v in e.directions]
    M = np.array(nearest(e.momentum))
    return [M / np.linalg.norm(M)]


def _marks(ax: Any, found: Well, eye: Array, radius: float = 1.0) -> list[Any]:
    """The motion and the passes of its well."""
    def places(*some: RelativeEquilibrium) -> list[Array]:
        return [radius * x for e in some for x in _places(e)]

    top = found.rotation.scene.kind is Kind.FREE and found.rotation.form.index
    handles = dots_of(ax, places(found.rotation), {**marker(Verdict.STABLE), "marker": "^" if top else "v"},
                      "maximum" if top else "minimum", eye)
    for shape in dict.fromkeys(map(_shape, found.passes)):
        some = [e for e in found.passes if _shape(e) == shape]
        handles += dots_of(ax, places(*some), {**OPEN, "marker": shape}, "pass", eye)
    return handles


def _shape(e: RelativeEquilibrium) -> str:
    return "D" if e.form.index == 1 else "v" if e.form.index == 0 else "^"
