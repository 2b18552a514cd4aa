"""Writes every public object and whole documents in Unicode, as print shows them."""
import re
from collections.abc import Iterable
from functools import singledispatch
from importlib import import_module
from textwrap import wrap
from typing import Any

from sympy import Expr, MatrixBase

from ...algebra.rings.readable import entries, readable
from ...algebra.text.numbers import double, shown
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.body import Gyrostat
from ...mechanics.scenes.lie_poisson import LiePoisson
from ...mechanics.scenes.potential import Potential
from ...mechanics.scenes.system import System
from ...stability.criteria.conditions import Condition, Criterion
from ...stability.criteria.energy_casimir import SecondVariation
from ...stability.criteria.linearization import Linearization
from ...stability.decision import Decision
from ...stability.report.report import Report
from ...typesetting import SUBSCRIPTS
from ..blocks import Block, Display, Heading, Number, Rows, Sentence, Word
from ..letters import letter, letters_in
from ..numbers import number
from ..results.decision import OF, named_margins
from ..results.document import point_blocks, report_blocks
from ..results.inequalities import comparisons
from ..results.scene import scene_blocks
from .unicode import matrix_lines, unicode

# columns of a sentence that is read, and of a formula in it that stays on one line
READ, SHORT = 100, 36
NO_BREAK = "\u00a0"


@singledispatch
def plain(obj: Any) -> str:
    """Write a public object as print shows it.

    A report is written as its document, a matrix in rows, everything else in a line or two.

    Examples
    --------
    >>> from gyrostat import analyze, assemble, axial_potential, symmetric_gyrostat, upright
    >>> print(analyze(upright(assemble(symmetric_gyrostat(), axial_potential()))).sufficient)
    (π₃⁰ + l)² > 4 I₁ U′(1)
    """
    results = import_module("..results.beyond_reports", __package__)  # what a report does without
    if not results.is_result(obj):
        raise TypeError(f"{type(obj).__name__} is not shown as text: give an object of the library")
    return "\n".join(line.strip() for line in text(results.result_blocks(obj)).splitlines())


@plain.register
def _condition(condition: Condition) -> str:
    return (" and " if condition.strict else " or ").join(
        f"{_inline(d.name, d.at)} {d.relation} {_inline(d.value, d.at)}" for d in comparisons(condition))


@plain.register
def _criterion(criterion: Criterion) -> str:
    if not criterion.alternatives:
        return "never" if criterion.necessary else "no information"
    text = " or ".join(" and ".join(map(plain, alternative)) or "always"
                       for alternative in criterion.alternatives)
    return text + (f", modulo the flow of {_row(criterion.modulo)}" if criterion.modulo else "")


@plain.register
def _matrix(derived: Linearization | SecondVariation) -> str:
    eq = derived.equilibrium
    return "\n".join(matrix_lines(entries(eq.insert_field(derived.matrix)).tolist(), eq.at)) or "()"


@plain.register
def _bracket(space: LiePoisson) -> str:
    return "\n".join(matrix_lines(space.tensor.tolist()))


@plain.register
def _system(scene: System) -> str:
    return text(scene_blocks(scene)).rstrip("\n")


@plain.register
def _equilibrium(eq: Equilibrium) -> str:
    return f"{eq.label}: " + text(point_blocks(eq)).strip()


@plain.register
def _body(body: Gyrostat) -> str:
    momentum = _entered(body.gyrostatic_momentum)
    if isinstance(body.inertia, MatrixBase):
        rows = "; ".join(_entered(row) for row in body.inertia.tolist())
        return f"gyrostat with inertia tensor ({rows}) and gyrostatic momentum ({momentum})"
    return f"gyrostat with inertia ({_entered(body.moments)}) and gyrostatic momentum ({momentum})"


@plain.register
def _potential(potential: Potential) -> str:
    return f"{letter(letters_in([potential.expression]), 'U').text} = {unicode(potential.expression)}"


@plain.register
def _decision(decision: Decision) -> str:
    said = decision.verdict.name
    if decision.notion:
        said += f", {decision.notion}"
        if decision.modulo:
            said += f" modulo the flow of {_row(decision.modulo)}"
        if decision.level:
            said += f" on its level of {_row(decision.level)}"
        if decision.locus:
            said += f" as a set, {decision.locus}"
    values = [f"{OF + name if name else unicode(readable(margin))} = {number_text(value)}"
              for margin, name, value in named_margins(decision)]
    reason = f"{', '.join(values)}: {decision.reason}" if values else decision.reason
    note = f" (note: {decision.note})" if decision.note else ""
    return f"{said}: {reason}{note}"


