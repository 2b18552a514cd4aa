"""Writes expressions, matrices and every public object in LaTeX, in the notation of the sources."""
import re
from collections.abc import Iterable, Sequence
from functools import singledispatch
from importlib import import_module
from typing import Any

from flint import fmpz
from sympy import Add, Basic, Expr, MatrixBase, Mul, Pow, Rational, Symbol

from ...algebra.rings.readable import entries, readable
from ...algebra.text.numbers import double
from ...errors import ArgumentError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.body import Gyrostat
from ...mechanics.scenes.lie_poisson import LiePoisson
from ...mechanics.scenes.potential import Potential
from ...mechanics.scenes.system import System
from ...notation import jet_name
from ...stability.criteria.conditions import Condition, Criterion
from ...stability.criteria.energy_casimir import SecondVariation
from ...stability.criteria.linearization import Linearization
from ...stability.decision import Decision
from ...stability.report.report import Report
from ..blocks import Block, Display, Number, Sentence, Word, rate_of
from ..decimals import DecimalPrinter
from ..letters import letters_in
from ..order import ordered_factors, ordered_terms, over, signed
from ..results.decision import letters_of_decision, levels_of
from ..results.inequalities import comparisons
from ..results.two_directions import motion_form
from .latex_names import Names, raised
from .linebreaks import width

FRACTION = 200.0                                           # points: the widest numerator
RELATIONS = {"≥": r"\geq", "≤": r"\leq", "≠": r"\neq", "∝": r"\propto", "≈": r"\approx"}
_RELATION = re.compile(r" ([<>=≥≤≠]) ")


class Printer(DecimalPrinter):
    """Prints terms and factors in the order of the notation.

    Derivatives of U take their argument from at.
    """

    def __init__(self, names: Names, at: Any = None):
        super().__init__()
        self.names, self.at = names, at

    def _print_Symbol(self, expr: Symbol, style: str = "plain") -> str:
        return self.names.of(expr.name, self.at)

    def _print_Integer(self, expr: Rational) -> str:
        """Write an integer of any length; Python refuses to print more than 4300 digits."""
        return str(fmpz(int(expr.p)))

    def _print_Rational(self, expr: Rational) -> str:
        return rf"{'- ' if expr.p < 0 else ''}\frac{{{fmpz(abs(int(expr.p)))}}}{{{fmpz(int(expr.q))}}}"

    def _print_Add(self, expr: Add, order: Any = None) -> str:
        return signed([self._print(term) for term in ordered_terms(expr)], "-")

    def _print_Mul(self, expr: Mul) -> str:
        if expr.could_extract_minus_sign():
            return "- " + self._print(-expr)
        top, bottom = over(expr)
        if bottom == 1:
            return " ".join(map(self._factor, ordered_factors(top)))
        above, below = ordered_factors(top), ordered_factors(bottom)
        if width(self._row(above)) > FRACTION:             # so that it can be broken
            return rf"\frac{{1}}{{{self._row(below)}}} " + " ".join(map(self._factor, above))
        return rf"\frac{{{self._row(above)}}}{{{self._row(below)}}}"

    def _row(self, factors: list[Expr]) -> str:
        return self._print(factors[0]) if len(factors) == 1 else " ".join(map(self._factor, factors)) or "1"

    def _factor(self, factor: Expr) -> str:
        return rf"\left({self._print(factor)}\right)" if factor.is_Add else self._print(factor)

    def _print_Pow(self, expr: Pow) -> str:
        base, exponent = expr.args
        if not exponent.is_Rational or exponent.q > 1 or not (base.is_Add or base.is_Symbol):
            return super()._print_Pow(expr)
        if exponent < 0:
            return rf"\frac{{1}}{{{self._print(Pow(base, -exponent))}}}"
        inner = self._print(base)
        closed = rf"\left({inner}\right)" if base.is_Add or raised(inner) else inner
        return f"{closed}^{{{exponent}}}"

    def _print_AppliedUndef(self, expr: Any) -> str:
        return f"{self.names.of(str(expr.func))}({', '.join(map(self._print, expr.args))})"

    def _print_Derivative(self, expr: Any) -> str:
        variables = "".join(str(v)[-1] * n for v, n in expr.variable_count)
        return self.names.of(jet_name(len(variables), variables if len(expr.expr.args) > 1 else ""))


def tex(value: Any, names: Names, at: Any = None) -> str:
    """Write an expression, a matrix, a number or a name."""
    if isinstance(value, Word):
        return names.fill(value.latex)
    if isinstance(value, Number):
        return "".join(tex(part, names) for part in value.parts)
    if isinstance(value, MatrixBase):
        cells = [[tex(entry, names, at) for entry in row] for row in value.tolist()]
        gap = r" \\[3pt] " if any(r"\frac" in cell for row in cells for cell in row) else r" \\ "
        return r"\begin{pmatrix} " + gap.join(" & ".join(row) for row in cells) + r" \end{pmatrix}"
    return Printer(names, at)._print(value)


def formula(obj: Any, names: Names | None = None) -> str:
    """Write a single formula for any public object; a report is its two criteria."""
    return _formula(obj, names or Names())


@singledispatch
def _formula(obj: Any, names: Names) -> str:
    results = import_module("..results.beyond_reports", __package__)  # what a report does without
    if not results.is_result(obj):
        raise ArgumentError("to_latex takes expressions, matrices and the library's own objects, not "
                        f"{type(obj).__name__}")
    lines = [_line(block, names) for block in results.result_blocks(obj)]
    return r"\begin{aligned} & " + r" \\ & ".join(lines) + r" \end{aligned}"


