"""gyrostat conditions --solve-for NAME.

The values of one parameter for which an equilibrium exists and is stable.
"""
import argparse
import contextlib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sympy import Expr

from ...algebra.rings.readable import readable
from ...algebra.text.inputs import name_of
from ...errors import EquilibriumError, GyrostatError, ScopeError
from ...mechanics.families.named_families import FAMILIES
from ...parameters.sets import Interval, Solution
from ...parameters.stabilizing_set import stabilizing_set
from ...printing.blocks import Block, Display, Heading, sentence
from ...printing.formats.article import article
from ...printing.formats.json_data import json_text, strings
from ...printing.formats.text import text
from ...printing.results.beyond_reports import result_blocks
from ...stability.report.analysis import analyze
from ...stability.report.report import Report
from ..options.latex_options import paper_of
from ..options.scene_texts import Asked, scene_of
from ..output import Output
from .equilibria import of_each, report_at


def run(given: argparse.Namespace, asked: Asked, labels: Sequence[str], numbers: Mapping[str, Expr],
        out: Output) -> int:
    """Write the sets; 0."""
    name = name_of(given.solve_for) or given.solve_for
    found, missing = of_each(labels, lambda label: [(label, *_solved(asked, label, name, numbers))])
    if given.format == "json":
        out(json_text({"equilibria": [{"label": label} | solution_data(solution)
                                      for label, _, solution in found]
                       + [m.data() for m in missing]}))
        return 0
    blocks: list[Block] = []
    for label, report, solution in found:
        blocks += [Heading(label), *_family(report), *result_blocks(solution)]
    blocks += [block for m in missing for block in m.blocks()]
    if given.format == "latex":
        title = f"Values of {name} that stabilise".replace("_", r"\_")
        out(article(title, blocks, paper_of(given)))
    else:
        out(text(blocks, out.width))
    return 0


def _family(report: Report) -> list[Block]:
    """What the family expresses by the other names."""
    eq = report.equilibrium
    return [block for name, value in eq.relations[-1:]
            for block in (sentence("On the family:"), Display(name, readable(value), eq.at))]


def _solved(asked: Asked, label: str, name: str,
            numbers: Mapping[str, Expr]) -> tuple[Report, Solution]:
    """The first form of the family in which the name can be solved for.

    E3 as it is, along its tilts, or with k3 expressed.
    """
    failed: list[GyrostatError] = []
    for report in _forms(asked, label, name, numbers):
        try:
            return report, stabilizing_set(report, name, numbers)
        except (ScopeError, EquilibriumError) as error:
            failed.append(error)
    raise failed[0]


def _forms(asked: Asked, label: str, name: str, numbers: Mapping[str, Expr]) -> Iterator[Report]:
    yield report_at(asked, label, {**numbers, name: None})
    scene = scene_of(asked)
    if label in FAMILIES and FAMILIES[label].tilted and scene.potential and scene.potential.given:
        for eliminated in (name, "k3") if asked.eliminate is None else ():
            with contextlib.suppress(EquilibriumError):    # the relation is not affine in it
                yield analyze(FAMILIES[label].of(scene, eliminate=eliminated))


def solution_data(solution: Solution) -> dict[str, Any]:
    """The set as data."""
    return {"name": solution.name, "parts": [{
        "meaning": part.meaning, "margin": str(part.margin), "cases": [{
            "when": [{"expression": str(e), "compared_with_0": relation} for e, relation in case.when],
            "intervals": [_interval(i) for i in case.intervals]} for case in part.cases]}
                                             for part in solution.parts]}


def _interval(i: Interval) -> dict[str, Any]:
    """Its ends, and the expressions of which the first that is not 0 is positive where the end belongs to it.
    """
    return {"low": str(i.low), "low_if": strings(i.low_if), "high": str(i.high),
            "high_if": strings(i.high_if),
            "tilt": i.tilt and strings(i.tilt)}
