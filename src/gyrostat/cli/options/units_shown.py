"""Writes the units of SI behind numbers that are printed, if those that are given have units."""
from collections.abc import Collection, Sequence
from dataclasses import replace

from ...notation import symbol
from ...printing.blocks import Block, Display, Number, Word, joined, sentence
from ...printing.formats.si_units import RATE, unit_of
from ...printing.nomenclature import occurring
from ...registry import INTERNAL


def in_units(blocks: Sequence[Block], rates: Collection[str]) -> list[Block]:
    """The blocks with units behind the numbers to which a name is compared, and the units of all names.

    Parameters
    ----------
    blocks : sequence of Block
    rates : collection of str
        names of the user's that are speeds of wheels
    """
    def of(name: str) -> str:
        return RATE if name in rates else unit_of(name)

    units = {name: of(name) for name in sorted(occurring(blocks) - INTERNAL) if of(name)}
    found: list[Block] = []
    for block in blocks:
        if isinstance(block, Display) and isinstance(block.value, Number) and str(block.name) in units:
            unit = Word(f" {units[str(block.name)]}", rf"\;\text{{{units[str(block.name)]}}}")
            block = replace(block, value=Number((*block.value.parts, unit)))
        found.append(block)
    told = joined(", ", [(symbol(name), f" in {unit}") for name, unit in units.items()])
    return [*found, sentence("Numbers are in SI units, ", *told, ".")] if units else found
