"""gyrostat conditions: where each equilibrium exists, its two conditions, and what decides between them."""
import argparse
import json

from ..blocks import Block, Heading, boundary_blocks, criterion_blocks, existence
from ..stability import Report
from ..stabilizing import inserted
from .data import conditions_data
from .output import Output
from .scenes import known_names, labels_of, numbers_of, reports_of, scene_of


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the conditions; 0."""
    numbers, scene = numbers_of(given.values), scene_of(given.potential)
    if given.solve_for:
        from .solving import run as solve
        return solve(given, labels_of(scene, given.equilibrium), numbers, out)
    reports = reports_of(given.potential, labels_of(scene, given.equilibrium), numbers)
    if numbers:
        known_names(reports, numbers)
        reports = [inserted(report, numbers) for report in reports]
    if given.format == "json":
        out(json.dumps({"equilibria": [conditions_data(report) for report in reports]}, indent=2, ensure_ascii=False) + "\n")
    elif given.format == "latex":
        from ..article import conditions_table
        out(conditions_table(reports, given.fragment))
    else:
        from ..unicode import text
        out(text([block for report in reports for block in conditions_blocks(report)]))
    return 0


def conditions_blocks(report: Report) -> list[Block]:
    """The conditions of one equilibrium."""
    eq = report.equilibrium
    return [Heading(eq.label), *(existence(d, eq.at) for d in eq.existence() if d.free_symbols),
            *criterion_blocks("Necessary", report.necessary, eq.at), *criterion_blocks("Sufficient", report.sufficient, eq.at),
            *boundary_blocks(report)]
