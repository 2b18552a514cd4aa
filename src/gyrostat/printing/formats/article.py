"""Writes reports as LaTeX articles or fragments, with equations that fit the line, and references."""
import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from sympy import MatrixBase

from ...arguments import checked
from ...stability.report.report import Report
from ..blocks import Block, Display, Heading, Rows, Sentence, Word
from ..results.document import report_blocks, whole_blocks
from .latex import RELATIONS, display, formula, tex
from .latex_names import PLAIN, Names, Paper
from .linebreaks import broken, width
from .prose import words
from .references import cited

LINE, NARROW = 440.0, 315.0                                # points: a line of a document, of a fragment
_SYMBOLS = 0.22, 0.72                                      # of a line: symbols, what they are


def document(reports: Iterable[Report], decisions: Iterable[Sequence[Block]] = (), paper: Paper = PLAIN,
             after: Sequence[Block] = ()) -> str:
    """Write an article: the scene of the first report, every report with its decision, and what follows.

    A fragment has no preamble, fits a column of 12 cm, and names its references in comments.
    """
    given = list(reports)
    blocks: list[Block] = []
    for report, decided in zip(given, list(decisions) or [()] * len(given)):
        blocks += [*report_blocks(report), *decided]
    blocks = whole_blocks(given[0].equilibrium.system, [*blocks, *after])
    return article("Stability of the relative equilibria of a gyrostat", blocks, paper)


def article(title: str, blocks: Sequence[Block], paper: Paper = PLAIN) -> str:
    """Write blocks as an article or a fragment, with the works they cite."""
    names, labels, limit = Names(paper.symbols), Labels(paper), NARROW if paper.fragment else LINE
    body = "\n".join(block_latex(block, names, limit, labels) for block in blocks)
    names.check(whole=True)
    works = cited([part for block in blocks if isinstance(block, Sentence)
                   for part in block.parts if isinstance(part, str)])
    if paper.fragment:
        return "\n".join(["% needs amsmath" + ("; it cites" if works else ""),
                          *(f"% {_words(work)}" for work in works), body, ""])
    listed = "\n".join(rf"\item {_words(work)}" for work in works)
    references = "\\section*{References}\n\\begin{itemize}\n" + listed + "\n\\end{itemize}\n" if works else ""
    return preamble(title) + body + "\n" + references + "\\end{document}\n"


class Labels:
    """Gives the labels of a document, each once."""

    def __init__(self, paper: Paper):
        self.paper, self.part = paper, ""
        self.given: Counter[str] = Counter()

    def of(self, block: Display | Rows) -> str:
        r"""The \label of a result, with its number where others have the same; "" for what has none."""
        if not block.label:
            return ""
        name = ":".join(filter(None, (self.part, block.label)))
        self.given[name] += 1
        return " " + self.paper.labelled(name if self.given[name] == 1 else f"{name}-{self.given[name]}")


def preamble(title: str, packages: Iterable[str] = ()) -> str:
    """Write an article up to its title."""
    return "\n".join((r"\documentclass{article}", r"\usepackage[utf8]{inputenc}",
                      *(rf"\usepackage{{{p}}}" for p in ("amsmath", *packages)),
                      r"\setlength{\textwidth}{17cm}", r"\setlength{\oddsidemargin}{-0.5cm}",
                      r"\setlength{\parindent}{0pt}",
                      r"\setlength{\emergencystretch}{3em}", r"\allowdisplaybreaks",
                      rf"\title{{{title}}}", r"\author{}", r"\date{}", r"\begin{document}", r"\maketitle",
                      ""))


def block_latex(block: Block, names: Names, limit: float, labels: Labels | None = None) -> str:
    """Write a block, with a label if labels are given."""
    if isinstance(block, Heading):
        if labels and block.level == 1:
            labels.part = block.label
        return rf"\{'section' if block.level == 1 else 'subsection'}*{{{_words(block.title)}}}"
    if isinstance(block, Sentence):
        return sentence_latex(block, names)
    label = labels.of(block) if labels else ""
    if isinstance(block, Rows):
        return _symbols(block, names, label)
    lines = _equations(block, names, limit)
    name = tex(block.name, names, block.at)
    listed = rf"The entries of ${name}$ that are not 0:\par" if len(lines) > 1 else ""
    return "\n".join([*filter(None, [listed]),
                      *(rf"\begin{{equation}}{'' if n else label} {line} \end{{equation}}"
                        for n, line in enumerate(lines))])


