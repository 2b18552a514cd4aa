"""gyrostat verify: published formulas checked against what the library derives."""
import argparse
import json
import sys

from ..published import SOURCES, Finding, check, errata, listing


def run(given: argparse.Namespace) -> tuple[str, bool]:
    """What the command prints, and whether every status is the expected one."""
    findings = check(given.sources or SOURCES, _progress if sys.stderr.isatty() else None)
    agreed = all(f.status == f.expected for f in findings)
    if given.format == "json":
        return json.dumps(listing.to_json(findings), indent=2, ensure_ascii=False) + "\n", agreed
    if given.format == "latex":
        return errata.latex(findings, given.fragment), agreed
    return listing.text(findings) + _summary(findings) + "\n", agreed


def _summary(findings: list[Finding]) -> str:
    unexpected = [f"{f.statement.source}:{f.statement.key}" for f in findings if f.status != f.expected]
    if unexpected:
        return f"{len(unexpected)} of {len(findings)} are not as expected: {', '.join(unexpected)}"
    return f"{len(findings)} statements, all as expected"


def _progress(source: str, done: int, total: int) -> None:
    """A bar on standard error, wiped when the source is done."""
    filled = 30 * done // total
    bar = f"\r{source:<12} [{'#' * filled}{'.' * (30 - filled)}] {done}/{total}"
    print(bar if done < total else "\r" + " " * len(bar) + "\r", end="", file=sys.stderr, flush=True)
