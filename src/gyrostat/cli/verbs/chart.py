"""gyrostat chart: the verdicts over a grid of parameters, as a picture or as data."""
import argparse
from collections.abc import Sequence
from math import prod
from typing import Any

import numpy as np

from ..._lazy import loaded
from ...charts.chart import stability_chart
from ...charts.codes import SURVIVED
from ...errors import ValuesError
from ...notation import symbol
from ...plotting import draw_chart
from ...printing.files import save_netcdf
from ...questions.answers.equilibria import report_for
from ...questions.given_numbers import numbers_of, one_spin
from ...stability.criteria.number_notes import scene_note
from ..options.axis_option import axis_of
from ..options.picture_options import Form, refuse_too_many_dots
from ..options.scene_files import asked_of, with_scene
from ..options.units_given import units_given
from ..output import PICTURES, Output, file_of, printed_look

DATA = (".nc", ".zarr")
KINDS = "a picture, chart.png, .pdf or .svg; data, chart.nc or chart.zarr"
PACKED = ("verdict", "damped", "rung", *SURVIVED)
LARGEST = 10**9                                        # points of a chart that is not written block by block


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the chart; 0."""
    given = with_scene(given)
    path = file_of(out, "chart", PICTURES + DATA, KINDS, {"xarray": "charts"})
    refuse_too_many_dots(given)
    numbers = numbers_of(given.values)
    axes = dict(_axes([("--axis", text) for text in given.axis or ()] + [("--y", given.y), ("--x", given.x)]))
    if len(axes) > 2 and path.suffix in PICTURES:
        raise ValuesError(f"the axes are {', '.join(axes)}, and a picture has two: write data instead, "
                          f"--output {path.with_suffix('.zarr')}")
    if (points := prod(map(len, axes.values()))) > LARGEST and path.suffix != ".zarr":
        raise ValuesError(f"the chart has {points} points, and at most {LARGEST} are held in memory: write "
                          f"them block by block, --output {path.with_suffix('.zarr')}")
    if given.well and path.suffix == ".zarr":
        raise ValuesError("--well adds to a picture or to chart.nc, and a store is written block by block: "
                          "leave one out")
    one_spin(names := {**numbers, **dict.fromkeys(axes)})
    report = report_for("chart", asked_of(given, names), given.equilibrium, names)
    *further, y, x = axes.items()
    store = path if path.suffix == ".zarr" else None
    chart = stability_chart(report, x=x, y=y, axes=dict(further), fixed=_as_written(given.values),
                            damped=given.damped, store=store, backend=given.backend,
                            threads=given.threads)
    if given.well:
        chart = loaded("charts.barriers:with_barriers")(chart, report)
    if path.suffix in PICTURES:
        form = Form(path, path.suffix.removeprefix("."), given.width, given.dpi, given.title)
        with printed_look():
            figure = form.figure()
            draw_chart(chart, figure.subplots(), si=units_given(given))
            form.save(figure)
    elif store is None:
        packed = {"zlib": True, "complevel": 1}
        save_netcdf(chart, path, encoding={name: packed for name in PACKED if name in chart})
    out.noted(scene_note(report.equilibrium.system,
                         {symbol(name): number for name, number in numbers.items()}))
    return 0


def _axes(texts: Sequence[tuple[str, str]]) -> list[tuple[str, Any]]:
    """The axes of NAME=LOW:HIGH:COUNT, in order."""
    axes: list[tuple[str, Any]] = []
    for option, text in texts:
        name, low, high, count = axis_of(option, text)
        if name in dict(axes):
            raise ValuesError(f"{name} is an axis twice: give it once")
        axes.append((name, np.linspace(float(low), float(high), count)))
    return axes


def _as_written(settings: Sequence[str]) -> dict[str, str]:
    """The numbers of --set as they stand there."""
    return {name.strip(): value.strip() for name, _, value in (setting.partition("=")
                                                               for setting in settings)}
