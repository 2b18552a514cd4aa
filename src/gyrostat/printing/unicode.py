"""Formulas in one line of Unicode, matrices as aligned rows, whole documents in 100 columns."""
import re
from collections.abc import Iterable, Sequence
from textwrap import wrap
from typing import Any

from sympy import Add, Expr, MatrixBase, Mul, Pow, Symbol
from sympy.printing.str import StrPrinter

from ..algebra.numbers import double, shown
from ..algebra.readable import entries, readable
from ..mechanics.body import Gyrostat
from ..mechanics.equilibria import Equilibrium
from ..mechanics.liepoisson import LiePoisson
from ..mechanics.potential import Potential
from ..mechanics.system import System
from ..notation import SUBSCRIPTS, SUPERSCRIPTS, jet_name, typeset
from ..stability.conditions import Condition, Criterion
from ..stability.energy_casimir import SecondVariation
from ..stability.linearization import Linearization
from ..stability.report import Decision, Report
from .blocks import Block, Display, Heading, Sentence, Word, comparison, trivial
from .document import point_blocks, report_blocks, scene_blocks
from .order import ordered_factors, ordered_terms, over
from .results import RESULTS, result_blocks


class _Unicode(StrPrinter):
    def __init__(self, at: Any = None):
        super().__init__()
        self.at = at

    def _print_Symbol(self, expr: Symbol) -> str:
        return typeset(expr.name, self.at, "text")

    def _print_Pow(self, expr: Pow, rational: bool = False) -> str:
        base, exponent = expr.args
        if exponent.is_Rational and exponent < 0:
            return "1/" + self._factor(Pow(base, -exponent))
        if exponent.is_Rational and exponent.q == 2 and exponent.p == 1:
            inner = self._print(base)
            return f"√{inner}" if base.is_Symbol or base.is_Integer and base >= 0 else f"√({inner})"
        inner = self._print(base)
        inner = inner if base.is_Symbol and not inner.endswith(tuple("⁰)")) else f"({inner})"
        return inner + (str(exponent).translate(SUPERSCRIPTS) if exponent.is_Integer
                        else f"^({self._print(exponent)})")

    def _print_Mul(self, expr: Mul) -> str:
        if expr.could_extract_minus_sign():
            return "−" + self._print(-expr)
        top, bottom = over(expr)
        if bottom == 1:
            return " ".join(map(self._factor, ordered_factors(top)))
        above = " ".join(map(self._factor, ordered_factors(top))) or "1"
        below = list(map(self._factor, ordered_factors(bottom)))
        return f"{above}/{below[0]}" if len(below) == 1 else f"{above}/({' '.join(below)})"

    def _factor(self, factor: Expr) -> str:
        return f"({self._print(factor)})" if factor.is_Add else self._print(factor)

    def _print_Add(self, expr: Add, order: Any = None) -> str:
        pieces: list[str] = []
        for term in ordered_terms(expr):
            text = self._print(term)
            pieces.append(text if not pieces else f" − {text[1:]}" if text.startswith("−") else f" + {text}")
        return "".join(pieces)

    def _print_Abs(self, expr: Expr) -> str:
        return f"|{self._print(expr.args[0])}|"

    def _print_Pi(self, expr: Expr) -> str:
        return "π"

    def _print_Integer(self, expr: Expr) -> str:
        return str(expr).replace("-", "−")

    def _print_Rational(self, expr: Expr) -> str:
        return str(expr).replace("-", "−")

    def _print_Derivative(self, expr: Any) -> str:
        variables = "".join(str(v)[-1] * n for v, n in expr.variable_count)
        return typeset(jet_name(len(variables), variables if len(expr.expr.args) > 1 else ""), style="text")


def unicode(expression: Expr, at: Any = None) -> str:
    """An expression in one line; derivatives of U take their argument from at.

    Examples
    --------
    >>> from gyrostat.notation import symbol
    >>> unicode((symbol("pi3_0") + symbol("l"))**2 - 4*symbol("I1")*symbol("dU"), at=1)
    '(π₃⁰ + l)² − 4 I₁ U′(1)'
    """
    return _Unicode(at)._print(expression)


