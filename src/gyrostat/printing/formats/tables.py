"""Writes conditions as a table of LaTeX, with what its equilibria, its symbols and its terms are."""
import re
from collections.abc import Iterable, Sequence
from typing import Any

from ...notation import symbol
from ...stability.report.report import Report
from ..blocks import Block, Display, Word, joined, sentence
from ..glossary import term_blocks
from ..letters import letter, letters_of, word
from ..nomenclature import Row, occurring, symbol_rows
from ..results.boundary import ladder, rung_display, squared_rate, undecided
from ..results.document import conditions_blocks
from ..results.inequalities import existence
from ..results.rotations import TILTED, definition_blocks, family_blocks, tilt_relations, title_of
from .article import NARROW, block_latex, inline, preamble, sentence_latex
from .latex import display, formula, tex
from .latex_names import PLAIN, Names, Paper
from .linebreaks import width

LONG = 60                                              # characters of a potential that the caption writes out
_COLUMNS = 0.13, 0.2, 0.56                             # of a line: equilibrium, what, formula
_WIDE = 200.0                                          # points: a formula that fills the third column
_RELATION = re.compile(r"(\\geq|\\leq|\\neq|\\propto|[<>=]) ")
_MANY = 30                                             # rows of a table that needs small letters
_LADDER = r"""\par\smallskip\noindent
If the necessary condition holds and the sufficient one does not, the first coefficient $⟨c_⟩_n$ that is not 0
in $%s = ⟨c_⟩_3 ⟨x⟩^3 + ⟨c_⟩_4 ⟨x⟩^4 + \dots$ decides; $\propto$ means up to a positive factor."""
_POLES = r"""At %s, $⟨x⟩ = 1 - |⟨k3⟩| \geq 0$: if $-⟨c_⟩_n > 0$, the equilibrium is Lyapunov stable, and if
$-⟨c_⟩_n < 0$, it is unstable."""
_TILTS = r"""At %s, $⟨x⟩$ is the deviation of $⟨k3⟩$ and has either sign: if $n$ is odd, the equilibrium is
unstable; if $n$ is even, it is Lyapunov stable modulo the flow if $-⟨c_⟩_n > 0$, and unstable if
$-⟨c_⟩_n < 0$."""


def conditions_table(reports: Iterable[Report], paper: Paper = PLAIN, after: Sequence[Block] = ()) -> str:
    """Write the relations of each equilibrium, when it exists, and its conditions, as a table.

    The caption says what the equilibria are and which field acts. Below the table stand what decides between
    the two conditions, the symbols, what comes after, and the terms.
    """
    given, names = list(reports), Names(paper.symbols)
    own = [b for r in given for b in (*family_blocks(r.equilibrium), *definition_blocks(r))]
    rows = []
    for report in given:
        rows += [rf"{report.equilibrium.label if n == 0 else ''} & {name} & {cell} \\{_apart(cell)}"
                 for n, (name, cell) in enumerate(_lines(report, names))] + [r"\hline"]
    columns = "".join(rf">{{\raggedright\arraybackslash}}p{{{share}\linewidth}}" for share in _COLUMNS)
    scene, note = given[0].equilibrium.system, _ladder_note(given, names)
    shown = [part for report in given for part in _parts(report)] + own + note
    symbols = symbol_rows(scene, occurring(shown))
    table = "\n".join((
        rf"\begin{{table}}[htbp]\{'scriptsize' if len(rows) > _MANY else 'footnotesize'}",  # a page holds it
        rf"\caption{{{_caption(given, names)}}}{paper.labelled('conditions')}\smallskip",
        rf"\begin{{tabular}}{{@{{}}{columns}@{{}}}}", r"\hline", *rows, r"\end{tabular}", r"\end{table}",
        *(tex(part, names) for part in note),
        *([rf"\par\smallskip\noindent In Table~\ref{{{paper.label}:conditions}}, "
           + _said(symbols.rows, names)] if symbols.rows else ()), ""))
    terms = term_blocks([*(b for r in given for b in conditions_blocks(r)), *after])
    table += "".join(block_latex(block, names, NARROW) + "\n" for block in (*own, *after, *terms))
    names.check(whole=True)
    if paper.fragment:
        return "% needs amsmath and array\n" + table
    return preamble("Conditions for stability", ("array",)) + table + "\\end{document}\n"


