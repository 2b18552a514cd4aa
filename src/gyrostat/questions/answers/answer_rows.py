"""The answers of decide as rows with the columns of gs.table, to be written as CSV."""
from collections.abc import Sequence

from ...equilibria.table_rows import Row, aligned, row
from .answers import Answer
from .equilibria import Missing


def answer_rows(answers: Sequence[Answer | Missing]) -> list[Row]:
    """A row for each equilibrium; one of which nothing can be said has a label and an error."""
    return aligned(a.data() if isinstance(a, Missing) else
                   row(a.found, a.found.label if a.found is not None and a.listed else a.label, a.decision,
                       a.damped)
                   for a in answers)
