"""Stability charts: the exact verdict at every point of a grid of parameters, labelled, with the exact boundary between the verdicts."""
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from sympy import Expr

from .algebra import Ring
from .certify import INVALID, STABLE, UNDECIDED, UNSTABLE, verdicts
from .contours import boundary, thinned
from .equilibria import Equilibrium
from .errors import ArgumentError, ValuesError, optional, require
from .exact import sign_of_constant
from .expressions import exact_number, shown
from .grids import Array
from .labels import check_plain
from .latex import tex
from .notation import NOTATION, jet, symbol, typeset, units
from .numeric import compile_margin
from .presentation import readable
from .progress import Told
from .stability import Report
from .values import check_family

CODES = {"unstable": UNSTABLE, "undecided": UNDECIDED, "stable": STABLE, "no_equilibrium": INVALID}
OWN = ("verdict", "margin", "boundary_x", "boundary_y", "vertex", "complete")    # names of the dataset itself
Axis = tuple[str, Any]


@dataclass(frozen=True)
class Chart:
    """What is asked of a grid of parameters.

    Parameters
    ----------
    report : Report
    names : tuple of str                     of the axes, outermost first
    fixed : tuple of (str, Expr, str)        name, exact number, and the number as it was given
    margins : bool                           whether the values of the margins are wanted besides
    backend : str                            "numpy" or "numba"
    """

    report: Report
    names: tuple[str, ...]
    fixed: tuple[tuple[str, Expr, str], ...]
    margins: bool
    backend: str

    @property
    def all_margins(self) -> list[Expr]:
        """The margins of both criteria, each once."""
        criteria = (self.report.necessary, self.report.sufficient)
        return list(dict.fromkeys(c.margin for criterion in criteria for alternative in criterion.alternatives for c in alternative))

    @property
    def deciding(self) -> list[Expr]:
        """What changes its sign between two verdicts: the margins, and what is positive where the equilibrium exists."""
        ring = Ring(existence := list(self.report.equilibrium.existence()))
        return [*self.all_margins, *(ring.expression(top * bottom) for top, bottom in map(ring.fraction, existence))]

    def variables(self, arrays: Sequence[Array], threads: int = 1) -> dict[str, Array]:
        """Verdicts, and margins if they are wanted, over the grid of the arrays, one for each axis."""
        grid = {name: array.reshape(-1, *(1,) * (len(arrays) - 1 - i)) for i, (name, array) in enumerate(zip(self.names, arrays))}
        numbers = {name: number for name, number, _ in self.fixed} | grid
        found = {"verdict": verdicts(self.report, numbers, invalid="mark", backend=self.backend, threads=threads)}
        if self.margins:
            shape = tuple(map(len, arrays))
            for n, margin in enumerate(self.all_margins):
                compiled = compile_margin(margin, self.backend)
                with np.errstate(all="ignore"):        # outside of the domain of U
                    values = compiled(**{name: numbers[name] for name in compiled.names}, threads=threads)
                found[f"margin_{n}"] = np.ascontiguousarray(np.broadcast_to(values, shape))
        return found

    def curves(self, arrays: Sequence[Array], verdict: Array | None = None) -> tuple[Array, Array]:
        """x and y of the boundary between the verdicts of two axes; followed on some 2000 values of each, where there are more."""
        rows, columns = map(thinned, map(len, arrays))
        y, x = arrays[0][rows], arrays[1][columns]
        seen = self.variables([y, x])["verdict"] if verdict is None else verdict[np.ix_(rows, columns)]
        up, across = map(symbol, self.names)
        numbers = {name: number for name, number, _ in self.fixed}

        def verdict_at(at_x: Array, at_y: Array) -> Array:
            return verdicts(self.report, numbers | {across.name: at_x, up.name: at_y}, invalid="mark")

        return boundary(self.deciding, {symbol(name): number for name, number in numbers.items()}, (across, x), (up, y), seen, verdict_at)


