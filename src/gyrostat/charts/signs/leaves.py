"""Reads what programs start from on a grid: symbols as they are given, functions rounded to doubles."""
from functools import lru_cache

import numpy as np
from flint import arb
from sympy import Expr, Integer, Symbol

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import ONE_AT_A_TIME
from ..grids import Grid, Slices, cut
from ..programs.straightline import Program
from .given_columns import largest_size

PRECISION = 128                                        # bits of the first balls

# a function is computed in balls, and its middle is rounded to a double: two roundings at most
_ROUNDINGS = 2


class Leaves:
    """The leaves of programs over the points of a grid.

    Parameters
    ----------
    grid : Grid
    """

    def __init__(self, grid: Grid):
        self.grid = grid

    def read(self, leaf: Expr, block: Slices) -> Array:
        """Return a leaf in a block."""
        if isinstance(leaf, Symbol):
            return cut(self.grid.values[leaf], block)
        with ONE_AT_A_TIME:
            return _floats(leaf, {s: cut(array, block) for s, array in self._arrays(leaf).items()})

    def largest(self, program: Program) -> dict[Expr, float]:
        """Return at least the size of each leaf of a program wherever it is known.

        Nothing is known beforehand about a function that varies along all axes.
        """
        return {leaf: largest_size(self.grid.values[leaf]) if isinstance(leaf, Symbol) else
                self._largest(leaf) for leaf in program.leaves}

    def _largest(self, leaf: Expr) -> float:
        arrays, full = self._arrays(leaf), self.grid.full
        along = frozenset().union(*(self.grid.axes[s] for s in arrays))
        if full and along == full:
            return float("inf")
        with ONE_AT_A_TIME:
            return largest_size(_floats(leaf, arrays))

    def roundings(self, program: Program) -> dict[Expr, int]:
        """Return how many roundings are behind each leaf of a program."""
        return {leaf: _ROUNDINGS for leaf in program.leaves
                if not isinstance(leaf, Symbol) or leaf in self.grid.exact}

    def in_whole_numbers(self, program: Program) -> bool:
        """Tell whether all that a program reads is doubles, and its coefficients are whole."""
        constants = (step.value for step in program.steps if step.operation == "constant")
        return all(isinstance(value, Integer) for value in constants) and all(
            leaf in self.grid.values and leaf not in self.grid.exact for leaf in program.leaves)

    def _arrays(self, leaf: Expr) -> dict[Symbol, Array]:
        """Return the numbers of a function: the exact ones, if the doubles are only near."""
        grid = self.grid
        return {s: grid.exact.get(s, grid.values[s]) for s in leaf.free_symbols}


def ball_of(x: float | Expr) -> arb:
    """Return the ball of a number."""
    return arb(x) if isinstance(x, float) else ball(x, PRECISION)


def _floats(leaf: Expr, arrays: dict[Symbol, Array]) -> Array:
    """Return a function in doubles, computed in balls and rounded.

    It is NaN where the function is not known that well.
    """
    symbols = sorted(leaf.free_symbols, key=str)
    shape = np.broadcast_shapes((1, 1), *(arrays[s].shape for s in symbols))
    rows = zip(*(np.broadcast_to(arrays[s], shape).ravel().tolist() for s in symbols))
    return np.array([_near(leaf, tuple(symbols), row) for row in rows] if symbols
                    else [_near(leaf, (), ())]).reshape(shape)


@lru_cache(maxsize=2**16)
def _near(leaf: Expr, symbols: tuple[Symbol, ...], numbers: tuple[float | Expr, ...]) -> float:
    """Return a double within two roundings of a function."""
    enclosure = ball(leaf, PRECISION, {s: ball_of(x) for s, x in zip(symbols, numbers)})
    if not enclosure.is_finite() or enclosure.rel_accuracy_bits() < 60 and enclosure != 0:
        return float("nan")
    near = float(enclosure.mid())
    return near if abs(near) >= 2.0**-1022 or enclosure == 0 else float("nan")
