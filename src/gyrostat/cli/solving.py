"""gyrostat conditions --solve-for NAME: the values of one parameter for which an equilibrium exists and is stable."""
import argparse
import json
from collections.abc import Mapping, Sequence
from typing import Any

from sympy import Expr

from ..blocks import Heading
from ..errors import EquilibriumError, GyrostatError, ScopeError
from ..families import inclined
from ..intervals import Interval, Solution
from ..notation import jet
from ..results import result_blocks
from ..stability import Report, analyze
from ..stabilizing import stabilizing_set
from .data import strings
from .output import Output
from .scenes import report_of, scene_of, spin_of


def run(given: argparse.Namespace, labels: Sequence[str], numbers: Mapping[str, Expr], out: Output) -> int:
    """Write the sets; 0."""
    spin = "omega3_0" if given.solve_for == "omega3_0" else spin_of(numbers)
    found = [(label, _solved(given.potential, label, spin, given.solve_for, numbers)) for label in labels]
    if given.format == "json":
        data = [{"label": label} | solution_data(solution) for label, solution in found]
        out(json.dumps({"equilibria": data}, indent=2, ensure_ascii=False) + "\n")
    elif given.format == "latex":
        from ..article import article
        title = f"Values of {given.solve_for} that stabilise".replace("_", r"\_")
        out(article(title, [b for label, s in found for b in (Heading(label), *result_blocks(s))], given.fragment))
    else:
        from ..unicode import text
        out(text([block for label, solution in found for block in (Heading(label), *result_blocks(solution))]))
    return 0


def _solved(potential: str | None, label: str, spin: str, name: str, numbers: Mapping[str, Expr]) -> Solution:
    """The first form of the family in which the name can be solved for: E3 in l along its tilts, or with k3 expressed by l."""
    failed: list[GyrostatError] = []
    for report in _forms(potential, label, spin, name):
        try:
            return stabilizing_set(report, name, {n: x for n, x in numbers.items() if n != report.equilibrium.eliminated or jet(n)})
        except (ScopeError, EquilibriumError) as error:
            failed.append(error)
    raise failed[-1]


def _forms(potential: str | None, label: str, spin: str, name: str) -> list[Report]:
    scene = scene_of(potential)
    if label != "E3" or not scene.potential or not scene.potential.given:
        return [report_of(potential, label, spin)]
    reports = []
    for eliminated in (name, "k3", None) if name in report_of(potential, "E3").equilibrium.relations[-1][0].name else ("k3", None):
        try:
            reports.append(analyze(inclined(scene, eliminated)))
        except EquilibriumError:
            continue
    return reports


def solution_data(solution: Solution) -> dict[str, Any]:
    """The set as data."""
    return {"name": solution.name, "parts": [{
        "meaning": part.meaning, "margin": str(part.margin), "cases": [{
            "when": [{"expression": str(e), "compared_with_0": relation} for e, relation in case.when],
            "intervals": [_interval(i) for i in case.intervals]} for case in part.cases]} for part in solution.parts]}


def _interval(i: Interval) -> dict[str, Any]:
    """Its ends, and the expressions of which the first that is not 0 is positive where the end belongs to it."""
    return {"low": str(i.low), "low_if": strings(i.low_if), "high": str(i.high), "high_if": strings(i.high_if),
            "tilt": i.tilt and strings(i.tilt)}
