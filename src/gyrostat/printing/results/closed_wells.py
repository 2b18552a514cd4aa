"""Writes wells in closed form: where they hold, the barrier, the kick and the tilt, case by case."""
from collections.abc import Iterator

from sympy import Expr, Piecewise, S, Symbol, oo

from ...equilibria.wells.closed_forms import ClosedForm
from ...notation import symbol
from ..blocks import Block, Display, prose, sentence


def closed_well_blocks(form: ClosedForm) -> list[Block]:
    """Write one form."""
    blocks: list[Block] = [prose(form.scene)]
    if form.conditions:
        blocks += [sentence("It is in a well if:" if len(form.conditions) == 1 else
                            "It is in a well if all of these hold:"),
                   *(Display(x, S.Zero, relation=">") for x in form.conditions)]
    if form.names:
        blocks += [block for name, x in form.names for block in _cases(name, x)]
    if form.equation is not None:
        blocks += [sentence("The pass is at the tilt z where this vanishes:"), Display(form.equation, S.Zero),
                   prose(f"Of its roots it is {form.root}")]
    barrier, kick, tilt = map(symbol, ("barrier", "kick", "tilt"))
    if form.barrier != oo:
        blocks += _cases(barrier, form.barrier)
    for name, x in ((kick, form.kick), (tilt, form.tilt)):
        if x is not None:
            short = x.xreplace({form.barrier: barrier}) if form.barrier.free_symbols else x
            blocks += _cases(name, short, "<")
    return blocks


def _cases(word: Symbol, value: Expr, relation: str = "=") -> Iterator[Block]:
    if not isinstance(value, Piecewise):
        yield Display(word, value, relation=relation)
        return
    for n, (x, condition) in enumerate(value.args):
        also = "Else, if " if n else "If "
        yield sentence("Else:") if condition == S.true else sentence(also, condition, ":")
        yield Display(word, x, relation=relation)
