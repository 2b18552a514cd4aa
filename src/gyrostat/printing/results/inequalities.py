"""Writes when an equilibrium exists, such as abs(k3) < 1, and its criteria as comparisons."""
import re
from dataclasses import replace
from typing import Any

from sympy import Abs, Expr, Pow, S

from ..._lazy import loaded
from ...algebra.rings.readable import readable
from ...registry import Letters
from ...stability.criteria.conditions import Condition, Criterion
from ...stability.criteria.linearization import square_root
from ...stability.notion import Notion
from ...stability.report.report import Report
from ..blocks import Block, Display, Word, modulo_flow, sentence
from ..letters import letters_of, word
from ..numbers import is_long
from ..order import inequality

LONG, SHORTER = 200, 4                                 # characters of long margins; how many times fewer


def polynomial_of(letters: Letters) -> Word:
    """Write λ⁴ + p λ² + q."""
    return word(letters, "⟨lamda⟩⁴ + ⟨p⟩ ⟨lamda⟩² + ⟨q⟩", r"⟨lamda⟩^4 + ⟨p⟩\,⟨lamda⟩^2 + ⟨q⟩")


def existence(domain: Expr, at: Any) -> Display:
    """Write when a family exists: abs(x) < 1 for 1 − x² > 0, x ≠ 0 for c x² > 0, otherwise domain > 0."""
    factor, square = domain.as_coeff_Mul()
    if factor.is_positive and isinstance(square, Pow) and square.exp == 2:
        base = readable(square.base)
        return Display(-base if base.could_extract_minus_sign() else base, S.Zero, at, "≠")
    root = readable(square_root(1 - domain))
    if any(x.exp == S.Half for x in root.atoms(Pow)):
        return Display(readable(domain), S.Zero, at, ">")
    return Display(Abs(-root if root.could_extract_minus_sign() else root, evaluate=False), S.One, at, "<")


def criterion_blocks(title: str, criterion: Criterion, at: Any, label: str) -> list[Block]:
    """Write each alternative by its comparisons, with labels."""
    if criterion.alternatives == () and criterion.necessary:
        return [sentence(f"{title}: never.")]
    if criterion.alternatives == ():
        form = "positive" if criterion.notion == Notion.SECULAR else "definite"
        return [sentence(f"{title}: no information, because the form is not {form}.")]
    modulo = (", ", *modulo_flow(criterion.modulo)) if criterion.modulo else ()
    if () in criterion.alternatives:
        return [sentence(title, *modulo, ": always.")]
    blocks: list[Block] = []
    for alternative in criterion.alternatives:
        blocks.append(sentence("or") if blocks else sentence(title, *modulo, ":"))
        blocks += _alternative(alternative, at, label)
    return blocks


def short_blocks(report: Report) -> list[Block]:
    """Write short inequalities that suffice, if the sufficient condition is long or written in names."""
    if report.closed is None and _size(report.sufficient) <= LONG:
        return []
    found = loaded("stability.criteria.short_sufficient:short_sufficient")(report.equilibrium)
    if found is None or report.closed is None and SHORTER * _size(found) > _size(report.sufficient):
        return []
    return [sentence("These short inequalities suffice:"),
            *_alternative(found.alternatives[0], report.equilibrium.at, "short")]


def _size(criterion: Criterion) -> int:
    """Count the characters of the margins of a criterion."""
    return sum(len(str(c.margin)) for alternative in criterion.alternatives for c in alternative)


def integral_blocks(report: Report) -> list[Block]:
    """Say what the given integrals have to do with the sufficient condition."""
    if not report.equilibrium.system.given_integrals:
        return []
    if report.sufficient == report.casimirs_only:
        return [sentence("The integrals that are given take part in verdicts at given numbers, not in this "
                         "condition.")]
    return [sentence("There the second variation of h + α F is definite on the orbit for some α, F an "
                     "integral of the scene; α is eliminated, and a verdict at given numbers gives it.")]


def _alternative(alternative: tuple[Condition, ...], at: Any, label: str) -> list[Block]:
    """Write conditions that hold together: comparisons, then the even factors that must not vanish."""
    telling = [c for c in alternative if not trivial(c)]
    blocks: list[Block] = [replace(comparison(condition), label=label) for condition in telling]
    for c in alternative:
        for factor in map(readable, c.degenerate):
            if c.strict and not telling:
                blocks.append(Display(factor, S.Zero, at, "≠", label))
            elif c.strict:
                blocks.append(sentence("and ", factor, " ≠ 0", at=at))
            else:
                blocks.append(sentence("or ", factor, " = 0", at=at))
    return blocks


def implied_blocks(report: Report) -> list[Block]:
    """Write which conditions are left out because others imply them, with the identities."""
    eq, letters, blocks = report.equilibrium, letters_of(report.equilibrium.system), list[Block]()
    criteria = {"the necessary condition": report.necessary, "the sufficient condition": report.sufficient,
                "that of the Casimirs alone": report.casimirs_only,
                "that under internal damping": report.damped}
    if report.casimirs_only == report.sufficient:
        del criteria["that of the Casimirs alone"]
    for name, criterion in criteria.items():
        for proof in (p for alternative in criterion.alternatives for c in alternative for p in c.implies):
            factor = () if proof.factor == 1 else (readable(proof.factor), " ")
            of = (", in ", polynomial_of(letters), ",") if "p" in proof.source else ()
            why = ("up to a positive factor it is ", readable(proof.square), " + ", *factor, "(",
                   readable(proof.by), ").")
            if is_long(proof.square) or is_long(proof.by):
                why = ("it follows from it.",)
            blocks.append(sentence("The condition on ", source_word(proof.source, letters), *of,
                                   f" adds nothing to {name}: ", *why, at=eq.at))
    return blocks


def source_word(source: str, letters: Letters, before: str = "") -> Word:
    """Name what a condition came from, p² − 4q or minor 3, after a text."""
    if source.startswith("minor"):
        return Word(before + source, rf"\text{{{before}{source}}}")
    template = re.sub(r"\b[pqts]\b|(?<=4)q", r"⟨\g<0>⟩", source)
    latex = template.replace("²", "^2").replace("−", "-")
    return word(letters, before + template, rf"\text{{{before}}}{latex}" if before else latex)


def trivial(condition: Condition) -> bool:
    """Whether a condition only says that a positive number is positive, as beside l ≠ 0."""
    return bool(condition.margin.is_number and condition.margin.is_positive)


def comparisons(condition: Condition) -> list[Display]:
    """Write a condition by its comparison, unless that is trivial, and its even factors."""
    relation = "≠" if condition.strict else "="
    factors = [Display(readable(e), S.Zero, condition.at, relation) for e in condition.degenerate]
    needless = condition.strict and factors and trivial(condition)
    return factors if needless else [comparison(condition), *factors]


def comparison(condition: Condition) -> Display:
    """Write a condition as left > right; a single negative product is written as product < 0."""
    if is_long(condition.margin):
        found: Display = loaded("printing.decimals:compared")(condition)
        return found
    left, right = inequality(condition)
    if left == 0:
        return Display(right, left, condition.at, "<" if condition.strict else "≤")
    return Display(left, right, condition.at, ">" if condition.strict else "≥")