def plain(obj: Any) -> str:
    """What print shows of a public object.

    A report as its document, a matrix in rows, everything else in a line or two.

    Examples
    --------
    >>> from gyrostat import analyze, assemble, axial_potential, symmetric_gyrostat, upright
    >>> print(analyze(upright(assemble(symmetric_gyrostat(), axial_potential()))).sufficient)
    (π₃⁰ + l)² > 4 I₁ U′(1)
    """
    if isinstance(obj, Report):
        return text(report_blocks(obj)).rstrip("\n")
    if isinstance(obj, System):
        return text(scene_blocks(obj)).rstrip("\n")
    if isinstance(obj, Equilibrium):
        return f"{obj.label}: " + text(point_blocks(obj)).strip()
    if isinstance(obj, RESULTS):
        return "\n".join(line.strip() for line in text(result_blocks(obj)).splitlines())
    if isinstance(obj, LiePoisson):
        return "\n".join(matrix_lines(obj.tensor.tolist()))
    if isinstance(obj, (Linearization, SecondVariation)):
        return (
            "\n".join(
                matrix_lines(entries(obj.equilibrium.insert_field(obj.matrix)).tolist(), obj.equilibrium.at)
            )
            or "()"
        )
    if isinstance(obj, Gyrostat):
        inertia, momentum = _entered(obj.inertia), _entered(obj.gyrostatic_momentum)
        return f"gyrostat with inertia ({inertia}) and gyrostatic momentum ({momentum})"
    if isinstance(obj, Potential):
        return f"U = {unicode(obj.expression)}"
    if isinstance(obj, Decision):
        modulo = f" modulo the flow of {_row(obj.modulo)}" if obj.modulo and obj.notion else ""
        notion = f", {obj.notion}{modulo}" if obj.notion else ""
        values = ", ".join(f"{margin} = {shown(value)}"
                           for margin, value in obj.margins if margin.free_symbols)
        return f"{obj.verdict.name}{notion}: {values}{': ' if values else ''}{obj.reason}" + (
            f" (note: {obj.note})" if obj.note else ""
        )
    if isinstance(obj, Condition):
        sides = comparison(obj)
        joint, relation = ("and", "≠") if obj.strict else ("or", "=")
        factors = [f" {joint} {unicode(readable(e), obj.at)} {relation} 0" for e in obj.degenerate]
        if obj.strict and factors and trivial(obj):
            return "".join(factors).removeprefix(" and ")
        return f"{unicode(sides.name, obj.at)} {sides.relation} {unicode(sides.value, obj.at)}" + "".join(
            factors
        )
    return _criterion(obj)


def _criterion(criterion: Criterion) -> str:
    if not criterion.alternatives:
        return "never" if criterion.notion == "spectral" else "no information"
    text = " or ".join(" and ".join(map(plain, alternative)) or "always"
                       for alternative in criterion.alternatives)
    return text + (f", modulo the flow of {_row(criterion.modulo)}" if criterion.modulo else "")


def _entered(values: Iterable[Expr]) -> str:
    """As in a row; a number that was given as a decimal with it."""
    return ", ".join(shown(x).replace("-", "−") if double(x) else unicode(x) for x in values)


def _row(values: Iterable[Expr]) -> str:
    return ", ".join(map(unicode, values))


def text(blocks: Iterable[Block], width: int = 100) -> str:
    """The document in Unicode, no line longer than the width unless one term of a formula is."""
    lines: list[str] = []
    for block in blocks:
        if isinstance(block, Heading):
            lines += (
                ["", block.title, "═" * len(block.title)] if block.level == 1 else ["", f"  {block.title}"]
            )
        elif isinstance(block, Sentence):
            lines += wrap(block.template.format(*(_inline(part, block.at) for part in block.parts)), width,
                          initial_indent="  ", subsequent_indent="  ", break_long_words=False)
        else:
            lines += _displayed(block, width)
    return "\n".join(lines).strip("\n") + "\n"


def _inline(part: Any, at: Any) -> str:
    return part.text if isinstance(part, Word) else unicode(part, at)


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
    """A formula that is too long, broken before its signs + and −."""
    lines = [""]
    for piece in re.split(r" (?=[+−] )", line):
        if lines[-1] and len(lines[-1]) + 1 + len(piece) > width:
            lines.append(" " * 8 + piece)
        else:
            lines[-1] += f" {piece}" if lines[-1] else piece
    return lines


def matrix_lines(rows: Sequence[Sequence[Expr]], at: Any = None) -> list[str]:
    """The rows of a matrix, columns aligned, in brackets."""
    cells = [[unicode(entry, at) for entry in row] for row in rows]
    widths = [max(len(row[j]) for row in cells) for j in range(len(cells[0]))]
    last = len(cells) - 1
    ends = ["()"] if last == 0 else ["⎛⎞", *["⎜⎟"] * (last - 1), "⎝⎠"]
    return [f"{e[0]} {'   '.join(c.center(w) for c, w in zip(row, widths))} {e[1]}"
            for e, row in zip(ends, cells)]
