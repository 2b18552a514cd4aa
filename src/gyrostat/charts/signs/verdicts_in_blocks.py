"""Makes verdicts in the blocks of a grid: proved signs of margins, and the ladder between criteria."""
from collections.abc import Iterable, Sequence
from functools import lru_cache, reduce
from itertools import chain, repeat
from typing import NamedTuple

import numpy as np
from sympy import Expr

from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import ONE_AT_A_TIME
from ...algebra.rings.polynomials import Ring
from ...stability.criteria.conditions import Condition
from ...stability.criteria.orientation_form import orientation_form
from ...stability.decision import Rung
from ...stability.report.report import Report
from ...stability.theorems.boundary import Boundary
from ...stability.theorems.two_directions import may_lie_on_curve, open_between
from ..codes import CODE_OF, INVALID, RUNGS, STABLE, UNDECIDED, UNSTABLE
from ..grids import Grid, Slices, cut, last, places
from ..programs.quotients import plainly_positive
from .criteria_codes import OPEN, CriteriaCodes, single_margin
from .grid_signs import TOGETHER, UNKNOWN, ArraySigns, dyadic_rational, may_vanish
from .stabilized_points import held


class Demands(NamedTuple):
    """What has to be positive, not 0, and 0 for the equilibrium to exist; the margin that decides alone."""

    positive: tuple[Expr, ...]
    nonzero: tuple[Expr, ...]
    zero: tuple[Expr, ...]
    alone: Expr | None


def demands_of(report: Report, grid: Grid, damped: bool) -> Demands:
    """Return the demands of a report on the numbers of a grid."""
    eq, alone = report.equilibrium, None if damped else single_margin(report.sufficient)
    denominators = _denominators(tuple(eq.field_values))
    return Demands((*eq.existence(), *(s for s in grid.values if s.is_positive)),
                   tuple(e for e in denominators if e.free_symbols <= grid.values.keys()),
                   tuple(eq.constraints),
                   alone if alone is not None and alone == single_margin(report.necessary) else None)


class Decided:
    """The verdicts of a report over a grid, written block by block on one thread.

    If there are rungs, of the merged shape, what decided each point between the two criteria is written, too.
    """

    def __init__(self, report: Report, grid: Grid, backend: str, damped: bool = False,
                 rungs: Array | None = None, demands: Demands | None = None):
        self.report, self.grid, self.damped, self.rungs = report, grid, damped, rungs
        self.stays_open = not damped and open_between(report.equilibrium)
        sufficient, necessary = ((report.damped,) * 2 if damped else (report.sufficient, report.necessary))
        self.codes = CriteriaCodes(sufficient, necessary, grid, backend, report.closed)
        demands = demands or demands_of(report, grid, damped)
        positive, nonzero, zero = ([*map(self.codes.signs, group)] for group in (
            [e for e in demands.positive if not _all_positive(e, grid)], demands.nonzero, demands.zero))
        self.positive = [a for a in positive if a.everywhere() != 1]
        self.nonzero = [a for a in nonzero if a.everywhere() not in (1, -1)]
        self.zero = [a for a in zero if a.everywhere() != 0]
        self.unsafe = [*grid.strange.values()]

    def fill(self, tiles: Iterable[Sequence[Slices]], result: Array) -> tuple[int, ...] | None:
        """Write the verdicts, and return the first place where the equilibrium does not exist."""
        first: tuple[int, ...] | None = None
        for block in chain.from_iterable(tiles):
            out = result[block][(0,) * (result.ndim - 2)]
            with np.errstate(all="ignore"):            # overflow is a value here
                nowhere = self._nowhere(block)
                self._decide(block, out, nowhere)
                if (doubtful := self._doubtful(block)) is not None:
                    out[np.broadcast_to(doubtful, out.shape)] = UNDECIDED
            if nowhere is not None:
                out[np.broadcast_to(nowhere, out.shape)] = INVALID
                here = _place(block, *np.argwhere(out == INVALID)[0])
                first = here if first is None else min(first, here)
        return first

    def _nowhere(self, block: Slices) -> Array | None:
        """Return where the equilibrium does not exist, or a number is not finite; None if nowhere."""
        wrong = [last(cut(a, block)) for a in self.unsafe]
        wrong += [signs(block) < 1 for signs in self.positive] + [signs(block) == 0 for signs in self.nonzero]
        wrong += [abs(signs(block)) == 1 for signs in self.zero]
        return _where_one(wrong)

    def _doubtful(self, block: Slices) -> Array | None:
        """Return where it is not proved that the equilibrium exists; None if nowhere."""
        return _where_one([signs(block) == UNKNOWN for signs in (*self.positive, *self.zero)])

    def _decide(self, block: Slices, out: Array, nowhere: Array | None) -> None:
        """Write the verdicts in a block."""
        decided = self.codes(block, out)
        if decided and not self.damped:
            return
        if self.damped:                                # an exception, or no exception: unstable
            out[out == OPEN] = UNSTABLE                # where its only margin is 0 the criterion fails, too
            between = (out == UNSTABLE) & self._exceptional(block)
        else:
            between = out == OPEN
        if (unknown := out == UNKNOWN).any():
            out[unknown] = UNDECIDED
            if self.report.closed is not None:         # only the margins as they are written prove no sign
                between = between | unknown
        if nowhere is not None:
            between = between & ~nowhere
        if self.stays_open and between.any():              # but on a closed curve, where K is degenerate
            between = between & self._on_curve(block)
        if between.any():
            rows, columns = places(between)
            for start in range(0, len(rows), TOGETHER):
                at = rows[start:start + TOGETHER], columns[start:start + TOGETHER]
                with ONE_AT_A_TIME:
                    out[at], rungs = self._between(self.grid.at(block, *at))
                if self.rungs is not None:
                    self.rungs[block][(0,) * (self.rungs.ndim - 2)][at] = rungs

    def _on_curve(self, block: Slices) -> Array:
        """Return where a satellite may lie on a closed curve of equilibria."""
        if not may_lie_on_curve(eq := self.report.equilibrium):
            return np.zeros((1, 1), bool)
        determinant = orientation_form(eq).stiffness.det(method="berkowitz")
        return may_vanish(self.codes.signs(eq.insert(determinant))(block))

    def open(self, block: Slices) -> Array:
        """Return where it is proved that the equilibrium exists and lies between the two criteria."""
        codes = np.empty([s.stop - s.start for s in block[-2:]], np.int8)
        self.codes(block, codes)
        found = codes == OPEN
        for excluded in (self._nowhere(block), self._doubtful(block)):
            found = found if excluded is None else found & ~excluded
        return found

    def _between(self, grid: Grid) -> tuple[Array | list[int], Array | list[int]]:
        """Return verdicts at points that the criteria leave open, and what decided each.

        The ladder of the boundary decides. If there is none, points that gyroscopic forces stabilise are
        decided together, and the others one by one.
        """
        boundary = self.report.boundary
        if boundary is not None and not self.damped:
            found = _climbed(boundary, grid, self.codes.alone)
            return found, np.full(len(found), RUNGS[Rung.REDUCED_MOTION])
        names = [s.name for s in grid.values]
        twists = repeat(0) if self.damped else held(self.report, grid)
        verdicts, rungs = list[int](), list[int]()
        for numbers, twist in zip(grid.numbers(grid.values), twists):
            if twist:
                verdict, rung = STABLE, RUNGS[Rung.TWIST_POSITIVE if twist > 0 else Rung.TWIST_NEGATIVE]
            else:
                values = dict(zip(names, map(dyadic_rational, numbers)))
                decision = self.report.verdict(values, self.damped)
                verdict, rung = CODE_OF[decision.verdict], RUNGS[decision.rung]
            verdicts.append(verdict)
            rungs.append(rung)
        return verdicts, rungs

    def _exceptional(self, block: Slices) -> Array:
        """Return where the form may be degenerate, or damping not reach all: all over if names are open."""
        standard = self.report.secular.standard
        if {*standard.counted_by} - {s.name for s in self.grid.values}:
            return np.ones((1, 1), bool)
        degenerate, *torques = standard.exceptions

        def one_may_vanish(factors: Sequence[Expr]) -> Array:
            return _some_of(may_vanish(self.codes.signs(e)(block)) for e in factors)

        unreached = np.ones((1, 1), bool)
        for torque in torques:
            if unreached.any():
                unreached = unreached & one_may_vanish(torque)
        return np.asarray(one_may_vanish(degenerate) | unreached)


