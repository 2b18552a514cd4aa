"""gyrostat report: the derivation as text, LaTeX or JSON."""
import argparse

from ..printing.article import document
from ..printing.blocks import Block
from ..printing.data import decision_data, json_text, report_data, scene_data
from ..printing.decision import decision_blocks
from ..printing.document import report_blocks, scene_blocks
from ..printing.text import text
from ..stability.report import Decision
from .options import enough, its_own, known_names, labels_of, numbers_of, of_each, reports_of, scene_of
from .output import Output


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the report; 0."""
    numbers, scene = numbers_of(given.values), scene_of(given.potential)
    reports, missing = reports_of(given.potential, labels_of(scene, given.equilibrium), numbers)
    decisions: list[Decision | None] = [None for _ in reports]
    if numbers:
        known_names(reports, numbers)
        asked = {report.equilibrium.label: report
                 for report, decided in zip(reports, enough(reports, numbers)) if decided}
        found, undecided = of_each(list(asked),
                                   lambda label: [(label,
                                                   asked[label].verdict(its_own(asked[label], numbers)))])
        decisions = [dict(found).get(report.equilibrium.label) for report in reports]
        missing = missing + undecided
    after = [block for m in missing for block in m.blocks()]
    if given.format == "json":
        equilibria = [report_data(report) | ({"decision": decision_data(decision)} if decision else {})
                      for report, decision in zip(reports, decisions)]
        out(json_text(scene_data(scene) | {"equilibria": equilibria + [m.data() for m in missing]}))
    elif given.format == "latex":
        out(document(reports, decisions, given.fragment, after))
    else:
        blocks: list[Block] = scene_blocks(scene)
        for report, decision in zip(reports, decisions):
            blocks += report_blocks(report) + (decision_blocks(decision, report.equilibrium.at) if decision
                                               else [])
        out(text(blocks + after))
    return 0
