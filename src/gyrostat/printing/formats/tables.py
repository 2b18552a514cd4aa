"""Conditions as a table of LaTeX, with what its symbols are."""
from collections.abc import Iterable, Sequence
from typing import Any

from ...stability.report.report import Report
from ..blocks import Block, Display, Word, joined, sentence
from ..letters import letters_of, word
from ..nomenclature import Row, occurring, symbol_rows
from ..results.boundary import ladder, rung_display, squared_rate, undecided
from ..results.inequalities import existence
from ..results.rotations import definition_blocks, family_blocks
from .article import NARROW, block_latex, inline, preamble, sentence_latex
from .latex import display, formula, tex
from .latex_names import PLAIN, Names, Paper

_COLUMNS = 0.13, 0.2, 0.56                             # of a line: equilibrium, what, formula
_BETWEEN = r"""\par\smallskip\noindent
Between the two, $%s = ⟨c_⟩_3 ⟨x⟩^3 + ⟨c_⟩_4 ⟨x⟩^4 + \dots$, where $⟨x⟩ \geq 0$ is the distance
of $⟨k3⟩$ from $\pm 1$, at E3 its deviation, and $\propto$ means up to a positive factor.
The first coefficient that is not 0 decides.
At E1 and E2, and of an even power at E3: $-⟨c_⟩_n > 0$ is stable, $-⟨c_⟩_n < 0$ unstable;
of an odd power at E3 both are unstable.\par"""


def conditions_table(reports: Iterable[Report], paper: Paper = PLAIN, after: Sequence[Block] = ()) -> str:
    """Where each equilibrium exists, its necessary and its sufficient condition, as a table.

    Below it what its symbols are, and what comes after.
    """
    given, names = list(reports), Names(paper.symbols)
    own = [b for r in given for b in (*family_blocks(r.equilibrium), *definition_blocks(r))]
    rows = []
    for report in given:
        rows += [
            rf"{report.equilibrium.label if n == 0 else ''} & {name} & ${inline(line)}$ \\"
            for n, (name, line) in enumerate(_lines(report, names))
        ] + [r"\hline"]
    columns = "".join(rf">{{\raggedright\arraybackslash}}p{{{width}\linewidth}}" for width in _COLUMNS)
    between = any("between the two" in row for row in rows)
    scene, note = given[0].equilibrium.system, list[Word]()
    if between:
        rate = tex(squared_rate(scene), names)
        note = [word(letters_of(scene), "", _BETWEEN.replace("%s", rate))]
    shown = [part for report in given for part in _parts(report)] + own + note
    symbols = symbol_rows(scene, occurring(shown))
    table = "\n".join((
        r"\begin{table}[htbp]\footnotesize",               # so that a page holds it
        rf"\caption{{Conditions for stability}}{paper.labelled('conditions')}\smallskip",
        rf"\begin{{tabular}}{{@{{}}{columns}@{{}}}}", r"\hline", *rows, r"\end{tabular}", r"\end{table}",
        *(tex(part, names) for part in note),
        *([rf"\par\smallskip\noindent In Table~\ref{{{paper.label}:conditions}}, "
           + _said(symbols.rows, names)] if symbols.rows else ()), ""))
    table += "".join(block_latex(block, names, NARROW) + "\n" for block in (*own, *after))
    names.check(whole=True)
    if paper.fragment:
        return "% needs amsmath and array\n" + table
    return preamble("Conditions for stability", ("array",)) + table + "\\end{document}\n"


def _lines(report: Report, names: Names) -> list[tuple[str, str]]:
    """What stands in the second and the third column."""
    exists = [("exists where", display(block, names)) for block in _existence(report)]
    rungs = [("" if n else "between the two", display(rung, names)) for n, rung in enumerate(_rungs(report))]
    return [*exists, ("necessary (spectral)", formula(report.necessary, names)),
            ("sufficient (formal)", formula(report.sufficient, names)), *rungs,
            ("under internal damping (secular)", formula(report.damped, names))]


def _existence(report: Report) -> list[Display]:
    eq = report.equilibrium
    return [existence(d, eq.at) for d in eq.existence() if d.free_symbols]


def _rungs(report: Report) -> list[Display]:
    """The ladder between the two conditions."""
    if not undecided(report) or report.boundary is None:
        return []
    letters = letters_of(report.equilibrium.system)
    return [rung_display(rung, letters) for rung in ladder(report.boundary)[0]]


def _parts(report: Report) -> list[Any]:
    """The formulas of the table."""
    criteria = report.necessary, report.sufficient, report.damped
    conditions = [c for criterion in criteria for alternative in criterion.alternatives for c in alternative]
    return [*_existence(report), *_rungs(report), *(x for c in conditions for x in (c.margin, *c.degenerate)),
            *(x for criterion in criteria for x in criterion.modulo)]


def _said(rows: Sequence[Row], names: Names) -> str:
    """What the symbols are, in a sentence."""
    clauses = [(*left, ": ", *right) for left, right in rows]
    return sentence_latex(sentence(*joined("; ", clauses), "."), names)
