"""What decide answers, as headings, sentences and displays."""
from collections.abc import Sequence

from sympy import Expr

from ..notation import symbol
from ..printing.blocks import Block, Display, Heading, Word, sentence
from ..printing.data import double
from ..printing.decision import damped_block, decision_blocks, reason_block
from ..printing.ends import number as rounded
from .answers import Answer
from .equilibria import Missing

LONG = 200                                                 # characters that nobody reads

_NOWHERE = "No such relative equilibrium exists at these numbers."


def answers_blocks(answers: Sequence[Answer | Missing]) -> list[Block]:
    """Each equilibrium with its place and its verdict; a sentence where there is none."""
    return [block for a in answers for block in (a.blocks() if isinstance(a, Missing) else _blocks(a))
            ] or [sentence(_NOWHERE)]


def _blocks(answer: Answer) -> list[Block]:
    blocks: list[Block] = [Heading(answer.label)]
    if answer.place:
        blocks += [Display(symbol(name), _value(number)) for name, number in answer.place.items()]
    blocks += [Display(symbol(name), rounded(rate)) for name, rate in answer.rates.items()]
    blocks += [*decision_blocks(answer.decision, answer.at), reason_block(answer.decision),
               damped_block(answer.decision, answer.damped)]
    if answer.itself:
        blocks += [*decision_blocks(answer.itself, answer.at, "The point itself"),
                   reason_block(answer.itself)]
    return blocks


def _value(number: Expr | None) -> Word:
    """A number exactly, and as a decimal where that says more; a long one as a decimal alone."""
    if number is None:
        return Word("any", "any")
    if len(str(number)) > LONG:
        return rounded(number)
    text = (
        str(number)
        if number.is_Integer
        else f"{number} ≈ {f'{value:.10g}' if (value := double(number)) else number.evalf(10)}"
    )
    return Word(text, text)
