"""gyrostat decide: verdicts at numbers, for one equilibrium or for all that the numbers allow."""
import argparse
from typing import Any

from ..._lazy import loaded
from ...notation import symbol
from ...printing.blocks import Block, Display, Heading, Word, prose, sentence
from ...printing.formats.json_data import form_data, json_text, window_data
from ...printing.formats.si_units import RATE
from ...printing.formats.text import number_text, text
from ...printing.glossary import term_blocks
from ...printing.results.decision import damped_block, decision_blocks, note_blocks, reason_block
from ...questions.answers.answer_list import answers_data, note_once
from ...questions.answers.answer_table import answer_table, legend
from ...questions.answers.answers import Answer, answers_at, normal_form_of
from ...questions.answers.arcs import arcs_at, arcs_blocks, arcs_data
from ...questions.answers.equilibria import Missing
from ...questions.given_numbers import numbers_of
from ...questions.scene_texts import scene_of
from ...stability.criteria.number_notes import scene_note
from ..options.scene_files import asked_of, with_scene
from ..options.units_given import units_given
from ..output import Output

_NOWHERE = "No such relative equilibrium exists at these numbers."


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the decisions; 0, whatever they are, and 2 if a line of a batch was bad."""
    if given.momentum is not None:
        given = argparse.Namespace(**{**vars(given), "values": [*given.values, f"M={given.momentum}"]})
    given = with_scene(given)
    if given.batch is not None:
        return int(loaded("cli.batch.batch:run")(given, out))
    numbers = numbers_of(given.values)
    asked = asked_of(given, numbers)
    if given.normal_form:
        form: Any = normal_form_of(asked, given.equilibrium, numbers, given.normal_form)
        out.noted(scene_note(scene_of(asked), {symbol(name): x for name, x in numbers.items()}))
        if isinstance(form, loaded("stability.normal_forms.d4_along_family:Window")):
            data, blocks = window_data(form), loaded("printing.results.normal_form:window_blocks")(form)
        else:
            written = loaded("printing.results.normal_form:form_blocks")(form)
            data, blocks = form_data(form), [*written, *_in_si(given)]
        out(json_text(data) if given.format == "json" else text(blocks, out.width))
        return 0
    if arcs := arcs_at(asked, given.equilibrium, numbers):
        out(json_text(arcs_data(arcs)) if given.format == "json" else text(
            [*arcs_blocks(arcs), *_in_si(given)], out.width))
        return 0
    answers = answers_at(asked, given.equilibrium, numbers)
    if given.format == "json":
        out(json_text(answers_data(answers)))
        return 0
    note, bare = note_once(answers)
    found = [a for a in bare if isinstance(a, Answer)]
    without = [block for m in bare if isinstance(m, Missing) for block in m.blocks()]
    units = units_given(given)
    if len(found) < 2 or given.equilibrium is not None:
        blocks = [block for a in found for block in _blocks(a, a.label, units)]
        out(text([*blocks, *without, *([] if blocks or without else [sentence(_NOWHERE)]),
                  *note_blocks(note), *(term_blocks(blocks) if given.full else [])], out.width))
        return 0
    out(answer_table(found, units, out.width) + "\n")
    details = [block for n, a in enumerate(found, 1) for block in _blocks(a, f"{n}  {a.label}", units)
               ] if given.full else []
    out(text([prose(legend(found)), *([] if given.full else [sentence("Details: --full")]), *without,
              *note_blocks(note), *details, *term_blocks(details)], out.width))
    return 0


def _in_si(given: argparse.Namespace) -> list[Block]:
    """The unit of rates, if the numbers given have units."""
    return [sentence(symbol("omega"), f" is in {RATE}.")] if units_given(given) else []


def _blocks(answer: Answer, title: str, units: bool) -> list[Block]:
    """The details of one equilibrium: its place and its rates, the verdicts and their reasons."""
    blocks: list[Block] = [Heading(title)]
    for name, number in [*answer.place.items(), *answer.rates.items()]:
        value = "any" if number is None else number_text(number)
        unit = answer.unit_of(name) if units else ""
        said = f"{value} {unit}".rstrip()
        blocks.append(Display(symbol(name), Word(said, said)))
    blocks += [*decision_blocks(answer.decision, answer.at), reason_block(answer.decision),
               damped_block(answer.decision, answer.damped)]
    if answer.itself is not None:
        blocks += [*decision_blocks(answer.itself, answer.at, "The point itself"),
                   reason_block(answer.itself)]
    return blocks
