"""Follows the curves on which a verdict changes, by marching squares and bisection in twofold arithmetic.

They are zeros of margins, each vertex on a line of the grid, moved along it to the last bits.
"""
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from sympy import Expr, Rational, Symbol

from ...algebra.enclosures.double_double import Twofold
from ...algebra.enclosures.floats import Array, in_floats
from ..grids import places
from ..programs.rounding import error_bound, rounded
from ..programs.straightline import program_of
from ..signs.grid_signs import TOGETHER, UNKNOWN
from .crossings import Places, Sign, edges, joined, pieces, zeros

Verdicts = Callable[[Array, Array], Array]
# values of an axis between which curves are followed: more would make no vertex more exact
FINEST = 2000
_AROUND = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if (i, j) != (0, 0)]


def boundary(margins: Sequence[Expr], numbers: Mapping[Symbol, Expr], x: tuple[Symbol, Array],
             y: tuple[Symbol, Array], verdict: Array, ask: Verdicts | None = None) -> tuple[Array, Array]:
    """Return points of the curves between different verdicts, with NaN between the pieces.

    Marching squares follow the sign of each margin. A vertex is kept if the verdict differs on the two sides
    of it, and is moved along its edge onto the zero, by bisection in twofold arithmetic (106 bits). For a
    polynomial with rational numbers it is within two units of the last place, if nothing is degenerate.
    Functions such as exp are taken in doubles, and the point is as good as they are.

    Parameters
    ----------
    margins : sequence of Expr
        what changes its sign where a verdict may change
    numbers : mapping of Symbol to Expr
        the other parameters
    x, y : pairs (symbol, array)
        the axes, strictly monotonic
    verdict : array, shape (len(y), len(x))
        codes of the verdicts at the points of the grid
    ask : callable or None
        gives the verdict at points: if several margins change their sign on one edge, it tells with which of
        them the verdict changes

    Returns
    -------
    pair of arrays
        x and y of the points

    References
    ----------
    Dekker, Numer. Math. 18 (1971) 224-242.

    Examples
    --------
    >>> import gyrostat as gs
    >>> a, b = gs.symbol("a"), gs.symbol("b")
    >>> across, up = np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0])
    >>> stable = np.array([[-1, -1, 1], [-1, -1, 1]])
    >>> boundary([a**2 - 2], {}, (a, across), (b, up), stable)
    (array([1.41421356, 1.41421356]), array([1., 0.]))
    """
    asked = [margin for margin in dict.fromkeys(margin.xreplace(dict(numbers)) for margin in margins)
             if {x[0], y[0]} & margin.free_symbols]
    signs = [signs_of(margin, x, y) for margin in asked]
    x_found, y_found = joined([
        _curves(sign_of(margin, x[0], y[0]), here, (x[1], y[1]), verdict,
                [other for other in signs if other is not here], ask) for margin, here in zip(asked, signs)])
    return x_found, y_found


def thinned(n: int) -> Array:
    """Return the places along an axis of n values between which curves are followed.

    They are all of them, or some 2000 that lie evenly, both ends included.
    """
    return np.unique(np.linspace(0, n - 1, min(n, FINEST)).round().astype(np.int64))


def _curves(sign: Sign, signs: Array, axes: tuple[Array, Array], verdict: Array, others: Sequence[Array],
            ask: Verdicts | None) -> Array:
    """Return the points of one margin, shape (2, points)."""
    columns, rows = axes
    gaps, good, bad = edges(signs)
    kept = ~gaps & _between_verdicts(verdict, signs, good, bad)
    points = np.full((2, len(gaps)), np.nan)
    if kept.any():
        good, bad = ((row[kept], column[kept]) for row, column in (good, bad))
        sides = [np.array([columns[column], rows[row]]) for row, column in (good, bad)]
        points[:, kept] = found = zeros(sign, *sides)
        several = sum((_changes(other, good, bad) for other in others), start=np.zeros(kept.sum(), bool))
        if ask is not None and several.any():
            inside = found[:, several]
            points[:, np.flatnonzero(kept)[several]] = np.where(
                _parts(ask, inside, *(side[:, several] for side in sides)), inside, np.nan)
    return pieces(points)


