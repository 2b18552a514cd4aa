"""Draws the well of a body of revolution, whose tilt alone moves, and says of what a well is."""
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array, in_floats
from ..equilibria.wells.tilts import TiltWell
from ..equilibria.wells.well import Well
from ..errors import ArgumentError
from ..mechanics.equilibrium.reduction import K3
from ..printing.formats.latex import tex
from ..printing.formats.latex_names import Names
from ..stability.decision import Verdict
from .captions import headed
from .globe import dots_of
from .headings import number, of_scene
from .looks import DARK, GREY, axes_of, axis, marker

WATER = "#c9ddef"
TILTS, HALVINGS = 801, 60
PASSES = {"well": "pass", "shelf": "pass, a shelf", "summit": "pass, at a pole"}


def tilts(found: Well, ax: Any, given: Mapping[str, Any]) -> Any:
    """V over k3, filled up to its pass."""
    line, barrier = found.line, found.barrier_double
    assert line is not None and barrier is not None
    ax = axes_of(ax)
    if ax.name == "3d":
        raise ArgumentError("the axes are a view of space, and the tilt alone moves: give flat axes")
    z0 = float(line.tilt)

    V0 = float(_potential(line, np.array(z0)))

    def rise(z: Array) -> Array:
        return _potential(line, z) - V0

    z = np.sort(np.append(-np.cos(np.linspace(1e-3, np.pi - 1e-3, TILTS)), z0))
    heights = rise(z)
    high = 2.2 * barrier if np.isfinite(barrier) else float(np.nanquantile(heights[heights > 0], 0.5))
    handles: list[Any] = []
    if np.isfinite(barrier):
        ends = [_end(lambda x: rise(x) - barrier, z0, side, [float(p.k3) for p in line.passes])
                for side in (-1, 1)]
        inside = np.linspace(ends[0], ends[1], TILTS)
        handles.append(ax.fill_between(inside, np.minimum(rise(inside), barrier), barrier, color=WATER,
                                       linewidth=0, zorder=0, label="well"))
        ax.axhline(barrier, color=GREY, linewidth=0.7, zorder=1)
    ax.plot(z, heights, **{"color": DARK, "linewidth": 1.6, **given})
    low = min(float(np.nanmin(heights)), 0.0)
    ax.set(xlim=(-1, 1), ylim=(max(low, -high) - 0.1 * high, high))
    handles += dots_of(ax, [(z0, 0.0)], {**marker(Verdict.STABLE), "marker": "v"}, "minimum", clip_on=False)
    for kind in dict.fromkeys(p.kind for p in line.passes):
        at = [(float(p.k3), barrier) for p in line.passes if p.kind == kind]
        handles += dots_of(ax, at, {**marker(Verdict.UNSTABLE), "marker": "^" if kind == "summit" else "D"},
                           PASSES[kind], clip_on=False)
    k3 = found.rotation.form.described[0][0]
    ax.set(xlabel=f"${tex(k3, Names())}$", ylabel=axis("V", (1, 2, 0)))
    headed(ax, "Well of the effective potential", said(found, []), handles, 3)
    return ax


def _potential(line: TiltWell, z: Array) -> Array:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.broadcast_to(in_floats(line.potential, np, {K3: z}), z.shape)


def _end(over: Callable[[Array], Array], z: float, side: int, passes: Sequence[float]) -> float:
    """The end of the well on one side: its pass, or where V is that high again, or the pole."""
    if there := [p for p in passes if side * (p - z) > 0]:
        return min(there, key=lambda p: abs(p - z))
    inside, outside = z, float(side)
    for _ in range(HALVINGS):
        middle = (inside + outside) / 2
        if float(over(np.array(middle))) < 0:
            inside = middle
        else:
            outside = middle
    return inside


def said(found: Well, level: Sequence[str]) -> tuple[list[str], list[str]]:
    """The field, the numbers, the level and the barrier."""
    above, shown = of_scene(found.rotation.scene, {})
    barrier = found.barrier_double
    assert barrier is not None
    last = f"barrier ${four(barrier)}$" if np.isfinite(barrier) else "no pass at any energy"
    return above, [*shown, *level, last]


def four(x: float) -> str:
    """Four digits, without a 0 after the point."""
    return number(x, f"{x:.4g}")
