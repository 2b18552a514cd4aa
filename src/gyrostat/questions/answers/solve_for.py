"""Solves for one parameter: the values for which an equilibrium exists and is stable."""
import contextlib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sympy import Expr

from ...errors import EquilibriumError, GyrostatError, ScopeError
from ...mechanics.families.named_families import FAMILIES
from ...parameters.sets import Interval, Solution
from ...parameters.stabilizing_set import stabilizing_set
from ...printing.formats.json_data import strings
from ...stability.report.analysis import analyze
from ...stability.report.report import Report
from ..scene_texts import Asked, scene_of
from .equilibria import Missing, of_each, report_at

Solved = tuple[str, Report, Solution]


def solved(asked: Asked, labels: Sequence[str], name: str,
           numbers: Mapping[str, Expr]) -> tuple[list[Solved], list[Missing]]:
    """The set of each equilibrium with its label and its report, and why there is none of the others."""
    return of_each(labels, lambda label: [(label, *_solved(asked, label, name, numbers))])


def solutions_data(found: Sequence[Solved], missing: Sequence[Missing]) -> dict[str, Any]:
    """The sets as data for JSON."""
    return {"equilibria": [*({"label": label} | _data(solution) for label, _, solution in found),
                           *(m.data() for m in missing)]}


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


def _data(solution: Solution) -> dict[str, Any]:
    """The set as data."""
    return {"name": solution.name, "parts": [{
        "meaning": part.meaning, "margin": str(part.margin), "cases": [{
            "when": [{"expression": str(e), "compared_with_0": relation} for e, relation in case.when],
            "intervals": [interval_data(i) for i in case.intervals]} for case in part.cases]}
                                             for part in solution.parts]}


def interval_data(i: Interval) -> dict[str, Any]:
    """Its ends, and the expressions of which the first that is not 0 is positive where the end belongs to it.
    """
    return {"low": str(i.low), "low_if": strings(i.low_if), "high": str(i.high),
            "high_if": strings(i.high_if),
            "tilt": i.tilt and strings(i.tilt)}
