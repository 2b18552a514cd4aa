"""Results written block by block: values, comparisons and what joins them, on threads."""
import operator
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import count
from typing import Any

import numpy as np
from sympy import Expr

from ...algebra.enclosures.floats import Array, in_floats
from ...errors import ValuesError, require
from ...stability.criteria.truth import Relation
from ..grids import Grid, Slices, cut
from ..progress import Told
from .kernels import Finish, Kernel
from .straightline import program_of
from .tiles import Tiles

# points: a few buffers fit a core's cache; a call is short beside the loop
NUMPY_BLOCK, NUMBA_BLOCK = 2**17, 2**20
Writer = Callable[[Slices, Array], None]                # writes a block of a result


def writer(margin: Expr, grid: Grid, finish: Finish, backend: str, kind: Any,
           spent: list[float]) -> Writer:
    """What writes the value of a margin, or a test of it, into a block of the result."""
    tiles = tiles_of(margin, grid, kind)
    if backend == "numba" and tiles.inner:
        return Kernel(tiles, finish, spent)

    def write(block: Slices, out: Array) -> None:
        if finish == "value":
            value = tiles.value(block, out)
            if value is not out:
                out[...] = value
        else:
            (np.greater if finish == "positive" else np.greater_equal)(tiles.value(block), 0, out=out)

    return write


def factor_writer(factor: Expr, grid: Grid, relation: Relation, kind: Any) -> Writer:
    """What writes whether an even factor stands in a relation to 0."""
    tiles = tiles_of(factor, grid, kind)
    compared = np.not_equal if relation is operator.ne else np.equal

    def write(block: Slices, out: Array) -> None:
        compared(tiles.value(block), 0, out=out)

    return write


def every_of(writers: Iterable[Writer]) -> Writer:
    """What writes where all hold."""
    return _joined(list(writers), np.logical_and, True)


def some_of(writers: Iterable[Writer]) -> Writer:
    """What writes where one holds."""
    return _joined(list(writers), np.logical_or, False)


def _joined(writers: Sequence[Writer], operation: np.ufunc, none: bool) -> Writer:
    if len(writers) == 1:
        return writers[0]

    def write(block: Slices, out: Array) -> None:
        if not writers:
            out[...] = none
            return
        writers[0](block, out)
        other = np.empty_like(out)
        for another in writers[1:]:
            another(block, other)
            operation(out, other, out=out)

    return write


def tiles_of(margin: Expr, grid: Grid, kind: Any = np.float64) -> Tiles:
    """The program of a margin over a grid."""
    def read(leaf: Expr, block: Slices) -> Array:
        here = {s: cut(grid.values[s], block) for s in leaf.free_symbols}
        return np.asarray(in_floats(leaf, np, here), dtype=kind)

    full = frozenset(i for i, n in enumerate(grid.merged) if n > 1)
    return Tiles(program_of(margin, grid.axes), full, read, kind)


def prepared(out: Array | None, shape: tuple[int, ...], kind: Any) -> Array:
    """The array to write to: the one given, if it fits, or a new one."""
    if out is None:
        return np.empty(shape, dtype=kind)
    require(out, np.ndarray, "out")
    if out.shape != shape or out.dtype != kind or not out.flags.carray:
        kept = "" if out.flags.carray else ", and is read-only or not C-contiguous"
        raise ValuesError(f"out has shape {out.shape}, type {out.dtype}{kept}; the result has shape "
                          f"{shape}, type {np.dtype(kind)}: "
                          "pass an array made by np.empty")
    return out


def in_threads(work: Callable[[Iterable[Any]], Any], tasks: Sequence[Any], threads: int,
               told: Told = lambda done, total: None) -> list[Any]:
    """The results of the work on equal shares of the tasks; told is called when one is done."""
    numbers = count(1)

    def counted(share: Iterable[Any]) -> Iterator[Any]:
        for task in share:
            yield task
            told(next(numbers), len(tasks))

    if threads <= 1 or len(tasks) <= 1:
        return [work(counted(tasks))]
    with ThreadPoolExecutor(threads) as pool:
        return list(pool.map(work, [counted(tasks[i::threads]) for i in range(threads)]))
