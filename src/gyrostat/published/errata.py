"""Sets the misprints among findings as a table of errata in LaTeX."""
from collections.abc import Iterable
from typing import Any

from sympy import Expr

from ..printing.formats.latex import formula, tex
from ..printing.formats.latex_names import Names, Paper
from ..printing.formats.prose import words
from ..stability.criteria.conditions import Criterion
from .checks.findings import Finding
from .listing import NOT_SHARP, SCENE, as_text, number, place, rows
from .longtable import longtable, place_cell
from .printed_latex import printed_latex

COLUMNS = (("Where", 0.19), ("Printed, and derived", 0.42), ("Counterexample", 0.31))


def _about(f: Finding, names: Names, at: Any) -> str:
    """Return what the statement is about: a quantity, or a claim in words."""
    quantity = f.statement.quantity
    if f.statement.kind in ("identity", "family", "number", "solution") and quantity != "0":
        return f"${printed_latex(quantity, names, at)}$"
    return words(quantity) if isinstance(quantity, str) and quantity != "0" else "$0$"


def errata(findings: Iterable[Finding], names: Names, paper: Paper) -> str:
    """Return a table of the misprints: where, what is printed, what is derived, a counterexample."""
    return longtable("Misprints", "errata", COLUMNS, (f for f in findings if f.status == "misprint"),
                     lambda f: _erratum(f, names), paper)


def _erratum(f: Finding, names: Names) -> str:
    at, lines = place(f), [rf"about {_about(f, names, place(f))}"]
    for word, entry, value in rows(f):
        said = f"${printed_latex(value, names, at)}$" if word == "printed" else _right(value, names, at, f)
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
    shown = r" \newline ".join(lines)
    return rf"{place_cell(f)} & {shown} & {example} \\[2ex]"


def _right(value: Any, names: Names, at: Any, f: Finding) -> str:
    if isinstance(value, (str, list)):
        corrected = f.outcome.corrected is not None
        return f"${printed_latex(value, names, at)}$" if corrected else words(as_text(value))
    return f"${formula(value, names)}$" if isinstance(value, Criterion) else f"${tex(value, names, at)}$"


def _value(value: Any) -> str:
    return f"${formula(value)}$" if isinstance(value, Expr) and value.is_Rational else words(number(value))
