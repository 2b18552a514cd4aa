"""Charts: the exact verdict over ranges of parameters, and the curves on which it changes.

A `chart` answers a `request`: `grids` names the numbers, from which `labels` refuses what has other labels or
masks, `programs` compute margins at every point of them, `signs` decides there, exactly where floats do not,
and `codes` stand for the verdicts. `curves` follows the boundaries between verdicts, `datasets` describes the
result, and `stores` keeps what is larger than memory, with a bar of `progress`. `barriers` adds how much a
stable point survives. `boxes` proves a verdict for all points of a box at once.
"""
from typing import TYPE_CHECKING

from .._lazy import later
from ..printing.files import save_netcdf

if TYPE_CHECKING:
    from .barriers import with_barriers
    from .boxes.certified_boxes import BoxDecision, CertifiedChart, certified_chart, certify_box
    from .chart import stability_chart
    from .signs.compiled_margins import CompiledMargin, compile_margin
    from .signs.verdict_arrays import verdicts

__all__ = ["BoxDecision", "certified_chart", "CertifiedChart", "certify_box", "compile_margin",
           "CompiledMargin", "save_netcdf", "stability_chart", "verdicts", "with_barriers"]

__getattr__, __dir__ = later(__name__, {
    "signs.verdict_arrays": "verdicts", "chart": "stability_chart", "barriers": "with_barriers",
    "signs.compiled_margins": "CompiledMargin compile_margin",
    "boxes.certified_boxes": "BoxDecision CertifiedChart certified_chart certify_box"})
