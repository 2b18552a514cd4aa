"""The reports of the equilibria of a scene, with their decisions where the numbers are enough."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Expr

from ..._lazy import loaded
from ...mechanics.scenes.system import System
from ...stability.decision import Decision
from ...stability.report.report import Report, both_verdicts
from ..scene_texts import Asked, scene_of
from .equilibria import Missing, enough, its_own, known_names, labels_of, of_each, reports_of


@dataclass(frozen=True)
class ReportList:
    """The reports, the verdict and that under damping by label, and why others have none."""

    scene: System
    reports: Sequence[Report]
    decisions: Mapping[str, tuple[Decision, Decision]]
    missing: Sequence[Missing]

    def data(self) -> dict[str, Any]:
        """For JSON."""
        data: dict[str, Any] = loaded("printing.formats.json_data:reports_data")(
            self.scene, self.reports, self.decisions)
        return data | {"equilibria": [*data["equilibria"], *(m.data() for m in self.missing)]}


def report_list(asked: Asked, given: Sequence[str] | None, numbers: Mapping[str, Expr]) -> ReportList:
    """The reports of the equilibria that are named, or of those that the scene is known to have."""
    scene = scene_of(asked)
    labels, others = labels_of(asked, given, numbers)
    reports, missing = reports_of(asked, labels, numbers)
    decisions: dict[str, tuple[Decision, Decision]] = {}
    if numbers:
        known_names(asked, reports, numbers)
    if numbers and reports:
        decided = {report.equilibrium.label: report
                   for report, whole in zip(reports, enough(reports, numbers)) if whole}
        found, undecided = of_each(list(decided), lambda label: [
            (label, both_verdicts(decided[label], its_own(decided[label], numbers)))])
        decisions, missing = dict(found), missing + undecided
    return ReportList(scene, reports, decisions, missing + others)
