"""Headings, sentences and displayed formulas.

Criteria, the ladder between them, the drift and decisions as such.
"""
from dataclasses import dataclass
from itertools import islice
from typing import Any

from sympy import Abs, Expr, Mul, Pow, S

from ..algebra.numbers import shown
from ..algebra.readable import readable
from ..mechanics.reduction import ENERGY, K3, P, V, reduce
from ..notation import SUBSCRIPTS, SUPERSCRIPTS, symbol
from ..stability.boundary import HIGHEST, Boundary, Rung
from ..stability.conditions import Condition, Criterion
from ..stability.drift import Drift
from ..stability.linearization import square_root
from ..stability.report import Decision, Report, Verdict
from .order import inequality


@dataclass(frozen=True)
class Word:
    """A name in both typesettings, such as π̇₁ and \\dot\\pi_1."""

    text: str
    latex: str


@dataclass(frozen=True)
class Heading:
    """The title of a part."""

    title: str
    level: int = 1


@dataclass(frozen=True)
class Sentence:
    """Prose with {} where formulas stand."""

    template: str
    parts: tuple[Any, ...] = ()
    at: Any = None


@dataclass(frozen=True)
class Display:
    """name = value: an expression, a matrix, or the two sides of a comparison."""

    name: Any
    value: Any
    at: Any = None
    relation: str = "="


Block = Heading | Sentence | Display
DOT = {f"{x}{i}": Word(f"{g}̇{'₀₁₂₃'[i]}", rf"\dot{{{t}}}_{i}")
       for x, g, t in (("pi", "π", r"\pi"), ("k", "k", "k")) for i in (1, 2, 3)}
VECTOR_FORM = {False: Word("π̇ = M × ω", r"\dot{\pi} = M\times\omega"), True: Word(
    "π̇ = M × ω + k × ∇U,  k̇ = k × ω",
    r"\dot{\pi} = M\times\omega + k\times\nabla U,\quad \dot{k} = k\times\omega")}
DISTANCE, SIGMA = symbol("x"), Word("σ", r"\sigma")
# rungs shown of a ladder without an end, of one with an end
FEW, SEVERAL = 3, 6
_TITLES = {Verdict.STABLE: "Lyapunov stable", Verdict.UNSTABLE: "unstable", Verdict.UNDECIDED: "undecided"}


def prose(text: str) -> Sentence:
    """A text as it is, whatever is in it, as a sentence."""
    return Sentence(text.replace("{", "{{").replace("}", "}}") + ("" if text.endswith((".", "…")) else "."))


def existence(domain: Expr, at: Any) -> Display:
    """Where a family exists: abs(x) < 1 for 1 − x² > 0, x ≠ 0 for x² > 0, else domain > 0."""
    if isinstance(domain, Pow) and domain.exp == 2:
        base = readable(domain.base)
        return Display(-base if base.could_extract_minus_sign() else base, S.Zero, at, "≠")
    root = readable(square_root(1 - domain))
    if any(x.exp == S.Half for x in root.atoms(Pow)):
        return Display(readable(domain), S.Zero, at, ">")
    return Display(Abs(-root if root.could_extract_minus_sign() else root, evaluate=False), S.One, at, "<")


def criterion_blocks(title: str, criterion: Criterion, at: Any) -> list[Block]:
    """Each alternative as its comparisons."""
    modulo = (", modulo the flow of " + ", ".join(["{}"] * len(criterion.modulo))) if criterion.modulo else ""
    if criterion.alternatives == ():
        return [Sentence(f"{title}: " + ("never." if criterion.notion == "spectral"
                                         else "no information, the form is not definite."))]
    if () in criterion.alternatives:
        return [Sentence(f"{title}{modulo}: always.", criterion.modulo)]
    blocks: list[Block] = []
    for n, alternative in enumerate(criterion.alternatives):
        blocks.append(Sentence(f"{title}{modulo}:" if n == 0 else "or", criterion.modulo if n == 0 else ()))
        telling = [c for c in alternative if not trivial(c)]
        blocks += [comparison(condition) for condition in telling]
        for c in alternative:
            for e in c.degenerate:
                blocks.append(Display(readable(e), S.Zero, at, "≠") if c.strict and not telling else
                              Sentence("and {} ≠ 0" if c.strict else "(also where {} = 0)", (readable(e),),
                                       at))
    for proof in (p for alternative in criterion.alternatives for c in alternative for p in c.implies):
        name, by = Word(proof.source, proof.source.replace("²", "^2").replace("−", "-")), readable(proof.by)
        blocks.append(Sentence("Here {} is, up to a positive factor, {} + {} ({}): it adds nothing.",
                               (name, readable(proof.square), readable(proof.factor), by), at))
    return blocks


