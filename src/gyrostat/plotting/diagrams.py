"""The tilts of relative equilibria against a parameter, with their stability and the points where they meet."""
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
from sympy import Expr, Symbol

from ..algebra import Ring, by_degree
from ..bifurcations import BifurcationPoint, bifurcation_points, bifurcations
from ..branches import Branch, exact_point, names_of, relative_equilibria
from ..errors import ValuesError, require
from ..expressions import exact_number
from ..grids import Array
from ..notation import jet, symbol
from ..numeric import in_floats
from ..reduction import K3, OMEGA, P
from ..stability import Verdict
from ..system import System
from .looks import DARK, axes_of, label, legend, line, named, runs

NODES = 120                                                # between two bifurcations, closer together at the ends
SHAPES = {"E3 leaves E1": "^", "E3 leaves E2": "v", "fold at fixed rate": "D"}


@dataclass(frozen=True)
class Piece:
    """Part of a branch of relative equilibria, of one verdict.

    Parameters
    ----------
    label : str                             "E1", "E2" or "E3"
    parameter, k3 : arrays, shape (n,)
    verdict : Verdict                       exact, at its middle
    """

    label: str
    parameter: Array
    k3: Array
    verdict: Verdict


def branch_pieces(scene: System, values: Mapping[str, Any], parameter: str, ends: tuple[Any, Any]) -> tuple[
        list[Piece], list[BifurcationPoint]]:
    """The branches of E1, E2 and E3 over a range of one parameter, and their bifurcations there.

    Between two bifurcations, which are exact, the number of branches does not change and they do not cross; it is that at the middle, which
    is exact. The curves are roots in doubles, and their verdicts change where the margin does; each piece has its exact verdict.

    Parameters
    ----------
    scene, values, parameter, ends      as in draw_bifurcation_diagram

    Examples
    --------
    >>> import gyrostat as gs
    >>> scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: k3**4 - k3**2 / 2))
    >>> pieces, points = branch_pieces(scene, {"I1": 2, "I3": 1, "l": "1/10"}, "omega", (0, 1))
    >>> [(point.kind, round(float(point.value), 4), round(float(point.k3), 4)) for point in points]
    [('fold at fixed rate', 0.7002, -0.2061)]
    >>> [piece.verdict.name for piece in pieces if piece.label == "E3"]
    ['STABLE', 'UNSTABLE', 'STABLE', 'STABLE', 'STABLE']
    """
    require(scene, System, "the scene")
    low, high = (exact_number(end, parameter) for end in ends)
    if not low < high:
        raise ValuesError(f"the range of {parameter} is {low} to {high}: give its lower end first")
    if "omega" not in (parameter, *values):
        raise ValuesError(f"E3 is followed at a rate about the vertical, given were {', '.join(values)}, free is {parameter}: give omega "
                          "too, or leave it free")
    points = [point for point in bifurcation_points(scene, values, parameter) if low <= point.value <= high]
    cuts = sorted({float(low), float(high), *(float(point.value) for point in points)})
    numbers, free = exact_point(scene, values, names_of(scene) | {"omega"}), symbol(parameter)
    relation, *margins = (margin.xreplace(numbers) for margin in _margins(scene))
    pieces: list[Piece] = []

    found = cache(lambda x: relative_equilibria(scene, {**values, parameter: x}))

    def exact(name: str, x: float) -> list[Branch]:
        return [branch for branch in found(x) if branch.label == name and branch.k3 is not None]

    def follow(name: str, nodes: Array, k3: Array, place: int = 0) -> None:
        height = np.broadcast_to(in_floats(margins[("E1", "E2", "E3").index(name)], np, {free: nodes, K3: k3}), nodes.shape)
        for x, y, middle in _parts(nodes, k3, height):
            pieces.append(Piece(name, x, y, exact(name, middle)[place].decision.verdict))

    for name, side in (("E1", 1.0), ("E2", -1.0)):
        if exact(name, (cuts[0] + cuts[-1]) / 2):       # U may be infinite there
            nodes = np.linspace(cuts[0], cuts[-1], NODES * len(cuts))
            follow(name, nodes, np.full(len(nodes), side))
    for a, b in pairwise(cuts):
        nodes = (a + b) / 2 - (b - a) / 2 * np.cos(np.pi * np.arange(NODES + 1) / NODES)
        count = len(exact("E3", float(nodes[NODES // 2])))
        for place, k3 in enumerate(_tilts(relation, free, nodes, count, points)):
            follow("E3", nodes, k3, place)
    return pieces, points


def _margins(scene: System) -> tuple[Expr, ...]:
    """What vanishes on E3, then what changes its sign where the stability of E1, E2 and E3 does, in the rate, k3 and the parameters."""
    assert scene.potential is not None
    l, spin = scene.body.gyrostatic_momentum[2], scene.body.inertia[2] * OMEGA
    equations = {b.kind: (b.equations, b.at) for b in bifurcations(scene)}
    found = []
    for kind, n, inserted in (("fold at fixed rate", 0, {}), ("precessions leave E1", 0, {symbol("pi3_0"): spin}),
                              ("precessions leave E2", 0, {symbol("pi3_0"): -spin}), ("fold on a level", 1, {P: spin * K3 + l})):
        expressions, at = equations[kind]
        jets = {d: scene.potential.value(d).xreplace({K3: at}) for d in expressions[n].free_symbols if jet(d.name)}
        found.append(expressions[n].xreplace({**jets, **inserted}))
    return tuple(found)


def _tilts(relation: Expr, free: Symbol, nodes: Array, count: int, points: Sequence[BifurcationPoint]) -> Array:
    """The roots in −1 ≤ k3 ≤ 1 at each node, from above, shape (count, n); at the ends the exact ones of bifurcations."""
    ring = Ring([relation, K3])
    top, place = ring.reduce(ring.fraction(relation)[0]), ring.generators.index(K3)
    coefficients = [np.broadcast_to(in_floats(ring.expression(c), np, {free: nodes}), nodes.shape)
                    for c in reversed(by_degree(top, place, top.degrees()[place]))]
    tilts = np.empty((count, len(nodes)))
    for n, row in enumerate(np.array(coefficients).T):
        roots = np.roots(row)
        off = np.abs(roots.imag) + np.maximum(0, np.abs(roots.real) - 1)
        tilts[:, n] = np.sort(roots.real[np.argsort(off)[:count]])[::-1]
    for point in points:
        for end in (0, -1):
            if float(point.value) == nodes[end]:
                tilts[np.abs(tilts[:, end] - float(point.k3)) < 1e-3, end] = float(point.k3)       # a multiple root in doubles
    return tilts


def _parts(x: Array, y: Array, margin: Array) -> Iterator[tuple[Array, Array, float]]:
    """A curve cut where the margin changes its sign, and a node inside each part; the ends of the curve have no sign."""
    for run in runs(np.sign(margin[1:-1])):
        first, last = run.start + 1, run.stop
        part = [np.stack([x, y])[:, first:last + 1]]
        for outer, inner, place in ((first - 1, first, 0), (last + 1, last, len(part))):
            step = 1.0 if outer in (0, len(x) - 1) else margin[inner] / (margin[inner] - margin[outer])
            end = [[c[inner] + step * (c[outer] - c[inner])] for c in (x, y)]
            part.insert(place if place == 0 else len(part), np.array(end))
        joined = np.concatenate(part, axis=1)
        yield joined[0], joined[1], float(x[(first + last) // 2])


def draw_bifurcation_diagram(scene: System, values: Mapping[str, Any], parameter: str, ends: tuple[Any, Any], ax: Any = None,
                             **kwargs: Any) -> Any:
    """Draw k3 of every E1, E2 and E3 at fixed rotor and rate about the vertical against one parameter.

    Solid: stable; dashed: unstable; dotted: undecided; E3 modulo the spin about the axis of the body. Bifurcations are marked.

    Parameters
    ----------
    scene : System                            body of revolution in a U rational in k3
    values : mapping of name to number        the moments, l, the parameters of U and omega, without the one that is free
    parameter : str                           "omega", or another name of these
    ends : pair of numbers                    of its range
    ax : matplotlib Axes                      a new one where it is left out
    kwargs                                    of the branches: of Axes.plot

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ScopeError             the body is not of revolution, U is unspecified, or not rational in k3
    ValuesError            numbers are missing, unknown or not admissible, or the range is empty
    MissingExtraError      pip install "gyrostat[plot]"

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> ax = draw_bifurcation_diagram(top, {"I1": 2, "I3": 1, "l": 0, "m0": -1}, "omega", (0, 3), Figure().subplots())
    >>> ax.get_xlabel(), [text.get_text() for text in ax.get_legend().get_texts()]
    ('$\\\\omega$', ['stable', 'unstable', 'E3 leaves E1'])
    """
    pieces, points = branch_pieces(scene, values, parameter, ends)
    ax = axes_of(ax)
    for piece in pieces:
        ax.plot(piece.parameter, piece.k3, **{**line(piece.verdict), "clip_on": False, **kwargs})
    handles = [named({**line(verdict), **kwargs}, verdict.name.lower()) for verdict in Verdict if any(p.verdict is verdict for p in pieces)]
    for kind, shape in SHAPES.items():
        if found := [(float(point.value), float(point.k3)) for point in points if point.kind == kind]:
            style = {"color": DARK, "marker": shape, "markersize": 6, "linestyle": "none"}
            ax.plot(*np.array(found).T, zorder=4, clip_on=False, **style)
            handles.append(named(style, kind))
    low, high = (float(exact_number(end, parameter)) for end in ends)
    ax.set(xlim=(low, high), ylim=(-1.1, 1.1))
    for name, height in (("E1", 1), ("E2", -1)):
        ax.annotate(name, (1, height), xytext=(4, 0), xycoords=ax.get_yaxis_transform(), textcoords="offset points", va="center")
    ax.set_xlabel(label(parameter))
    ax.set_ylabel(label("k3"))
    legend(ax, handles)
    return ax
