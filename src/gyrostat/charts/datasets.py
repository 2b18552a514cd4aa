"""The labelled dataset of a chart.

What is asked of a grid, and coordinates and variables with meaning, units and LaTeX.
"""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import Expr

from ..algebra.floats import Array
from ..algebra.polynomials import Ring
from ..algebra.readable import readable
from ..errors import optional
from ..mechanics.equilibria import Equilibrium
from ..notation import NOTATION, jet, symbol, typeset, units
from ..printing.latex import tex
from ..stability.report import Report
from ..version import __version__
from .arrays import verdicts
from .codes import FLAGS
from .contours import boundary, thinned
from .numeric import compile_margin

OWN = ("verdict", "margin", "boundary_x", "boundary_y", "vertex", "complete")    # names of the dataset itself


@dataclass(frozen=True)
class Chart:
    """What is asked of a grid of parameters.

    Parameters
    ----------
    report : Report
    names : tuple of str
        of the axes, outermost first
    fixed : tuple of (str, Expr, str)
        name, exact number, and the number as it was given
    margins : bool
        whether the values of the margins are wanted besides
    backend : str
        "numpy" or "numba"
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
        return list(dict.fromkeys(c.margin for criterion in criteria
                                  for alternative in criterion.alternatives for c in alternative))

    @property
    def deciding(self) -> list[Expr]:
        """What changes its sign between two verdicts.

        The margins, and what is positive where the equilibrium exists.
        """
        ring = Ring(existence := list(self.report.equilibrium.existence()))
        return [*self.all_margins, *(ring.expression(top * bottom)
                                     for top, bottom in map(ring.fraction, existence))]

    def variables(self, arrays: Sequence[Array], threads: int = 1) -> dict[str, Array]:
        """Verdicts, and margins if they are wanted, over the grid of the arrays, one for each axis."""
        grid = {name: array.reshape(-1, *(1,) * (len(arrays) - 1 - i))
                for i, (name, array) in enumerate(zip(self.names, arrays))}
        numbers = {name: number for name, number, _ in self.fixed} | grid
        found = {"verdict": verdicts(self.report, numbers, invalid="mark", backend=self.backend,
                                     threads=threads)}
        if self.margins:
            shape = tuple(map(len, arrays))
            for n, margin in enumerate(self.all_margins):
                compiled = compile_margin(margin, self.backend)
                with np.errstate(all="ignore"):        # outside of the domain of U
                    values = compiled(**{name: numbers[name] for name in compiled.names}, threads=threads)
                found[f"margin_{n}"] = np.ascontiguousarray(np.broadcast_to(values, shape))
        return found

    def curves(self, arrays: Sequence[Array], verdict: Array | None = None) -> tuple[Array, Array]:
        """x and y of the boundary between the verdicts of two axes.

        Followed on some 2000 values of each, where there are more.
        """
        rows, columns = map(thinned, map(len, arrays))
        y, x = arrays[0][rows], arrays[1][columns]
        seen = self.variables([y, x])["verdict"] if verdict is None else verdict[np.ix_(rows, columns)]
        up, across = map(symbol, self.names)
        numbers = {name: number for name, number, _ in self.fixed}

        def verdict_at(at_x: Array, at_y: Array) -> Array:
            return verdicts(self.report, numbers | {across.name: at_x, up.name: at_y}, invalid="mark")

        return boundary(self.deciding, {symbol(name): number for name, number in numbers.items()},
                        (across, x), (up, y), seen, verdict_at)


def described(chart: Chart, arrays: Sequence[Array], found: Mapping[str, Array],
              verdict: Array | None = None) -> Any:
    """The dataset of what was found.

    The boundary from the verdicts, or from some 2000 values of each axis where they are not given.
    """
    xarray = optional("xarray", "charts")
    eq = chart.report.equilibrium
    coordinates: dict[str, Any] = {name: (name, array, coordinate_attributes(name, eq))
                                   for name, array in zip(chart.names, arrays)}
    coordinates |= {name: ((), float(number), coordinate_attributes(name, eq) | {"exact": text})
                    for name, number, text in chart.fixed}
    variables: dict[str, Any] = {name: (chart.names, values, variable_attributes(name, chart))
                                 for name, values in found.items()}
    if len(arrays) == 2 and min(map(len, arrays)) > 1:
        for axis, points in zip("xy", chart.curves(arrays, verdict)):
            name = chart.names["yx".index(axis)]
            variables[f"boundary_{axis}"] = "vertex", points, {
                "long_name": f"{name} on the boundary between the verdicts, NaN between its pieces",
                "parameter": name}
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
    return {"long_name": f"stability of {eq.label}",
            "flag_values": np.array(list(FLAGS.values()), dtype=np.int8),
            "flag_meanings": " ".join(FLAGS), "notion": "Lyapunov where stable, spectral where unstable"} | (
                {"modulo": f"the flow of {modulo}"} if modulo else {})


def coordinate_attributes(name: str, eq: Equilibrium) -> dict[str, str]:
    """Meaning, units and LaTeX of a parameter."""
    entry, derivative = NOTATION.get(name), jet(name)
    if entry:
        meaning = entry.meaning
    else:
        meaning = f"derivative {name} of U" if derivative else f"parameter {name}"
    unit = (
        {"units": units(*((1, 2, 0) if derivative or not entry else (*entry.dimension, entry.length)))}
        if derivative or entry
        else {}
    )
    return {"long_name": meaning, "latex": typeset(name, eq.at)} | unit


def _attributes(eq: Equilibrium) -> dict[str, str]:
    potential = eq.system.potential
    relations = (
        {"relations": "; ".join(f"{name} = {value}" for name, value in eq.relations)} if eq.relations else {}
    )
    return {"Conventions": "CF-1.11", "title": f"Stability of {eq.label}", "equilibrium": eq.label,
            "potential": str(potential.expression) if potential else "none",
            **({"potential_latex": tex(potential.expression)} if potential and potential.given else {}),
            **relations,
            **({"eliminated": eq.eliminated} if eq.eliminated else {}), "gyrostat_version": __version__}
