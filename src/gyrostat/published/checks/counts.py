"""Checks printed counts: how many equilibria a satellite has, and how many with each index of K."""
from typing import Any

from ...equilibria.search import relative_equilibria
from ...errors import PublishedError
from ..independent.counterexample import Values
from ..independent.counts_by_newton import found_by_search
from ..statements import Doubt, Outcome, Seen
from . import routes
from .readings import Reading

INDICES = tuple(f"index {n}" for n in range(4))
COUNTED = ("equilibria", *INDICES)
CURVE = "not finite: there is a closed curve of equilibria"


def count(r: Reading) -> Outcome | Doubt:
    """Check the printed numbers of equilibria, at the values of `at`."""
    asked, printed = _texts(r.statement.quantity), _texts(r.statement.printed)
    if "orbit" not in r.scene.table or r.scene.equilibrium is not None:
        raise PublishedError("a count is of the equilibria of a satellite: give the scene an orbit, and no "
                             "equilibrium")
    if unknown := [name for name in asked if name not in COUNTED]:
        raise PublishedError(f"quantity = {unknown[0]!r}: what is counted is {', '.join(COUNTED)}")
    if len(printed) != len(asked) or not all(text.lstrip("-").isdigit() for text in printed):
        raise PublishedError(f"printed = {', '.join(printed)}: give a whole number for each of "
                             f"{', '.join(asked)}")
    values = {s.name: value for s, value in r.at.items()}
    derived = _said(asked, [None if e.locus or not e.form.signs[-1] else e.form.index
                            for e in relative_equilibria(r.scene.system, values)])
    if derived == printed:
        return Outcome(True, ", ".join(printed), ", ".join(derived), route=routes.COUNTED)
    return Doubt([r.at], ", ".join(printed), ", ".join(derived))


def _said(asked: list[str], indices: list[int | None]) -> list[str]:
    """Return how many equilibria there are of each kind asked for; the index on a curve of them is None."""
    if None in indices:
        return [CURVE] * len(asked)
    return [str(len(indices) if name == "equilibria" else indices.count(INDICES.index(name)))
            for name in asked]


def count_at(r: Reading, values: Values, doubt: Doubt) -> Seen | None:
    """Count the equilibria again by a search from many starts, in floats."""
    found = found_by_search(r.scene, values)
    asked, printed = _texts(r.statement.quantity), _texts(r.statement.printed)
    again = _said(asked, found)                            # where K is singular: a curve
    if ", ".join(again) != doubt.derived:
        raise PublishedError(f"by a search from many starts the numbers are {', '.join(again)}, by the "
                             f"library {doubt.derived}")
    if again == printed:
        return None
    other = " + U" if "potential" in r.scene.table else ""
    return Seen(doubt.printed, doubt.derived, f"a search from many starts, by Newton's method in V = (3/2) "
                f"ω0² r·Ir − (1/2) ω0² n·In − ω0 n·l{other}, ends at {len(found)} different points", True)


def _texts(value: Any) -> list[str]:
    return [str(x) for x in value] if isinstance(value, list) else [str(value)]
