"""The verdict over ranges of parameters.

A margin becomes a program ordered by the axes of a grid (`straightline`), with a proved bound of its
`rounding` error; it runs over the blocks of a grid (`grids`, `tiles`, `kernels`, `numeric`; `labels` guards
what arrays carry). `signs` and `arrays` decide every point, exactly where floats do not. Over boxes it runs
in `intervals`: `regions`, `proofs`, `paving` and `boxes` cover them by bisection. `contours` follow the
curves between verdicts; a `chart` is all of it as one labelled dataset (`datasets`), larger than memory in
`stores` (`layout`, `marks`), with a bar of `progress`.
"""
from .arrays import verdicts
from .boxes import BoxDecision, CertifiedChart, certified_chart, certify_box
from .chart import stability_chart
from .numeric import compile_margin

__all__ = ["BoxDecision", "CertifiedChart", "certified_chart", "certify_box", "compile_margin",
           "stability_chart", "verdicts"]
