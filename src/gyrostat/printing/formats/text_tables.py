"""Tables in Unicode: aligned columns, in a second line of each row where one line is too narrow."""
from collections.abc import Sequence
from dataclasses import dataclass
from textwrap import wrap

BETWEEN = "  "


@dataclass(frozen=True)
class Column:
    """A title, a unit or "", and a cell for each row; numbers stand on the right."""

    title: str
    cells: Sequence[str]
    unit: str = ""
    number: bool = False

    @property
    def width(self) -> int:
        """The characters of its widest cell."""
        return max(map(len, (self.title, self.unit, *self.cells)))

    def shown(self, text: str) -> str:
        """A text in the width of the column."""
        return text.rjust(self.width) if self.number else text.ljust(self.width)


def table_text(columns: Sequence[Column], notes: Sequence[str], width: int) -> str:
    """The table, and below each row what is noted of it, if anything.

    The first column stays on the first line. Columns that do not fit there go on further lines.

    Examples
    --------
    >>> print(table_text([Column("#", ["1", "2"]), Column("x", ["5/12", "−1"], "m", True)], ["", ""], 80))
    #     x
          m
    1  5/12
    2    −1
    """
    first, *others = columns
    indent = " " * len(first.width * " " + BETWEEN)
    groups: list[list[Column]] = [[first]]
    for column in others:
        if len(BETWEEN.join(" " * c.width for c in [*groups[-1], column])) + len(
                indent if len(groups) > 1 else "") > width and len(groups[-1]) > (len(groups) == 1):
            groups.append([])
        groups[-1].append(column)
    titles = [[c.title for c in group] for group in groups]
    rows = [_lines(groups, titles, indent)]
    if any(c.unit for c in columns):
        rows.append(_lines(groups, [[c.unit for c in group] for group in groups], indent))
    for n, note in enumerate(notes):
        rows.append(_lines(groups, [[c.cells[n] for c in group] for group in groups], indent)
                    + wrap(note, width, initial_indent=indent, subsequent_indent=indent))
    return "\n".join(line for row in rows for line in row)


def _lines(groups: Sequence[Sequence[Column]], texts: Sequence[Sequence[str]], indent: str) -> list[str]:
    """A row, a line for each group of columns."""
    lines = [BETWEEN.join(c.shown(text) for c, text in zip(group, its)).rstrip()
             for group, its in zip(groups, texts)]
    return [lines[0], *(f"{indent}{line}" for line in lines[1:])]
