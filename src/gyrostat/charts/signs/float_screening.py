"""Screens a list of points by floats: one look at its columns, after which few points are left."""
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import chain

import numpy as np
from sympy import Expr, Symbol

from ...algebra.enclosures.floats import Array
from ...algebra.rings.polynomials import Ring
from ...stability.report.report import Report
from ..grids import Grid, Slices, cut
from ..programs.kernels import assignments, function_of
from ..programs.rounding import LARGEST, error_bound, rounded
from ..programs.straightline import Program, program_of
from .block_writing import NUMBA_BLOCK, NUMPY_BLOCK
from .given_columns import largest_size
from .verdicts_in_blocks import Decided, Demands

SAMPLE, ROOM = 64, 1.5                                 # so many numbers tell the size of most, with a factor
HIGHEST = 32                                           # degree up to which a bound has room for that factor


class Screen:
    """The verdicts of a report at points that have a number of their own for each name, or one for all.

    Some numbers of each column tell how large they are; if the degree is high, all of them do. A point whose
    numbers are not much larger, and whose signs floats prove with the bound that belongs to that size, is
    decided in one loop. Everything else about it is known by then: that its numbers are finite, and that the
    equilibrium exists. All other points are left to Decided.

    Parameters
    ----------
    report : Report
    grid : Grid
        a list, as screened says
    demands : Demands
    """

    def __init__(self, report: Report, grid: Grid, demands: Demands):
        self.report, self.grid = report, grid
        assert demands.alone is not None
        sampled = _degree(demands.alone) <= HIGHEST
        largest = {s: _largest(a, sampled) for s, a in grid.values.items()}
        tests = [*((e, "{0} > {1}") for e in demands.positive),
                 *((e, "abs({0}) > {1}") for e in demands.nonzero),
                 (demands.alone, "({0} > {1}) - ({0} < -{1})")]
        programs = [(program_of(e, grid.axes), test) for e, test in tests]
        self.bounds = [float(error_bound(program, {leaf: largest[leaf] for leaf in program.leaves}, {}))
                       for program, _ in programs]
        self.limits = [largest[s] for s in grid.values]
        self.function = function_of(_source(grid, programs))

    def blocks(self, threads: int) -> list[list[Slices]]:
        """Return long runs of points, a share for each thread at least."""
        points = self.grid.merged[1]
        length = min(-(-points // max(threads, 1)), NUMBA_BLOCK)
        return [[(slice(0, 1), slice(start, min(start + length, points)))]
                for start in range(0, points, length)]

    def fill(self, tiles: Iterable[Sequence[Slices]], result: Array) -> tuple[int, ...] | None:
        """Write the verdicts, and return the first place where the equilibrium does not exist."""
        left = [np.empty(0, int)]
        for block in chain.from_iterable(tiles):
            out = result[block].reshape(-1)
            self.function(*(np.ascontiguousarray(cut(a, block).reshape(-1)) if a.size > 1 else a.item()
                            for a in self.grid.values.values()), *self.limits, *self.bounds, out)
            left.append(np.flatnonzero(out == 0) + block[-1].start)
        columns = np.concatenate(left)
        if not len(columns):
            return None
        points = self.grid.at(self.grid.whole, np.zeros_like(columns), columns)
        found = np.empty(points.merged, np.int8)
        first = Decided(self.report, points, "numpy").fill(points.blocks(NUMPY_BLOCK), found)
        result[0, columns] = found[0]
        return None if first is None else (0, int(columns[first[-1]]))


def screened(grid: Grid, demands: Demands) -> bool:
    """Tell whether it is a list of doubles, and one margin without functions decides."""
    if demands.alone is None or demands.zero or grid.exact or len(grid.merged) != 2 or grid.merged[1] < 2:
        return False
    return all(a.size == 1 or a.shape == grid.merged for a in grid.values.values()) and all(
        isinstance(leaf, Symbol) for e in (demands.alone, *demands.positive, *demands.nonzero)
        for leaf in program_of(e, grid.axes).leaves)


@lru_cache(maxsize=256)
def _degree(margin: Expr) -> int:
    """Return the degree of a margin in all its names."""
    return int(Ring([margin]).numerator(margin).total_degree())


def _largest(array: Array, sampled: bool) -> float:
    """Return at least the size of most numbers of a column, or of the one number; NaN if that is not finite.

    Places are multiples of the golden section: they do not repeat with any period that a column has.
    """
    if array.size == 1:
        return abs(array.item()) if np.isfinite(array.item()) else float("nan")
    if not sampled:
        return min(largest_size(array), LARGEST)
    places = np.arange(SAMPLE) * ((5**0.5 - 1) / 2) % 1 * array.size
    some = np.abs(array.reshape(-1)[places.astype(int)])
    return min(ROOM * float(np.max(some, initial=0.0, where=np.isfinite(some))), LARGEST)


def _source(grid: Grid, programs: Sequence[tuple[Program, str]]) -> str:
    """Return the source of the loop over the points of a block."""
    names: dict[Expr, str] = {s: f"a{i}[j]" if a.size > 1 else f"a{i}"
                              for i, (s, a) in enumerate(grid.values.items())}
    answers = [f"(abs({name}) <= c{i})" for i, name in enumerate(names.values())]
    lines: list[str] = []
    for k, (program, test) in enumerate(programs):
        steps = list(enumerate(program.steps))
        results = {i: names[step.value] if step.operation == "leaf"
                   else repr(min(rounded(step.value)[0], LARGEST))             # there is no bound beyond
                   for i, step in steps if not step.arguments}
        lines += assignments([(i, step) for i, step in steps if step.arguments], results, f"x{k}_")
        answers.append(f"({test.format(results[len(steps) - 1], f'e{k}')})")
    *known, sign = answers
    arguments = [f"{x}{i}" for x, n in (("a", len(names)), ("c", len(names)), ("e", len(programs)))
                 for i in range(n)]
    return "\n".join([f"def kernel({', '.join(arguments)}, out):", "    for j in range(out.shape[0]):",
                      *(f"        {line}" for line in lines),
                      f"        out[j] = {sign} * ({' & '.join(known)})", ""])
