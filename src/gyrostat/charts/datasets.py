"""Makes the labelled dataset of a chart: coordinates and variables with meaning, units and LaTeX."""
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from sympy import Expr

from ..algebra.enclosures.floats import Array
from ..algebra.rings.readable import readable
from ..errors import optional
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..mechanics.families.circular_orbit import CircularOrbit
from ..mechanics.families.named_entries import named_entries
from ..notation import NOTATION, dimension_of, jet, symbol, units
from ..printing.formats.latex import tex
from ..printing.formats.latex_names import Names
from ..stability.criteria.conditions import sources
from ..typesetting import typeset
from ..version import __version__
from .codes import CURVES, FLAGS, RUNGS
from .request import Request

# names of the dataset itself
OWN = ("verdict", "damped", "rung", "margin", "boundary_x", "boundary_y", "vertex", "curve_x", "curve_y",
       "curve", "place", "complete")
LONGEST = 24                                           # letters of an exact number of the scene


def described(request: Request, arrays: Sequence[Array], found: Mapping[str, Array]) -> Any:
    """Return the dataset of what was found.

    The curves are followed on the verdicts that were found, or, if none were, on those of some 2000 values of
    each axis.
    """
    xarray = optional("xarray", "charts")
    eq = request.report.equilibrium
    coordinates: dict[str, Any] = {name: (name, array, coordinate_attributes(name, eq))
                                   for name, array in zip(request.names, arrays)}
    coordinates |= {name: ((), float(number), coordinate_attributes(name, eq) | {"exact": text})
                    for name, number, text in request.fixed}
    variables: dict[str, Any] = {name: (request.names, values, variable_attributes(name, request))
                                 for name, values in found.items()}
    if len(arrays) == 2 and min(map(len, arrays)) > 1:
        for name, points in request.curves(arrays, found).items():
            along = "vertex" if name.startswith("boundary") else "place"
            variables[name] = along, points, curve_attributes(name, request)
    dataset = xarray.Dataset(variables, coordinates, _attributes(eq))
    for variable in dataset.variables.values():
        if variable.dtype.kind == "f":
            variable.encoding["_FillValue"] = None     # NaN is a value, between pieces of curves
    return dataset


def curve_attributes(name: str, request: Request) -> dict[str, Any]:
    """Return what the points of curves are."""
    if name == "curve":
        return {"long_name": "the curve in a window on which a point lies: the frequencies are as 1 to 2, as "
                "1 to 3, or D4 changes its sign within 2**-12 of an edge of the grid; 0 between pieces",
                **_flags(CURVES)}
    parameter = request.names["yx".index(name[-1])]
    where = "the boundary between the verdicts" if name.startswith("boundary") else "curves in windows"
    return {"long_name": f"{parameter} on {where}, NaN between pieces", "parameter": parameter}


def _flags(codes: Mapping[str, int]) -> dict[str, Any]:
    """Return the values of a flag variable and what they mean, each in one word."""
    return {"flag_values": np.array(list(codes.values()), dtype=np.int8),
            "flag_meanings": " ".join(name.replace(" > 0", "_positive").replace(" < 0", "_negative")
                                      .replace(" ", "_") for name in codes)}


def variable_attributes(name: str, request: Request) -> dict[str, Any]:
    """Return what a verdict, a rung or a margin means."""
    eq = request.report.equilibrium
    if name.startswith("margin_"):
        margin = request.all_margins[int(name.removeprefix("margin_"))]
        (source,) = sources(eq, [margin], (request.report.sufficient, request.report.necessary)) or ("",)
        return {"long_name": str(margin), "latex": tex(readable(margin), Names(), eq.at)} | (
            {"condition": source} if source else {})
    if name == "rung":
        codes = {rung.value: code for rung, code in RUNGS.items()}
        return {"long_name": "what decided the point", **_flags(codes)}
    damped = name == "damped"
    criterion = request.report.damped if damped else request.report.sufficient
    modulo = ", ".join(map(str, criterion.modulo))
    return {"long_name": f"stability of {eq.label}{' under internal damping' if damped else ''}",
            **_flags(FLAGS),
            "notion": "secular" if damped else "Lyapunov where stable, spectral where unstable"} | (
                {"modulo": f"the flow of {modulo}"} if modulo else {})


def coordinate_attributes(name: str, eq: Equilibrium) -> dict[str, str]:
    """Return meaning, units and LaTeX of a parameter."""
    entry, dimension = NOTATION.get(name), dimension_of(name)
    meaning = entry.meaning if entry else f"derivative {name} of U" if jet(name) else f"parameter {name}"
    unit = {"units": units(*dimension)} if dimension else {}
    return {"long_name": meaning, "latex": typeset(name, eq.at)} | unit


def _attributes(eq: Equilibrium) -> dict[str, str]:
    potential = eq.system.potential
    found = {"Conventions": "CF-1.11", "title": f"Stability of {eq.label}", "equilibrium": eq.label,
             "potential": str(potential.expression) if potential else "none"}
    if isinstance(potential, CircularOrbit):
        found["orbit"] = "circular"
        if potential.beside:
            found["potential_latex"] = tex(potential.beside, Names())
    elif potential and potential.given:
        found["potential_latex"] = tex(potential.expression, Names())
    if known := {name: x for name, x in named_entries(eq.system).items() if x not in (0, symbol(name))}:
        found["scene"] = "; ".join(f"{name} = {_written(x)}" for name, x in known.items())
    if eq.relations:
        found["relations"] = "; ".join(f"{name} = {value}" for name, value in eq.relations)
    if eq.eliminated:
        found["eliminated"] = ", ".join(eq.eliminated)
    return found | {"gyrostat_version": __version__}


def _written(entry: Expr) -> str:
    """Return an entry of a scene as a text; a long number in 17 digits."""
    text = str(entry)
    return text if len(text) <= LONGEST or entry.free_symbols else str(entry.evalf(17))
