"""Finds what decides between the two conditions of an equilibrium."""
from ...errors import ScopeError
from ...printing.blocks import Block, prose
from ...printing.results.boundary import undecided
from ...printing.results.normal_form import window_blocks
from ...stability.normal_forms.d4_along_family import Window
from ...stability.report.report import Report


def between(report: Report) -> Window | str | None:
    """What decides an equilibrium that gyroscopic forces may stabilise, or why there is no formula.

    None if its conditions leave nothing open.
    """
    if not undecided(report) or report.between:
        return None
    try:
        return report.window()
    except ScopeError as error:
        return str(error)


def between_blocks(found: Window | str) -> list[Block]:
    """The formulas, or the reason."""
    return [prose(found)] if isinstance(found, str) else window_blocks(found)
