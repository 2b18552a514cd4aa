"""Margins and criteria as functions of named arrays: NumPy in blocks, Numba, or any array namespace."""
import operator
from collections.abc import Iterable, Mapping
from functools import partial, reduce
from itertools import chain
from types import ModuleType
from typing import Any

import numpy as np
from sympy import Expr

from ...algebra.enclosures.floats import Array, in_floats
from ...arguments import checked
from ...errors import ArgumentError, optional
from ...notation import own
from ...stability.criteria.conditions import Condition, Criterion
from ...stability.criteria.numbers_asked import check_names, names_in
from ...stability.criteria.truth import Relation, truth
from ..grids import Grid, Slices, grid_of
from ..labels import check_plain
from ..programs.rounding import rounded
from ..programs.straightline import program_of
from .block_writing import NUMBA_BLOCK, NUMPY_BLOCK, Writer, in_threads, joined, prepared, writer


class CompiledMargin:
    """A margin or criterion as a function of named arrays, made by compile_margin.

    It is called with out=None, threads=1 and an array for each of its names, float64; they broadcast as in
    NumPy. Arrays of shapes (n, 1) and (m,) make a grid, and nothing is computed again along an axis on which
    it does not depend. If all are float32, the result is float32. With NumPy and Numba, out is where to
    write: an array, C-contiguous, of the shape of the result, which may overlap the arrays given; blocks are
    shared out among threads. names are the arrays that it takes; backend is "numpy", "numba", or the name of
    the namespace.

    Parameters
    ----------
    what : Criterion or Expr
        a criterion gives booleans, a margin its values
    backend : str or module
        as in compile_margin

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> ((condition,),) = gs.analyze(gs.upright(top)).sufficient.alternatives
    >>> margin = gs.charts.compile_margin(condition)
    >>> margin.names, margin(I1=1, l=0, m0=1, pi3_0=[1.0, 3.0])
    (('I1', 'l', 'm0', 'pi3_0'), array([-3.,  5.]))
    """

    def __init__(self, what: Criterion | Expr, backend: str | ModuleType):
        self._what = what
        self.names = names_in([what] if isinstance(what, Expr) else
                              [e for alternative in what.alternatives for c in alternative
                               for e in (c.margin, *c.degenerate)])
        self.backend = backend if isinstance(backend, str) else backend.__name__
        self._spent: list[float] = []
        self._namespace = None if isinstance(backend, str) else backend

    @property
    def compile_seconds(self) -> float:
        """The seconds spent so far on compiling, or on reading from disk what was compiled before."""
        return sum(self._spent)

    def __call__(self, *, out: Array | None = None, threads: int = 1, **arrays: Any) -> Any:
        """Return the values of the margin, or where the criterion holds, in the common shape of arrays.

        Parameters
        ----------
        **arrays : array-like
            one for each name; they broadcast as in NumPy. Arrays of shapes (n, 1) and (m,) make a grid, and
            nothing is computed again along an axis on which it does not depend. If all are float32, the
            result is float32
        out : array or None
            where to write, with NumPy and Numba; C-contiguous, of the shape of the result; it may overlap the
            arrays given; default a new array
        threads : int
            how many threads share the blocks; default 1

        Returns
        -------
        array
            floats [the dimension of the margin]; for a criterion bool

        Raises
        ------
        ValuesError
            names are missing or unknown, an array is not of finite real numbers, shapes disagree
        """
        check_names(arrays, self.names, "this margin" if isinstance(self._what, Expr) else "this criterion")
        if self._namespace is not None:
            if out is not None:
                raise ArgumentError(f"out is written to by NumPy and Numba, not by {self.backend}: leave "
                                    "it out, and keep what is returned")
            check_plain(arrays)
            return self._everywhere(self._namespace, arrays)
        used = {name: arrays[name] for name in self.names}
        several = [a for a in used.values() if getattr(a, "ndim", 0) or isinstance(a, list | tuple)]
        single = bool(several) and all(getattr(a, "dtype", None) == np.float32 for a in several)
        kind = np.float32 if single else np.float64
        with np.errstate(all="ignore"):
            grid = grid_of(used, kind)
        result = prepared(out, grid.shape, kind if isinstance(self._what, Expr) else np.bool_)
        grid = grid.apart_from(result)
        merged = result.reshape(grid.merged)
        blocks = grid.blocks(NUMBA_BLOCK if self.backend == "numba" else NUMPY_BLOCK)

        def work(some: Iterable[list[Slices]]) -> None:
            write = self._writer(grid, kind)
            with np.errstate(all="ignore"):            # overflow is a value here
                for block in chain.from_iterable(some):
                    write(block, merged[block][(0,) * (merged.ndim - 2)])

        in_threads(work, blocks, threads)
        return result if grid.shape or out is not None else result[()]

    def _writer(self, grid: Grid, kind: Any) -> Writer:
        """Return what fills a block."""
        def written(expression: Expr, relation: Relation | None) -> Writer:
            return writer(expression, relation, grid, self.backend, kind, self._spent)

        if isinstance(self._what, Expr):
            return written(self._what, None)
        return truth(self._what, written, partial(joined, np.logical_and), partial(joined, np.logical_or))

    def _everywhere(self, xp: ModuleType, arrays: Mapping[str, Any]) -> Any:
        """Return the whole result at once, in another namespace."""
        kinds = [a.dtype for a in (arrays[name] for name in self.names) if hasattr(a, "dtype")
                 and xp.isdtype(a.dtype, "real floating")]
        kind = xp.result_type(*kinds) if kinds else xp.asarray(1.0).dtype
        given = {name: xp.asarray(arrays[name], dtype=kind) for name in self.names}
        if isinstance(self._what, Expr):
            return _in_namespace(self._what, xp, given)

        def compare(expression: Expr, relation: Relation) -> Any:
            return relation(_in_namespace(expression, xp, given), 0)

        return truth(self._what, compare, lambda answers: reduce(operator.and_, answers, xp.asarray(True)),
                     lambda answers: reduce(operator.or_, answers, xp.asarray(False)))