def trivial(condition: Condition) -> bool:
    """Whether it only says that a positive number is one, as beside l ≠ 0."""
    return bool(condition.margin.is_number and condition.margin.is_positive)


def comparison(condition: Condition) -> Display:
    """The condition as left > right; a negative product alone as product < 0."""
    left, right = inequality(condition)
    if left == 0:
        return Display(right, left, condition.at, "<" if condition.strict else "≤")
    return Display(left, right, condition.at, ">" if condition.strict else "≥")


def boundary_blocks(report: Report) -> list[Block]:
    """What decides where the necessary condition holds and the sufficient one does not.

    The ladder, if there is one.
    """
    if not undecided(report):
        return []
    between, boundary, eq = (
        "Where the necessary condition holds and the sufficient one does not, ",
        report.boundary,
        report.equilibrium,
    )
    if boundary is None and report.between:
        return [Sentence(between + "the energy on the momentum sphere decides to fourth order, at numbers.")]
    if boundary is None:
        return [Sentence(between + "nothing is claimed.")]
    if report.recognised:
        between, eq = (
            f"The scene is {report.recognised.sentence}; with that axis for the third: w{between[1:]}",
            boundary.equilibrium,
        )
    rungs, more = ladder(boundary)
    levels = {ENERGY: symbol("h"), V: symbol("C1"),
              P: eq.system.space.coordinates[2] + eq.system.body.gyrostatic_momentum[2]}
    levels |= {name: value for name, value in eq.relations if not value.free_symbols and name != K3}
    motion = Word("I₁² k̇₃² = g", r"I_1^2 \dot{k}_3^2 = g")
    series, inward = Word("g = c₃ x³ + c₄ x⁴ + …",
                          r"g = c_3 x^3 + c_4 x^4 + \dots"), Word("x ≥ 0", r"x \geq 0")
    place, parts = (
        ("{} = {}, {}", (K3, eq.at * (1 - DISTANCE), inward))
        if boundary.pole
        else ("{} the deviation of {}", (DISTANCE, K3))
    )
    decides = (
        "the first coefficient that is not 0 decides. Up to positive factors:"
        if rungs
        else "all coefficients are 0: unstable."
    )
    return [Sentence(f"{between}the motion of {{}} by itself decides, on the level of the equilibrium: "
                     f"{{}} with", (K3, motion)),
            Display(Word("g", "g"), reduce(eq.system).square().xreplace(levels)),
            Sentence(f"There {{}}, with {place}; {decides}", (series, *parts)),
            *map(rung_display, rungs), *(_outcome(boundary, rungs, more, report.sufficient.modulo) if rungs
                                         else [])]


def undecided(report: Report) -> bool:
    """Whether the two criteria leave anything open."""
    return () not in report.sufficient.alternatives and report.necessary.alternatives != ()


def ladder(boundary: Boundary) -> tuple[list[Rung], bool]:
    """The rungs to show, without those that vanish with the ones before, and whether there may be more to
    decide after them.
    """
    rungs: list[Rung] = []
    for rung in islice(boundary.rungs(), FEW if boundary.last is None else SEVERAL):
        margin = rung.condition.margin
        if margin == 0 or any(margin in (r.condition.margin, -r.condition.margin)
                              and not r.condition.degenerate for r in rungs):
            continue
        rungs.append(rung)
        if margin.is_number and not rung.condition.degenerate:
            return rungs, False
    return rungs, True


def rung_display(rung: Rung) -> Display:
    """−c ∝ what has its sign: the margin, with its even factors."""
    condition, sub = rung.condition, str(rung.power).translate(SUBSCRIPTS)
    value = Mul(condition.margin, *(factor**2 for factor in condition.degenerate))
    return Display(Word(f"−c{sub}", f"-c_{{{rung.power}}}"), readable(value), condition.at, "∝")


