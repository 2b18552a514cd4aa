"""Proves the signs of an expression on a grid: by floats with a proved bound, then by whole numbers.

With functions or exact numbers, balls and rationals take the place of whole numbers.
"""
from math import isfinite
from typing import Any

import numpy as np
from flint import arb
from sympy import Expr, Rational, Symbol

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import ONE_AT_A_TIME, own_precision
from ...algebra.enclosures.rationals import to_flint, to_sympy
from ...algebra.reals.exact import sign
from ..grids import Grid, Slices, gathered, places
from ..programs.kernels import SIGN, Kernel
from ..programs.rounding import error_bound, rounded
from ..programs.straightline import Named, program_of
from ..programs.tiles import Tiles
from .dyadic import dyadic_signs
from .leaves import PRECISION, Leaves, ball_of

UNKNOWN = 2                                            # no sign is proved
TOGETHER = 2**14                                       # points, of which all steps fit a cache


class ArraySigns:
    """The sign of an expression in the blocks of a grid: −1, 0, 1, or UNKNOWN; each is proved.

    Parameters
    ----------
    expression : Expr
        a polynomial in symbols, functions and constants, and in named numbers
    grid : Grid
    backend : str
        "numpy" or "numba"
    named : Named or None
        the numbers that have names
    """

    def __init__(self, expression: Expr, grid: Grid, backend: str = "numpy", named: Named | None = None):
        self.expression, self.grid, self.named = expression, grid, named
        program, leaves = program_of(expression, grid.axes, named), Leaves(grid)
        self.tiles = Tiles(program, grid.full, leaves.read)
        self.kernel = Kernel(self.tiles, [SIGN], []) if backend == "numba" and self.tiles.inner else None
        self.whole_numbers, self.roundings = leaves.in_whole_numbers(program), leaves.roundings(program)
        self.bound = float(error_bound(program, leaves.largest(program), self.roundings))
        self.kept: tuple[Any, Array] | None = None
        self.below = np.empty((0, 0), np.bool_)        # a buffer that all blocks of one shape use
        self.sufficed = False                          # whether the one bound was enough in the last block
        self.whole = program.steps[-1].axes == grid.full
        self.shape = tuple(n if i in program.steps[-1].axes else 1 for i, n in enumerate(grid.merged))

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
                self.kernel(block, out, [self.bound])
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
        exact = ExactSign(self.expression, self.named)
        with ONE_AT_A_TIME:
            return [exact(numbers) for numbers in points.numbers(exact.symbols)]

    def _bounded(self, leaves: dict[Any, Array], points: int) -> tuple[Array, Array]:
        """Return signs that doubles prove with a bound for each point in a row, else 0; and the bounds."""
        program = self.tiles.program
        computed: list[Any] = program.run(leaves.__getitem__, lambda c: np.full(1, rounded(c)[0]))
        bound = error_bound(program, {leaf: np.abs(x) for leaf, x in leaves.items()},
                            self.roundings, computed)
        signs = np.greater(computed[-1], bound).astype(np.int8) - np.less(computed[-1], -bound)
        return np.broadcast_to(signs, points).copy(), np.broadcast_to(bound, points)


class ExactSign:
    """The sign of one expression at one point after another: −1, 0, 1, or UNKNOWN.

    It is proved by balls of 128 bits. If they contain 0, it is proved by rationals, or, with functions and
    algebraic numbers, by balls of more bits, unless there are named numbers.
    """

    def __init__(self, expression: Expr, named: Named | None = None):
        self.expression, self.named = expression, named
        self.program = program_of(expression, {}, named)
        self.symbols = sorted({s for leaf in self.program.leaves for s in leaf.free_symbols}, key=str)
        self.rational = all(isinstance(leaf, Symbol) for leaf in self.program.leaves)

    def __call__(self, numbers: tuple[float | Expr, ...]) -> int:
        """Return the sign at the numbers of the symbols, in their order."""
        if not all(isfinite(x) for x in numbers if isinstance(x, float)):
            return UNKNOWN
        with own_precision(PRECISION):
            values = dict(zip(self.symbols, map(ball_of, numbers)))
            enclosure = self.program.run(lambda leaf: values[leaf] if leaf in values
                                         else ball(leaf, PRECISION, values),
                                         lambda c: arb(to_flint(c)))[-1]
        if enclosure > 0 or enclosure < 0:
            return 1 if enclosure > 0 else -1
        if self.rational and all(isinstance(x, (float, Rational)) for x in numbers):
            given = dict(zip(self.symbols, map(to_flint, numbers)))
            value = self.program.run(given.__getitem__, to_flint)[-1]
            return 1 if value > 0 else -1 if value < 0 else 0
        if self.named is not None:
            return UNKNOWN
        found = sign(self.expression, dict(zip(self.symbols, map(dyadic_rational, numbers))))
        return UNKNOWN if found is None else found


def may_vanish(signs: Array) -> Array:
    """Return where it is not proved that a sign is not 0."""
    return (signs == 0) | (signs == UNKNOWN)


def dyadic_rational(x: float | Expr) -> Expr:
    """Return the number that a double is."""
    return to_sympy(x) if isinstance(x, float) else x