def _caption(given: Sequence[Report], names: Names) -> str:
    """Say what the table is about: the field, and how each equilibrium moves."""
    potential = given[0].equilibrium.system.potential
    field: tuple[Any, ...] = (" without a field",)
    if potential is not None:
        U = letter(letters_of(given[0].equilibrium.system), "U")
        field = (" in the potential ", U)
        if not potential.given:
            field = (" in the potential ", potential.expression)
        elif len(str(potential.expression)) <= LONG:
            field = (" in the potential ", U, " = ", potential.expression)
    titles = [title for title in (title_of(report.equilibrium) for report in given) if ": " in title]
    tilt: tuple[Any, ...] = ()
    if any(report.equilibrium.label in TILTED for report in given):
        tilt = (" The cosine of the tilt is ", symbol("k3"), ".")
    said = sentence("Conditions for stability", *field, ".", *(f" {title}." for title in titles), *tilt)
    return sentence_latex(said, names).removesuffix(r"\par")


def _lines(report: Report, names: Names) -> list[tuple[str, str]]:
    """Write what stands in the second and the third column."""
    relations = [("satisfies", block) for block in tilt_relations(report.equilibrium)]
    exists = [("exists if", block) for block in _existence(report)]
    rungs = [("between the two", block) for block in _rungs(report)]
    parts = [*relations, *exists]
    before = [("" if n and parts[n - 1][0] == name else name, _cell(display(block, names)))
              for n, (name, block) in enumerate(parts)]
    between = [("" if n else name, _cell(display(block, names))) for n, (name, block) in enumerate(rungs)]
    return [*before, ("necessary (spectral)", _cell(formula(report.necessary, names))),
            ("sufficient (formal)", _cell(formula(report.sufficient, names))), *between,
            ("under internal damping (secular)", _cell(formula(report.damped, names)))]


def _apart(cell: str) -> str:
    """Write the space below a cell that keeps its fractions from touching the next row."""
    return "[3pt]" if r"\frac" in cell.rsplit(r"\newline")[-1] else ""


def _cell(line: str) -> str:
    """Write a formula for the column; no line ends after a relation.

    The flow that is divided out has a line of its own.
    """
    kept = inline(line)
    if width(line) > _WIDE:
        kept = _RELATION.sub(r"\1\\nobreak ", kept)
    return f"${kept}$".replace(r" \quad \text{", r"$\newline $\text{")


def _existence(report: Report) -> list[Display]:
    eq = report.equilibrium
    return [existence(d, eq.at) for d in eq.existence() if d.free_symbols]


def _rungs(report: Report) -> list[Display]:
    """The ladder between the two conditions."""
    if not undecided(report) or report.boundary is None:
        return []
    letters = letters_of(report.equilibrium.system)
    return [rung_display(rung, letters) for rung in ladder(report.boundary)[0]]


def _ladder_note(given: Sequence[Report], names: Names) -> list[Word]:
    """Say what the coefficients between the two conditions mean, at poles and at tilts."""
    of = {report.equilibrium.label: report.boundary.pole for report in given
          if report.boundary is not None and _rungs(report)}
    if not of:
        return []
    scene = given[0].equilibrium.system
    parts = [_LADDER.replace("%s", tex(squared_rate(scene), names))]
    for template, pole in ((_POLES, True), (_TILTS, False)):
        if labels := [label for label, here in of.items() if here is pole]:
            parts.append(template.replace("%s", " and ".join(labels)))
    return [word(letters_of(scene), "", "\n".join(parts) + r"\par")]


def _parts(report: Report) -> list[Any]:
    """The formulas of the table."""
    criteria = report.necessary, report.sufficient, report.damped
    conditions = [c for criterion in criteria for alternative in criterion.alternatives for c in alternative]
    return [*tilt_relations(report.equilibrium), *_existence(report), *_rungs(report),
            *(x for c in conditions for x in (c.margin, *c.degenerate)),
            *(x for criterion in criteria for x in criterion.modulo)]


def _said(rows: Sequence[Row], names: Names) -> str:
    """Say what the symbols are, in a sentence."""
    clauses = [(*left, ": ", *right) for left, right in rows]
    return sentence_latex(sentence(*joined("; ", clauses), "."), names)
