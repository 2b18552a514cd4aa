"""gyrostat report: the derivation as text, LaTeX or JSON."""
import argparse

from ..._lazy import loaded
from ...notation import symbol
from ...printing.blocks import Block
from ...printing.formats.text import text
from ...printing.results.decision import damped_block, decision_blocks
from ...printing.results.document import report_blocks, whole_blocks
from ...stability.criteria.number_notes import scene_note
from ...stability.decision import Decision
from ...stability.report.report import Report
from ..answers.equilibria import both_verdicts, enough, its_own, known_names, labels_of, of_each, reports_of
from ..options.options import numbers_of
from ..options.scene_files import with_scene
from ..options.scene_texts import asked_of, scene_of
from ..output import Output

TITLE = "Equations of motion of a gyrostat"


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the report; 0."""
    given = with_scene(given)
    numbers = numbers_of(given.values)
    asked = asked_of(given, numbers)
    scene = scene_of(asked)
    labels, others = labels_of(asked, given.equilibrium, numbers)
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
    if not decisions:
        out.noted(scene_note(scene, {symbol(name): x for name, x in numbers.items()}))
    missing = missing + others
    after = [block for m in missing for block in m.blocks()]
    if given.format == "json":
        write = loaded("printing.formats.json_data:reports_text")
        out(write(scene, reports, decisions, [m.data() for m in missing]))
        return 0
    decided_blocks = [_blocks(report, decisions.get(report.equilibrium.label)) for report in reports]
    if given.format == "latex":
        paper = loaded("cli.options.latex_options:paper_of")(given)
        article = loaded("printing.formats.article:" + ("document" if reports else "article"))
        out(article(reports, decided_blocks, paper, after) if reports
            else article(TITLE, whole_blocks(scene, after), paper))
    else:
        blocks: list[Block] = []
        for report, its in zip(reports, decided_blocks):
            blocks += report_blocks(report) + its
        out(text(whole_blocks(scene, blocks + after), out.width))
    return 0


def _blocks(report: Report, decisions: tuple[Decision, Decision] | None) -> list[Block]:
    """The verdict, and what internal damping makes of it, where there are numbers."""
    if decisions is None:
        return []
    decision, damped = decisions
    return [*decision_blocks(decision, report.equilibrium.at), damped_block(decision, damped)]