def _changes(signs: Array, good: Places, bad: Places) -> Array:
    """Tell for each edge whether another margin may change its sign there."""
    one, other = signs[good], signs[bad]
    return ((one == 1) != (other == 1)) | (one == UNKNOWN) | (other == UNKNOWN)


def signs_of(margin: Expr, x: tuple[Symbol, Array], y: tuple[Symbol, Array]) -> Array:
    """Return the sign at every point of the grid, UNKNOWN where the margin has none.

    If doubles with their bound cannot tell, it is taken in twofold arithmetic.
    """
    (across, columns), (up, rows) = x, y
    program = program_of(margin, {up: frozenset([0]), across: frozenset([1])})
    signs = np.empty((len(rows), len(columns)), np.int8)

    def values(x: Array, y: Array) -> Array:
        found: Array = program.run(lambda leaf: in_floats(leaf, np, {across: x, up: y}),
                                   lambda value: np.float64(rounded(value)[0]))[-1]
        return np.broadcast_to(found, np.broadcast_shapes(x.shape, y.shape))

    with np.errstate(all="ignore"):
        sizes, roundings = {}, {}
        for leaf in program.leaves:
            sizes[leaf] = np.max(np.abs(in_floats(leaf, np, {across: columns, up: rows[:, None]})), initial=0)
            roundings[leaf] = 0 if isinstance(leaf, Symbol) else 4
        bound = error_bound(program, sizes, roundings)
        height = max(1, TOGETHER // len(columns))
        for start in range(0, len(rows), height):
            here = values(columns, rows[start:start + height, None])
            signs[start:start + height] = (here > bound).astype(np.int8) - (here < -bound)
        row, column = places(signs == 0)
        near, found = (value(columns[column], rows[row]) for value in (values, sign_of(margin, across, up)))
        found = np.where(np.isfinite(near), found, np.sign(near))
        signs[row, column] = np.where(np.isnan(found), UNKNOWN, found)
    return signs


def _between_verdicts(verdict: Array, signs: Array, good: tuple[Array, ...], bad: tuple[Array, ...]) -> Array:
    """Tell for each edge whether the verdict differs on the two sides.

    If an end lies on the curve itself, it tells whether the verdict differs beyond that end.
    """
    here = verdict[good]
    different = here != verdict[bad]
    asked = np.nonzero(~different & (signs[bad] == 0))[0]
    for i, j in _AROUND:
        row = np.clip(bad[0][asked] + i, 0, verdict.shape[0] - 1)
        column = np.clip(bad[1][asked] + j, 0, verdict.shape[1] - 1)
        different[asked] |= (signs[row, column] < 0) & (verdict[row, column] != here[asked])
    return different


def _parts(ask: Verdicts, points: Array, good: Array, bad: Array) -> Array:
    """Tell whether the verdict differs between points on edges and their two sides.

    The sides are a few units of the last place away.
    """
    # a vertex is within two units of the zero: four units away its sign is that of the side
    seen = [ask(*points)]
    for side in (good, bad):
        step = np.minimum(4 * np.spacing(np.abs(points)), np.abs(side - points))
        seen.append(ask(*(points + np.sign(side - points) * step)))
    return (seen[0] != seen[1]) | (seen[0] != seen[2])


def sign_of(margin: Expr, across: Symbol, up: Symbol) -> Sign:
    """Return the function that gives the sign of a margin in two names at points, in twofold arithmetic."""
    program = program_of(margin, {})

    def constant(value: Rational) -> Twofold:
        near = float(value)
        return Twofold(np.float64(near), np.float64(float(value - Rational(near))))

    def sign(x: Array, y: Array) -> Array:
        def leaf(value: Expr) -> Twofold:
            if not value.free_symbols:
                return constant(Rational(value.evalf(40)))
            return Twofold(in_floats(value, np, {across: x, up: y}), np.float64(0))

        with np.errstate(all="ignore"):
            found = program.run(leaf, constant)[-1]
            return np.sign(np.where(found.high != 0, found.high, found.low))

    return sign
