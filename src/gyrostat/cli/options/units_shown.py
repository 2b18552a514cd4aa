"""Writes the units of SI behind numbers that are printed, if those that are given have units."""
from collections.abc import Sequence
from dataclasses import replace

from ...mechanics.scenes.rotors import Rotor
from ...notation import symbol
from ...printing.blocks import Block, Display, Number, Word, joined, sentence
from ...printing.formats.si_units import RATE, unit_of
from ...printing.nomenclature import occurring
from ...registry import INTERNAL


def unit_in(rotors: Sequence[Rotor], name: str) -> str:
    """The unit of a name, which may be that of the speed or the momentum of a wheel."""
    for of, field in ((RATE, "rate"), (unit_of("l"), "momentum")):
        if any(symbol(name) in getattr(getattr(rotor, field), "free_symbols", ()) for rotor in rotors):
            return of
    return unit_of(name)


def in_units(blocks: Sequence[Block], rotors: Sequence[Rotor]) -> list[Block]:
    """The blocks with units behind the numbers to which a name is compared, and the units of all names."""
    named = {name: unit_in(rotors, name) for name in sorted(occurring(blocks) - INTERNAL)}
    units = {name: unit for name, unit in named.items() if unit}
    found: list[Block] = []
    for block in blocks:
        if isinstance(block, Display) and isinstance(block.value, Number) and str(block.name) in units:
            unit = Word(f" {units[str(block.name)]}", rf"\;\text{{{units[str(block.name)]}}}")
            block = replace(block, value=Number((*block.value.parts, unit)))
        found.append(block)
    told = joined(", ", [(symbol(name), f" in {unit}") for name, unit in units.items()])
    return [*found, sentence("Numbers are in SI units, ", *told, ".")] if units else found
