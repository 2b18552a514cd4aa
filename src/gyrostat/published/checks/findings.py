"""Checks each statement of a source against what the library derives."""
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from ...arguments import checked
from ...errors import PublishedError
from ..sources import _HERE, SOURCES, Source, _at, load
from ..statements import Doubt, Outcome, Statement
from . import claims, counts, evidence, formulas
from .readings import Reading
from .unknown_names import refuse_unknown_names

_CHECKS: Mapping[str, Callable[[Reading], Outcome | Doubt]] = {
    "identity": formulas.identity, "family": formulas.identity, "equilibrium": formulas.equilibrium,
    "solution": formulas.solution,
    "number": formulas.rounded, "condition": claims.condition, "count": counts.count,
    "statement": claims.statement}
_STATUS = {True: "confirmed", False: "misprint", None: "unchecked"}


@dataclass(frozen=True)
class Finding:
    """What the library found about one statement.

    Parameters
    ----------
    statement : Statement
    status : str
        confirmed, misprint or unchecked: computed, never stored
    expected : str
    outcome : Outcome
        printed, derived, difference and counterexample

    Examples
    --------
    >>> import gyrostat as gs
    >>> finding = gs.published.check(["AR"])[0]
    >>> finding.statement.source, finding.status, finding.expected
    ('AR', 'confirmed', 'confirmed')
    """

    statement: Statement
    status: str
    expected: str
    outcome: Outcome


def source_of(finding: Finding) -> Source:
    """Return the source of a finding."""
    own = finding.statement.source in SOURCES and finding.statement.file == str(
        _HERE / f"{finding.statement.source}.toml"
    )
    return load(finding.statement.source if own else finding.statement.file)


@checked
def check(sources: Iterable[str | Path] = SOURCES,
          progress: Callable[[str, int, int], None] | None = None) -> list[Finding]:
    """Check every statement of the sources against what the library derives.

    The library derives from the bracket and the Hamiltonian, or from the kinematics of the rotation.

    Parameters
    ----------
    sources : iterable of str or Path
        as in load; default: all
    progress : function or None
        called with the source, the number of statements done, and their total

    Returns
    -------
    list of Finding

    Raises
    ------
    PublishedError
        a formula cannot be read; the message names file and key

    Examples
    --------
    >>> import gyrostat as gs
    >>> findings = gs.published.check(["AR"])
    >>> [f.statement.key for f in findings if f.status == "misprint"]
    ['Omega-1', 'Omega-2', 'Omega-3', '2K-dot', 'ellipsoid']
    """
    return list(findings(sources, progress))


def findings(sources: Iterable[str | Path], progress: Callable[[str, int, int], None] | None = None
             ) -> Iterator[Finding]:
    """Yield the findings of check one by one, so that those before a fault are not lost."""
    for source in map(load, sources):
        refuse_unknown_names(source)
        for n, statement in enumerate(source.statements, 1):
            yield _finding(source, statement)
            if progress:
                progress(source.name, n, len(source.statements))


def _finding(source: Source, statement: Statement) -> Finding:
    with _at(Path(statement.file), statement.key):
        outcome = outcome_of(statement)
        return Finding(statement, _STATUS[outcome.agrees], source.expected.get(statement.key, "confirmed"),
                       outcome)


def outcome_of(statement: Statement) -> Outcome:
    """Compare one statement with what is derived.

    Raises
    ------
    GyrostatError
        the statement cannot be read, a difference was found that is not confirmed independently, or what it
        is corrected to is not what is derived
    """
    outcome = _checked(statement)
    if outcome.agrees is not False or statement.corrected is None:
        return outcome
    right = _checked(replace(statement, printed=statement.corrected))
    if not right.agrees:
        raise PublishedError(f"corrected = {statement.corrected!r} is not what is derived: {right.derived}")
    return replace(outcome, corrected=statement.corrected)


def _checked(statement: Statement) -> Outcome:
    reading = Reading(statement)
    found = _CHECKS[statement.kind](reading)
    return evidence.decided(reading, found) if isinstance(found, Doubt) else found
