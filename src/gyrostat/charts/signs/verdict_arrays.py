"""The exact verdict at every point of a grid: floats with a proved bound first, then exact numbers.

The ladder of theorems is asked only at points that both criteria leave open.
"""
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from ...algebra.enclosures.floats import Array
from ...arguments import checked
from ...errors import ArgumentError, ValuesError, optional
from ...stability.criteria.numbers_asked import check_family
from ...stability.decision import Rung
from ...stability.report.report import Report
from ..codes import INVALID, RUNGS, STABLE, UNDECIDED, UNSTABLE
from ..grids import Grid, grid_of
from ..progress import Told, telling
from .block_writing import NUMBA_BLOCK, NUMPY_BLOCK, in_threads, prepared
from .float_screening import Screen, screened
from .grid_signs import dyadic_rational
from .verdicts_in_blocks import Decided, demands_of


@checked
def verdicts(report: Report, values: Mapping[Any, Any] | None = None, /, *, damped: bool = False,
             invalid: str = "raise", backend: str = "numpy", threads: int = 1, out: Array | None = None,
             progress: Told | bool | None = None, **arrays: Any) -> Array:
    """Return the exact verdict at every point of a grid.

    It is what Report.verdict says at each point, near the speed of the margin in doubles. Doubles decide if
    they are further from 0 than a proved bound of their error, balls and rationals decide the rest, and on
    the boundary the ladder does. A float is the dyadic rational that it is.

    Parameters
    ----------
    report : Report
    values : mapping of name to number or array, any shape
        float64, float32, integers, or objects: Fraction, SymPy numbers; they broadcast. Arrays of shapes
        (n, 1) and (m,) make a grid, which is fastest. The eliminated name is omitted
    damped : bool
        whether the body loses energy inside, as in Report.verdict; default False. If the second variation is
        degenerate, or the damping does not reach every motion, it is decided point by point
    invalid : str
        "raise", the default, or "mark": what to do if the equilibrium does not exist, or a number is not
        finite
    backend : str
        "numpy", the default, or "numba" (extra fast)
    threads : int
        how many threads share the blocks; default 1
    out : array of int8 or None, of the common shape
        the array to write to; it may overlap the arrays given; default a new one
    progress : callable, False or None
        called with the number of blocks that are done and of all blocks; by default a bar is drawn on a
        terminal or in a notebook, if it takes longer than some seconds
    **arrays : number or array, any shape
        the same as values, by keyword

    Returns
    -------
    array of int8, of the common shape
        STABLE = 1, UNSTABLE = −1, UNDECIDED = 0, INVALID = −2

    Raises
    ------
    ValuesError
        names are missing or unknown, shapes disagree, a number is not finite, or the equilibrium does not
        exist at a point: the first such index is named
    ArgumentError
        there is no such backend, or no such way with what is invalid
    MissingExtraError
        Numba is not installed

    References
    ----------
    Rounding: Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. (2002), chapter 3. Balls:
    Johansson, IEEE Trans. Comput. 66 (2017) 1281-1292.

    Examples
    --------
    >>> import gyrostat as gs
    >>> import numpy as np
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> rows, columns = [[0.0], [0.5]], [-2.0, 1.0, 1.5, 2.0]
    >>> gs.charts.verdicts(report, I1=1, m0=1, l=np.array(rows),
    ...                    pi3_0=np.array(columns))
    array([[ 1, -1, -1,  1],
           [-1, -1,  1,  1]], dtype=int8)
    """
    return decided(report, {**(values or {}), **arrays}, damped, invalid, backend, threads, out,
                   progress=progress)


def decided(report: Report, values: Mapping[str, Any], damped: bool = False, invalid: str = "raise",
            backend: str = "numpy", threads: int = 1, out: Array | None = None, rungs: Array | None = None,
            progress: Told | bool | None = False) -> Array:
    """Return the verdicts at every point of a grid, and write what decided each point into rungs.

    The array rungs has zeros of int8 and the common shape; the other arguments are those of verdicts.
    """
    if invalid not in ("raise", "mark"):
        raise ArgumentError(f"invalid = {invalid!r} is neither 'raise' nor 'mark': choose one")
    if backend not in ("numpy", "numba"):
        raise ArgumentError(f"backend = {backend!r} is neither 'numpy' nor 'numba': choose one")
    if backend == "numba":
        optional("numba", "fast")
    given = {str(name): value for name, value in values.items()}
    grid = grid_for(report, given, finite=False, damped=damped)
    result = prepared(out, grid.shape, np.int8)
    grid = grid.apart_from(result)
    merged = result.reshape(grid.merged)
    layer = None if rungs is None else rungs.reshape(grid.merged)
    demands = demands_of(report, grid, damped)
    filler: Callable[[], Screen | Decided] = partial(Decided, report, grid, backend, damped, layer, demands)
    blocks = grid.blocks(NUMBA_BLOCK if backend == "numba" else NUMPY_BLOCK)
    if rungs is None and backend == "numba" and screened(grid, demands):
        screen = Screen(report, grid, demands)
        filler, blocks = lambda: screen, screen.blocks(threads)
    elif invalid == "raise":
        _refuse_strange(report, given, grid, damped)
    with telling(progress, "verdicts") as told:
        firsts = in_threads(lambda some: filler().fill(some, merged), blocks, threads, told)
    if invalid == "raise" and (bad := [first for first in firsts if first is not None]):
        _refuse_strange(report, given, grid, damped)
        place = min(bad)
        block = tuple(slice(i, i + 1) for i in place)
        (numbers,) = grid.at(block, np.zeros(1, int), np.zeros(1, int)).numbers(grid.values)
        why = f"{report.equilibrium.label} does not exist there"
        try:
            report.verdict(dict(zip((s.name for s in grid.values), map(dyadic_rational, numbers))), damped)
        except ValuesError as error:
            why = str(error)
        raise ValuesError(f"at index {grid.index(place)}: {why}; or ask for such points to be marked, "
                          "invalid=\"mark\"")
    if rungs is not None:
        rungs[(rungs == 0) & (result == STABLE)] = RUNGS[Rung.SECOND_VARIATION]
        rungs[(rungs == 0) & (result == UNSTABLE)] = RUNGS[Rung.SPECTRUM]
        rungs[(result == UNDECIDED) | (result == INVALID)] = RUNGS[Rung.NOTHING]
    return result


def _refuse_strange(report: Report, given: Mapping[str, Any], grid: Grid, damped: bool) -> None:
    """Say which number is not finite, if there is one."""
    if grid.strange:
        grid_for(report, given, damped=damped)


def grid_for(report: Report, given: Mapping[str, Any], finite: bool = True, damped: bool = False) -> Grid:
    """Return the grid of the names given, all that a verdict needs and no other."""
    required = (report.secular if damped else report).compared
    check_family(report.equilibrium, given, required, report.parameters, "give a number or an array for each")
    return grid_of(given, finite=finite)
