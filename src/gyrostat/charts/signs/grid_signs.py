"""Proves the signs of an expression on a grid: by floats with a proved bound, then by whole numbers.

With functions or exact numbers, balls and rationals take the place of whole numbers.
"""
from functools import lru_cache
from math import isfinite
from typing import Any

import numpy as np
from flint import arb
from sympy import Expr, Integer, Rational, Symbol

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import ONE_AT_A_TIME, own_precision
from ...algebra.enclosures.rationals import to_flint, to_sympy
from ...algebra.reals.exact import compiled, sign
from ..grids import Grid, Slices, cut, gathered, places
from .dyadic import dyadic_signs
from .given_columns import largest_size
from .kernels import SIGN, Kernel
from .rounding import error_bound, rounded
from .straightline import Program, program_of
from .tiles import Tiles

UNKNOWN = 2                                            # no sign is proved
TOGETHER = 2**14                                       # points, of which all steps fit a cache
PRECISION = 128                                        # bits of the first balls

# a function is computed in balls, and its middle is rounded to a double: two roundings at most
_ROUNDINGS = 2


class ArraySigns:
    """The sign of an expression in the blocks of a grid: −1, 0, 1, or UNKNOWN; each is proved.

    Parameters
    ----------
    expression : Expr
        a polynomial in symbols, functions and constants
    grid : Grid
    backend : str
        "numpy" or "numba"
    """

    def __init__(self, expression: Expr, grid: Grid, backend: str = "numpy"):
        self.expression, self.grid = expression, grid
        program = program_of(expression, grid.axes)
        self.tiles = Tiles(program, grid.full, self._read)
        self.kernel = Kernel(self.tiles, SIGN, []) if backend == "numba" and self.tiles.inner else None
        with ONE_AT_A_TIME:
            largest = {leaf: self._largest(leaf) for leaf in program.leaves}
        self.whole_numbers = _in_whole_numbers(program, grid)
        self.bound = float(error_bound(program, largest, _roundings(program, grid)))
        self.kept: tuple[Any, Array] | None = None
        self.below = np.empty((0, 0), np.bool_)        # a buffer that all blocks of one shape use
        self.sufficed = False                          # whether the one bound was enough in the last block
        self.whole = program.steps[-1].axes == grid.full
        self.shape = tuple(n if i in program.steps[-1].axes else 1 for i, n in enumerate(grid.merged))

    def _read(self, leaf: Expr, block: Slices) -> Array:
        with ONE_AT_A_TIME:
            return _floats(leaf, {s: cut(array, block) for s, array in _arrays(leaf, self.grid).items()})

    def _largest(self, leaf: Expr) -> float:
        """Return at least the size of a leaf wherever it is known.

        Nothing is known beforehand about a function that varies along all axes.
        """
        arrays, full = _arrays(leaf, self.grid), self.grid.full
        along = frozenset().union(*(self.grid.axes[s] for s in arrays))
        if full and along == full and not isinstance(leaf, Symbol):
            return float("inf")
        return largest_size(_floats(leaf, arrays))

    def __call__(self, block: Slices, out: Array | None = None) -> Array:
        """Return the signs in a block, of as many rows and columns as the expression varies along.

        What does not change from one block to the next is kept.
        """
        key = None if self.whole else [(s.start, s.stop) for s, n in zip(block, self.shape) if n > 1]
        if key is not None and self.kept is not None and self.kept[0] == key:
            return self.kept[1]
        signs = self.empty(block) if out is None or key is not None else out
        self.filtered(block, signs)
        self.sufficed = bool(np.bitwise_and.reduce(signs, axis=None) & 1)      # 1 and −1 are odd
        if not self.sufficed:
            with np.errstate(all="ignore"):
                self._decide(block, signs)
        self.kept = (key, signs) if key is not None else None
        return signs

    def everywhere(self) -> int | None:
        """Return the sign of an expression that is the same at all points; None if it varies."""
        if any(n != 1 for n in self.shape):
            return None
        return int(self(self.grid.whole).item())

    def empty(self, block: Slices) -> Array:
        """Return an array for the signs in a block."""
        return np.empty([s.stop - s.start if n > 1 else 1 for s, n in zip(block[-2:], self.shape[-2:])],
                        dtype=np.int8)

    def filtered(self, block: Slices, out: Array) -> None:
        """Write the signs that floats prove with one bound for the whole grid, and 0 elsewhere."""
        with np.errstate(all="ignore"):
            if self.kernel is not None:
                self.kernel(block, out, self.bound)
                return
            value = self.tiles.value(block)
            if self.below.shape != value.shape:
                self.below = np.empty(value.shape, np.bool_)
            np.greater(value, self.bound, out=out.view(np.bool_))
            np.less(value, -self.bound, out=self.below)
        np.subtract(out, self.below.view(np.int8), out=out)

    def _decide(self, block: Slices, signs: Array) -> None:
        """Decide what is 0 in a block, some points at a time.

        A bound for each point comes first, then whole numbers, then one point after another.
        """
        program = self.tiles.program
        leaves = {step.value: self.tiles.small(i, block)
                  for i, step in enumerate(program.steps) if step.operation == "leaf"}
        unsure = places(signs == 0)
        for start in range(0, len(unsure[0]), TOGETHER):
            rows, columns = (place[start:start + TOGETHER] for place in unsure)
            here = {leaf: gathered(a, rows, columns) for leaf, a in leaves.items()}
            found, bound = self._bounded(here, len(rows))
            # there abs(computed) ≤ bound, so that the exact value is at most twice the bound
            left = np.flatnonzero(found == 0)
            if len(left) and self.whole_numbers:
                found[left], known = dyadic_signs(program, {s: x[left] if len(x) > 1 else x
                                                            for s, x in here.items()}, 2 * bound[left])
                left = left[~known]
            if len(left):
                found[left] = self._one_by_one(self.grid.at(block, rows[left], columns[left]))
            signs[rows, columns] = found

    def _one_by_one(self, points: Grid) -> list[int]:
        exact = ExactSign(self.expression)
        with ONE_AT_A_TIME:
            return [exact(numbers) for numbers in points.numbers(exact.symbols)]

    def _bounded(self, leaves: dict[Any, Array], points: int) -> tuple[Array, Array]:
        """Return signs that doubles prove with a bound for each point in a row, else 0; and the bounds."""
        program = self.tiles.program
        computed: list[Any] = program.run(leaves.__getitem__, lambda c: np.full(1, rounded(c)[0]))
        bound = error_bound(program, {leaf: np.abs(x) for leaf, x in leaves.items()},
                            _roundings(program, self.grid), computed)
        signs = np.greater(computed[-1], bound).astype(np.int8) - np.less(computed[-1], -bound)
        return np.broadcast_to(signs, points).copy(), np.broadcast_to(bound, points)


