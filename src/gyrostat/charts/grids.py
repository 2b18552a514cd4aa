"""Named arrays on a common grid, broadcast, in blocks that fit a cache.

Each array knows the axes along which it varies, so that nothing is computed twice along another.
"""
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product, repeat
from math import prod
from typing import Any

import numpy as np
from sympy import Symbol

from .._cached import cached_property
from ..algebra.enclosures.floats import Array
from ..errors import ValuesError
from ..notation import symbol
from .labels import check_plain
from .programs.straightline import Axes
from .signs.given_columns import all_finite, read_entry

Slices = tuple[slice, ...]                            # a block, one slice for each axis
COLUMNS, ROWS = 16384, 256                              # short neighbouring axes are joined up to this length


@dataclass(frozen=True)
class Grid:
    """Arrays by symbol over the points of a grid, with one number of dimensions.

    An array has length 1 along an axis on which it does not vary.

    Parameters
    ----------
    shape : tuple of int
        what the arrays broadcast to
    merged : tuple of int
        the shape of the same points, neighbouring axes joined if every array allows it; two axes at least
    values : dict
        floats, by symbol
    exact : dict
        the numbers themselves, as objects, for symbols whose floats are only near
    """

    shape: tuple[int, ...]
    merged: tuple[int, ...]
    values: dict[Symbol, Array]
    exact: dict[Symbol, Array]

    @cached_property
    def axes(self) -> dict[Symbol, Axes]:
        """The axes of the merged grid along which each symbol varies."""
        return {s: frozenset(i for i, n in enumerate(a.shape) if n > 1) for s, a in self.values.items()}

    @cached_property
    def full(self) -> Axes:
        """The axes of the merged grid along which it has more than one point."""
        return frozenset(i for i, n in enumerate(self.merged) if n > 1)

    @property
    def whole(self) -> Slices:
        """All of the merged grid as one block."""
        return tuple(slice(0, n) for n in self.merged)

    @cached_property
    def strange(self) -> dict[Symbol, Array]:
        """Where the numbers of a name are NaN or infinite, for names that have such numbers."""
        found = {s: ~np.isfinite(a) for s, a in self.values.items()
                 if s not in self.exact and not all_finite(a)}
        for name, numbers in self.exact.items():
            where = np.frompyfunc(lambda x: isinstance(x, float), 1, 1)(numbers).astype(bool)
            if where.any():
                found[name] = where
        return found

    def apart_from(self, out: Array) -> "Grid":
        """Return the same grid, in which arrays that may share memory with another are copies.

        So what is written to the other is not read.
        """
        return replace(self, values={s: a.copy() if np.may_share_memory(a, out) else a
                                     for s, a in self.values.items()})

    def index(self, place: Sequence[int]) -> tuple[int, ...]:
        """Return where in the result a place of the merged grid lies."""
        flat = np.ravel_multi_index(tuple(place), self.merged)
        return tuple(int(i) for i in np.unravel_index(flat, self.shape)) if self.shape else ()

    def blocks(self, points: int) -> list[list[Slices]]:
        """Return tiles of the last two axes, each with its blocks along the others.

        A block has about so many points.
        """
        *outer, rows, columns = self.merged
        if 0 in self.merged:
            return []
        # at least eight rows in a block, so that what varies with the column is read eight times at least
        width = min(columns, max(points // 8, 1))
        height = min(rows, max(points // width, 1))
        places = list(product(*(range(n) for n in outer)))
        return [[(*(slice(i, i + 1) for i in place), slice(row, min(row + height, rows)),
                  slice(column, min(column + width, columns)))
                 for place in places] for column in range(0, columns, width)
                for row in range(0, rows, height)]

    def at(self, block: Slices, rows: Array, columns: Array) -> "Grid":
        """Return the points at these rows and columns of a block, in a row."""
        count = len(rows)
        return Grid((count,), (1, count), *({s: gathered(last(cut(a, block)), rows, columns).reshape(1, -1)
                                             for s, a in arrays.items()}
                                            for arrays in (self.values, self.exact)))

    def numbers(self, symbols: Collection[Symbol]) -> Iterable[tuple[Any, ...]]:
        """Yield the numbers of some symbols, point after point.

        They are doubles, or exact numbers if the doubles are only near.
        """
        if not symbols:
            return repeat((), prod(self.merged))
        return zip(*(np.broadcast_to(self.exact.get(s, self.values[s]), self.merged).ravel().tolist()
                     for s in symbols))


def cut(array: Array, block: Slices) -> Array:
    """Return the part of an array in a block."""
    return array[tuple(s if n > 1 else slice(None) for s, n in zip(block, array.shape))]


def gathered(array: Array, rows: Array, columns: Array) -> Array:
    """Return entries of rows and columns in a row.

    An axis along which the array is constant has one place.
    """
    if array.size > 1:
        array = array[rows if array.shape[0] > 1 else 0, columns if array.shape[1] > 1 else 0]
    return array.reshape(-1)


def places(where: Array) -> tuple[Array, Array]:
    """Return the rows and columns where an array is true.

    The array is read as one row, because numpy.nonzero takes several times as long for two axes as for one.
    """
    rows, columns = np.divmod(np.flatnonzero(where), where.shape[1])
    return rows, columns


def last(array: Array) -> Array:
    """Return an array of a block as rows and columns; the axes before have length 1."""
    return array.reshape(array.shape[-2:] if array.ndim > 1 else (1, 1))


def grid_of(values: Mapping[str, Any], kind: Any = np.float64, finite: bool = True) -> Grid:
    """Return the grid of named numbers and arrays.

    Parameters
    ----------
    values : mapping of name to array or number
        floats, integers, or objects: Fraction, SymPy numbers
    kind : NumPy type
        the type of the floats
    finite : bool
        whether NaN and infinities are refused

    Returns
    -------
    Grid

    Raises
    ------
    ValuesError
        an array is not of real finite numbers, has masked ones, or other labels than another; shapes do not
        broadcast
    """
    check_plain(values)
    read = {symbol(str(name)): read_entry(str(name), value, kind, finite) for name, value in values.items()}
    try:
        shape = np.broadcast_shapes(*(floats.shape for floats, _ in read.values()))
    except ValueError:
        shapes = ", ".join(f"{s} {floats.shape}" for s, (floats, _) in read.items() if floats.shape)
        raise ValuesError(f"the arrays do not broadcast: {shapes}; give shapes that agree, such as (n, 1) "
                          "and (m,) for a grid") from None
    read = {s: (_base(floats), None if exact is None else _base(exact))
            for s, (floats, exact) in read.items()}
    groups = _groups(shape, [floats.shape for floats, _ in read.values()])

    def merge(array: Array) -> Array:
        full = (1,) * (len(shape) - array.ndim) + array.shape
        return array.reshape([prod(full[i] for i in group) for group in groups])

    merged = tuple(prod(shape[i] for i in group) for group in groups)
    return _widened(Grid(shape, merged, {s: merge(floats) for s, (floats, _) in read.items()},
                         {s: merge(exact) for s, (_, exact) in read.items() if exact is not None}))


def _widened(grid: Grid) -> Grid:
    """Return the grid with short last axes joined, so that columns, and then rows, are worth a loop.

    Few numbers are repeated.
    """
    for last_of_pair, most in ((1, COLUMNS), (2, ROWS)):
        while (place := len(grid.merged) - last_of_pair - 1) >= 0 and len(grid.merged) > 2:
            pair = grid.merged[place:place + 2]
            if prod(pair) > most or not _apart(grid, place):
                break
            shape = (*grid.merged[:place], prod(pair), *grid.merged[place + 2:])
            both = ({s: _joined(a, place, pair) for s, a in arrays.items()}
                    for arrays in (grid.values, grid.exact))
            grid = Grid(grid.shape, shape, *both)
    return grid


def _joined(array: Array, place: int, pair: tuple[int, ...]) -> Array:
    """Return an array with two axes joined, along which it is repeated if it varies along one of them."""
    before, here, after = array.shape[:place], array.shape[place:place + 2], array.shape[place + 2:]
    if here == (1, 1):
        return array.reshape(*before, 1, *after)
    return np.broadcast_to(array, (*before, *pair, *after)).reshape(*before, prod(pair), *after)


def _apart(grid: Grid, place: int) -> bool:
    """Tell whether two neighbouring axes can be joined without repeating many numbers.

    Each array varies along both of them, or along neither, or along nothing else.
    """
    pair = {place, place + 1}
    return all(along >= pair or along <= pair or not along & pair for along in grid.axes.values())


def _base(array: Array) -> Array:
    """Return an array without the axes along which it was broadcast before."""
    repeated = [step == 0 and n > 1 for step, n in zip(array.strides, array.shape)]
    if not any(repeated):
        return array
    return array[tuple(slice(0, 1) if again else slice(None) for again in repeated)]


def _groups(shape: tuple[int, ...], shapes: list[tuple[int, ...]]) -> list[list[int]]:
    """Return neighbouring axes in groups, on each of which every array varies along all axes or along none.

    Empty groups stand in front, so that there are two.
    """
    varies = [(1,) * (len(shape) - len(s)) + s for s in shapes]
    groups: list[list[int]] = []
    for axis, n in enumerate(shape):
        same = groups and n > 1 and all((s[axis] > 1) == (s[groups[-1][-1]] > 1) for s in varies)
        if same or (groups and n == 1):
            groups[-1].append(axis)
        else:
            groups.append([axis])
    return [[] for _ in range(2 - len(groups))] + groups
