"""Reports as LaTeX articles and fragments: sentences, numbered equations that fit the line, references.

Tables of conditions.
"""
from collections.abc import Iterable, Sequence
from typing import Any

from sympy import MatrixBase

from ..stability.report import Decision, Report
from .blocks import Block, Display, Heading, Sentence, Word
from .boundary import ladder, rung_display, undecided
from .conditions import existence
from .decision import decision_blocks
from .document import report_blocks, scene_blocks
from .latex import RELATIONS, display, formula, tex
from .linebreaks import broken, width
from .references import cited

_BETWEEN = "\n".join((
    r"\par\smallskip\noindent Between the two, $I_1^2 \dot{k}_3^2 = c_3 x^3 + c_4 x^4 + \dots$, "
    r"where $x \geq 0$ is the distance of",
    r"$k_3$ from $\pm 1$, at E3 its deviation, and $\propto$ means up to a positive factor. "
    r"The first coefficient that is not 0 decides. At E1",
    r"and E2, and of an even power at E3: $-c_n > 0$ is stable, $-c_n < 0$ unstable; "
    r"of an odd power at E3 both are unstable.\par",
    ""))
LINE, NARROW = 440.0, 315.0                                # points: a line of a document, of a fragment
_COLUMNS = 0.13, 0.2, 0.56                                 # of a line: equilibrium, what, formula


def document(reports: Iterable[Report], decisions: Iterable[Decision | None] = (), fragment: bool = False,
             after: Sequence[Block] = ()) -> str:
    """An article with the scene of the first report, every report, the decisions that go with them, and what
    comes after.

    A fragment has no preamble, fits a column of 12 cm, and names its references in comments.
    """
    given = list(reports)
    blocks = scene_blocks(given[0].equilibrium.system)
    for report, decision in zip(given, list(decisions) or [None] * len(given)):
        blocks += report_blocks(report) + (decision_blocks(decision, report.equilibrium.at) if decision
                                           else [])
    blocks += after
    return article("Stability of the relative equilibria of a gyrostat", blocks, fragment)


def article(title: str, blocks: Sequence[Block], fragment: bool = False) -> str:
    """Blocks as an article or a fragment, with the works they cite."""
    body = "\n".join(_block(block, NARROW if fragment else LINE) for block in blocks)
    works = cited([part for block in blocks if isinstance(block, Sentence)
                   for part in block.parts if isinstance(part, str)])
    if fragment:
        return "\n".join(["% needs amsmath" + ("; it cites" if works else ""),
                          *(f"% {_words(work)}" for work in works), body, ""])
    listed = "\n".join(rf"\item {_words(work)}" for work in works)
    references = "\\section*{References}\n\\begin{itemize}\n" + listed + "\n\\end{itemize}\n" if works else ""
    return preamble(title) + body + "\n" + references + "\\end{document}\n"


def conditions_table(reports: Iterable[Report], fragment: bool = False, after: Sequence[Block] = ()) -> str:
    """Where each equilibrium exists, its necessary and its sufficient condition, as a table.

    Below it what comes after.
    """
    rows = []
    for report in reports:
        eq = report.equilibrium
        exists = [("exists where", display(existence(d, eq.at))) for d in eq.existence() if d.free_symbols]
        lines = [*exists, ("necessary (spectral)", formula(report.necessary)),
                 ("sufficient (formal)", formula(report.sufficient)),
                 *_between(report)]
        rows += [
            rf"{eq.label if n == 0 else ''} & {name} & ${_inline(line)}$ \\"
            for n, (name, line) in enumerate(lines)
        ] + [r"\hline"]
    columns = "".join(rf">{{\raggedright\arraybackslash}}p{{{width}\linewidth}}" for width in _COLUMNS)
    table = "\n".join((rf"\begin{{tabular}}{{@{{}}{columns}@{{}}}}", r"\hline", *rows, r"\end{tabular}", ""))
    if "between the two" in table:
        table += _BETWEEN
    table += "".join(_block(block, NARROW) + "\n" for block in after)
    if fragment:
        return "% needs amsmath and array\n" + table
    return preamble("Conditions for stability", ("array",)) + table + "\\end{document}\n"


def _between(report: Report) -> list[tuple[str, str]]:
    """The ladder between the two conditions, as rows."""
    if not undecided(report) or report.boundary is None:
        return []
    rungs, _ = ladder(report.boundary)
    return [("" if n else "between the two", display(rung_display(rung))) for n, rung in enumerate(rungs)]


