"""Turns a list of answers into data for JSON, with the note that all of them have."""
import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from ..._lazy import loaded
from ...equilibria.relative_equilibrium import RelativeEquilibrium
from ...printing.formats.json_data import damped_data, decision_data
from ...stability.decision import Decision
from .answers import Answer
from .equilibria import Missing


def note_once(answers: Sequence[Answer | Missing]) -> tuple[str, list[Answer | Missing]]:
    """The note that all decisions of a list have, and the list without it; "" if the notes differ."""
    notes = [a.decision.note for a in answers if isinstance(a, Answer)]
    if len(notes) < 2 or len({*notes}) > 1:
        return "", list(answers)
    return notes[0], [a if isinstance(a, Missing) else
                         replace(a, decision=replace(a.decision, note=""), damped=_bare(a.damped),
                                 itself=_bare(a.itself)) for a in answers]


def _bare(decision: Decision | None) -> Decision | None:
    return None if decision is None else replace(decision, note="")


def answers_data(answers: Sequence[Answer | Missing], exact: bool = False,
                 wells: bool = False) -> dict[str, Any]:
    """The answers as data for JSON, with a common note once; exact numbers and wells if asked for."""
    note, bare = note_once(answers)
    listed = [a.data() if isinstance(a, Missing) else {"number": n} | _data(a) | (_exact(a) if exact else {})
              | (_well(a) if wells else {})
              for n, a in enumerate(bare, 1)]
    return {"equilibria": listed} | ({"note": note} if note else {})


def _data(answer: Answer) -> dict[str, Any]:
    """The same keys for every kind of scene; frequencies and growth rate of what was found at a point."""
    found, damped, itself = answer.found, answer.damped, answer.itself
    return {"label": found.label if found is not None and answer.listed else answer.label,
            "locus": "" if found is None else found.locus,
            "place": _finite(found.doubles.place) if found is not None and answer.listed else {},
            "attitude": None if found is None or found.attitude is None else found.attitude.data,
            **_rates(answer.at_point),
            "decision": decision_data(answer.decision),
            "damped_decision": None if damped is None else damped_data(damped),
            "itself": None if itself is None else decision_data(itself)}


def _well(answer: Answer) -> dict[str, Any]:
    """The well, or why there is none."""
    return {"well": loaded("printing.results.well:well_data")(answer.well)}


def _rates(found: RelativeEquilibrium | None) -> dict[str, Any]:
    """The rates of the small motions; all null if they vary, or if they are not known."""
    names = "frequencies", "frequencies_per_orbit", "growth_rate", "doubling_time"
    return {name: None if found is None else _finite(getattr(found.doubles, name)) for name in names}


def _finite(numbers: Any) -> Any:
    """Doubles, several or one; null for one that is too large, as JSON has no infinity."""
    if isinstance(numbers, dict):
        return {name: _finite(x) for name, x in numbers.items()}
    if isinstance(numbers, tuple):
        return [_finite(x) for x in numbers]
    return numbers if numbers is not None and math.isfinite(numbers) else None


def _exact(answer: Answer) -> dict[str, Any]:
    """Place, frequencies and growth rate by polynomials, if they are known exactly."""
    exact_data = loaded("printing.formats.exact_numbers:exact_data")
    numbers = {name: exact_data(x) for name, x in (answer.place | answer.rates).items() if x is not None}
    return {"exact": {name: x for name, x in numbers.items() if x is not None}}