def sentence_latex(block: Sentence, names: Names) -> str:
    """Write prose with its formulas."""
    return "".join(_words(part) if isinstance(part, str) else f"${inline(tex(part, names, block.at))}$"
                   for part in block.parts) + r"\par"


def _symbols(block: Rows, names: Names, label: str) -> str:
    """Write a table of two columns with a caption."""
    columns = "".join(rf"p{{{width}\linewidth}}" for width in _SYMBOLS)
    rows = [" & ".join(sentence_latex(Sentence(cell), names).removesuffix(r"\par") for cell in row) + r" \\"
            for row in block.rows]
    return "\n".join((r"\begin{table}[htbp]", rf"\caption{{{block.title}}}{label}\smallskip",
                      rf"\begin{{tabular}}{{@{{}}{columns}@{{}}}}", r"\hline", *rows, r"\hline",
                      r"\end{tabular}", r"\end{table}"))


def _equations(block: Display, names: Names, limit: float) -> list[str]:
    """Write a displayed formula, broken if it is too wide.

    If a matrix stays too wide, its entries that are not 0 are written one by one.
    """
    whole = display(block, names)
    if width(whole) <= limit:
        return [whole]
    name, relation = tex(block.name, names, block.at), RELATIONS.get(block.relation, block.relation)
    if not isinstance(block.value, MatrixBase) and width(name) > limit / 3:
        return [r"\begin{aligned}[b] & " + r" \\ & \quad ".join(broken(whole, limit)) + r" \end{aligned}"]
    if not isinstance(block.value, MatrixBase):
        first, *rest = broken(f"{relation} {tex(block.value, names, block.at)}", limit - width(name))
        return [rf"\begin{{aligned}}[b] {name} & {first} \\ "
                + r" \\ ".join(rf"& \quad {line}" for line in rest) + r" \end{aligned}"]
    if width(whole) <= 1.2 * limit:
        return [rf"\text{{\footnotesize$\displaystyle {whole}$}}"]
    base = f"{{{name}}}" if "_" in name else name
    return [line for i, row in enumerate(block.value.tolist(), 1) for j, entry in enumerate(row, 1) if entry
            for line in _equations(Display(Word("", rf"{base}_{{{i}{j}}}"), entry, block.at), names, limit)]


def inline(formula: str) -> str:
    """Write a formula for a sentence, so that lines may end inside its parentheses."""
    return formula.replace(r"\left(", "(").replace(r"\right)", ")")


def _words(text: str) -> str:
    """Write prose for LaTeX; lines may end at the commas of a typed list."""
    return re.sub(r"\S{30,}", lambda word: word[0].replace(",", r",\allowbreak "), words(text))


@checked
def to_latex(obj: Any, symbols: Mapping[Any, str] | None = None, label: str = "gyrostat") -> str:
    r"""LaTeX of a public object: a formula for everything but a report, which becomes a whole document.

    Parameters
    ----------
    obj : Expr, Condition, Criterion, Linearization, SecondVariation, System, Equilibrium, Report, …
        or a matrix, LiePoisson, Gyrostat, Potential, Decision; or a sequence of Report, for one document
    symbols : mapping of str or Symbol to str, optional
        the LaTeX of names that a paper writes otherwise, one symbol each; U renames its derivatives too
    label : str
        what the labels of a document's equations begin with: gyrostat:E1:sufficient

    Returns
    -------
    str
        without dollar signs; the document is of class article and uses amsmath

    Raises
    ------
    TypeError
        for anything else
    ValuesError
        two names would have one symbol, or a name does not occur in the document
    ExpressionError
        what is given for a name is not one symbol

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> report = gs.analyze(gs.upright(top))
    >>> print(gs.to_latex(report.sufficient))
    \left(\pi_3^0 + l\right)^{2} > 4 I_1 U'(1)
    >>> symbols = {"I1": "A", "l": r"\sigma", "U": "V"}
    >>> print(gs.to_latex(report.sufficient, symbols=symbols))
    \left(\pi_3^0 + \sigma\right)^{2} > 4 A V'(1)
    """
    paper = Paper({str(name): symbol for name, symbol in (symbols or {}).items()}, label)
    reports = obj if isinstance(obj, (list, tuple)) else [obj]
    if reports and all(isinstance(report, Report) for report in reports):
        return document(reports, paper=paper)
    names = Names(paper.symbols)
    shown = formula(obj, names)
    names.check()
    return shown
