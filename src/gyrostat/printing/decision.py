"""A verdict at numbers, with its margins."""
from typing import Any

from ..algebra.numbers import shown
from ..algebra.readable import readable
from ..stability.report import Decision, Verdict
from .blocks import Block, Display, Word, modulo_flow, sentence

_TITLES = {Verdict.STABLE: "Lyapunov stable", Verdict.UNSTABLE: "unstable", Verdict.UNDECIDED: "undecided"}


def decision_blocks(decision: Decision, at: Any, of: str = "Verdict") -> list[Block]:
    """The verdict at the numbers given."""
    modulo = (" ", *modulo_flow(decision.modulo)) if decision.modulo and decision.notion else ()
    blocks: list[Block] = [sentence(f"{of}: {_TITLES[decision.verdict]}", *modulo,
                                    f"; {decision.verdict.value}.")]
    blocks += [Display(readable(margin), Word(shown(value), shown(value)), at, label="value")
               for margin, value in decision.margins if margin.free_symbols]
    if decision.note:
        blocks.append(sentence(f"Note: {decision.note}."))
    return blocks
