"""Writes columns as a table in LaTeX that may span pages, with a caption and sentences below it."""
from collections.abc import Sequence

from .article import preamble
from .latex_names import Paper
from .prose import words
from .text_tables import Column

SMALL = 9                                              # columns from which on letters are small


def longtable(caption: str, columns: Sequence[Column], notes: Sequence[str], said: Sequence[str],
              paper: Paper) -> str:
    """Return a document, or a fragment for a column of 12 cm, with the table and sentences below it.

    Parameters
    ----------
    caption : str
    columns : sequence of Column
        as for a text
    notes : sequence of str
        what stands below each row, if anything
    said : sequence of str
        sentences below the table
    paper : Paper
    """
    table = _table(caption, columns, notes, paper) if columns else []
    body = "\n".join([*table, *(rf"\par\noindent {words(text)}\par" for text in said), ""])
    if paper.fragment:
        return "% needs amsmath and longtable\n" + body
    return preamble("Relative equilibria of a gyrostat", ("longtable",)) + body + "\\end{document}\n"


def _table(caption: str, columns: Sequence[Column], notes: Sequence[str], paper: Paper) -> list[str]:
    heads = [[c.title.replace("#", "") for c in columns], [c.unit for c in columns]]
    rows = []
    for n, note in enumerate(notes):
        rows.append(_row([c.cells[n] for c in columns]))
        if note:
            width = rf"{{{len(columns) - 1}}}{{p{{0.85\linewidth}}}}"
            rows[-1] += "*"                                # no page ends here
            rows.append(rf"& \multicolumn{width}{{\raggedright {words(note)}}} \\")
    size = "scriptsize" if len(columns) >= SMALL else "small"
    return [rf"\begingroup\{size}\setlength{{\tabcolsep}}{{3pt}}",
            rf"\begin{{longtable}}{{@{{}}{''.join('r' if c.number else 'l' for c in columns)}@{{}}}}",
            rf"\caption{{{words(caption)}}}{paper.labelled('equilibria')}\\",
            r"\hline", *(_row(head) for head in heads if any(head)), r"\hline \endhead", r"\hline \endfoot",
            *rows, r"\end{longtable}\endgroup"]


def _row(cells: Sequence[str]) -> str:
    return rf"{' & '.join(map(words, cells))} \\"
