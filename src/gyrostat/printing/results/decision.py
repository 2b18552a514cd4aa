"""Writes a verdict at given numbers, with its margins and its reason."""
from collections.abc import Iterator
from typing import Any

from sympy import Expr

from ...algebra.rings.readable import readable
from ...notation import symbol
from ...registry import Letters
from ...stability.decision import C1, Decision, Verdict
from ..blocks import Block, Display, Sentence, listed, modulo_flow, sentence
from ..letters import letter, letters_in
from ..numbers import number
from .inequalities import source_word

LONG = 200                                                 # characters of a margin that is shown by its name
OF = "margin of "

_IN_WORDS = {Verdict.STABLE: "Stable", Verdict.UNSTABLE: "Unstable", Verdict.UNDECIDED: "Undecided"}
_DAMPED = {(Verdict.STABLE, Verdict.STABLE): "Stable, and stays so under internal damping",
           (Verdict.STABLE, Verdict.UNSTABLE): "Stable, and destroyed by internal damping",
           (Verdict.UNSTABLE, Verdict.UNSTABLE): "Unstable, under internal damping too",
           (Verdict.UNDECIDED, Verdict.STABLE): "Stable under internal damping",
           (Verdict.UNDECIDED, Verdict.UNSTABLE): "Unstable under internal damping"}
_TITLES = {Verdict.STABLE: "Lyapunov stable", Verdict.UNSTABLE: "unstable", Verdict.UNDECIDED: "undecided"}


def decision_blocks(decision: Decision, at: Any, of: str = "Verdict") -> list[Block]:
    """Write the verdict at given numbers."""
    modulo = (" ", *modulo_flow(decision.modulo)) if decision.modulo and decision.notion else ()
    letters = letters_of_decision(decision)
    level = (" on its level of ", *listed(levels_of(decision, letters))) if decision.level else ()
    locus = f" as a set, {decision.locus}" if decision.locus else ""
    blocks: list[Block] = [sentence(f"{of}: {_TITLES[decision.verdict]}", *level, locus, *modulo,
                                    f"; {decision.proved}.")]
    for margin, name, value in named_margins(decision):
        left = source_word(name, letters, OF) if name else readable(margin)
        blocks.append(Display(left, number(value), at, label="value"))
    if any(name in ("t", "s") for _, name, _ in named_margins(decision)):
        trace, determinant = letter(letters, "t"), letter(letters, "s")
        blocks.append(sentence("Here ", trace, " and ", determinant, " are the trace and the determinant of "
                               "the second variation of the amended potential on the plane across ",
                               letter(letters, "vector_k"), "."))
    if decision.certificate:
        blocks.append(sentence("Certificate: ", letter(letters, "h"), *(part for F, a in decision.certificate
                                                   for part in (" + (", a, ") (", F, ")")),
                               " has a definite second variation on the orbit.", at=at))
    return [*blocks, *note_blocks(letters.prose(decision.note))]


def note_blocks(note: str) -> list[Block]:
    """Write what is unusual about the numbers, if anything is."""
    return [sentence(f"Note: {note}.")] if note else []


def letters_of_decision(decision: Decision) -> Letters:
    """The letters beside the names in its margins."""
    return letters_in([margin for margin, _ in decision.margins])


def levels_of(decision: Decision, letters: Letters) -> list[Expr]:
    """The integrals that keep their values if a proof is for one level alone, in these letters."""
    return [symbol(letters.of(C1.name)) if level == C1 else level for level in decision.level]


def reason_block(decision: Decision) -> Sentence:
    """Write the notion and the reason."""
    notion = f" ({decision.notion})" if decision.notion else ""
    return sentence(letters_of_decision(decision).prose(f"Reason{notion}: {decision.reason}."))


def named_margins(decision: Decision) -> Iterator[tuple[Expr, str, Expr]]:
    """Give the margins that are not numbers, each with its value and, if it is long, its name."""
    for n, (margin, value) in enumerate(decision.margins):
        if margin.free_symbols:
            long = decision.names and len(str(margin)) > LONG
            yield margin, decision.names[n] if long else "", value


def damped_block(decision: Decision, damped: Decision | None) -> Sentence:
    """Say what internal damping makes of a verdict; None stands for no equilibrium under it."""
    said = _IN_WORDS[decision.verdict]
    if damped is None:
        return sentence(f"{said}; with internal damping it is no equilibrium, because ω turns in the body.")
    if damped.verdict is Verdict.UNDECIDED:
        return sentence(f"{said}; undecided under internal damping: {damped.reason}.")
    if (decision.verdict, damped.verdict) == (Verdict.UNSTABLE, Verdict.STABLE):
        return sentence("Unstable; under internal damping stable ", *modulo_flow(damped.modulo), ".")
    modes = f": {damped.growing} growing mode{'' if damped.growing == 1 else 's'}" if damped.growing else ""
    return sentence(f"{_DAMPED[decision.verdict, damped.verdict]}{modes}.")
