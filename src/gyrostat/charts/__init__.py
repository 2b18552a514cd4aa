"""The verdict over ranges of parameters.

A margin becomes a program ordered by the axes of a grid (`straightline`), with a proved bound of its
`rounding` error; it runs over the blocks of a grid (`entries`, `grids`, `tiles`, `kernels`, `writing`,
`numeric`; `labels` guards what arrays carry); `constants` are put into long margins first. `signs` and
`deciding` decide every point, exactly where floats do not (`dyadic`), what gyroscopic forces hold together
(`held`, in `ball_arrays`), a list after one look at its columns (`screens`), and `arrays` asks them. Over
boxes it runs in `intervals` and `enclosures`: `regions`, `proofs`, `paving` and `boxes` cover them by
bisection; `answers` are three-valued, `codes` stand for verdicts. `contours` follow the curves between
verdicts by their `crossings` of edges, `window_curves` those inside windows; a `chart` is all of it, a
`request` as one labelled dataset (`datasets`), larger than memory in `stores` (`frame`, `marks`), with a bar
of `progress`.
"""
from typing import TYPE_CHECKING

from .._lazy import later
from ..printing.files import save_netcdf

if TYPE_CHECKING:
    from .boxes.certified_boxes import BoxDecision, CertifiedChart, certified_chart, certify_box
    from .chart import stability_chart
    from .signs.compiled_margins import CompiledMargin, compile_margin
    from .signs.verdict_arrays import verdicts

__all__ = ["BoxDecision", "certified_chart", "CertifiedChart", "certify_box", "compile_margin",
           "CompiledMargin", "save_netcdf", "stability_chart", "verdicts"]

__getattr__, __dir__ = later(__name__, {
    "signs.verdict_arrays": "verdicts", "chart": "stability_chart",
    "signs.compiled_margins": "CompiledMargin compile_margin",
    "boxes.certified_boxes": "BoxDecision CertifiedChart certified_chart certify_box",
})
