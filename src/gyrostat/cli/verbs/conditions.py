"""gyrostat conditions: where each equilibrium exists, its two conditions, and what decides between them."""
import argparse

from ...notation import symbol
from ...parameters.stabilizing_set import inserted
from ...printing.blocks import Heading
from ...printing.formats.json_data import conditions_data, criterion_data, json_text, window_data
from ...printing.formats.tables import conditions_table
from ...printing.formats.text import text
from ...printing.results.document import conditions_blocks
from ...printing.results.inequalities import criterion_blocks
from ...printing.symbols import occurring, symbol_rows
from ...stability.criteria.number_notes import scene_note
from ..answers.between_criteria import between, between_blocks
from ..answers.energy_sink import sink_of
from ..answers.equilibria import known_names, labels_of, of_each, reports_of, some
from ..answers.solve_for import run as solve
from ..options.latex_options import paper_of
from ..options.options import numbers_of
from ..options.scene_files import with_scene
from ..options.scene_texts import asked_of, scene_of
from ..output import Output


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the conditions; 0."""
    given = with_scene(given)
    numbers = numbers_of(given.values)
    sink = sink_of(given, numbers)
    asked = asked_of(given, {*numbers, given.solve_for})
    labels, others = labels_of(asked, given.equilibrium, numbers)
    some(labels, others)
    out.noted(scene_note(scene_of(asked), {symbol(name): x for name, x in numbers.items()}))
    if given.solve_for:
        return solve(given, asked, labels, numbers, out)
    reports, missing = reports_of(asked, labels, numbers)
    if numbers:
        known_names(asked, reports, numbers)
        by_label = {report.equilibrium.label: report for report in reports}
        reports, without = of_each(list(by_label), lambda label: [inserted(by_label[label], numbers)])
        missing = missing + without
    missing = missing + others
    after = [block for m in missing for block in m.blocks()]
    if sink:
        after += [Heading("Energy sink"), *criterion_blocks("Stable, to first order in weak dampers", sink,
                                                             symbol("k3"), "energy sink")]
    held = {r.equilibrium.label: found for r in reports if (found := between(r))} if given.windows else {}
    for label, found in held.items():
        after += [Heading(f"{label}, between its two conditions"), *between_blocks(found)]
    if given.format == "json":
        data = {"equilibria": [*map(conditions_data, reports), *(m.data() for m in missing)]}
        windows = {label: {"open": found} if isinstance(found, str) else window_data(found)
                   for label, found in held.items()}
        out(json_text(data | ({"windows": windows} if held else {})
                      | ({"energy_sink": criterion_data(sink)} if sink else {})))
    elif given.format == "latex":
        out(conditions_table(reports, paper_of(given), after))
    else:
        blocks = [block for report in reports for block in conditions_blocks(report)]
        symbols = symbol_rows(reports[0].equilibrium.system, occurring(blocks))
        out(text([*blocks, *after, symbols], out.width))
    return 0
