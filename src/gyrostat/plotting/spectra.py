"""Eigenvalues of an equilibrium in the complex plane, along a parameter."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations
from typing import Any

import numpy as np
from sympy import Expr, Symbol

from ..conditions import spectral_criterion
from ..equilibria import Equilibrium
from ..errors import ValuesError, require
from ..expressions import exact_number
from ..grids import Array
from ..linearization import linearize
from ..notation import symbol
from ..numeric import in_floats
from ..values import check_names, names_in
from .looks import DARK, GREY, axes_of, label, legend, named


@dataclass(frozen=True)
class Spectrum:
    """Eigenvalues along a parameter.

    Parameters
    ----------
    parameter : array, shape (n,)                  the samples and the collisions
    eigenvalues : complex array, shape (n, d)      d = 2 or 4; each column is continuous
    collisions : list of (value, eigenvalues)      where the kind of the spectrum changes
    """

    parameter: Array
    eigenvalues: Array
    collisions: list[tuple[float, Array]]


def spectrum(eq: Equilibrium, values: Mapping[str, Any], parameter: str, samples: Sequence[float]) -> Spectrum:
    """The roots of λ⁴ + p λ² + q, or λ² + p, at values of one parameter, and where p² − 4q or q, or p where q is 0, changes its sign.

    Parameters
    ----------
    eq, values, parameter, samples      as in draw_eigenvalues

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), spin="omega3_0")
    >>> found = spectrum(top, {"I1": 1, "I3": "8/5", "l": 0, "m0": 1}, "omega3_0", np.linspace(2, 0, 80))
    >>> [round(value, 9) for value, _ in found.collisions]
    [1.25]
    """
    require(eq, Equilibrium, "the equilibrium")
    linear = linearize(eq)
    coefficients = [eq.insert(c) for c in linear.coefficients]
    margins = [eq.insert(c.margin) for c in spectral_criterion(linear).alternatives[0] if c.source != "p" or not coefficients[-1]]
    check_names([*values, parameter], names_in([*coefficients, symbol(parameter)]), f"the spectrum of {eq.label}")
    at, free = np.asarray(samples, dtype=float), symbol(parameter)
    if at.ndim != 1 or len(at) < 2 or not (np.diff(at) * (at[-1] - at[0]) > 0).all():
        raise ValuesError(f"samples are {samples}: give two values of {parameter} or more, increasing or decreasing")
    numbers = {symbol(name): exact_number(value, name) for name, value in values.items()}
    placed = [c.xreplace(numbers) for c in coefficients]
    found = [x for margin in margins for x in _crossings(margin.xreplace(numbers), free, at)]
    at = np.sort(np.concatenate([at, found]))[::1 if at[0] < at[-1] else -1]              # the curves go through the collisions
    roots = _roots(placed, free, at)
    for n in range(1, len(at)):                            # each column goes on to the nearest
        orders = list(permutations(roots[n]))
        roots[n] = orders[int(np.argmin([np.abs(np.array(order) - roots[n - 1]).sum() for order in orders]))]
    return Spectrum(at, roots, [(x, _roots(placed, free, np.array([x]))[0]) for x in found])


def _roots(coefficients: Sequence[Expr], free: Symbol, at: Array) -> Array:
    p, *rest = (np.broadcast_to(in_floats(c, np, {free: at}), at.shape).astype(complex) for c in coefficients)
    if not rest:
        return np.stack([np.sqrt(-p), -np.sqrt(-p)], axis=1)
    inner = np.sqrt(p**2 - 4 * rest[0])
    squares = [(-p + inner) / 2, (-p - inner) / 2]
    return np.stack([sign * np.sqrt(square) for square in squares for sign in (1, -1)], axis=1)


def _crossings(expression: Expr, free: Symbol, at: Array) -> list[float]:
    """Where an expression changes its sign between two samples, by bisection in doubles."""
    def sign(x: Any) -> Any:
        return np.sign(in_floats(expression, np, {free: np.asarray(x)}))

    signs, found = np.broadcast_to(sign(at), at.shape), []
    for n in np.flatnonzero(signs[:-1] * signs[1:] < 0):
        low, high = at[n], at[n + 1]
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if sign(middle) == signs[n] else (low, middle)
        found.append(float(low + high) / 2)
    return found


def draw_eigenvalues(eq: Equilibrium, values: Mapping[str, Any], parameter: str, samples: Sequence[float], ax: Any = None,
                     **kwargs: Any) -> Any:
    """Draw the eigenvalues of the linearised field in the complex plane, along a parameter.

    The colour is the parameter, arrows point the way the samples go, crosses are collisions.

    Parameters
    ----------
    eq : Equilibrium
    values : mapping of name to number         for every other name in the spectrum
    parameter : str
    samples : sequence of float                of the parameter, from one end to the other
    ax : matplotlib Axes                       a new one where it is left out
    kwargs                                     of the curves: of matplotlib.collections.LineCollection

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ValuesError            names are missing or unknown
    MissingExtraError      pip install "gyrostat[plot]"

    Source
    ------
    Marsden & Ratiu, Introduction to Mechanics and Symmetry, §15.10 (the sleeping top).

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> top = gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), spin="omega3_0")
    >>> samples = np.linspace(2, 0, 80)
    >>> ax = draw_eigenvalues(top, {"I1": 1, "I3": "8/5", "l": 0, "m0": 1}, "omega3_0", samples, Figure().subplots())
    >>> ax.get_xlabel()
    '$\\\\mathrm{Re}\\\\,\\\\lambda$'
    """
    found = spectrum(eq, values, parameter, samples)
    ax = axes_of(ax)
    from matplotlib.collections import LineCollection
    points = np.stack([found.eigenvalues.real, found.eigenvalues.imag], axis=-1).transpose(1, 0, 2)
    segments = np.concatenate([np.stack([curve[:-1], curve[1:]], axis=1) for curve in points])
    along = np.tile((found.parameter[:-1] + found.parameter[1:]) / 2, len(points))
    lines = LineCollection(list(segments), array=along, **{"cmap": "cividis", "linewidths": 2.4, "capstyle": "round", **kwargs})
    ax.axhline(0, color=GREY, linewidth=0.6, zorder=0)
    ax.axvline(0, color=GREY, linewidth=0.6, zorder=0)
    ax.add_collection(lines)
    ax.margins(0.12)
    ax.autoscale_view()
    for curve in points:
        _arrows(ax, curve, lines.to_rgba(found.parameter))
    style = {"color": DARK, "marker": "x", "markersize": 9, "markeredgewidth": 1.8, "linestyle": "none"}
    if found.collisions:
        collided = np.concatenate([at for _, at in found.collisions])
        ax.plot(collided.real, collided.imag, zorder=4, **style)
        values_there = ", ".join(f"{value:.4g}" for value, _ in found.collisions)
        legend(ax, [named(style, f"collision at {label(parameter)} = {values_there}")])
    ax.set_xlabel(rf"$\mathrm{{Re}}\,{label('lamda')[1:-1]}$")
    ax.set_ylabel(rf"$\mathrm{{Im}}\,{label('lamda')[1:-1]}$")
    ax.figure.colorbar(lines, ax=ax, label=label(parameter))
    return ax


def _arrows(ax: Any, curve: Array, colors: Array) -> None:
    """Arrowheads at a third and two thirds of the length of a curve."""
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    for part in (1 / 4, 3 / 4):
        n = int(np.clip(np.searchsorted(length, part * length[-1]), 1, len(curve) - 1))
        ax.annotate("", curve[n], curve[n - 1], arrowprops={"arrowstyle": "-|>", "color": colors[n], "mutation_scale": 16,
                                                            "shrinkA": 0, "shrinkB": 0})
