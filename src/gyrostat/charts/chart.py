"""Stability charts: the exact verdict at every point of a grid of parameters, as a labelled dataset.

With two axes the dataset has the boundary between the verdicts, exact to the last bits.
"""
from collections.abc import Iterable, Mapping, Sequence, Sized
from pathlib import Path
from typing import Any

import numpy as np
from sympy import Expr

from ..algebra.enclosures.floats import Array
from ..algebra.reals.exact import sign_of_constant
from ..algebra.text.numbers import exact_number, shown
from ..arguments import MOST, checked
from ..errors import ArgumentError, ValuesError, optional
from ..notation import symbol
from ..stability.criteria.numbers_asked import check_family
from ..stability.report.report import Report
from .datasets import OWN, described
from .labels import check_plain
from .progress import Told
from .request import Request
from .stores.chart_stores import filled

Axis = tuple[str, Any]


@checked
def stability_chart(report: Report, *, x: Axis, y: Axis, fixed: Mapping[str, Any] | None = None,
                    axes: Mapping[str, Any] | None = None, margins: bool = False, damped: bool = False,
                    store: str | Path | None = None, backend: str = "numpy", threads: int = 1,
                    progress: Told | bool | None = None) -> Any:
    """Return the verdict at every point of a grid of parameters, as a labelled dataset.

    Each verdict is what Report.verdict says at that point, and is proved. With two axes there are the curves
    on which the verdict changes between the points.

    Parameters
    ----------
    report : Report
    x, y : pairs (name, values)
        the values are floats, shape (n,), strictly increasing or decreasing, with the dimension of the name
        in the notation table
    fixed : mapping of name to number
        the other parameters, exact: "1/3", Fraction, int; a float is the dyadic rational it is
    axes : mapping of name to values
        further axes, outermost first; default none
    margins : bool
        whether the values of the margins are wanted, too; default False
    damped : bool
        whether the verdicts of Report.verdict(values, damped=True) are wanted, too; default False
    store : str or Path
        a path that ends in .zarr: blocks are written to it, and an existing store is continued; the chart may
        be larger than the memory; default none, the chart is made in memory
    backend : str
        "numpy", the default, or "numba" (extra fast)
    threads : int
        how many threads share the blocks; default 1
    progress : callable, False or None
        called with the number of blocks that are done and of all blocks; without a store the damped verdicts
        are counted anew. By default a bar is drawn on a terminal or in a notebook, if it takes longer than
        some seconds

    Returns
    -------
    xarray.Dataset
        verdict (int8: 1 stable, 0 undecided, −1 unstable, −2 no equilibrium) with the dimensions (…, y, x);
        on request damped, in the same codes, and margin_0, …; with two axes boundary_x and boundary_y, NaN
        between pieces. If gyroscopic forces may stabilise a maximum: rung (int8), what decided each point,
        and with two axes curve_x, curve_y and curve, the resonances 1:2, 1:3 and D4 = 0. Every parameter is a
        coordinate with its meaning, units (SI) and LaTeX, fixed ones with the exact number. A store is opened
        lazily

    Raises
    ------
    ValuesError
        names are missing, unknown, given twice or expressed by others; values are not finite, not monotonic,
        or not positive, but the parameter is
    StoreError
        the store holds another chart
    ArgumentError
        x or y is no pair
    MissingExtraError
        pip install "gyrostat[charts]"

    References
    ----------
    Curves: marching squares, then bisection in twofold arithmetic, Dekker, Numer. Math. 18 (1971) 224-242.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> chart = gs.charts.stability_chart(
    ...     report, x=("pi3_0", [-2, 1, 1.5, 2]), y=("l", [0, 0.5]),
    ...     fixed={"I1": 1, "m0": "1"})
    >>> chart.verdict.values
    array([[ 1, -1, -1,  1],
           [-1, -1,  1,  1]], dtype=int8)
    """
    optional("xarray", "charts")
    given = [*(axes or {}).items(), _pair(y, "y"), _pair(x, "x")]
    _check_names(report, [name for name, _ in given], list(fixed or {}), damped)
    arrays = [_axis(name, values) for name, values in given]
    request = Request(report.written_out, tuple(name for name, _ in given),
                  tuple(_number(name, value) for name, value in (fixed or {}).items()),
                  bool(margins), backend, bool(damped))
    if store is not None:
        return filled(Path(store), request, arrays, threads, progress)
    found = request.variables(arrays, threads, progress)
    return described(request, arrays, found)


def _pair(axis: Any, which: str) -> Axis:
    if not isinstance(axis, tuple) or len(axis) != 2 or not isinstance(axis[0], str):
        raise ArgumentError(f'{which} is no pair of a name and values: write {which}=("l", np.linspace(0, '
                            '1, 200))')
    return axis


def _check_names(report: Report, varied: Sequence[str], fixed: Sequence[str], damped: bool) -> None:
    for n, name in enumerate(given := [*varied, *fixed]):
        if name in given[:n]:
            raise ValuesError(f"{name} is given twice, as an axis and again as an axis or fixed: give it "
                              "once")
        if name in OWN or name.startswith("margin_"):
            raise ValuesError(f"{name} is a name of the dataset itself: call the parameter otherwise")
    further = report.secular.compared if damped else ()
    check_family(report.equilibrium, given, tuple(dict.fromkeys((*report.compared, *further))),
                 report.parameters, "fix each at a number, or make it an axis")


def _number(name: str, value: Any) -> tuple[str, Expr, str]:
    """Return a fixed parameter: its name, its exact number, and the text of it."""
    number = exact_number(value, name)
    if symbol(name).is_positive and sign_of_constant(number) in (0, -1):
        raise ValuesError(f"{name} = {shown(number)}, but it must be positive: give a positive number")
    return name, number, value if isinstance(value, str) else str(number)


def _axis(name: str, values: Iterable[Any]) -> Array:
    """Return the values of an axis, checked."""
    check_plain({name: values})
    if isinstance(values, Sized) and len(values) > MOST:
        raise ValuesError(f"{name} has {len(values)} values: give at most {MOST}")
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "iufO":
            raise TypeError(f"they are of type {array.dtype}")
        array = array.astype(np.float64)
    except (OverflowError, TypeError, ValueError) as error:
        raise ValuesError(f"the values of {name} are not real numbers ({error}): give floats, such as "
                          "np.linspace(0, 1, 200)") from None
    if array.ndim != 1 or not array.size:
        raise ValuesError(f"the values of {name} have the shape {array.shape}: give one sequence, with one "
                          "value at least")
    if not np.isfinite(array).all():
        place = int(np.argmin(np.isfinite(array)))
        raise ValuesError(f"the value {place} of {name} is {array[place]}, not finite: remove it")
    if symbol(name).is_positive and not (array > 0).all():
        place = int(np.argmin(array > 0))
        raise ValuesError(f"the value {place} of {name} is {array[place]}, but {name} must be positive: "
                          "give an axis of positive values")
    on = array[1:] < array[:-1] if array.size > 1 and array[1] < array[0] else array[1:] > array[:-1]
    if not on.all():
        place = int(np.argmin(on)) + 1
        raise ValuesError(f"the values of {name} are not strictly monotonic: {array[place - 1]} is "
                          f"followed by {array[place]} at index {place}; sort them, each once")
    return array
