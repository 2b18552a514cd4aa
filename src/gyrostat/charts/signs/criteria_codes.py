"""Tells in every block of a grid where a sufficient criterion holds, and where a necessary one fails."""
import operator
from collections.abc import Callable, Iterable
from functools import lru_cache
from math import isfinite

import numpy as np
from sympy import Expr

from ...algebra.enclosures.floats import Array
from ...stability.criteria.conditions import Criterion
from ...stability.criteria.truth import Relation, truth
from ..codes import STABLE, UNSTABLE
from ..grids import Grid, Slices, places
from ..programs.kernels import Kernel
from ..programs.rounding import error_bounds
from ..programs.straightline import Named, programs_of
from ..programs.tiles import Tiles
from .grid_constants import with_constants
from .grid_signs import TOGETHER, UNKNOWN, ArraySigns
from .leaves import Leaves
from .three_valued import answered, every, some

OPEN = 0                                               # both criteria leave it open


class CriteriaCodes:
    """STABLE where a sufficient criterion holds, UNSTABLE where a necessary one fails, OPEN between them.

    Each of these is proved; elsewhere the code is UNKNOWN. With Numba one loop writes the codes that doubles
    prove with one bound for each margin, and the margins of the necessary criterion are only computed in
    runs of points where those of the sufficient one do not decide. Signs of each margin decide the rest.

    Parameters
    ----------
    sufficient, necessary : Criterion
    grid : Grid
    backend : str
        "numpy" or "numba"
    named : Named or None
        the numbers by which the margins are written
    """

    def __init__(self, sufficient: Criterion, necessary: Criterion, grid: Grid, backend: str,
                 named: Named | None = None):
        self.sufficient, self.necessary, self.grid, self.named = sufficient, necessary, grid, named
        self.alone = _alone(sufficient, necessary)
        self.known: dict[Expr, ArraySigns] = {}
        self.backend = backend
        self.kernel = self._compiled() if backend == "numba" else None

    def __call__(self, block: Slices, out: Array) -> bool:
        """Write the codes in a block, and tell whether STABLE or UNSTABLE is proved everywhere."""
        if self.kernel is None:
            return self._by_signs(block, out)
        self.kernel(block, out)
        if _decided(out):
            return True
        rows, columns = places(out == UNKNOWN)
        for start in range(0, len(rows), TOGETHER):
            at = rows[start:start + TOGETHER], columns[start:start + TOGETHER]
            points = self.grid.at(block, *at)
            found = np.empty(points.merged, np.int8)
            CriteriaCodes(self.sufficient, self.necessary, points, "numpy", self.named)(points.whole, found)
            out[at] = found[0]
        return _decided(out)

    def signs(self, expression: Expr) -> ArraySigns:
        """Return the signs of an expression over the grid."""
        if expression not in self.known:
            self.known[expression] = ArraySigns(with_constants(expression, self.grid), self.grid,
                                                self.backend, self.named)
        return self.known[expression]

    def _by_signs(self, block: Slices, out: Array) -> bool:
        """Write the codes by the signs of each margin, and tell the same."""
        if self.alone is not None:                     # where it vanishes, both criteria leave it open
            signs = self.signs(self.alone)
            if (found := signs(block, out)) is not out:
                out[...] = found
            return signs.sufficed or _decided(out)
        holds = self.holds(self.sufficient, block)
        if (holds > 0).all():
            out[...] = STABLE
            return True
        necessary = self.holds(self.necessary, block)
        out[...] = np.where(holds > 0, STABLE, np.where(necessary < 0, UNSTABLE, np.where(
            (holds < 0) & (necessary > 0), OPEN, UNKNOWN)))
        return _decided(out)

    def holds(self, criterion: Criterion, block: Slices) -> Array:
        """Return 1 where a criterion holds, −1 where it does not, 0 where that is not proved."""
        def compare(expression: Expr, relation: Relation) -> Array:
            signs = self.signs(expression)(block)
            known, holds = signs != UNKNOWN, relation(signs, 0)
            return answered(known & holds, known & ~holds)

        return truth(criterion, compare, every, some)

    def _compiled(self) -> Callable[[Slices, Array], None] | None:
        """Return the loop that writes what doubles prove; None if there is nothing to do at each point."""
        first, later = (dict.fromkeys(_expressions(c)) for c in (self.sufficient, self.necessary))
        margins = tuple(with_constants(e, self.grid) for e in {**first, **later})
        if not margins:
            return None
        program, leaves = programs_of(margins, self.grid.axes, self.named), Leaves(self.grid)
        tiles = Tiles(program, self.grid.full, leaves.read)
        bounds = [*map(float, error_bounds(program, leaves.largest(program), leaves.roundings(program)))]
        if not tiles.inner or not all(isfinite(bound) for bound in bounds[:len(first)]):
            return None
        kernel = Kernel(tiles, _stages(self.sufficient, self.necessary, program.results), [], UNKNOWN)
        return lambda block, out: kernel(block, out, bounds)


