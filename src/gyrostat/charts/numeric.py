"""Margins and criteria as functions of named arrays: NumPy in blocks, Numba, or any array namespace."""
import operator
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import reduce
from itertools import chain
from types import ModuleType
from typing import Any

import numpy as np
from sympy import Expr

from ..algebra.floats import Array, in_floats
from ..errors import ArgumentError, ValuesError, optional, require
from ..notation import own
from ..stability.conditions import Condition, Criterion
from ..stability.values import check_names, names_in
from .grids import Block, Grid, cut, grid_of
from .kernels import Finish, Kernel
from .labels import check_plain
from .rounding import rounded
from .straightline import program_of
from .tiles import Tiles

# points: a few buffers fit a core's cache; a call is short beside the loop
NUMPY_BLOCK, NUMBA_BLOCK = 2**17, 2**20


class CompiledMargin:
    """A margin or criterion as a function of named arrays.

    Calling it ----------

    Attributes
    ----------
    names : tuple of str
        the arrays that it takes
    backend : str
        "numpy", "numba", or the name of the namespace
    **arrays : array-like
        one for each name; they broadcast as in NumPy. Arrays of shapes (n, 1) and (m,) make a grid, and
        nothing is computed again along an axis on which it does not depend. float32 throughout gives float32
    out : array or None
        where to write; C-contiguous, of the shape of the result; it may overlap the arrays given. Of NumPy
        and Numba
    threads : int
        blocks are shared out among them
    """

    def __init__(self, conditions: Sequence[Sequence[Condition]], margin: Expr | None,
                 backend: str | ModuleType):
        self._conditions, self._margin = conditions, margin
        parts = [margin] if margin is not None else [x for group in conditions for c in group
                                                     for x in (c.margin, *c.degenerate)]
        self.names = names_in(parts)
        self.backend = backend if isinstance(backend, str) else backend.__name__
        self._spent: list[float] = []
        self._namespace = None if isinstance(backend, str) else backend

    @property
    def compile_seconds(self) -> float:
        """Seconds spent so far on compiling, or on reading from disk what was compiled before."""
        return sum(self._spent)

    def __call__(self, *, out: Array | None = None, threads: int = 1, **arrays: Any) -> Any:
        check_names(arrays, self.names, "this margin" if self._margin is not None else "this criterion")
        if self._namespace is not None:
            if out is not None:
                raise ArgumentError(f"out is written to by NumPy and Numba, not by {self.backend}: leave "
                                    "it out, and keep what is returned")
            check_plain(arrays)
            return self._everywhere(self._namespace, arrays)
        used = {name: arrays[name] for name in self.names}
        single = bool(used) and all(getattr(a, "dtype", None) == np.float32
                                    for a in used.values() if np.ndim(a))
        kind = np.float32 if single and any(np.ndim(a) for a in used.values()) else np.float64
        with np.errstate(all="ignore"):
            grid = grid_of(used, kind)
        result = prepared(out, grid.shape, kind if self._margin is not None else np.bool_)
        grid = grid.apart_from(result)
        merged = result.reshape(grid.merged)
        blocks = grid.blocks(NUMBA_BLOCK if self.backend == "numba" else NUMPY_BLOCK)

        def work(some: Iterable[list[Block]]) -> None:
            write = self._writer(grid, kind)
            with np.errstate(all="ignore"):            # overflow is a value here
                for block in chain.from_iterable(some):
                    write(block, merged[block][(0,) * (merged.ndim - 2)])

        in_threads(work, blocks, threads)
        return result if grid.shape or out is not None else result[()]

    def _writer(self, grid: Grid, kind: Any) -> Callable[[Block, Array], None]:
        """What fills a block."""
        if self._margin is not None:
            return filler(self._margin, grid, "value", self.backend, kind, self._spent)
        groups = [[self._condition(c, grid, kind) for c in group] for group in self._conditions]
        if len(groups) == 1 and len(groups[0]) == 1:
            return groups[0][0]

        def write(block: Block, out: Array) -> None:
            each, some = np.empty_like(out), np.empty_like(out)
            out[...] = False
            for group in groups:
                some[...] = True
                for fill in group:
                    fill(block, each)
                    np.logical_and(some, each, out=some)
                np.logical_or(out, some, out=out)

        return write

    def _condition(self, condition: Condition, grid: Grid, kind: Any) -> Callable[[Block, Array], None]:
        finish: Finish = "positive" if condition.strict else "nonnegative"
        fill = filler(condition.margin, grid, finish, self.backend, kind, self._spent)
        if not condition.degenerate:
            return fill
        factors = [tiles_of(x, grid, kind) for x in condition.degenerate]

        def write(block: Block, out: Array) -> None:
            fill(block, out)
            for factor in factors:
                value = factor.value(block)
                if condition.strict:
                    np.logical_and(out, value != 0, out=out)
                else:
                    np.logical_or(out, value == 0, out=out)

        return write

    def _everywhere(self, xp: ModuleType, arrays: Mapping[str, Any]) -> Any:
        """The whole result at once, in another namespace."""
        kinds = [a.dtype for a in (arrays[name] for name in self.names) if hasattr(a, "dtype")
                 and xp.isdtype(a.dtype, "real floating")]
        kind = xp.result_type(*kinds) if kinds else xp.asarray(1.0).dtype
        given = {name: xp.asarray(arrays[name], dtype=kind) for name in self.names}
        if self._margin is not None:
            return _in_namespace(self._margin, xp, given)
        groups = []
        for group in self._conditions:
            each = []
            for c in group:
                margin = _in_namespace(c.margin, xp, given)
                each.append(reduce(operator.and_ if c.strict else operator.or_, [
                    _in_namespace(x, xp, given) != 0 if c.strict else _in_namespace(x, xp, given) == 0
                    for x in c.degenerate],
                    margin > 0 if c.strict else margin >= 0))
            groups.append(reduce(operator.and_, each, xp.asarray(True)))
        return reduce(operator.or_, groups, xp.asarray(False))


