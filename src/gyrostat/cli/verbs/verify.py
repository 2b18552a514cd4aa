"""gyrostat verify: published formulas checked against what the library derives."""
import argparse
from textwrap import wrap

from ...charts.progress import Progress
from ...errors import GyrostatError
from ...printing.formats.json_data import json_text
from ...published import SOURCES, Finding, listing
from ...published.checks.findings import findings as each
from ...published.latex import latex
from ..options.latex_options import paper_of
from ..output import Output


def run(given: argparse.Namespace, out: Output) -> int:
    """Write the findings; 0, or 1 if a status is not the expected one."""
    progress = Progress()

    def shown(source: str, done: int, total: int) -> None:
        progress.show(source, done, total)
        if done == total:
            progress.wipe()

    findings = list[Finding]()
    try:
        for finding in each(given.sources or SOURCES, shown):
            findings.append(finding)
    except GyrostatError:
        progress.wipe()
        if findings and given.format == "text":            # what was checked before is not lost
            out(listing.text(findings, out.width, given.full))
        raise
    if given.format == "json":
        out(json_text({"statements": listing.to_json(findings)}))
    elif given.format == "latex":
        out(latex(findings, paper_of(given), given.full))
    else:
        out(listing.text(findings, out.width, given.full))
        out("\n".join(wrap(listing.summary(findings), out.width)) + "\n")
    return int(any(f.status != f.expected for f in findings))
