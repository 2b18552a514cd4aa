"""gyrostat verify: published formulas checked against what the library derives."""
import argparse

from ..charts.progress import Progress
from ..printing.data import json_text
from ..published import SOURCES, Finding, check, errata, listing
from .output import Output
from .paper import paper_of


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the findings; 0, or 1 if a status is not the expected one."""
    progress = Progress()

    def shown(source: str, done: int, total: int) -> None:
        progress.show(source, done, total)
        if done == total:
            progress.wipe()

    findings = check(given.sources or SOURCES, shown)
    if given.format == "json":
        out(json_text({"statements": listing.to_json(findings)}))
    elif given.format == "latex":
        out(errata.latex(findings, paper_of(given)))
    else:
        out(listing.text(findings, out.width) + _summary(findings) + "\n")
    return int(any(f.status != f.expected for f in findings))


def _summary(findings: list[Finding]) -> str:
    unexpected = [f"{f.statement.source}:{f.statement.key}" for f in findings if f.status != f.expected]
    if unexpected:
        return f"{len(unexpected)} of {len(findings)} are not as expected: {', '.join(unexpected)}"
    return f"{len(findings)} statements, all as expected"
