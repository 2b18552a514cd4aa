"""Takes a scene as a table, and gives the answers of the command line as data for JSON.

A table, or the options of the command line, become `scene_texts` and `given_numbers`. `answers` finds what
is said of them, and `documents` writes it for a table, as report, conditions and decide do with JSON. `page`
shows an equilibrium of a table with formulas in LaTeX.
"""
from typing import TYPE_CHECKING

from .._lazy import later

if TYPE_CHECKING:
    from .documents import conditions, decide, report
    from .page.shown import WANTED, show

__all__ = ["conditions", "decide", "report", "show", "WANTED"]

__getattr__, __dir__ = later(__name__, {"documents": "conditions decide report", "page.shown": "WANTED show"})