class ExactSign:
    """The sign of one expression at one point after another: −1, 0, 1, or UNKNOWN.

    It is proved by balls of 128 bits. If they contain 0, it is proved by rationals, or, with functions and
    algebraic numbers, by balls of more bits.
    """

    def __init__(self, expression: Expr):
        self.expression = expression
        self.symbols = sorted(expression.free_symbols, key=str)
        self.program = program_of(expression, {})
        self.polynomial = compiled(expression)         # a margin has no denominator

    def __call__(self, numbers: tuple[float | Expr, ...]) -> int:
        """Return the sign at the numbers of the symbols, in their order."""
        if not all(isfinite(x) for x in numbers if isinstance(x, float)):
            return UNKNOWN
        with own_precision(PRECISION):
            values = dict(zip(self.symbols, map(_ball_of, numbers)))
            enclosure = self.program.run(lambda leaf: values[leaf] if leaf in values
                                         else ball(leaf, PRECISION, values),
                                         lambda c: arb(to_flint(c)))[-1]
        if enclosure > 0 or enclosure < 0:
            return 1 if enclosure > 0 else -1
        if self.polynomial is None or not all(isinstance(x, (float, Rational)) for x in numbers):
            found = sign(self.expression, dict(zip(self.symbols, map(dyadic_rational, numbers))))
            return UNKNOWN if found is None else found
        given = dict(zip(self.symbols, map(to_flint, numbers)))
        value = self.polynomial[1](*(given[s] for s in self.polynomial[0]))
        return 1 if value > 0 else -1 if value < 0 else 0


def may_vanish(signs: Array) -> Array:
    """Return where it is not proved that a sign is not 0."""
    return (signs == 0) | (signs == UNKNOWN)


def dyadic_rational(x: float | Expr) -> Expr:
    """Return the number that a double is."""
    return to_sympy(x) if isinstance(x, float) else x


def _ball_of(x: float | Expr) -> arb:
    return arb(x) if isinstance(x, float) else ball(x, PRECISION)


def _in_whole_numbers(program: Program, grid: Grid) -> bool:
    """Tell whether all that is read is doubles, and the coefficients are whole."""
    return all(leaf in grid.values and leaf not in grid.exact for leaf in program.leaves) and all(
        isinstance(step.value, Integer) for step in program.steps if step.operation == "constant")


def _roundings(program: Program, grid: Grid) -> dict[Expr, int]:
    """Return how many roundings are behind each leaf."""
    return {leaf: _ROUNDINGS for leaf in program.leaves if not isinstance(leaf, Symbol) or leaf in grid.exact}


def _arrays(leaf: Expr, grid: Grid) -> dict[Symbol, Array]:
    """Return the numbers of a leaf.

    A symbol has doubles; a function has the exact numbers, if the doubles are only near.
    """
    return {s: grid.values[s] if s is leaf else grid.exact.get(s, grid.values[s]) for s in leaf.free_symbols}


def _floats(leaf: Expr, arrays: dict[Symbol, Array]) -> Array:
    """Return a leaf in doubles: the array of a symbol, or a function, computed in balls and rounded.

    It is NaN where the function is not known that well.
    """
    if isinstance(leaf, Symbol):
        return arrays[leaf]
    symbols = sorted(leaf.free_symbols, key=str)
    shape = np.broadcast_shapes((1, 1), *(arrays[s].shape for s in symbols))
    rows = zip(*(np.broadcast_to(arrays[s], shape).ravel().tolist() for s in symbols))
    return np.array([_near(leaf, tuple(symbols), row) for row in rows] if symbols
                    else [_near(leaf, (), ())]).reshape(shape)


@lru_cache(maxsize=2**16)
def _near(leaf: Expr, symbols: tuple[Symbol, ...], numbers: tuple[float | Expr, ...]) -> float:
    """Return a double within two roundings of a function."""
    enclosure = ball(leaf, PRECISION, {s: _ball_of(x) for s, x in zip(symbols, numbers)})
    if not enclosure.is_finite() or enclosure.rel_accuracy_bits() < 60 and enclosure != 0:
        return float("nan")
    near = float(enclosure.mid())
    return near if abs(near) >= 2.0**-1022 or enclosure == 0 else float("nan")