@plain.register
def _report(report: Report) -> str:
    return text(report_blocks(report)).rstrip("\n")


def number_text(value: Expr) -> str:
    """A number as all texts have it.

    Examples
    --------
    >>> from sympy import Rational, sqrt
    >>> number_text(Rational(-1, 2)), number_text(sqrt(3) / 4)
    ('−1/2', '√3/4 ≈ 0.4330')
    """
    return _inline(number(value), None)


def _entered(values: Iterable[Expr]) -> str:
    """List numbers as they were entered: a decimal stands beside the fraction that it was."""
    return ", ".join(shown(x).replace("-", "−") if double(x) else unicode(x) for x in values)


def _row(values: Iterable[Expr]) -> str:
    return ", ".join(map(unicode, values))


def text(blocks: Iterable[Block], width: int = 100) -> str:
    """Write a document in Unicode; no line is longer than the width, unless one term of a formula is.

    Sentences are at most 100 columns wide, and no line ends inside a short formula.
    """
    lines: list[str] = []
    for block in blocks:
        if isinstance(block, Heading):
            lines += (
                ["", block.title, "═" * len(block.title)] if block.level == 1 else ["", f"  {block.title}"]
            )
        elif isinstance(block, Sentence):
            sentence = "".join(_whole(part, block.at) for part in block.parts)
            lines += [line.replace(NO_BREAK, " ") for line in wrap(
                sentence, min(width, READ), initial_indent="  ", subsequent_indent="  ",
                break_long_words=False)]
        elif isinstance(block, Rows):
            lines += _symbols(block, min(width, READ))
        else:
            lines += _displayed(block, width)
    return "\n".join(lines).strip("\n") + "\n"


def _whole(part: Any, at: Any) -> str:
    """Write a part of a sentence; no line ends inside a short formula."""
    shown = _inline(part, at)
    return shown if isinstance(part, str) or len(shown) > SHORT else shown.replace(" ", NO_BREAK)


def _inline(part: Any, at: Any) -> str:
    """Write a text, a name, a number or a formula in one line."""
    if isinstance(part, str):
        return part
    if isinstance(part, Number):
        return "".join(_inline(each, at) for each in part.parts)
    return part.text if isinstance(part, Word) else unicode(part, at)


def _symbols(block: Rows, width: int) -> list[str]:
    """Write symbols on the left and their meanings beside them."""
    cells = [["".join(_whole(part, None) for part in cell) for cell in row] for row in block.rows]
    size = max((len(left) for left, _ in cells), default=0)
    lines = ["", f"  {block.title}"] if cells else []
    for left, right in cells:
        lines += wrap(right, width, initial_indent=f"    {left:<{size}}   ",
                      subsequent_indent=" " * (size + 7), break_long_words=False)
    return [line.replace(NO_BREAK, " ") for line in lines]


def _displayed(block: Display, width: int) -> list[str]:
    name = "    " + _inline(block.name, block.at)
    if not isinstance(block.value, MatrixBase):
        return _broken(f"{name} {block.relation} {_inline(block.value, block.at)}", width)
    rows = block.value.tolist()
    lines = matrix_lines(rows, block.at)
    indent = " " * (len(name) + 3)
    middle = (len(lines) - 1) // 2
    lines = [(f"{name} = " if i == middle else indent) + line for i, line in enumerate(lines)]
    if max(map(len, lines)) <= width:
        return lines
    return [line for i, row in enumerate(rows, 1) for j, entry in enumerate(row, 1) if entry
            for line in _broken(f"{name}{f'{i}{j}'.translate(SUBSCRIPTS)} = {unicode(entry, block.at)}",
                                width)]


def _broken(line: str, width: int) -> list[str]:
    """Break a formula that is too long before its signs + and −."""
    lines = [""]
    for piece in re.split(r" (?=[+−] )", line):
        if lines[-1] and len(lines[-1]) + 1 + len(piece) > width:
            lines.append(" " * 8 + piece)
        else:
            lines[-1] += f" {piece}" if lines[-1] else piece
    return lines
