"""Draws the energy-momentum diagram of a body of revolution in U(k3).

These are the critical values of (C1, h) at a fixed axial momentum.
"""
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array, in_floats, row
from ..arguments import checked
from ..equilibria.curves.critical_values import EnergyMomentum, critical_values
from ..equilibria.finders.rate_level_tilt import names_of
from ..equilibria.relative_equilibrium import RelativeEquilibrium
from ..mechanics.equilibrium.reduction import K3, V
from ..mechanics.scenes.system import System
from ..printing.letters import letters_of
from ..stability.decision import Verdict
from ..stability.notion import Notion
from .beside import Marks, written_at
from .captions import headed
from .globe import dots_of
from .headings import of_scene
from .legends import named, room
from .looks import DARK, MARKER, axes_of, axis, line, marker
from .scene_numbers import in_own_axes, numbers_of

CELLS = 400                                                # of each axis, for the regions
# k3 has no place, one band, two bands, three or more
BANDS = ("#ffffff", "#eceff3", "#d3dae3", "#b9c4d1")


def energy_momentum(scene: System, values: Mapping[str, Any]) -> EnergyMomentum:
    """Return every critical value of (C1, h) at a fixed p_psi = π3 + l.

    On regular precessions I1 k3 W² − p_ψ W + U' = 0 has a slow and a fast root W at each tilt; C1 and h
    follow. The curves are in doubles, cut where stability changes; the verdict of each part is exact.

    Parameters
    ----------
    scene, values
        as in draw_energy_momentum

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> found = energy_momentum(top, {"I1": 1, "I3": 1, "l": 0, "m0": 1, "p_psi": 1})
    >>> {curve.verdict.name for curve in found.curves}
    {'STABLE'}
    >>> [(v, h, pole.decision.verdict.name) for v, h, pole in found.poles]
    [(1.0, 1.5, 'UNSTABLE'), (-1.0, -0.5, 'STABLE')]
    """
    names_of(scene)
    return critical_values(scene, numbers_of(scene, values, ("p_psi",)))


def bands(found: EnergyMomentum, momentum: Array, energy: Array) -> Array:
    """Count the bands of k3 in which the body can move, shape (len(energy), len(momentum))."""
    k3 = np.cos(np.linspace(0, np.pi, CELLS + 2)[1:-1])
    height = in_floats(found.potential, np, {V: momentum[:, None], K3: k3})
    below = height[None] <= energy[:, None, None]
    return below[..., 0].astype(int) + (below[..., 1:] & ~below[..., :-1]).sum(axis=-1)


