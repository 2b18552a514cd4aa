"""Proved verdicts on arrays and on boxes of parameters."""
from collections.abc import Iterable, Mapping, Sequence
from functools import reduce
from itertools import chain
from typing import Any

import numpy as np
from sympy import Expr

from ..algebra.floats import Array
from ..algebra.polynomials import Ring
from ..algebra.precision import ONE_AT_A_TIME
from ..errors import ArgumentError, ValuesError, optional, require
from ..stability.conditions import Condition, Criterion
from ..stability.report import Report, Verdict
from ..stability.values import check_family
from .boxes import BoxDecision, certified_chart, certify_box
from .grids import Block, Grid, cut, grid_of, last, places
from .numeric import NUMBA_BLOCK, NUMPY_BLOCK, in_threads, prepared
from .paving import CertifiedChart
from .proofs import ABSENT as INVALID
from .proofs import STABLE, UNDECIDED, UNSTABLE
from .signs import UNKNOWN, ArraySigns, exact_number

__all__ = ["BoxDecision", "certified_chart", "CertifiedChart", "certify_box", "CODES", "INVALID", "STABLE",
           "UNDECIDED", "UNSTABLE",
           "verdicts"]
CODES = {Verdict.STABLE: STABLE, Verdict.UNDECIDED: UNDECIDED, Verdict.UNSTABLE: UNSTABLE}


def verdicts(report: Report, values: Mapping[str, Any] | None = None, /, *, invalid: str = "raise",
             backend: str = "numpy",
             threads: int = 1, out: Array | None = None, **arrays: Any) -> Array:
    """The exact verdict at every point of a grid.

    What Report.verdict says of each point, near the speed of the margin in doubles: those decide where they
    are further from 0 than a proved bound of their error, balls and rationals decide the rest, and on the
    boundary the ladder does. A float is the dyadic rational that it is.

    Parameters
    ----------
    report : Report
    values, arrays : name to number or array
        float64, float32, integers, or objects: Fraction, SymPy numbers; they broadcast. Arrays of shapes (n,
        1) and (m,) make a grid, which is fastest. The eliminated name is omitted
    invalid : str
        "raise", or "mark": where the equilibrium does not exist, or a number is not finite
    backend : str
        "numpy", or "numba" (extra fast)
    threads : int
    out : array or None
        of int8, to write to; it may overlap the arrays given

    Returns
    -------
    array of int8
        STABLE = 1, UNSTABLE = −1, UNDECIDED = 0, INVALID = −2

    Raises
    ------
    ValuesError
        names are missing or unknown, shapes disagree, a number is not finite, or the equilibrium does not
        exist at a point: the first such index is named

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    >>> verdicts(top, I1=1, m0=1, l=np.array([[0.0], [0.5]]), pi3_0=np.array([-2.0, 1.0, 1.5, 2.0]))
    array([[ 1, -1, -1,  1],
           [-1, -1,  1,  1]], dtype=int8)
    """
    require(report, Report, "the report")
    if invalid not in ("raise", "mark"):
        raise ArgumentError(f"invalid = {invalid!r} is neither 'raise' nor 'mark': choose one")
    if backend not in ("numpy", "numba"):
        raise ArgumentError(f"backend = {backend!r} is neither 'numpy' nor 'numba': choose one")
    if backend == "numba":
        optional("numba", "fast")
    require(values or {}, Mapping, "what is given by name")
    given = {str(name): value for name, value in {**(values or {}), **arrays}.items()}
    grid = grid_for(report, given, finite=invalid == "raise")
    result = prepared(out, grid.shape, np.int8)
    grid = grid.apart_from(result)
    merged = result.reshape(grid.merged)
    blocks = grid.blocks(NUMBA_BLOCK if backend == "numba" else NUMPY_BLOCK)
    firsts = in_threads(lambda some: _Worker(report, grid, backend).fill(some, merged), blocks, threads)
    if invalid == "raise" and (bad := [first for first in firsts if first is not None]):
        place = min(bad)
        block = tuple(slice(i, i + 1) for i in place)
        (numbers,) = grid.at(block, np.zeros(1, int), np.zeros(1, int)).numbers(grid.values)
        why = f"{report.equilibrium.label} does not exist there"
        try:
            report.verdict(dict(zip((s.name for s in grid.values), map(exact_number, numbers))))
        except ValuesError as error:
            why = str(error)
        raise ValuesError(f"at index {grid.index(place)}: {why}; or ask for such points to be marked, "
                          "invalid=\"mark\"")
    return result


