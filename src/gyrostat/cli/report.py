"""gyrostat report: the derivation as text, LaTeX or JSON."""
import argparse

from ..printing.article import article, document
from ..printing.blocks import Block
from ..printing.data import decision_data, json_text, report_data, scene_data
from ..printing.decision import decision_blocks
from ..printing.document import report_blocks, whole_blocks
from ..printing.text import text
from ..stability.report import Decision
from .asked import asked_of, scene_of
from .equilibria import enough, its_own, known_names, labels_of, of_each, reports_of
from .options import numbers_of
from .output import Output
from .paper import paper_of
from .scene_files import with_scene

TITLE = "Equations of motion of a gyrostat"


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the report; 0."""
    given = with_scene(given)
    numbers = numbers_of(given.values)
    asked = asked_of(given, numbers)
    scene = scene_of(asked)
    labels, others = labels_of(asked, given.equilibrium, numbers)
    reports, missing = reports_of(asked, labels, numbers)
    decisions: list[Decision | None] = [None for _ in reports]
    if numbers:
        known_names(asked, reports, numbers)
    if numbers and reports:
        decided = {report.equilibrium.label: report
                   for report, whole in zip(reports, enough(reports, numbers)) if whole}
        found, undecided = of_each(list(decided),
                                   lambda label: [(label, decided[label].verdict(
                                       its_own(decided[label], numbers)))])
        decisions = [dict(found).get(report.equilibrium.label) for report in reports]
        missing = missing + undecided
    missing = missing + others
    after = [block for m in missing for block in m.blocks()]
    if given.format == "json":
        equilibria = [report_data(report) | ({"decision": decision_data(decision)} if decision else {})
                      for report, decision in zip(reports, decisions)]
        out(json_text(scene_data(scene) | {"equilibria": equilibria + [m.data() for m in missing]}))
    elif given.format == "latex":
        out(document(reports, decisions, paper_of(given), after) if reports
            else article(TITLE, whole_blocks(scene, after), paper_of(given)))
    else:
        blocks: list[Block] = []
        for report, decision in zip(reports, decisions):
            blocks += report_blocks(report) + (decision_blocks(decision, report.equilibrium.at) if decision
                                               else [])
        out(text(whole_blocks(scene, blocks + after), out.width))
    return 0