def _all_positive(expression: Expr, grid: Grid) -> bool:
    """Tell whether an expression is a name with doubles that are all positive: the most common demand."""
    array = grid.values.get(expression)
    return array is not None and expression not in grid.exact and bool(array.min(initial=np.inf) > 0)


def _where_one(answers: Iterable[Array]) -> Array | None:
    """Return where one of them is true; None if nowhere."""
    found = [answer for answer in answers if answer.any()]
    return reduce(np.logical_or, found) if found else None


def _some_of(answers: Iterable[Array]) -> Array:
    """Return where one of them is true."""
    return reduce(np.logical_or, answers, np.zeros((1, 1), bool))


def _climbed(boundary: Boundary, grid: Grid, vanishing: Expr | None) -> Array:
    """Return verdicts at points in a row by the ladder of the boundary.

    Each rung decides at the points where all below it vanish, as a margin may be known to.
    """
    found = np.full(grid.shape, UNDECIDED, dtype=np.int8)
    left = np.arange(len(found))
    for rung in boundary.decisive():
        if not rung.condition.symbols <= grid.values.keys():
            return found
        if rung.condition.margin == vanishing:         # it is 0 here, and even factors do not change that
            continue
        signs = signs_in_row(rung.condition, grid.at(grid.whole, np.zeros_like(left), left))
        decided = np.where(rung.stable(signs), STABLE, UNSTABLE)
        found[left] = np.where(may_vanish(signs), UNDECIDED, decided)
        left = left[signs == 0]
        if not len(left):
            return found
    if boundary.last is not None:
        found[left] = UNSTABLE
    return found


def signs_in_row(condition: Condition, grid: Grid) -> Array:
    """Return the sign of a condition at points in a row, 0 where an even factor vanishes."""
    signs, *factors = (np.broadcast_to(ArraySigns(e, grid)(grid.whole)[0], grid.shape)
                       for e in (condition.margin, *condition.degenerate))
    for factor in factors:
        signs = np.where(factor == 0, 0, np.where((factor == UNKNOWN) & (signs != 0), UNKNOWN, signs))
    return signs


def _place(block: Slices, row: int, column: int) -> tuple[int, ...]:
    """Return the place in the merged grid of a row and column of a block."""
    return (*(s.start for s in block[:-2]), block[-2].start + int(row), block[-1].start + int(column))


@lru_cache(maxsize=256)
def _denominators(values: tuple[Expr, ...]) -> list[Expr]:
    """Return what must not vanish for U and its derivatives to be finite."""
    found: dict[Expr, None] = {}
    for value in values:
        ring = Ring([value])
        _, factors = ring.fraction(value)[1].factor()
        found |= dict.fromkeys(ring.expression(f) for f, _ in factors if not plainly_positive(ring, f))
    return [*found]