@lru_cache(maxsize=256)
def _stages(sufficient: Criterion, necessary: Criterion, results: tuple[int, ...]) -> tuple[str, ...]:
    """Return the codes as expressions in the results {n} of a program, one for each margin, and bounds e{n}.

    If the sufficient criterion does not have all margins, a stage by those that it has comes first.
    """
    first, later = (dict.fromkeys(_expressions(c)) for c in (sufficient, necessary))
    place = {e: n for n, e in enumerate({**first, **later})}
    at_first = {results[place[e]] for e in first}

    def code(computed: Callable[[int], bool]) -> str:
        def proved(tests: dict[Relation, str]) -> Callable[[Expr, Relation], str]:
            return lambda e, relation: (tests.get(relation, "False") if computed(place[e])
                                        else "False").replace("?", str(place[e]))

        holds = proved({operator.gt: "({?} > e?)", operator.ge: "({?} > e?)", operator.ne: "(abs({?}) > e?)"})
        fails = proved({operator.gt: "({?} < -e?)", operator.ge: "({?} < -e?)",
                        operator.eq: "(abs({?}) > e?)"})
        stable, unstable = truth(sufficient, holds, _and, _or), truth(necessary, fails, _or, _and)
        if _alone(sufficient, necessary) is not None:
            return f"{STABLE} if {stable} else {UNSTABLE} if {unstable} else {UNKNOWN}"
        between = _and([truth(sufficient, fails, _or, _and), truth(necessary, holds, _and, _or)])
        return (f"{STABLE} if {stable} else {UNSTABLE} if {unstable} else {OPEN} if {between} "
                f"else {UNKNOWN}")

    whole = code(lambda n: True)
    return (code(lambda n: results[n] in at_first), whole) if at_first < {*results} else (whole,)


def single_margin(criterion: Criterion) -> Expr | None:
    """Return the margin that decides alone, None if there is no such margin."""
    return None if criterion.only is None else criterion.only.margin


def _alone(sufficient: Criterion, necessary: Criterion) -> Expr | None:
    """Return the margin that decides alone in both criteria, None if there is no such margin."""
    margin = single_margin(sufficient)
    return margin if margin is not None and margin == single_margin(necessary) else None


def _expressions(criterion: Criterion) -> list[Expr]:
    return [e for alternative in criterion.alternatives for c in alternative
            for e in (c.margin, *c.degenerate)]


def _decided(codes: Array) -> bool:
    """Tell whether all codes are STABLE or UNSTABLE: these are odd, the others are even."""
    return bool(np.bitwise_and.reduce(codes, axis=None) & 1)


def _and(tests: Iterable[str]) -> str:
    return f"({' & '.join(given)})" if (given := list(tests)) else "True"


def _or(tests: Iterable[str]) -> str:
    return f"({' | '.join(given)})" if (given := list(tests)) else "False"
