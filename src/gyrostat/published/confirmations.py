"""Sets what is confirmed as a LaTeX table: its place, the derived formula, its hypotheses, the comparison."""
from collections.abc import Iterable
from typing import Any

from sympy import Expr, MatrixBase

from ..printing.formats.article import LINE, NARROW, inline
from ..printing.formats.latex import formula, tex
from ..printing.formats.latex_names import Names, Paper
from ..printing.formats.linebreaks import width
from ..printing.formats.prose import words
from ..stability.criteria.conditions import Criterion
from .checks.findings import Finding
from .hypotheses import Printed, hypotheses
from .listing import IN_WORDS, is_short, place, quantity, shortest
from .longtable import longtable, place_cell
from .printed_latex import printed_latex
from .statements import as_text, entry_of

DERIVED = 0.44                                         # of the width of the text
COLUMNS = (("Where", 0.16), ("Derived", DERIVED), ("Hypotheses, and comparison", 0.33))


def confirmations(findings: Iterable[Finding], names: Names, paper: Paper) -> str:
    """Return a table of the confirmed statements."""
    limit = DERIVED * (NARROW if paper.fragment else LINE)
    return longtable("Confirmed statements", "confirmed", COLUMNS,
                     (f for f in findings if f.status == "confirmed"), lambda f: _row(f, names, limit), paper)


def _row(f: Finding, names: Names, limit: float) -> str:
    assumed = [rf"\textbf{{{name}}} {''.join(_piece(piece, names, place(f)) for piece in pieces)}"
               for name, pieces in hypotheses(f.statement)]
    under = r" \newline ".join([*assumed, rf"\textbf{{compared}} {words(f.outcome.route)}"])
    return rf"{place_cell(f)} & {_derived(f, names, limit)} & {under} \\ \noalign{{\medskip}}"


def _piece(piece: str | Expr, names: Names, at: Any) -> str:
    """Words as words, formulas in mathematical mode."""
    if isinstance(piece, Printed):
        return f"${inline(printed_latex(piece, names, at))}$"
    return words(piece) if isinstance(piece, str) else f"${inline(tex(piece, names, at))}$"


def _derived(f: Finding, names: Names, limit: float) -> str:
    """The quantity, with what is derived for it."""
    value, at = f.outcome.derived, place(f)
    if f.statement.kind in IN_WORDS:
        shown = f"${_open(formula(value, names))}$" if isinstance(value, Criterion) else words(value)
        return f"{words(as_text(f.statement.quantity))}: {shown}"
    left = inline(printed_latex(quantity(f), names, at))
    if f.statement.kind == "number":
        return f"${left} {_decimal(value, names)}$"
    if not isinstance(value, MatrixBase):
        return f"${left} = {inline(tex(shortest(value, at), names, at))}$"
    value = value.applyfunc(lambda entry: shortest(entry, at))
    if value.cols == 1:
        listed = "$, $".join(inline(tex(entry, names, at)) for entry in value)
        return f"${left} = ({listed})$"                    # a line may end at each comma
    if width(whole := f"{left} = {tex(value, names, at)}") <= limit:
        return f"${whole}$"
    entries = [f"{entry_of((i, j), value)}${inline(tex(value[i, j], names, at))}$"
               for i in range(value.rows) for j in range(value.cols) if value[i, j]]
    others = ["the others are 0"] if len(entries) < len(value) else []
    return r" \newline ".join([f"${left}$ has the entries", *entries, *others])


def _open(shown: str) -> str:
    """Alternatives without brackets that keep a line from being broken."""
    return inline(shown).replace(r"\left[", "[").replace(r"\right]", "]")


def _decimal(value: Expr, names: Names) -> str:
    """A number after its sign: = and exact if that is short, else ≈ and 15 digits."""
    digits = str(value.evalf(15))
    if not is_short(value):
        return rf"\approx {digits}"
    return f"= {tex(value, names)}" + ("" if value.is_Rational else rf" \approx {digits}")