def preamble(title: str, packages: Iterable[str] = ()) -> str:
    """An article up to its title."""
    return "\n".join((r"\documentclass{article}", r"\usepackage[utf8]{inputenc}",
                      *(rf"\usepackage{{{p}}}" for p in ("amsmath", *packages)),
                      r"\setlength{\textwidth}{17cm}", r"\setlength{\oddsidemargin}{-0.5cm}",
                      r"\setlength{\parindent}{0pt}",
                      r"\setlength{\emergencystretch}{3em}", r"\allowdisplaybreaks",
                      rf"\title{{{title}}}", r"\author{}", r"\date{}", r"\begin{document}", r"\maketitle",
                      ""))


def _block(block: Block, limit: float) -> str:
    if isinstance(block, Heading):
        return rf"\{'section' if block.level == 1 else 'subsection'}*{{{_words(block.title)}}}"
    if isinstance(block, Sentence):
        return "".join(_words(part) if isinstance(part, str) else f"${_inline(tex(part, block.at))}$"
                       for part in block.parts) + r"\par"
    lines = _equations(block, limit)
    listed = rf"The entries of ${tex(block.name, block.at)}$ that are not 0:\par" if len(lines) > 1 else ""
    return "\n".join([*filter(None, [listed]),
                      *(rf"\begin{{equation}} {line} \end{{equation}}" for line in lines)])


def _equations(block: Display, limit: float) -> list[str]:
    """The display, broken where it is too wide.

    A matrix that stays too wide by its entries that are not 0.
    """
    whole = display(block)
    if width(whole) <= limit:
        return [whole]
    name, relation = tex(block.name, block.at), RELATIONS.get(block.relation, block.relation)
    if not isinstance(block.value, MatrixBase) and width(name) > limit / 3:
        return [r"\begin{aligned}[b] & " + r" \\ & \quad ".join(broken(whole, limit)) + r" \end{aligned}"]
    if not isinstance(block.value, MatrixBase):
        first, *rest = broken(f"{relation} {tex(block.value, block.at)}", limit - width(name))
        return [rf"\begin{{aligned}}[b] {name} & {first} \\ "
                + r" \\ ".join(rf"& \quad {line}" for line in rest) + r" \end{aligned}"]
    if width(whole) <= 1.2 * limit:
        return [rf"\text{{\footnotesize$\displaystyle {whole}$}}"]
    return [line for i, row in enumerate(block.value.tolist(), 1) for j, entry in enumerate(row, 1) if entry
            for line in _equations(Display(Word("", rf"{name}_{{{i}{j}}}"), entry, block.at), limit)]


def _inline(formula: str) -> str:
    """A formula in a sentence: its parentheses do not keep it from being broken."""
    return formula.replace(r"\left(", "(").replace(r"\right)", ")")


def _words(text: str) -> str:
    """Prose in LaTeX, in ASCII; an expression in it stands as it is typed."""
    text = (
        text.replace("\\", r"\char92 ")
        .replace("^", r"\char94 ")
        .replace("~", r"\char126 ")
        .replace("…", r"\ldots ")
    )
    for sign in "_%#$":
        text = text.replace(sign, rf"\{sign}")
    for sign in ("<", ">", *RELATIONS):
        text = text.replace(f" {sign} ", f" ${RELATIONS.get(sign, sign)}$ ")
    return text.replace("&", r"\&").replace("§", r"\S").replace("í", r"\'{\i}")


def to_latex(obj: Any) -> str:
    r"""LaTeX of a public object: a formula for everything but a report, which becomes a whole document.

    Parameters
    ----------
    obj : Expr, Condition, Criterion, Linearization, SecondVariation, System, Equilibrium, Report, …
        or a matrix, LiePoisson, Gyrostat, Potential, Decision; or a sequence of Report, for one document

    Returns
    -------
    str
        without dollar signs; the document is of class article and uses amsmath

    Raises
    ------
    TypeError
        for anything else

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> print(gs.to_latex(gs.analyze(gs.upright(top)).sufficient))
    \left(\pi_3^0 + l\right)^{2} > 4 I_1 U'(1)
    """
    if isinstance(obj, Report):
        return document([obj])
    if isinstance(obj, (list, tuple)) and obj and all(isinstance(report, Report) for report in obj):
        return document(obj)
    return formula(obj)
