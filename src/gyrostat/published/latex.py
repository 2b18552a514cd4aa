"""Writes findings as LaTeX: the table of errata, and if it is asked for the table of what is confirmed."""
from collections.abc import Iterable

from ..printing.formats.article import preamble
from ..printing.formats.latex_names import PLAIN, Names, Paper
from ..printing.formats.prose import words
from .checks.findings import Finding
from .confirmations import confirmations
from .errata import errata


def latex(findings: Iterable[Finding], paper: Paper = PLAIN, full: bool = False) -> str:
    """Return a document, or a fragment, with the errata; if full, also with what is confirmed."""
    found, names = list(findings), Names(paper.symbols)
    tables = errata(found, names, paper) + (confirmations(found, names, paper) if full else "")
    names.check(whole=True)
    if paper.symbols:                                      # prose keeps the names of the grammar
        said = ", ".join(f"{words(name)} is ${symbol}$" for name, symbol in paper.symbols.items())
        tables = rf"\noindent In what is said in words, {said}.\par" + "\n" + tables
    if paper.fragment:
        return "% needs amsmath, array and longtable\n" + tables
    title = "Errata and confirmed statements" if full else "Errata"
    return preamble(title, ("longtable", "array")) + tables + "\\end{document}\n"
