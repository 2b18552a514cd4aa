"""Draws the eigenvalues of an equilibrium in the complex plane, along a parameter."""
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array
from ..arguments import checked
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..notation import dimension_of
from ..parameters.spectra import spectrum
from ..typesetting import typeset
from .beside import written_at
from .captions import headed
from .headings import number, of_scene
from .legends import named, room
from .looks import DARK, GREY, axes_of, axis, label, with_dimension

SHAPES = {"Hamiltonian Hopf": "x", "zero eigenvalue": "+", "real pairs meet": "1"}


@checked
def draw_eigenvalues(eq: Equilibrium, name: str, samples: Sequence[float], values: Mapping[str, Any],
                     ax: Any = None, **kwargs: Any) -> Any:
    r"""Draw the eigenvalues of the linearised field in the complex plane, along a parameter.

    The colour is the parameter, and arrows point the way the samples go. A mark stands where eigenvalues
    collide, with the value of the parameter beside it. The legend names what happens there, and says whether
    spectral stability changes. A unit is as long across as up.

    Parameters
    ----------
    eq : Equilibrium
    name : str
        in the spectrum
    samples : sequence of float, shape (n,)
        of that name, from one end to the other
    values : mapping of name to number
        for every other one
    ax : matplotlib Axes
        a new one where it is left out
    **kwargs : Any
        of the curves: of matplotlib.collections.LineCollection

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ValuesError
        names are missing or unknown
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Marsden & Ratiu, Introduction to Mechanics and Symmetry, §15.10 (the sleeping top).

    Examples
    --------
    >>> import gyrostat as gs
    >>> import numpy as np
    >>> from matplotlib.figure import Figure
    >>> scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> top, numbers = gs.upright(scene, spin="omega3_0"), np.linspace(2, 0, 80)
    >>> body = {"I1": 1, "I3": "8/5", "l": 0, "m0": 1}
    >>> ax = gs.plotting.draw_eigenvalues(
    ...     top, "omega3_0", numbers, body, Figure().subplots())
    >>> ax.get_xlabel()
    '$\\mathrm{Re}\\,\\lambda$ $[\\mathrm{T^{-1}}]$'
    """
    found = spectrum(eq, name, samples, values)
    ax = axes_of(ax)
    from matplotlib.collections import LineCollection
    points = np.stack([found.eigenvalues.real, found.eigenvalues.imag], axis=-1).transpose(1, 0, 2)
    segments = np.concatenate([np.stack([curve[:-1], curve[1:]], axis=1) for curve in points])
    along = np.tile((found.parameter[:-1] + found.parameter[1:]) / 2, len(points))
    lines = LineCollection(list(segments), array=along,
                           **{"cmap": "cividis", "linewidths": 2.4, "capstyle": "round", **kwargs})
    ax.axhline(0, color=GREY, linewidth=0.6, zorder=0)
    ax.axvline(0, color=GREY, linewidth=0.6, zorder=0)
    ax.add_collection(lines)
    ax.margins(0.12)
    ax.set_aspect("equal", adjustable="datalim")       # circles are circles
    ax.autoscale_view()
    for curve in points:
        _arrows(ax, curve, lines.to_rgba(found.parameter))
    handles, values_at = [], []
    for kind, changes in dict.fromkeys((collision.kind, collision.changes) for collision in found.collisions):
        these = [collision for collision in found.collisions
                 if (collision.kind, collision.changes) == (kind, changes)]
        style = {"color": DARK, "marker": SHAPES[kind], "markersize": 10, "markeredgewidth": 1.8,
                 "linestyle": "none"}
        at = np.concatenate([collision.eigenvalues for collision in these])
        ax.plot(at.real, at.imag, zorder=4, **style)
        handles.append(named(style, f"{kind}, {'stability changes' if changes else 'no change'}"))
        for collision in these:
            highest = max(collision.eigenvalues, key=lambda x: (x.imag, x.real))
            values_at.append((f"${typeset(name)} = {number(collision.value)}$", (highest.real, highest.imag)))
    above, shown = of_scene(eq.system, values)
    for part, put in (("Re", ax.set_xlabel), ("Im", ax.set_ylabel)):
        put(with_dimension(rf"$\mathrm{{{part}}}\,{typeset('lamda')}$", dimension_of("lamda")))
    ax.figure.colorbar(lines, ax=ax, label=axis(name))
    headed(ax, f"Eigenvalues of the linearised field along {label(name)}", ([eq.label, *above], shown),
           handles, 1, after="Arrows point the way the parameter goes" + (
               ", and its values stand beside the collisions" if handles else ""))
    for _ in range(2):                                 # limits follow the room, and then no more
        room(ax)
    written_at(ax, values_at, 10)
    return ax


def _arrows(ax: Any, curve: Array, colors: Array) -> None:
    """Arrowheads at a third and two thirds of the length of a curve."""
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    for part in (1 / 4, 3 / 4):
        n = int(np.clip(np.searchsorted(length, part * length[-1]), 1, len(curve) - 1))
        ax.annotate("", curve[n], curve[n - 1],
                    arrowprops={"arrowstyle": "-|>", "color": colors[n], "mutation_scale": 16,
                                                            "shrinkA": 0, "shrinkB": 0})
