"""Sets findings in a LaTeX table of three columns, under the title of each source; it may span pages."""
from collections.abc import Callable, Iterable, Sequence
from itertools import groupby

from ..printing.formats.latex_names import Paper
from ..printing.formats.prose import words
from .checks.findings import Finding, source_of

Column = tuple[str, float]                             # its title, and its part of the width of the text


def longtable(caption: str, label: str, columns: Sequence[Column], findings: Iterable[Finding],
              row: Callable[[Finding], str], paper: Paper) -> str:
    """Return the table, with the row that is made for each finding."""
    body = list[str]()
    for _, group in groupby(findings, key=lambda f: f.statement.source):
        found = list(group)
        source = source_of(found[0])
        title = rf"\rule{{0pt}}{{3ex}}\textbf{{{words(source.name)}}}: {words(source.title)}"
        body += [rf"\multicolumn{{3}}{{@{{}}p{{0.96\textwidth}}@{{}}}}{{{title}}}\\[1ex]", *map(row, found)]
    widths = "".join(rf">{{\raggedright\arraybackslash}}p{{{width}\textwidth}}" for _, width in columns)
    heads = " & ".join(rf"\textbf{{{title}}}" for title, _ in columns)
    return "\n".join((
        r"\begingroup\small\setlength{\LTleft}{0pt}\setlength{\LTright}{0pt}"
        r"\setlength{\emergencystretch}{3em}",
        rf"\begin{{longtable}}{{@{{}}{widths}@{{}}}}",
        rf"\caption{{{caption}}}{paper.labelled(label)}\\",
        rf"{heads}\\ \hline \endhead",
        *body,
        r"\end{longtable}\endgroup",
        ""))


def place_cell(finding: Finding) -> str:
    """Return where the source prints the statement, and its key."""
    return rf"{words(finding.statement.where)} \newline \textsf{{{words(finding.statement.key)}}}"