def _outcome(boundary: Boundary, rungs: list[Rung], more: bool, modulo: tuple[Expr, ...]) -> list[Block]:
    """What each sign means, and what comes after the rungs shown."""
    flow = f" modulo the flow of {', '.join(['{}'] * len(modulo))}" if modulo else ""
    signs = (
        ["Positive: Lyapunov stable (supercritical); negative: unstable (subcritical)"]
        if boundary.pole
        else [
            *["Of an odd power, not 0: unstable"] * any(r.escapes for r in rungs),
            *[f"of an even power, positive: Lyapunov stable{flow}; negative: unstable"]
            * any(not r.escapes for r in rungs),
        ]
    )
    parts: tuple[Any, ...] = () if boundary.pole or all(r.escapes for r in rungs) else modulo
    end = boundary.last or HIGHEST
    further = more and (boundary.last is None or end > 2 + SEVERAL)
    text = "; ".join(signs) + ("; 0: the next coefficient." if further or len(rungs) > 1 else ".")
    if further:
        given = (potential := boundary.equilibrium.system.potential) is not None and potential.given
        text += " And so on, up to {}." if given else " And so on, to any order."
        parts += () if not given else (Word(f"x{str(end).translate(SUPERSCRIPTS)}", f"x^{{{end}}}"),)
    if more and boundary.last:
        text, parts = text + " If all vanish, every {} nearby is a motion: unstable.", (*parts, K3)
    return [Sentence(text, parts)]


def drift_blocks(report: Report) -> list[Block]:
    """Why a tilted equilibrium is not Lyapunov stable as a point."""
    if report.boundary is None or report.boundary.pole:
        return []
    drift = report.drift
    spin, exception = Word("ω k + σ e₃",
                           r"\omega k + \sigma e_3"), Word("I₁ = I₃, l = 0, ω ≠ 0",
                                                           r"I_1 = I_3,\ l = 0,\ \omega \neq 0")
    turning = Sentence("The point itself is not Lyapunov stable: near it are relative equilibria {} that "
                       "turn about the axis of the body "
                       "and leave it, at a rate {}" + (" with" if drift.omega else " that is free."),
                       (spin, SIGMA))
    growing = Sentence("Where {} and {} are not 0, the linearised flow grows besides, by a Jordan block of "
                       "the eigenvalue 0:",
                       (symbol("p"), symbol("D")))
    *rates, defect = drift_displays(drift)
    axes = (
        [Sentence(f"The scene is {report.recognised.sentence}; with that axis for the third:")]
        if report.recognised
        else []
    )
    return [*axes, turning, *rates, growing, defect,
            *([Sentence("The only exception: {} and a constant {}.", (exception, Word("U", "U")))]
              if drift.omega else [])]


def drift_displays(drift: Drift) -> list[Block]:
    """The rates of the relative equilibria nearby, unless any goes, and D."""
    at = drift.equilibrium.at
    names = ("k₃", "k_3"), ("ω", r"\omega")
    rates = zip(names, drift.rates) if drift.omega else ()
    return [*(Display(Word(f"∂σ/∂{t}", rf"\partial\sigma/\partial {x}"), readable(rate), at) for (t, x),
              rate in rates),
            Display(symbol("D"), readable(drift.defect), at)]


def decision_blocks(decision: Decision, at: Any, of: str = "Verdict") -> list[Block]:
    """The verdict at the numbers given."""
    title = _TITLES[decision.verdict]
    modulo = (
        (" modulo the flow of " + ", ".join(["{}"] * len(decision.modulo)))
        if decision.modulo and decision.notion
        else ""
    )
    values = [Display(readable(margin), Word(shown(value), shown(value)), at)
              for margin, value in decision.margins
              if margin.free_symbols]
    notes: list[Block] = [Sentence(f"Note: {decision.note}.")] if decision.note else []
    return [Sentence(f"{of}: {title}{modulo}; {decision.verdict.value}.", decision.modulo if modulo else ()),
            *values, *notes]
