"""Turns a list of answers into data for JSON, with the note that all of them have."""
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from ...printing.formats.json_data import damped_data, decision_data, number_data, rate_data
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


def answers_data(answers: Sequence[Answer | Missing]) -> dict[str, Any]:
    """The answers as data for JSON, with a common note once."""
    note, bare = note_once(answers)
    return _listed(bare) | ({"note": note} if note else {})


def _listed(answers: Sequence[Answer | Missing]) -> dict[str, Any]:
    return {"equilibria": [a.data() if isinstance(a, Missing) else _data(a) for a in answers]}


def _data(answer: Answer) -> dict[str, Any]:
    """The same keys for every kind of scene; frequencies and growth rate of what was found at a point."""
    found, damped, itself = answer.found, answer.damped, answer.itself
    at_point, place, growth = answer.at_point, answer.place, answer.rates.get("growth_rate")
    return {"label": found.label if found is not None and place else answer.label,
            "locus": "" if found is None else found.locus,
            "place": {name: number_data(x) for name, x in place.items()},
            "frequencies": None if at_point is None else [rate_data(x) for x in at_point.frequencies],
            "growth_rate": None if growth is None else rate_data(growth),
            "decision": decision_data(answer.decision),
            "damped_decision": None if damped is None else damped_data(damped),
            "itself": None if itself is None else decision_data(itself)}
