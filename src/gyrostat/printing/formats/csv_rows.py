"""Writes rows as CSV: a header, a line for each row, numbers in as many digits as tell doubles apart."""
import csv
from collections.abc import Mapping, Sequence
from io import StringIO
from typing import Any


def csv_text(rows: Sequence[Mapping[str, Any]]) -> str:
    """Return rows with the same keys as CSV (RFC 4180, in UTF-8); None is an empty cell.

    Examples
    --------
    >>> print(csv_text([{"number": 1, "r1": 0.1, "note": "a, b", "growth_rate": None}]))
    number,r1,note,growth_rate
    1,0.1,"a, b",
    <BLANKLINE>
    """
    file = StringIO(newline="")
    writer = csv.DictWriter(file, list(rows[0]) if rows else [], lineterminator="\n")
    if rows:
        writer.writeheader()
        writer.writerows(rows)
    return file.getvalue()