def grid_for(report: Report, given: Mapping[str, Any], finite: bool = True) -> Grid:
    """The grid of the names given, all that a verdict needs and no other."""
    check_family(report.equilibrium, given, report.required, report.parameters,
                 "give a number or an array for each")
    return grid_of(given, finite=finite)


class _Worker:
    """Fills blocks with verdicts, on one thread."""

    def __init__(self, report: Report, grid: Grid, backend: str):
        self.report, self.grid, self.backend = report, grid, backend
        self.known: dict[Expr, ArraySigns] = {}
        eq = report.equilibrium
        self.positive = [self._signs(e) for e in (*eq.existence(),
                                                  *(s for s in grid.values if s.is_positive))]
        self.nonzero = [self._signs(e) for e in _denominators(eq.field_values)
                        if e.free_symbols <= grid.values.keys()]
        self.zero = [self._signs(e) for e in eq.constraints]
        self.unsafe = [a for a in map(grid.strange, grid.values) if a is not None]
        sufficient, necessary = report.sufficient.alternatives, report.necessary.alternatives
        self.alone = _single(sufficient) if _single(sufficient) == _single(necessary) else None

    def _signs(self, expression: Expr) -> ArraySigns:
        if expression not in self.known:
            self.known[expression] = ArraySigns(expression, self.grid, self.backend, [])
        return self.known[expression]

    def fill(self, tiles: Iterable[Sequence[Block]], result: Array) -> tuple[int, ...] | None:
        """Write the verdicts; the first place where the equilibrium does not exist."""
        first: tuple[int, ...] | None = None
        for block in chain.from_iterable(tiles):
            out = result[block][(0,) * (result.ndim - 2)]
            with np.errstate(all="ignore"):            # overflow is a value here
                nowhere = self._nowhere(block)
                self._decide(block, out, nowhere)
                out[np.broadcast_to(self._doubtful(block), out.shape)] = UNDECIDED
            if nowhere is not None:
                out[np.broadcast_to(nowhere, out.shape)] = INVALID
                here = _place(block, *np.argwhere(out == INVALID)[0])
                first = here if first is None else min(first, here)
        return first

    def _nowhere(self, block: Block) -> Array | None:
        """Where the equilibrium does not exist, or a number is not finite; None: nowhere in the block."""
        wrong = [last(cut(a, block)) for a in self.unsafe]
        wrong += [signs(block) < 1 for signs in self.positive] + [signs(block) == 0 for signs in self.nonzero]
        wrong += [abs(signs(block)) == 1 for signs in self.zero]
        found = [w for w in wrong if w.any()]
        return reduce(np.logical_or, found) if found else None

    def _doubtful(self, block: Block) -> Array:
        """Where it is not proved that the equilibrium exists."""
        return reduce(np.logical_or, [signs(block) == UNKNOWN for signs in (*self.positive, *self.zero)],
                      np.zeros((1, 1), bool))

    def _decide(self, block: Block, out: Array, nowhere: Array | None) -> None:
        """Write the verdicts in a block."""
        if self.alone is not None:
            signs = self._signs(self.alone)
            if (found := signs(block, out)) is not out:
                out[...] = found
            if signs.sufficed:
                return
            between = out == 0
            out[out == UNKNOWN] = UNDECIDED
        else:
            sufficient, necessary = (self._holds(c, block)
                                     for c in (self.report.sufficient, self.report.necessary))
            out[...] = np.where(sufficient > 0, STABLE, np.where(necessary < 0, UNSTABLE, UNDECIDED))
            between = np.broadcast_to((sufficient < 0) & (necessary > 0), out.shape)
        if nowhere is not None:
            between = between & ~nowhere
        if between.any():
            rows, columns = places(between)
            with ONE_AT_A_TIME:
                out[rows, columns] = self._between(self.grid.at(block, rows, columns))

    def _between(self, grid: Grid) -> Array | list[int]:
        """Verdicts at points between the two criteria.

        By the ladder of the boundary, or one by one where there is none.
        """
        boundary = self.report.boundary
        if boundary is None:
            names = [s.name for s in grid.values]
            return [CODES[self.report.verdict(dict(zip(names, map(exact_number, numbers)))).verdict]
                    for numbers in grid.numbers(grid.values)]
        found = np.full(grid.shape, UNDECIDED, dtype=np.int8)
        left = np.arange(len(found))
        for rung in boundary.decisive():
            if not rung.condition.symbols <= grid.values.keys():
                return found
            signs = _signs_of(rung.condition,
                              grid.at((slice(0, 1), slice(0, len(found))), np.zeros_like(left), left))
            unknown = (signs == UNKNOWN) | (signs == 0)
            found[left] = np.where(unknown, UNDECIDED,
                                   np.where((signs > 0) & (not rung.escapes), STABLE, UNSTABLE))
            left = left[signs == 0]
            if not len(left):
                return found
        if boundary.last is not None:
            found[left] = UNSTABLE
        return found

    def _holds(self, criterion: Criterion, block: Block) -> Array:
        """1 where the criterion holds, −1 where it does not, 0 where that is not proved."""
        groups = [reduce(np.minimum, [self._condition(c, block) for c in group], np.ones((1, 1), np.int8))
                  for group in criterion.alternatives]
        return reduce(np.maximum, groups, -np.ones((1, 1), np.int8))

    def _condition(self, condition: Condition, block: Block) -> Array:
        margin = self._signs(condition.margin)(block)
        factors = [self._signs(factor)(block) for factor in condition.degenerate]
        vanishes = reduce(np.logical_or, [f == 0 for f in factors], np.zeros((1, 1), bool))
        unsure = reduce(np.logical_or, [f == UNKNOWN for f in factors], margin == UNKNOWN)
        if condition.strict:
            holds = np.where((margin <= 0) | vanishes, -1, 1)
            return np.where(unsure & (holds > 0), 0, holds)
        holds = np.where((margin >= 0) & (margin != UNKNOWN) | vanishes, 1, -1)
        return np.where(unsure & (holds < 0), 0, holds)


