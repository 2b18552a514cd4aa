"""The answers of decide as rows with the columns of gs.table, to be written as CSV."""
from collections.abc import Sequence

from ...equilibria.table_rows import Row, aligned, of_well, row
from .answers import Answer
from .equilibria import Missing


def answer_rows(answers: Sequence[Answer | Missing], wells: bool = False) -> list[Row]:
    """A row for each equilibrium; one of which nothing can be said has a label and an error.

    wells adds the columns of their wells.
    """
    return aligned(a.data() if isinstance(a, Missing) else
                   row(a.found, a.found.label if a.found is not None and a.listed else a.label, a.decision,
                       a.damped) | (of_well(a.well) if wells else {})
                   for a in answers)
