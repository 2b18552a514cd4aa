"""The misprints among findings as a table of errata in LaTeX."""
from collections.abc import Iterable
from itertools import groupby
from typing import Any

from sympy import Expr

from ..errors import ExpressionError
from ..printing.formats.article import preamble
from ..printing.formats.latex import formula, tex
from ..printing.formats.latex_names import PLAIN, Names, Paper
from ..printing.formats.prose import words
from ..stability.criteria.conditions import Criterion
from .checks.findings import Finding, source_of
from .listing import NOT_SHARP, SCENE, as_text, number, place, rows
from .printed_latex import formula_of


def _latex(printed: Any, names: Names, at: Any) -> str:
    """A printed text, or texts, in LaTeX: a formula, comparisons, or words."""
    if isinstance(printed, list):
        # so that lines may end at the commas
        entries = "$, $".join(_latex(entry, names, at) for entry in printed)
        return rf"\bigl({entries}\bigr)"
    try:
        return formula_of(printed, names, at)
    except ExpressionError:                                # a verdict in words
        return rf"\text{{{words(printed)}}}"


def _about(f: Finding, names: Names, at: Any) -> str:
    """What the statement is about: a quantity, or a claim in words."""
    quantity = f.statement.quantity
    if f.statement.kind in ("identity", "family", "number", "solution") and quantity != "0":
        return f"${_latex(quantity, names, at)}$"
    return words(quantity) if isinstance(quantity, str) and quantity != "0" else "$0$"


def latex(findings: Iterable[Finding], paper: Paper = PLAIN) -> str:
    """A table of errata: where, what is printed, what is derived, a counterexample."""
    body, names = [], Names(paper.symbols)
    for _, group in groupby((f for f in findings if f.status == "misprint"),
                            key=lambda f: f.statement.source):
        found = list(group)
        source = source_of(found[0])
        title = rf"\rule{{0pt}}{{3ex}}\textbf{{{words(source.name)}}}: {words(source.title)}"
        body += [rf"\multicolumn{{3}}{{@{{}}p{{0.96\textwidth}}@{{}}}}{{{title}}}\\[1ex]"]
        body += [_erratum(f, names) for f in found]
    table = "\n".join(
        (
            r"\begingroup\small\setlength{\LTleft}{0pt}\setlength{\LTright}{0pt}"
            r"\setlength{\emergencystretch}{3em}",
            r"\begin{longtable}{@{}"
            r">{\raggedright\arraybackslash}p{0.19\textwidth}>{\raggedright\arraybackslash}p{0.42\textwidth}"
            r">{\raggedright\arraybackslash}p{0.31\textwidth}@{}}",
            rf"\caption{{Misprints}}{paper.labelled('errata')}\\",
            r"\textbf{Where} & \textbf{Printed, and derived} & "
            r"\textbf{Counterexample}\\ \hline \endhead",
            *body,
            r"\end{longtable}\endgroup",
            "",
        )
    )
    names.check(whole=True)
    if paper.symbols:                                      # prose keeps the names of the grammar
        said = ", ".join(f"{words(name)} is ${symbol}$" for name, symbol in paper.symbols.items())
        table = rf"\noindent In what is said in words, {said}.\par" + "\n" + table
    if paper.fragment:
        return "% needs amsmath, array and longtable\n" + table
    return preamble("Errata", ("longtable", "array")) + table + "\\end{document}\n"


def _erratum(f: Finding, names: Names) -> str:
    at, lines = place(f), [rf"about {_about(f, names, place(f))}"]
    for word, entry, value in rows(f):
        said = f"${_latex(value, names, at)}$" if word == "printed" else _right(value, names, at, f)
        lines.append(rf"{entry}\textbf{{{word}}} {said}")
    if f.statement.note:
        lines.append(rf"\emph{{{words(f.statement.note)}}}")
    example = ""
    if c := f.outcome.counterexample or f.outcome.not_sharp:
        values = ", ".join(f"${names.of(n) if n.isidentifier() else n} = {formula(v, names)}$"
                           for n, v in c.values) or SCENE
        example = f"{NOT_SHARP} " if f.outcome.not_sharp else ""
        example += (
            f"{values}: printed {_value(c.printed)}, derived {_value(c.derived)}; {words(c.confirmation)}"
        )
    where = rf"{words(f.statement.where)} \newline \textsf{{{words(f.statement.key)}}}"
    shown = r" \newline ".join(lines)
    return rf"{where} & {shown} & {example} \\[2ex]"


def _right(value: Any, names: Names, at: Any, f: Finding) -> str:
    if isinstance(value, (str, list)):
        return f"${_latex(value, names, at)}$" if f.outcome.corrected is not None else words(as_text(value))
    return f"${formula(value, names)}$" if isinstance(value, Criterion) else f"${tex(value, names, at)}$"


def _value(value: Any) -> str:
    return f"${formula(value)}$" if isinstance(value, Expr) and value.is_Rational else words(number(value))
