"""gyrostat report: the derivation as text, LaTeX or JSON."""
import argparse

from ..._lazy import loaded
from ...notation import symbol
from ...printing.blocks import Block, Heading
from ...printing.formats.text import text
from ...printing.results.decision import damped_block, decision_blocks
from ...printing.results.document import report_blocks, whole_blocks
from ...questions.answers.report_list import report_list
from ...questions.given_numbers import numbers_of
from ...stability.criteria.number_notes import scene_note
from ...stability.decision import Decision
from ...stability.report.report import Report
from ..options.scene_files import asked_of, with_scene
from ..output import Output

TITLE = "Equations of motion of a gyrostat"


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the report; 0."""
    given = with_scene(given)
    numbers = numbers_of(given.values)
    found = report_list(asked_of(given, numbers), given.equilibrium, numbers)
    if not found.decisions:
        out.noted(scene_note(found.scene, {symbol(name): x for name, x in numbers.items()}))
    if given.format == "json":
        out(loaded("printing.formats.json_data:json_text")(found.data()))
        return 0
    after = [block for m in found.missing for block in m.blocks()]
    decided = [_blocks(report, found.decisions.get(label := report.equilibrium.label),
                       "Verdict" if given.format == "latex" else label) for report in found.reports]
    if given.format == "latex":
        paper = loaded("cli.options.latex_options:paper_of")(given)
        article = loaded("printing.formats.article:" + ("document" if found.reports else "article"))
        out(article(found.reports, decided, paper, after) if found.reports
            else article(TITLE, whole_blocks(found.scene, after), paper))
    else:
        derived = [block for report in found.reports for block in report_blocks(report)]
        verdicts: list[Block] = [Heading("Verdicts at these numbers")] if found.decisions else []
        out(text([*verdicts, *(block for its in decided for block in its),
                  *whole_blocks(found.scene, derived + after)], out.width))
    return 0


def _blocks(report: Report, decisions: tuple[Decision, Decision] | None, of: str) -> list[Block]:
    """The verdict, and what internal damping makes of it, if there are numbers."""
    if decisions is None:
        return []
    decision, damped = decisions
    return [*decision_blocks(decision, report.equilibrium.at, of), damped_block(decision, damped)]
