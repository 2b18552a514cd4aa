"""gyrostat decide: verdicts at numbers, for one equilibrium or for all that the numbers allow."""
import argparse
from pathlib import Path
from typing import Any

from ..._lazy import loaded
from ...errors import ValuesError
from ...notation import symbol
from ...printing.blocks import Block, Display, Heading, Word, prose, sentence
from ...printing.formats.json_data import form_data, json_text, window_data
from ...printing.formats.si_units import RATE
from ...printing.formats.text import number_text, text
from ...printing.formats.unicode import unicode
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

_OF_SUFFIX = {".csv": "csv", ".json": "json", ".tex": "latex"}
_NOWHERE = "No such relative equilibrium exists at these numbers."


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the decisions; 0, whatever they are, and 2 if a line of a batch was bad."""
    if given.momentum is not None:
        given = argparse.Namespace(**{**vars(given), "values": [*given.values, f"M={given.momentum}"]})
    given = with_scene(given)
    form = form_of(given)
    if given.batch is not None:
        return int(loaded("cli.batch.batch:run")(given, out))
    numbers = numbers_of(given.values)
    asked = asked_of(given, numbers)
    if given.normal_form:
        _text_or_json(form, "a normal form")
        made: Any = normal_form_of(asked, given.equilibrium, numbers, given.normal_form)
        out.noted(scene_note(scene_of(asked), {symbol(name): x for name, x in numbers.items()}))
        if isinstance(made, loaded("stability.normal_forms.d4_along_family:Window")):
            data, blocks = window_data(made), loaded("printing.results.normal_form:window_blocks")(made)
        else:
            written = loaded("printing.results.normal_form:form_blocks")(made)
            data, blocks = form_data(made), [*written, *_in_si(given)]
        out(json_text(data) if form == "json" else text(blocks, out.width))
        return 0
    if arcs := arcs_at(asked, given.equilibrium, numbers):
        _text_or_json(form, "a list of arcs")
        out(json_text(arcs_data(arcs)) if form == "json" else text(
            [*arcs_blocks(arcs), *_in_si(given)], out.width))
        return 0
    answers = answers_at(asked, given.equilibrium, numbers)
    if form == "json":
        out(json_text(answers_data(answers, given.exact, given.well)))
        return 0
    if form == "csv":
        rows = loaded("questions.answers.answer_rows:answer_rows")(answers, given.well)
        out(loaded("printing.formats.csv_rows:csv_text")(rows))
        return 0
    if form == "latex":
        paper = loaded("printing.formats.latex_names:Paper")({}, given.label or "gyrostat", given.fragment)
        out(loaded("questions.answers.answer_latex:answer_latex")(
            answers, paper, units_given(given), given.well))
        return 0
    note, bare = note_once(answers)
    found = [a for a in bare if isinstance(a, Answer)]
    without = [block for m in bare if isinstance(m, Missing) for block in m.blocks()]
    units = units_given(given)
    if len(found) < 2 or given.equilibrium is not None:
        blocks = [block for a in found
                  for block in [*_blocks(a, a.label, units), *_well(a, given.well, units)]]
        out(text([*blocks, *without, *([] if blocks or without else [sentence(_NOWHERE)]),
                  *note_blocks(note), *(term_blocks(blocks) if given.full else [])], out.width))
        return 0
    out(answer_table(found, units, out.width) + "\n")
    details = [block for n, a in enumerate(found, 1)
               for block in [*(_blocks(a, f"{n}  {a.label}", units) if given.full else []),
                             *_titled(f"{n}  {a.label}", _well(a, given.well and a.decision.stable, units),
                                      given.full)]]
    out(text([prose(legend(found)), *([] if given.full else [sentence("Details: --full")]), *without,
              *note_blocks(note), *details, *term_blocks(details)], out.width))
    return 0


def form_of(given: argparse.Namespace) -> str:
    """The form that is asked for by --format, or by the suffix of --output; else text.

    Raises
    ------
    ValuesError
        exact numbers are asked for in another form than JSON, or in that of a batch
    """
    path = given.output if given.batch is None else None
    form = str(given.format or path and _OF_SUFFIX.get(Path(path).suffix.lower()) or "text")
    if given.exact and (form != "json" or given.batch is not None):
        raise ValuesError("--exact gives polynomials in JSON, and another form is written: add --format "
                          "json, or leave --exact out")
    return form


def _text_or_json(form: str, what: str) -> None:
    """Refuse another form of what is no table of equilibria."""
    if form not in ("text", "json"):
        raise ValuesError(f"--format {form} writes a table of equilibria, and {what} is none: leave it out, "
                          "or write --format json")


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
    blocks += _attitude(answer, units)
    blocks += [*decision_blocks(answer.decision, answer.at), reason_block(answer.decision),
               damped_block(answer.decision, answer.damped)]
    if answer.itself is not None:
        blocks += [*decision_blocks(answer.itself, answer.at, "The point itself"),
                   reason_block(answer.itself)]
    return blocks


def _well(answer: Answer, asked: bool, units: bool) -> list[Block]:
    """The well, if it is asked for."""
    blocks: list[Block] = loaded("printing.results.well:well_blocks")(answer.well, units) if asked else []
    return blocks


def _titled(title: str, blocks: list[Block], full: bool) -> list[Block]:
    """Blocks under the number and the name of an equilibrium, unless its details stand above."""
    return [Heading(title), *blocks] if blocks and not full else blocks


def _attitude(answer: Answer, units: bool) -> list[Block]:
    """Angles, quaternion, frequencies per orbit and doubling time of an equilibrium that was found."""
    if (found := answer.at_point) is None:
        return []
    shown: dict[str, str] = {}
    if found.attitude is not None:
        per_orbit = found.doubles.frequencies_per_orbit or ()
        quaternion = ", ".join(f"{x:.6f}" for x in found.attitude.scalar_first)
        shown |= {"attitude": str(found.attitude), "quaternion (w, x, y, z)": f"({quaternion})",
                  **{f"{unicode(symbol(f'frequency_{n}'))} per orbit": f"{x:.6g}"
                     for n, x in enumerate(per_orbit, 1)}}
    if (time := found.doubles.doubling_time) is not None:
        shown["doubling time"] = f"{time:.6g}{' s' if units else ''}"
    return [Display(Word(name, name), Word(said, said)) for name, said in
            ((name, said.replace("-", "−")) for name, said in shown.items())]
