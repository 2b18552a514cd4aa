"""A scene as a table in, an answer as data for JSON out.

A table, or the options of the command line, become `scene_texts` and `given_numbers`. `answers` finds what
is said of them, and `documents` writes that of a table as report, conditions and decide do with JSON. `page`
shows an equilibrium of a table, its formulas typeset in LaTeX.
"""
from typing import TYPE_CHECKING

from .._lazy import later

if TYPE_CHECKING:
    from .documents import conditions, decide, report
    from .page.shown import WANTED, show

__all__ = ["conditions", "decide", "report", "show", "WANTED"]

__getattr__, __dir__ = later(__name__, {"documents": "conditions decide report", "page.shown": "WANTED show"})
