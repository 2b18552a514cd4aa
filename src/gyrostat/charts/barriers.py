"""Barriers and kicks at the points of a chart, where the well of an equilibrium has a closed form."""
from collections.abc import Sequence
from typing import Any

import numpy as np
from sympy import Expr, lambdify, oo

from ..algebra.enclosures.floats import Array
from ..arguments import checked
from ..equilibria.wells.closed_forms import ClosedForm, closed_forms
from ..errors import ScopeError, ValuesError, optional, require
from ..notation import symbol, units
from ..stability.report.report import Report
from .codes import STABLE, SURVIVED


@checked
def with_barriers(chart: Any, report: Report) -> Any:
    """Return a stability chart with the barrier and the safe kick at each of its points.

    Parameters
    ----------
    chart : xarray.Dataset
        of stability_chart
    report : Report
        that of the chart: of a rotation of a free gyrostat about the axis that carries l, or of an
        Earth-pointing satellite whose l is along the pitch axis

    Returns
    -------
    xarray.Dataset
        the chart with barrier [M L²/T²] and kick [M L²/T], in doubles; NaN where it is not stable, where
        gyroscopic forces alone hold it, and for the kick where no formula is known

    Raises
    ------
    ScopeError
        no closed form is known, or it has a root of an equation in it
    ValuesError
        the chart is of another equilibrium
    MissingExtraError
        pip install "gyrostat[charts]"

    References
    ----------
    Those of conditions --well; Hughes, Spacecraft Attitude Dynamics (1986), chapters 6, 9 and 10.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((60, 70, 35), (0, "l", 0))
    >>> satellite = gs.assemble(body, gs.circular_orbit())
    >>> report = gs.analyze(gs.earth_pointing(satellite))
    >>> chart = gs.charts.stability_chart(
    ...     report, x=("l", [0, 5, 30]), y=("omega0", [1, 2]))
    >>> gs.charts.with_barriers(chart, report).barrier.values
    array([[  5.  ,  11.25,  37.5 ],
           [ 20.  ,  31.25, 120.  ]])
    """
    require(chart, optional("xarray", "charts").Dataset, "the chart")
    if chart.attrs.get("equilibrium") != (label := report.equilibrium.label):
        raise ValuesError(f"the chart is of {chart.attrs.get('equilibrium', 'nothing')}, and the report of "
                          f"{label}: give the report from which the chart was made")
    forms = [form for form in closed_forms(report.equilibrium) if not form.root and form.barrier != oo]
    if not forms:
        raise ScopeError(f"the well of {label} has no closed form without a root in it: a chart has those of "
                         "a free gyrostat about the axis that carries l, and of a satellite whose l is along "
                         "the pitch axis")
    dims, stable = chart.verdict.dims, chart.verdict.values == STABLE
    found = {name: np.full(stable.shape, np.nan) for name in SURVIVED}
    for form in forms:
        here = stable & np.all([values > 0 for values in _at(form, form.conditions, chart)], axis=0)
        for name, values in zip(SURVIVED, _at(form, (form.kick, form.barrier), chart)):
            there = here & (values > 0)
            found[name][there] = values[there]
    return chart.assign({name: (dims, found[name], {"long_name": meaning, "units": units(*dimension)})
                         for name, (meaning, dimension, _) in SURVIVED.items()})


def _at(form: ClosedForm, expressions: Sequence[Expr], chart: Any) -> list[Array]:
    """Expressions of a form at each point."""
    written = [x.xreplace(dict(form.names)) for x in expressions]
    names, dims = sorted({s.name for x in written for s in x.free_symbols}), chart.verdict.dims
    grid = [chart[name].values.reshape([-1 if dim == name else 1 for dim in dims]) for name in names]
    with np.errstate(all="ignore"):                    # of cases that do not hold somewhere
        values = lambdify([symbol(name) for name in names], written, "numpy")(*grid)
    return [np.broadcast_to(np.asarray(x, dtype=float), chart.verdict.shape) for x in values]