def stability_chart(report: Report, *, x: Axis, y: Axis, fixed: Mapping[str, Any] | None = None, axes: Mapping[str, Any] | None = None,
                    margins: bool = False, store: str | Path | None = None, backend: str = "numpy", threads: int = 1,
                    progress: Told | bool | None = None) -> Any:
    """The verdict at every point of a grid of parameters, as a labelled dataset.

    Each is what Report.verdict says of that point, proved; between them, of two axes, the curves on which they change.

    Parameters
    ----------
    report : Report
    x, y : pairs (name, values)             values: floats, strictly increasing or decreasing
    fixed : mapping of name to number       the other parameters, exact: "1/3", Fraction, int; a float is the dyadic rational it is
    axes : mapping of name to values        further axes, outermost first
    margins : bool                          the values of the margins too
    store : str or Path                     a path that ends in .zarr: blocks are written to it, and continued where it exists; the chart
                                            may be larger than the memory
    backend : str                           "numpy", or "numba" (extra fast)
    threads : int
    progress : callable, False or None      called with the blocks that are done and all blocks of a store; None: a bar on a terminal

    Returns
    -------
    xarray.Dataset      verdict (int8: 1 stable, 0 undecided, −1 unstable, −2 no equilibrium) with the dimensions (…, y, x); on request
                        margin_0, …; of two axes boundary_x and boundary_y, NaN between pieces. Every parameter is a coordinate with its
                        meaning, units (SI) and LaTeX, fixed ones with the exact number. Of a store, opened lazily

    Raises
    ------
    ValuesError         names are missing, unknown, given twice or expressed by others; values are not finite, not monotonic, or not
                        positive where the parameter is
    StoreError          the store holds another chart
    MissingExtraError   pip install "gyrostat[charts]"

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    >>> chart = stability_chart(top, x=("pi3_0", [-2, 1, 1.5, 2]), y=("l", [0, 0.5]), fixed={"I1": 1, "m0": "1"})
    >>> chart.verdict.values
    array([[ 1, -1, -1,  1],
           [-1, -1,  1,  1]], dtype=int8)
    """
    optional("xarray", "charts")
    require(report, Report, "the report")
    given = [*(axes or {}).items(), _pair(y, "y"), _pair(x, "x")]
    _check_names(report, [name for name, _ in given], list(fixed or {}))
    arrays = [_axis(name, values) for name, values in given]
    chart = Chart(report, tuple(name for name, _ in given), tuple(_number(name, value) for name, value in (fixed or {}).items()),
                  bool(margins), backend)
    if store is not None:
        from .stores import filled  # a view of this one: dask and zarr are loaded where they are needed
        return filled(Path(store), chart, arrays, threads, progress)
    found = chart.variables(arrays, threads)
    return described(chart, arrays, found, found["verdict"])


def described(chart: Chart, arrays: Sequence[Array], found: Mapping[str, Array], verdict: Array | None = None) -> Any:
    """The dataset of what was found; the boundary from the verdicts, or from some 2000 values of each axis where they are not given."""
    xarray = optional("xarray", "charts")
    eq = chart.report.equilibrium
    coordinates: dict[str, Any] = {name: (name, array, coordinate_attributes(name, eq)) for name, array in zip(chart.names, arrays)}
    coordinates |= {name: ((), float(number), coordinate_attributes(name, eq) | {"exact": text}) for name, number, text in chart.fixed}
    variables: dict[str, Any] = {name: (chart.names, values, variable_attributes(name, chart)) for name, values in found.items()}
    if len(arrays) == 2 and min(map(len, arrays)) > 1:
        for axis, points in zip("xy", chart.curves(arrays, verdict)):
            name = chart.names["yx".index(axis)]
            variables[f"boundary_{axis}"] = "vertex", points, {
                "long_name": f"{name} on the boundary between the verdicts, NaN between its pieces", "parameter": name}
    dataset = xarray.Dataset(variables, coordinates, _attributes(eq))
    for variable in dataset.variables.values():
        if variable.dtype.kind == "f":
            variable.encoding["_FillValue"] = None     # NaN is a value here
    return dataset


