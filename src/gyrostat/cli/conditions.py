"""gyrostat conditions: where each equilibrium exists, its two conditions, and what decides between them."""
import argparse

from ..printing.article import conditions_table
from ..printing.blocks import Block, Heading
from ..printing.boundary import boundary_blocks
from ..printing.conditions import criterion_blocks, existence
from ..printing.data import conditions_data, json_text
from ..printing.text import text
from ..stability.report import Report
from ..stability.stabilizing import inserted
from .asked import asked_of
from .equilibria import known_names, labels_of, of_each, reports_of, some
from .options import numbers_of
from .output import Output
from .scene_files import with_scene
from .solve_for import run as solve


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the conditions; 0."""
    given = with_scene(given)
    numbers = numbers_of(given.values)
    asked = asked_of(given, {*numbers, given.solve_for})
    labels, others = labels_of(asked, given.equilibrium, numbers)
    some(labels, others)
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
    if given.format == "json":
        out(json_text({"equilibria": [conditions_data(report) for report in reports]
                       + [m.data() for m in missing]}))
    elif given.format == "latex":
        out(conditions_table(reports, given.fragment, after))
    else:
        out(text([block for report in reports for block in conditions_blocks(report)] + after,
                 out.width))
    return 0


def conditions_blocks(report: Report) -> list[Block]:
    """The conditions of one equilibrium."""
    eq = report.equilibrium
    return [Heading(eq.label), *(existence(d, eq.at) for d in eq.existence() if d.free_symbols),
            *criterion_blocks("Necessary", report.necessary, eq.at),
            *criterion_blocks("Sufficient", report.sufficient, eq.at),
            *boundary_blocks(report)]
