"""Writes results block by block, on threads: values, comparisons and what joins them."""
import operator
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import count
from typing import Any

import numpy as np
from sympy import Expr, Symbol

from ...algebra.enclosures.floats import Array, in_floats
from ...errors import ValuesError, require
from ...stability.criteria.truth import Relation
from ..grids import Grid, Slices, cut
from ..programs.kernels import Kernel
from ..programs.straightline import program_of
from ..programs.tiles import Tiles
from ..progress import Told

# points of a block: for NumPy a few buffers fit a core's cache; for Numba a call is short beside the loop
NUMPY_BLOCK, NUMBA_BLOCK = 2**17, 2**20
Writer = Callable[[Slices, Array], None]                # writes a block of a result
# Numba compiles values and tests of margins, not those of even factors, which are few and short
_COMPILED: dict[Relation | None, str] = {None: "{0}", operator.gt: "{0} > 0", operator.ge: "{0} >= 0"}
_COMPARED: dict[Relation, np.ufunc] = {operator.gt: np.greater, operator.ge: np.greater_equal,
                                       operator.ne: np.not_equal, operator.eq: np.equal}


def writer(expression: Expr, relation: Relation | None, grid: Grid, backend: str, kind: Any,
           spent: list[float]) -> Writer:
    """Return what writes the value of an expression into a block of the result, or its relation to 0."""
    def read(leaf: Expr, block: Slices) -> Array:
        if isinstance(leaf, Symbol):
            return cut(grid.values[leaf], block)
        here = {s: cut(grid.values[s], block) for s in leaf.free_symbols}
        return np.asarray(in_floats(leaf, np, here), dtype=kind)

    tiles = Tiles(program_of(expression, grid.axes), grid.full, read, kind)
    if backend == "numba" and tiles.inner and relation in _COMPILED:
        return Kernel(tiles, [_COMPILED[relation]], spent)

    def write(block: Slices, out: Array) -> None:
        if relation is not None:
            _COMPARED[relation](tiles.value(block), 0, out=out)
        elif (value := tiles.value(block, out)) is not out:
            out[...] = value

    return write


def joined(operation: np.ufunc, writers: Iterable[Writer]) -> Writer:
    """Return what writes where all hold, by np.logical_and, or where one holds, by np.logical_or."""
    given = list(writers)
    if len(given) == 1:
        return given[0]

    def write(block: Slices, out: Array) -> None:
        if not given:
            out[...] = operation.identity
            return
        given[0](block, out)
        other = np.empty_like(out)
        for another in given[1:]:
            another(block, other)
            operation(out, other, out=out)

    return write


def prepared(out: Array | None, shape: tuple[int, ...], kind: Any) -> Array:
    """Return the array to write to: the one given, if it fits, or a new one."""
    if out is None:
        return np.empty(shape, dtype=kind)
    require(out, np.ndarray, "out")
    if out.shape != shape or out.dtype != kind or not out.flags.carray:
        kept = "" if out.flags.carray else ", and is read-only or not C-contiguous"
        raise ValuesError(f"out has shape {out.shape}, type {out.dtype}{kept}; the result has shape "
                          f"{shape}, type {np.dtype(kind)}: pass an array made by np.empty")
    return out


def in_threads(work: Callable[[Iterable[Any]], Any], tasks: Sequence[Any], threads: int,
               told: Told = lambda done, total: None) -> list[Any]:
    """Return the results of the work on equal shares of the tasks; told is called when one is done."""
    numbers = count(1)

    def counted(share: Iterable[Any]) -> Iterator[Any]:
        for task in share:
            yield task
            told(next(numbers), len(tasks))

    if threads <= 1 or len(tasks) <= 1:
        return [work(counted(tasks))]
    with ThreadPoolExecutor(threads) as pool:
        return list(pool.map(work, [counted(tasks[i::threads]) for i in range(threads)]))
