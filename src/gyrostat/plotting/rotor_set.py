"""Draws the bifurcation set of a free gyrostat: where in a plane of its rotor permanent rotations meet."""
from collections.abc import Mapping
from typing import Any

import numpy as np
from sympy import Expr, ImmutableMatrix, discriminant

from ..algebra.enclosures.floats import Array, in_floats, row
from ..algebra.reals.exact import proved_sign
from ..algebra.text.numbers import exact_number
from ..arguments import checked
from ..equilibria.curves.rotor_planes import fold_intervals, fold_squares, numbers_of_rotations_over
from ..equilibria.finders.free import NU
from ..equilibria.finders.rate_level_tilt import LENGTH, exact_point
from ..errors import ScopeError, ValuesError, brief
from ..mechanics.scenes.body import Gyrostat
from ..mechanics.scenes.system import System, assemble, at_numbers, names_of_scene
from ..notation import components, symbol
from ..stability.criteria.numbers_asked import names_in
from .captions import headed
from .energy_levels import in_principal_axes
from .globe import curves_of
from .headings import components_in, of_sphere
from .looks import BLUE, DARK, axes_of, axis

ARC, CELLS = 400, 120                                      # samples of an arc, of the plane each way
FOLD = {"color": DARK, "linewidth": 1.4}
PITCHFORK = {"color": BLUE, "linewidth": 1.4, "linestyle": "-."}
SMALL, LEAST = 1e-6, 3                                     # beside 0, of abs(M); cells about a number
SHADES = {2: "#ffffff", 4: "#e4edf5", 6: "#c3d7e8"}


@checked
def draw_rotor_set(scene: System, values: Mapping[str, Any], ax: Any = None, **kwargs: Any) -> Any:
    r"""Draw where, in a plane of the rotor at a given abs(M), permanent rotations of a free gyrostat meet.

    Two components of l along principal axes are free, and the third has a value. Of a tensor the principal
    axes are found, moments increasing; l1, l2, l3 are along them, and the title says where they point. At
    dark curves, folds, two rotations meet. At blue curves, pitchforks, which exist if the third component is
    0, two rotations off the plane meet one in it. Each region shows the number of its rotations, 2, 4 or 6,
    and more are darker.

    Parameters
    ----------
    scene : System
        without a field, its moments different; with a tensor its rotor is (l1, l2, l3), three names
    values : mapping of name to number
        for M and every name but two components of l
    ax : matplotlib Axes
        new ones where they are left out
    **kwargs : Any
        of the curves: of Axes.plot

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ScopeError
        the scene has a field, or two moments are equal; with a tensor, its rotor is not three names
    ValuesError
        the names without a number are not two components of l, or a number is not admissible
    MissingExtraError
        pip install "gyrostat[plot]"

    References
    ----------
    Cayley, On the centro-surface of an ellipsoid, Collected Papers VIII, no. 520; derived.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> body = gs.assemble(gs.Gyrostat((1, 2, 3)))
    >>> ax = gs.plotting.draw_rotor_set(body, {"l2": 0, "M": 1}, Figure().subplots())
    >>> sorted({text.get_text() for text in ax.texts}), ax.get_xlabel()
    (['2', '4', '6'], '$l_1$ $[\\mathrm{M\\,L^{2}\\,T^{-1}}]$')
    """
    standard, axes, left = _in_principal_axes(scene, values)
    body, radius, free = _section(standard, left)
    held = next(n for n in range(3) if n not in free)
    arcs = [_arc(body, radius, held, a, b) for a, b in fold_intervals(body, radius, held)]
    ax = axes_of(ax)
    ellipse = _pitchforks(body, radius, held)
    row([radius], "M")                                     # a double
    width, height = (1.12 * max((float(np.nanmax(curve[n])) for curve in [*arcs, *ellipse]),
                                default=float(radius)) for n in (0, 1))
    x, y = (np.linspace(-size, size, CELLS) for size in (width, height))
    counts = _counts(body, radius, free, x, y)
    ax.contourf(x, y, counts, levels=[1, 3, 5, 7], colors=list(SHADES.values()))
    handles: list[Any] = []
    for curves, style, name in ((arcs, FOLD, "fold"), (ellipse, PITCHFORK, "pitchfork")):
        every = [curve.T * side for curve in curves for side in ((1, 1), (1, -1), (-1, 1), (-1, -1))]
        handles += curves_of(ax, every, {**style, **kwargs}, name)
    for rotations, place in _places(x, y, counts):
        ax.text(*place, str(rotations), ha="center", va="center")
    ax.set(xlim=(-width, width), ylim=(-height, height), xlabel=axis(f"l{free[0] + 1}"),
           ylabel=axis(f"l{free[1] + 1}"))
    above, shown = of_sphere(scene, values, values[LENGTH.name])
    headed(ax, "Bifurcation set of a free gyrostat", ([*above, *axes], shown), handles,
           after="The number in each region is that of the permanent rotations")
    return ax