_formula.register(Basic, tex)
_formula.register(MatrixBase, tex)


@_formula.register
def _condition(condition: Condition, names: Names) -> str:
    joint = r" \;\land\; " if condition.strict else r" \;\lor\; "
    return joint.join(display(shown, names) for shown in comparisons(condition))


@_formula.register
def _criterion(criterion: Criterion, names: Names) -> str:
    if not criterion.alternatives:
        return r"\text{never}" if criterion.necessary else r"\text{no information}"
    rows = [r" \;\land\; ".join(_formula(c, names) for c in a) or r"\text{always}"
            for a in criterion.alternatives]
    shown = rows[0] if len(rows) == 1 else r" \;\lor\; ".join(rf"\left[{row}\right]" for row in rows)
    return shown + _listed("modulo the flow of", criterion.modulo, names)


@_formula.register
def _linearization(linearization: Linearization, names: Names) -> str:
    eq = linearization.equilibrium
    return tex(entries(eq.insert_field(linearization.matrix)), names, eq.at)


@_formula.register
def _second_variation(variation: SecondVariation, names: Names) -> str:
    eq = variation.equilibrium
    return tex(eq.insert_field(variation.matrix).applyfunc(readable), names, eq.at)


@_formula.register
def _bracket(space: LiePoisson, names: Names) -> str:
    return tex(space.tensor, names)


@_formula.register
def _system(scene: System, names: Names) -> str:
    vector = tex(motion_form(scene), names)
    rates = ((rate_of(str(x)), rate) for x, rate in zip(scene.space.coordinates, scene.vector_field()))
    return rf"\begin{{gathered}} {vector} \\ {_aligned(rates, names)} \end{{gathered}}"


@_formula.register
def _equilibrium(eq: Equilibrium, names: Names) -> str:
    return rf"\left({', '.join(tex(x, names) for x in eq.point)}\right)"


@_formula.register
def _body(body: Gyrostat, names: Names) -> str:
    tensor = isinstance(body.inertia, MatrixBase)
    left = Word("I", "I") if tensor else Word("I", r"\left(⟨I1⟩, ⟨I2⟩, ⟨I3⟩\right)")
    return _aligned(((left, body.inertia),
                     (Word("l", r"\left(⟨l1⟩, ⟨l2⟩, ⟨l3⟩\right)"), body.gyrostatic_momentum)), names)


@_formula.register
def _potential(potential: Potential, names: Names) -> str:
    return f"{names.of(letters_in([potential.expression]).of('U'))} = {tex(potential.expression, names)}"


@_formula.register
def _decision(decision: Decision, names: Names) -> str:
    verdict = decision.verdict.name.lower()
    if not decision.notion:
        return rf"\text{{{verdict}}}"
    proof = "".join(rf" + \left({tex(a, names)}\right) \left({tex(F, names)}\right)"
                    for F, a in decision.certificate)
    letters = letters_of_decision(decision)
    shown = rf" \quad \text{{by }} {names.of(letters.of('h'))}{proof}" if proof else ""
    level = _listed("on its level of", levels_of(decision, letters), names)
    locus = rf" \quad \text{{as a set, {decision.locus}}}" if decision.locus else ""
    modulo = _listed("modulo the flow of", decision.modulo, names)
    return rf"\text{{{verdict} ({decision.notion})}}{level}{locus}{modulo}{shown}"


@_formula.register
def _report(report: Report, names: Names) -> str:
    return _aligned(((Word("necessary", r"\text{necessary: }"), report.necessary),
                     (Word("sufficient", r"\text{sufficient: }"), report.sufficient)), names)


def _line(block: Block, names: Names) -> str:
    """Write a sentence or a display as one line of a formula."""
    if not isinstance(block, Sentence):
        return display(block, names) if isinstance(block, Display) else rf"\text{{{block.title}}}"
    line = ""
    for part in block.parts:
        if not isinstance(part, str):
            line += tex(part, names, block.at)
            continue
        for n, words in enumerate(_RELATION.split(part)):
            if n % 2:                                      # a relation
                line += f" {RELATIONS.get(words, words)} "
            elif words:
                line += rf"\text{{{words}}}"
    return line


def _listed(words: str, formulas: Sequence[Expr], names: Names) -> str:
    shown = ", ".join(tex(formula, names) for formula in formulas)
    return rf" \quad \text{{{words} }} {shown}" if formulas else ""


def _aligned(rows: Iterable[tuple[Word, Any]], names: Names) -> str:
    def right(value: Any) -> str:
        if isinstance(value, tuple):
            return rf"\left({', '.join(_entered(x, names) for x in value)}\right)"
        return _formula(value, names)

    lines = [f"{tex(name, names)} & {'' if isinstance(value, Criterion) else '= '}{right(value)}"
             for name, value in rows]
    return r"\begin{aligned} " + r" \\ ".join(lines) + r" \end{aligned}"


def _entered(value: Any, names: Names) -> str:
    """Write a number; if it was given as a decimal, that stands beside it."""
    return tex(value, names) + (rf" \; ({decimal})" if (decimal := double(value)) else "")


def display(block: Display, names: Names) -> str:
    """Write name = value, or a comparison."""
    relation = RELATIONS.get(block.relation, block.relation)
    return f"{tex(block.name, names, block.at)} {relation} {tex(block.value, names, block.at)}"