def _signs_of(condition: Condition, grid: Grid) -> Array:
    """The sign of a condition at points in a row, 0 where an even factor vanishes."""
    whole = (slice(0, 1), slice(0, grid.shape[0]))
    signs, *factors = (np.broadcast_to(ArraySigns(e, grid, "numpy", [])(whole)[0], grid.shape)
                       for e in (condition.margin, *condition.degenerate))
    for factor in factors:
        signs = np.where(factor == 0, 0, np.where((factor == UNKNOWN) & (signs != 0), UNKNOWN, signs))
    return signs


def _place(block: Block, row: int, column: int) -> tuple[int, ...]:
    """The place in the merged grid of a row and column of a block."""
    return (*(s.start for s in block[:-2]), block[-2].start + int(row), block[-1].start + int(column))


def _single(alternatives: Sequence[Sequence[Condition]]) -> Expr | None:
    """The margin that decides alone, None if there is no such."""
    conditions = list(chain.from_iterable(alternatives))
    return (
        conditions[0].margin
        if len(alternatives) == len(conditions) == 1 and not conditions[0].degenerate
        else None
    )


def _denominators(values: Sequence[Expr]) -> list[Expr]:
    """What must not vanish for U and its derivatives to be finite."""
    found = []
    for value in values:
        ring = Ring([value])
        bottom = ring.fraction(value)[1]
        if not bottom.is_constant():
            found.append(ring.expression(bottom))
    return list(dict.fromkeys(found))

