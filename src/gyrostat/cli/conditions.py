"""gyrostat conditions: where each equilibrium exists, its two conditions, and what decides between them."""
import argparse
import json
from collections.abc import Mapping
from dataclasses import replace

from sympy import Expr

from ..blocks import Block, Heading, boundary_blocks, criterion_blocks, existence
from ..equilibria import Equilibrium
from ..errors import ValuesError
from ..exact import sign_of_constant
from ..expressions import shown
from ..notation import jet, symbol
from ..stability import Report, analyze
from .data import conditions_data
from .output import Output
from .scenes import known_names, labels_of, numbers_of, reports_of, scene_of


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the conditions; 0."""
    numbers, scene = numbers_of(given.values), scene_of(given.potential)
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


def inserted(report: Report, numbers: Mapping[str, Expr]) -> Report:
    """The report with numbers in place of some of its names."""
    eq = report.equilibrium
    if jets := [name for name in numbers if jet(name)]:
        raise ValuesError(f"{jets[0]} is a derivative of U: give U itself, --potential EXPR, or ask for a verdict, gyrostat decide")
    if eq.eliminated in numbers:
        raise ValuesError(f"{eq.label} expresses {eq.eliminated} by the other names, {dict(eq.relations)[symbol(eq.eliminated)]}: "
                          f"leave out --set {eq.eliminated}")
    pairs = tuple((symbol(name), number) for name, number in numbers.items() if name in report.parameters)
    return analyze(_existing(replace(eq, relations=(*eq.relations, *pairs))))


def _existing(eq: Equilibrium) -> Equilibrium:
    for domain, value in zip(eq.domain, eq.existence()):
        if not value.free_symbols and sign_of_constant(value) != 1:
            raise ValuesError(f"{eq.label} exists only where {domain} > 0, here it is {shown(value)}: choose other numbers")
    return eq


def conditions_blocks(report: Report) -> list[Block]:
    """The conditions of one equilibrium."""
    eq = report.equilibrium
    return [Heading(eq.label), *(existence(d, eq.at) for d in eq.existence() if d.free_symbols),
            *criterion_blocks("Necessary", report.necessary, eq.at), *criterion_blocks("Sufficient", report.sufficient, eq.at),
            *boundary_blocks(report)]