@checked
def compile_margin(what: Condition | Criterion | Expr, backend: str | ModuleType = "numpy") -> CompiledMargin:
    """Return a function of named arrays: the values of a margin, or where a criterion holds.

    Parameters
    ----------
    what : Condition, Criterion or Expr
        a condition stands for its margin [its dimension], a criterion for a bool
    backend : str or module
        "numpy", the default; "numba" (extra fast); or a namespace of the array API standard, such as
        jax.numpy

    Returns
    -------
    CompiledMargin
        it has the names, and is called with arrays

    Raises
    ------
    ArgumentError
        there is no such backend, or this is no margin and no criterion
    ValuesError
        when it is called: names are missing or unknown, an array is not of finite real numbers, shapes
        disagree
    MissingExtraError
        Numba is not installed

    References
    ----------
    Straight-line programs: Bürgisser, Clausen & Shokrollahi, Algebraic Complexity Theory (1997), chapter 4.

    Examples
    --------
    >>> import gyrostat as gs
    >>> import numpy as np
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> stable = gs.charts.compile_margin(report.sufficient)
    >>> stable.names
    ('I1', 'l', 'm0', 'pi3_0')
    >>> rotor, spin = np.array([[-1.0], [1.0]]), np.array([0.0, 1.0, 2.0])
    >>> stable(I1=1, m0=1, l=rotor, pi3_0=spin)
    array([[False, False, False],
           [False, False,  True]])
    """
    if isinstance(backend, str) and backend not in ("numpy", "numba"):
        raise ArgumentError(f"backend = {backend!r} is not known: use 'numpy', 'numba' or a "
                            "module such as array_api_strict")
    if backend == "numba":
        optional("numba", "fast")
    if isinstance(what, Condition):
        return CompiledMargin(what.margin, backend)
    return CompiledMargin(own(what) if isinstance(what, Expr) else what, backend)


def _in_namespace(margin: Expr, xp: ModuleType, given: Mapping[str, Any]) -> Any:
    arrays = {s: given[s.name] for s in margin.free_symbols}
    kind = next(iter(given.values())).dtype if given else None
    dimensions = max((a.ndim for a in arrays.values()), default=0)
    axes = {s: frozenset(i + dimensions - a.ndim for i, n in enumerate(a.shape) if n != 1)
            for s, a in arrays.items()}
    return program_of(margin, axes).run(lambda leaf: in_floats(leaf, xp, arrays),
                                        lambda c: xp.asarray(rounded(c)[0], dtype=kind))[-1]
