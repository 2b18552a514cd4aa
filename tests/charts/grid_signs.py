"""Signs over a grid, in blocks and point by point."""
from fractions import Fraction

import numpy as np
from sympy import Rational

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign
from gyrostat.charts.grids import grid_of
from gyrostat.charts.signs.grid_signs import UNKNOWN, ArraySigns


def signs_of(expression, values, backend="numpy", points=100, finite=True):
    """The signs over the grid of the values, in blocks."""
    grid = grid_of(values, finite=finite)
    found, result = ArraySigns(expression, grid, backend), np.full(grid.merged, 9, dtype=np.int8)
    for tile in grid.blocks(points):
        for block in tile:
            with np.errstate(all="ignore"):
                result[block][(0,) * (result.ndim - 2)][...] = found(block)
    return result.reshape(grid.shape)


def exactly(expression, values):
    """The sign at every point, by sign of exact.py."""
    names, full = list(values), np.broadcast_arrays(*(np.asarray(v, dtype=object) for v in values.values()))
    result = np.empty(full[0].shape, dtype=np.int8)
    for index in np.ndindex(result.shape):
        point = {gs.symbol(n): Rational(*a[index].as_integer_ratio())
                 if isinstance(a[index], (float, Fraction, int)) else a[index]
                 for n, a in zip(names, full)}
        found = sign(expression, point)
        result[index] = UNKNOWN if found is None else found
    return result
