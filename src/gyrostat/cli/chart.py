"""gyrostat chart: the verdicts over a grid of parameters, as a picture or as data."""
import argparse
from collections.abc import Sequence
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from ..charts import stability_chart
from ..errors import ValuesError, optional
from ..expressions import exact_number
from .output import Output
from .scenes import labels_of, numbers_of, one_spin, reports_of, scene_of

PICTURES, DATA = (".png", ".pdf", ".svg"), (".nc", ".zarr")
KINDS = "a picture, chart.png, .pdf or .svg; data, chart.nc or chart.zarr"
LARGEST = 10**9                                        # points of a chart that is not written block by block
LONGEST = 10**7                                        # values of an axis


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the chart; 0."""
    path = _path(out)
    numbers = numbers_of(given.values)
    axes = dict(_axes([("--axis", text) for text in given.axis or ()] + [("--y", given.y), ("--x", given.x)]))
    if len(axes) > 2 and path.suffix in PICTURES:
        raise ValuesError(f"a picture has two axes, these are {', '.join(axes)}: write the data, --output {path.with_suffix('.zarr')}")
    if (points := prod(map(len, axes.values()))) > LARGEST and path.suffix != ".zarr":
        raise ValuesError(f"{points} points are more than the {LARGEST} that are held in memory: --output {path.with_suffix('.zarr')}")
    one_spin(names := {**numbers, **dict.fromkeys(axes)})
    scene = scene_of(given.potential)
    if scene.potential is not None and given.equilibrium is None:
        raise ValuesError("--equilibrium is missing, a chart is of one: name E1, E2 or E3")
    (label,) = labels_of(scene, given.equilibrium and [given.equilibrium])
    (report,) = reports_of(given.potential, [label], names)
    *further, y, x = axes.items()
    store = path if path.suffix == ".zarr" else None
    chart = stability_chart(report, x=x, y=y, axes=dict(further), fixed=_as_written(given.values), store=store, backend=given.backend,
                            threads=given.threads)
    if path.suffix in PICTURES:
        _draw(chart, path)
    elif store is None:
        chart.to_netcdf(path, engine="netcdf4", encoding={"verdict": {"zlib": True, "complevel": 1}})
    return 0


def _path(out: Output) -> Path:
    """The file to write, of a kind that there is, and its packages."""
    if out.path is None:
        raise ValuesError(f"--output is missing, a chart goes to a file: name {KINDS}")
    path = Path(out.path)
    if path.suffix not in PICTURES + DATA:
        raise ValuesError(f"--output {path} is of no kind that is written: name {KINDS}")
    for module, extra in (("matplotlib", "plot"),) if path.suffix in PICTURES else (("netCDF4", "charts"),) if path.suffix == ".nc" else ():
        optional(module, extra)
    path.parent.stat()                                 # raises OSError where there is no such folder
    return path


def _axes(texts: Sequence[tuple[str, str]]) -> list[tuple[str, Any]]:
    """The axes of NAME=LOW:HIGH:COUNT, in order."""
    axes: list[tuple[str, Any]] = []
    for option, text in texts:
        name, equals, values = text.partition("=")
        name, ends = name.strip(), values.split(":")
        if not equals or not name.isidentifier() or len(ends) != 3:
            raise ValuesError(f"{option} {text} is not NAME=LOW:HIGH:COUNT: write, for example, {option} l=-2:2:400")
        if name in dict(axes):
            raise ValuesError(f"{name} is an axis twice: give it once")
        low, high = (float(exact_number(end, name)) for end in ends[:2])
        count = ends[2].strip()
        if not count.isdecimal() or not 2 <= int(count) <= LONGEST:
            raise ValuesError(f"{option} {text} has the COUNT {count}: give a whole number from 2 to {LONGEST}; one value goes to --set")
        axes.append((name, np.linspace(low, high, int(count))))
    return axes


def _as_written(settings: Sequence[str]) -> dict[str, str]:
    """The numbers of --set as they stand there."""
    return {name.strip(): value.strip() for name, _, value in (setting.partition("=") for setting in settings)}


def _draw(chart: Any, path: Path) -> None:
    from matplotlib.figure import Figure

    from ..plotting import caption, draw_chart
    figure = Figure()
    draw_chart(chart, figure.subplots(), title=caption(chart))
    figure.savefig(path, dpi=200, bbox_inches="tight")