def variable_attributes(name: str, chart: Chart) -> dict[str, Any]:
    """What a verdict or a margin means."""
    eq = chart.report.equilibrium
    if name != "verdict":
        margin = chart.all_margins[int(name.removeprefix("margin_"))]
        return {"long_name": str(margin), "latex": tex(readable(margin), eq.at)}
    modulo = ", ".join(map(str, chart.report.sufficient.modulo))
    return {"long_name": f"stability of {eq.label}", "flag_values": np.array(list(CODES.values()), dtype=np.int8),
            "flag_meanings": " ".join(CODES), "notion": "Lyapunov where stable, spectral where unstable"} | (
                {"modulo": f"the flow of {modulo}"} if modulo else {})


def coordinate_attributes(name: str, eq: Equilibrium) -> dict[str, str]:
    """Meaning, units and LaTeX of a parameter."""
    entry, derivative = NOTATION.get(name), jet(name)
    meaning = entry.meaning if entry else f"derivative {name} of U" if derivative else f"parameter {name}"
    unit = {"units": units(*((1, 2, 0) if derivative or not entry else (*entry.dimension, entry.length)))} if derivative or entry else {}
    return {"long_name": meaning, "latex": typeset(name, eq.at)} | unit


def _attributes(eq: Equilibrium) -> dict[str, str]:
    from . import __version__
    potential = eq.system.potential
    relations = {"relations": "; ".join(f"{name} = {value}" for name, value in eq.relations)} if eq.relations else {}
    return {"Conventions": "CF-1.11", "title": f"Stability of {eq.label}", "equilibrium": eq.label,
            "potential": str(potential.expression) if potential else "none",
            **({"potential_latex": tex(potential.expression)} if potential and potential.given else {}), **relations,
            **({"eliminated": eq.eliminated} if eq.eliminated else {}), "gyrostat_version": __version__}


def _pair(axis: Any, which: str) -> Axis:
    if not isinstance(axis, tuple) or len(axis) != 2 or not isinstance(axis[0], str):
        raise ArgumentError(f'{which} is no pair of a name and values: write {which}=("l", np.linspace(0, 1, 200))')
    return axis


def _check_names(report: Report, varied: Sequence[str], fixed: Sequence[str]) -> None:
    for n, name in enumerate(given := [*varied, *fixed]):
        if name in given[:n]:
            raise ValuesError(f"{name} is given twice, as an axis and again as an axis or fixed: give it once")
        if name in OWN or name.startswith("margin_"):
            raise ValuesError(f"{name} is a name of the dataset itself: call the parameter otherwise")
    check_family(report.equilibrium, given, report.required, report.parameters, "fix each at a number, or make it an axis")


def _number(name: str, value: Any) -> tuple[str, Expr, str]:
    """A fixed parameter, exact, and the text of it."""
    number = exact_number(value, name)
    if symbol(name).is_positive and sign_of_constant(number) in (0, -1):
        raise ValuesError(f"{name} = {shown(number)}, but it must be positive: give a positive number")
    return name, number, value if isinstance(value, str) else str(number)


def _axis(name: str, values: Iterable[Any]) -> Array:
    """The values of an axis, checked."""
    check_plain({name: values})
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "iufO":
            raise TypeError(f"they are of type {array.dtype}")
        array = array.astype(np.float64)
    except (TypeError, ValueError) as error:
        raise ValuesError(f"the values of {name} are not real numbers ({error}): give floats, such as np.linspace(0, 1, 200)") from None
    if array.ndim != 1 or not array.size:
        raise ValuesError(f"the values of {name} have the shape {array.shape}: give one sequence, with one value at least")
    if not np.isfinite(array).all():
        place = int(np.argmin(np.isfinite(array)))
        raise ValuesError(f"the value {place} of {name} is {array[place]}, not finite: remove it")
    if symbol(name).is_positive and not (array > 0).all():
        place = int(np.argmin(array > 0))
        raise ValuesError(f"the value {place} of {name} is {array[place]}, but {name} must be positive: give an axis of positive values")
    on = array[1:] < array[:-1] if array.size > 1 and array[1] < array[0] else array[1:] > array[:-1]
    if not on.all():
        place = int(np.argmin(on)) + 1
        raise ValuesError(f"the values of {name} are not strictly monotonic: {array[place - 1]} is followed by {array[place]} at index "
                          f"{place}; sort them, each once")
    return array