def _in_principal_axes(scene: System, values: Mapping[str, Any]
                       ) -> tuple[System, list[str], Mapping[str, Any]]:
    """Return the scene in principal axes, of a tensor in doubles; where these point; the values left."""
    body = scene.body
    if scene.potential is not None or not isinstance(body.inertia, ImmutableMatrix):
        return scene, [], values
    if body.gyrostatic_momentum != components("l"):
        raise ScopeError("the picture is a plane of components along principal axes, and the rotor of this "
                         f"tensor is {body.gyrostatic_momentum}: leave it out of the body, "
                         "Gyrostat(inertia), and give one of l1, l2, l3")
    own = names_in(body.entries)
    if missing := [name for name in own if name not in values]:
        raise ValuesError(f"the tensor needs {', '.join(missing)}: give a number for each")
    body = at_numbers(scene, {symbol(name): exact_number(values[name], name) for name in own}).body
    level = body.tensor.charpoly().as_expr()
    if proved_sign(discriminant(level)) == 0:
        raise ScopeError(f"two principal moments of {brief(body.tensor.tolist())} are equal, and l may be "
                         "turned about their axis; give three different ones")
    moments, R = in_principal_axes(body)
    shown = [[f"{x:.2f}" for x in row] for row in R.round(2) + 0.0]        # no −0.00
    rows = [f"axis {n} {components_in(row)}" for n, row in enumerate(shown, 1)]
    return assemble(Gyrostat(moments.tolist())), rows, {
        name: x for name, x in values.items() if name not in own}


def _section(scene: System, values: Mapping[str, Any]) -> tuple[Gyrostat, Expr, list[int]]:
    """Return the body at given numbers, abs(M), and the two axes along which l is free."""
    if scene.potential is not None:
        raise ScopeError("permanent rotations on a sphere of M are those of a free gyrostat, the scene has "
                         f"the potential {scene.potential.expression}: assemble the body alone")
    needed = {s.name for s in names_of_scene(scene)} | {LENGTH.name}
    numbers = exact_point(scene, values, needed)
    body = at_numbers(scene, numbers).body
    left = {symbol(name) for name in needed - values.keys()}
    free = [n for n, l in enumerate(body.gyrostatic_momentum) if l in left]
    if len(free) != 2 or len(left) != 2:
        raise ValuesError(f"without a number are {', '.join(sorted(map(str, left))) or 'no names'}, and "
                          "the picture is a plane of two components of the rotor: leave out two of l1, l2, "
                          "l3, and give a number for every other name and M")
    if len(set(body.moments)) < 3:
        raise ScopeError(f"inertia = {body.moments}: two moments are equal, and l may be turned about their "
                         "axis; give three different ones")
    if proved_sign(numbers[LENGTH]) != 1:
        raise ValuesError(f"M = {numbers[LENGTH]} is not the radius of a momentum sphere: give a positive "
                          "number")
    return body, numbers[LENGTH], free


def _arc(body: Gyrostat, radius: Expr, held: int, a: Expr, b: Expr) -> Array:
    """Return the free components of l along an interval of ν, in one quadrant."""
    low, high = float(a), float(b)
    nu = (low + high) / 2 - (high - low) / 2 * np.cos(np.pi * np.linspace(1e-4, 1 - 1e-4, ARC))
    squares = [in_floats(square, np, {NU: nu}) for square in fold_squares(body, radius, held)]
    return np.sqrt(np.maximum(np.array([np.broadcast_to(square, nu.shape) for square in squares]), 0.0))


def _pitchforks(body: Gyrostat, radius: Expr, held: int) -> list[Array]:
    """l_i²/(1 − I_i/I_k)² + l_j²/(1 − I_j/I_k)² = abs(M)² in one quadrant, where the component k is 0."""
    if proved_sign(body.gyrostatic_momentum[held]) != 0:
        return []
    turn, own = np.linspace(0, np.pi / 2, ARC), body.moments[held]
    half = [float(radius * abs(1 - moment / own)) for n, moment in enumerate(body.moments) if n != held]
    return [np.array([half[0] * np.cos(turn), half[1] * np.sin(turn)])]


def _counts(body: Gyrostat, radius: Expr, free: list[int], x: Array, y: Array) -> Array:
    """Count the rotations over the plane, shape (len(y), len(x)); if the third component is 0, beside it."""
    size = float(radius)
    rotor = [np.full((len(y), len(x)), 0.0 if n in free else float(l) or SMALL * size)
             for n, l in enumerate(body.gyrostatic_momentum)]
    rotor[free[0]], rotor[free[1]] = np.meshgrid(x, y)
    return numbers_of_rotations_over(np.array(body.moments, float), rotor, size)


def _places(x: Array, y: Array, counts: Array) -> list[tuple[int, tuple[float, float]]]:
    """Return a place well inside each region that has room for its number, with the number."""
    found, left = [], np.ones(counts.shape, dtype=bool)
    while left.any():
        start = tuple(np.argwhere(left)[0])
        region = np.zeros_like(left)
        region[start] = True
        same = counts == counts[start]
        while (grown := _spread(region) & same).sum() > region.sum():
            region = grown
        left &= ~region
        inside, depth = region, 0
        while (less := ~_spread(~np.pad(inside, 1))[1:-1, 1:-1]).any():
            inside, depth = less, depth + 1
        if depth > LEAST:
            cells = np.argwhere(inside)
            row, column = cells[((cells - cells.mean(axis=0)) ** 2).sum(axis=1).argmin()]
            found.append((int(counts[start]), (float(x[column]), float(y[row]))))
    return found


def _spread(region: Array) -> Array:
    """Return a region with its neighbouring cells."""
    wide = np.pad(region, 1)
    return wide[1:-1, 1:-1] | wide[2:, 1:-1] | wide[:-2, 1:-1] | wide[1:-1, 2:] | wide[1:-1, :-2]