@checked
def draw_energy_momentum(scene: System, values: Mapping[str, Any],
                         window: tuple[float, float, float, float] | None = None, ax: Any = None,
                         **kwargs: Any) -> Any:
    """Draw the energy-momentum diagram of a body of revolution in U(k3): h against C1 at a fixed p_psi.

    p_psi = π3 + l is the axial momentum. The curves are the regular precessions, and the points are E1 and
    E2: solid or filled if stable, dashed or open if unstable, dotted or half filled if undecided. In the grey
    region motion is possible; it is darker where there are more bands of k3 at the same C1 and h.

    Parameters
    ----------
    scene : System
        body of revolution in a U rational in k3, or about any other axis c, rational in k·c; k3 and π3 + l
        are then the components along c
    values : mapping of name to number
        for its parameters, and p_psi [M L²/T]
    window : (C1, C1, h, h) or None
        lower and upper ends of the axes; None: around what is critical
    ax : matplotlib Axes
        to draw in; a new one where it is left out
    **kwargs : Any
        of the curves: of Axes.plot

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ScopeError
        U is unspecified or not rational in k3, or the body is not of revolution
    ValuesError
        numbers are missing, unknown or not admissible
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Smale, Inventiones Mathematicae 10 (1970) 305-331; Cushman & Bates, Global Aspects of Classical Integrable
    Systems (1997), chapter V.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> values = {"I1": 1, "I3": 1, "l": 0, "m0": 1, "p_psi": 1}
    >>> ax = gs.plotting.draw_energy_momentum(top, values, ax=Figure().subplots())
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['stable (curves: modulo the spin)', 'unstable', '1 band of $k_3$']
    >>> [text.get_text() for text in ax.texts]
    ['E1, focus-focus', 'E2']
    """
    standard, left_over, k3, about = in_own_axes(scene, values)
    found = energy_momentum(standard, left_over)
    ax = axes_of(ax)
    left, right, low, high = _window(found) if window is None else row(window, "window").tolist()
    momentum, energy = np.linspace(left, right, CELLS), np.linspace(low, high, CELLS)
    count = bands(found, momentum, energy)
    ax.contourf(momentum, energy, count, levels=[0.5, 1.5, 2.5, 99], colors=BANDS[1:], zorder=0)
    for curve in found.curves:
        ax.plot(curve.momentum, curve.energy, **{**line(curve.verdict), **kwargs})
    names: dict[tuple[float, float], list[str]] = {}
    for v, h, branch in found.poles:
        ax.plot([v], [h], zorder=4, **marker(branch.decision.verdict))
        said = f"{branch.label}, focus-focus" if _focus(branch) else branch.label
        names.setdefault((v, h), []).append(said)
    shown = left, right, low, high
    cusps = [cusp for cusp in found.cusps if _inside(*cusp, shown)]
    style = {"color": DARK, "marker": "D", "markersize": 4.5, "linestyle": "none"}
    marks = [Marks(handle, cusps) for handle in dots_of(ax, cusps, style, "fold on a level")]
    ax.set(xlim=(left, right), ylim=(low, high), xlabel=axis("C1", (1, 1, 0)),
           ylabel=axis(letters_of(scene).of("h"), (1, 2, 0)))
    curves = {x.verdict for x in found.curves if _inside(x.momentum, x.energy, shown)}
    points = {branch.decision.verdict for v, h, branch in found.poles if _inside(v, h, shown)}
    modulo = " (curves: modulo the spin)" if Verdict.STABLE in curves else ""
    verdicts = [named({**(marker(x) if x in points else {}), **(line(x) | kwargs if x in curves else {})},
                      x.name.lower() + (modulo if x is Verdict.STABLE else ""))
                for x in Verdict if x in curves | points]
    above, numbers = of_scene(scene, values)
    headed(ax, "Energy-momentum diagram of a body of revolution", ([*above, *about], numbers),
           [*verdicts, *_areas(int(count.max()), k3)], 2, marks,
           "The curves are regular precessions, and the points are E1 and E2")
    room(ax)
    written_at(ax, [("; ".join(several), place) for place, several in names.items()], MARKER)
    return ax


def _inside(momentum: Any, energy: Any, window: Sequence[float]) -> bool:
    """Whether a point is in the window, or one of a curve."""
    left, right, low, high = window
    return bool(np.any((left <= momentum) & (momentum <= right) & (low <= energy) & (energy <= high)))


def _focus(branch: RelativeEquilibrium) -> bool:
    """Whether E1 or E2, below the critical spin, is a focus-focus point of (C1, h).

    Its eigenvalues are a complex quadruple.
    """
    return branch.decision.verdict is Verdict.UNSTABLE and branch.decision.notion == Notion.SPECTRAL


def _areas(most: int, k3: str) -> list[Any]:
    """What stands in the legend for the regions."""
    from matplotlib.patches import Patch
    names = (f"1 band of ${k3}$", "2 bands", "3 bands or more")
    return [Patch(facecolor=color, edgecolor="none", label=name)
            for color, name in list(zip(BANDS[1:], names))[:most]]


def _window(found: EnergyMomentum) -> tuple[float, float, float, float]:
    """Around E1, E2 and half of the precessions."""
    if not found.curves and not found.poles:
        return -1.0, 1.0, -1.0, 1.0
    tilted = [curve for curve in found.curves if np.ptp(curve.k3)]
    evenly = [np.abs(np.interp(np.linspace(curve.k3[0], curve.k3[-1], CELLS), curve.k3, curve.momentum))
              for curve in tilted]
    marked = [*(abs(v) for v, _, _ in found.poles), *(abs(v) for v, _ in found.cusps)]
    width = 1.5 * max([float(np.median(np.concatenate(evenly))) if evenly else 0.0, *marked]) or 1.0
    near = np.concatenate([[h for _, h, _ in found.poles],
                           *(curve.energy[np.abs(curve.momentum) < width] for curve in found.curves)])
    low, high = float(near.min()), float(near.max())
    return -width, width, low - 0.15 * (high - low), high + 0.15 * (high - low)
