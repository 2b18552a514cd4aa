"""gyrostat conditions: where each equilibrium exists, its two conditions, and what decides between them."""
import argparse
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from sympy import Expr

from ..._lazy import loaded
from ...algebra.rings.readable import readable
from ...algebra.text.inputs import name_of
from ...notation import symbol
from ...printing.blocks import Block, Display, Heading, sentence
from ...printing.decimals import with_decimals
from ...printing.formats.json_data import json_text
from ...printing.formats.text import text
from ...printing.glossary import term_blocks
from ...printing.nomenclature import occurring, symbol_rows
from ...printing.results.document import conditions_blocks
from ...printing.results.inequalities import criterion_blocks
from ...questions.answers.between_criteria import between_blocks
from ...questions.answers.condition_list import condition_list
from ...questions.answers.equilibria import labels_of, reports_of, some
from ...questions.given_numbers import numbers_of
from ...questions.scene_texts import Asked, scene_of, table_of
from ...stability.criteria.number_notes import scene_note
from ...stability.report.report import Report
from ..options.scene_files import asked_of, with_scene
from ..options.units_given import units_given
from ..output import Output

if TYPE_CHECKING:
    from ...questions.answers.solve_for import Solved

FEW = 25                                               # lines of the sets of --solve-for without --full


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the conditions; 0."""
    given = with_scene(given)
    numbers = numbers_of(given.values)
    dampings = given.platform_damping, given.rotor_damping
    asked = asked_of(given, {*numbers, given.solve_for})
    sink = None if dampings == (None, None) else loaded("questions.answers.energy_sink:sink_of")(
        table_of(asked), dampings, numbers)
    if given.solve_for and asked.rotors and asked.orbit and _speeds(given, asked, numbers, out):
        return 0
    labels, others = labels_of(asked, given.equilibrium, numbers)
    some(labels, others)
    _note(asked, numbers, out)
    if given.solve_for:
        return _solve(given, asked, labels, numbers, out)
    found = condition_list(asked, labels, others, numbers, given.windows, sink)
    after = [block for m in found.missing for block in m.blocks()]
    if sink:
        after += [Heading("Energy sink"), *criterion_blocks("Stable, to first order in weak dampers", sink,
                                                             symbol("k3"), "energy sink")]
    wells = {}
    if given.well:
        reports, _ = reports_of(asked, labels, numbers)
        wells = loaded("questions.answers.closed_wells:wells_of")(reports, numbers)
        after += loaded("questions.answers.closed_wells:wells_blocks")(wells)
    for label, held in found.between.items():
        after += [Heading(f"{label}, between its two conditions"), *between_blocks(held)]
    if given.format == "json":
        more = {"wells": loaded("questions.answers.closed_wells:wells_data")(wells)} if wells else {}
        out(json_text(found.data() | more))
    elif given.format == "latex":
        paper = loaded("cli.options.latex_options:paper_of")(given)
        out(loaded("printing.formats.tables:conditions_table")(found.reports, paper, after))
    else:
        blocks = [block for report in found.reports for block in conditions_blocks(report)]
        names = occurring(blocks)
        [symbols] = with_decimals([symbol_rows(found.reports[0].equilibrium.system, names)])
        if units_given(given):
            blocks = loaded("cli.options.units_shown:in_units")(blocks, table_of(asked).rotors)
        out(text([*blocks, *after, symbols, *term_blocks([*blocks, *after])], out.width))
    return 0


def _speeds(given: argparse.Namespace, asked: Asked, numbers: Mapping[str, Expr], out: Output) -> bool:
    """Write the speeds of a wheel at which an attitude is stable; False if something else is asked."""
    name, unit = name_of(given.solve_for) or given.solve_for, "rpm" if units_given(given) else ""
    found = loaded("questions.answers.wheel_answer:speeds_at")(asked, given.equilibrium, name, numbers, unit)
    if found is None:
        return False
    _note(asked, numbers, out)
    if given.format == "json":
        out(json_text(loaded("questions.answers.wheel_answer:speeds_data")(found)))
    else:
        _written(given, loaded("questions.answers.wheel_answer:speeds_blocks")(found), name, out)
    return True


def _note(asked: Asked, numbers: Mapping[str, Expr], out: Output) -> None:
    out.noted(scene_note(scene_of(asked), {symbol(name): x for name, x in numbers.items()}))


def _written(given: argparse.Namespace, blocks: Sequence[Block], name: str, out: Output) -> None:
    """Write blocks about the values of a name as text or in LaTeX."""
    if given.format != "latex":
        out(text(blocks, out.width))
        return
    title = f"Values of {name} that stabilise".replace("_", r"\_")
    paper = loaded("cli.options.latex_options:paper_of")(given)
    out(loaded("printing.formats.article:article")(title, blocks, paper))


def _solve(given: argparse.Namespace, asked: Asked, labels: Sequence[str], numbers: Mapping[str, Expr],
           out: Output) -> int:
    """Write the sets of --solve-for; 0."""
    name = name_of(given.solve_for) or given.solve_for
    found, missing = loaded("questions.answers.solve_for:solved")(asked, labels, name, numbers)
    if given.format == "json":
        out(json_text(loaded("questions.answers.solve_for:solutions_data")(found, missing)))
        return 0
    without = [block for m in missing for block in m.blocks()]
    if given.format == "latex":
        _written(given, [*_sets(found), *without], name, out)
        return 0
    unit, said = "", ""
    if units_given(given):
        unit = loaded("cli.options.units_shown:unit_in")(table_of(asked).rotors, name)
    scale = [sentence(symbol(name), f" is in {unit}.")] if unit else []
    sets: Sequence[Solved] = found
    if not given.full:
        brief = loaded("questions.answers.brief_solutions:brief")
        sets, said = brief(found, lambda few, told: _shown(few, told, out.width).count("\n") <= FEW)
    out("\n".join(filter(None, (_shown(sets, said, out.width), *(
        text(more, out.width) for more in (scale, without) if more)))))
    return 0


def _shown(found: Sequence["Solved"], said: str, width: int) -> str:
    """The sets, and apart from them what is said below."""
    sets = _sets(found)
    return "\n".join(text(blocks, width) for blocks in (sets, [sentence(said)] if said else []) if blocks)


def _sets(found: Sequence["Solved"]) -> list[Block]:
    """The set of each equilibrium."""
    result_blocks = loaded("printing.results.beyond_reports:result_blocks")
    return [block for label, report, solution in found
            for block in (Heading(label), *_family(report), *result_blocks(solution))]


def _family(report: Report) -> list[Block]:
    """What the family expresses by the other names."""
    eq = report.equilibrium
    return [block for name, value in eq.relations[-1:]
            for block in (sentence("On the family:"), Display(name, readable(value), eq.at))]