def compile_margin(what: Condition | Criterion | Expr, backend: str | ModuleType = "numpy") -> CompiledMargin:
    """A function of named arrays: the values of a margin, or where a criterion holds.

    Parameters
    ----------
    what : Condition, Criterion or Expr
        a condition stands for its margin [its dimension], a criterion for a bool
    backend : str or module
        "numpy"; "numba" (extra fast); or a namespace of the array API standard, such as jax.numpy

    Returns
    -------
    CompiledMargin

    Raises
    ------
    ValuesError, when it is called
        names are missing or unknown, an array is not of finite real numbers, shapes disagree
    MissingExtraError
        Numba is not installed

    Examples
    --------
    >>> import gyrostat as gs
    >>> report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    >>> stable = compile_margin(report.sufficient)
    >>> stable.names
    ('I1', 'l', 'm0', 'pi3_0')
    >>> stable(I1=1, m0=1, l=np.array([[-1.0], [1.0]]), pi3_0=np.array([0.0, 1.0, 2.0]))
    array([[False, False, False],
           [False, False,  True]])
    """
    if isinstance(backend, str) and backend not in ("numpy", "numba"):
        raise ArgumentError(f"backend = {backend!r} is none that there is: use 'numpy', 'numba' or a "
                            "module such as array_api_strict")
    if backend == "numba":
        optional("numba", "fast")
    if isinstance(what, Condition):
        return CompiledMargin((), what.margin, backend)
    if isinstance(what, Criterion):
        return CompiledMargin(what.alternatives, None, backend)
    if isinstance(what, Expr):
        return CompiledMargin((), own(what), backend)
    raise ArgumentError(f"what to compile is a {type(what).__name__}, not a Condition or a Criterion: pass "
                        "report.sufficient, say")


def filler(margin: Expr, grid: Grid, finish: Finish, backend: str, kind: Any,
           spent: list[float]) -> Callable[[Block, Array], None]:
    """What writes the value of a margin, or a test of it, into a block of the result."""
    tiles = tiles_of(margin, grid, kind)
    if backend == "numba" and tiles.inner:
        return Kernel(tiles, finish, spent)

    def write(block: Block, out: Array) -> None:
        if finish == "value":
            value = tiles.value(block, out)
            if value is not out:
                out[...] = value
        else:
            (np.greater if finish == "positive" else np.greater_equal)(tiles.value(block), 0, out=out)

    return write


def tiles_of(margin: Expr, grid: Grid, kind: Any = np.float64) -> Tiles:
    """The program of a margin over a grid."""
    def read(leaf: Expr, block: Block) -> Array:
        here = {s: cut(grid.values[s], block) for s in leaf.free_symbols}
        return np.asarray(in_floats(leaf, np, here), dtype=kind)

    full = frozenset(i for i, n in enumerate(grid.merged) if n > 1)
    return Tiles(program_of(margin, grid.axes), full, read, kind)


def _in_namespace(margin: Expr, xp: ModuleType, given: Mapping[str, Any]) -> Any:
    arrays = {s: given[s.name] for s in margin.free_symbols}
    kind = next(iter(given.values())).dtype if given else None
    dimensions = max((a.ndim for a in arrays.values()), default=0)
    axes = {s: frozenset(i + dimensions - a.ndim for i, n in enumerate(a.shape) if n != 1)
            for s, a in arrays.items()}
    return program_of(margin, axes).run(lambda leaf: in_floats(leaf, xp, arrays),
                                        lambda c: xp.asarray(rounded(c)[0], dtype=kind), xp)[-1]


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


def in_threads(work: Callable[[Iterable[Any]], Any], tasks: Sequence[Any], threads: int) -> list[Any]:
    """The results of the work on equal shares of the tasks."""
    require(threads, int, "threads")
    if threads <= 1 or len(tasks) <= 1:
        return [work(tasks)]
    with ThreadPoolExecutor(threads) as pool:
        return list(pool.map(work, [tasks[i::threads] for i in range(threads)]))
