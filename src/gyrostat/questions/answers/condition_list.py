"""The conditions of the equilibria of a scene at numbers, with what decides between them."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sympy import Expr

from ...parameters.stabilizing_set import inserted
from ...printing.formats.json_data import conditions_data, criterion_data, window_data
from ...stability.criteria.conditions import Criterion
from ...stability.normal_forms.d4_along_family import Window
from ...stability.report.report import Report
from ..scene_texts import Asked
from .between_criteria import between
from .equilibria import Missing, known_names, of_each, reports_of


@dataclass(frozen=True)
class ConditionList:
    """The reports that have conditions, why others have none, and what decides between the two by label."""

    reports: Sequence[Report]
    missing: Sequence[Missing]
    between: Mapping[str, Window | str] = field(default_factory=dict)
    sink: Criterion | None = None

    def data(self) -> dict[str, Any]:
        """For JSON."""
        found: dict[str, Any] = {"equilibria": [*map(conditions_data, self.reports),
                                                *(m.data() for m in self.missing)]}
        if self.between:
            found["windows"] = {label: {"open": held} if isinstance(held, str) else window_data(held)
                                for label, held in self.between.items()}
        return found | ({"energy_sink": criterion_data(self.sink)} if self.sink else {})


def condition_list(asked: Asked, labels: Sequence[str], others: Sequence[Missing],
                   numbers: Mapping[str, Expr], windows: bool = False,
                   sink: Criterion | None = None) -> ConditionList:
    """The conditions of the equilibria of these labels, and why others have none."""
    reports, missing = reports_of(asked, labels, numbers)
    if numbers:
        known_names(asked, reports, numbers)
        by_label = {report.equilibrium.label: report for report in reports}
        reports, without = of_each(list(by_label), lambda label: [inserted(by_label[label], numbers)])
        missing = missing + without
    held = {r.equilibrium.label: found for r in reports if (found := between(r))} if windows else {}
    return ConditionList(reports, [*missing, *others], held, sink)
