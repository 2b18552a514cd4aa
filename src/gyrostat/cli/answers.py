"""What decide answers: the equilibrium that the numbers name, or all that they allow."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sympy import Expr

from ..algebra.exact import sign_of_constant
from ..errors import ScopeError, ValuesError
from ..mechanics.families import E3, FAMILIES, POLES
from ..mechanics.system import System
from ..notation import symbol
from ..printing.data import decision_data, number_data
from ..stability.branch import Branch
from ..stability.branches import branches_at, pole_at
from ..stability.report import Decision, Report
from .options import (
    AT_REST,
    AXIS,
    Missing,
    enough,
    its_own,
    known_names,
    labels,
    labels_of,
    of_each,
    report_of,
    scene_of,
    spin_of,
)

# with these numbers of the motion all are found
MOTION = ({"omega"}, {"k3"}, {"pi3_0", "C1"}, {"k3", "pi3_0"})


@dataclass(frozen=True)
class Answer:
    """One equilibrium, where it lies if it was found, and what is decided.

    Of it, and of the point itself where that differs.
    """

    label: str
    at: Expr
    decision: Decision
    itself: Decision | None
    place: dict[str, Expr | None] = field(default_factory=dict)


def answers_at(potential: str | None, label: str | None,
               numbers: Mapping[str, Expr]) -> list[Answer | Missing]:
    """The equilibrium of that label, or all that the numbers allow.

    Of one that does not exist in this field, why.
    """
    scene = scene_of(potential)
    if label is None and "omega" in numbers and {"pi3_0", "omega3_0", "C1"} & numbers.keys():
        raise ValuesError("omega and a momentum are both given: give omega, or pi3_0 and C1, or k3 and "
                          "pi3_0; or name the --equilibrium")
    (axis, *_) = labels_of(scene, label and [label])
    given = scene.potential is not None and scene.potential.given
    if axis == AXIS or label not in (None, E3.label):
        return [_answer(report_of(potential, axis, spin_of(numbers)), numbers)]
    if label is None and not (given and _level(numbers).keys() & set().union(*MOTION) in MOTION):
        reports, missing = of_each(labels(), lambda name: [report_of(potential, name, spin_of(numbers))])
        known_names(reports, numbers)
        asked = {r.equilibrium.label: r for r, decided in zip(reports, enough(reports, numbers)) if decided}
        answers, without = of_each(list(asked),
                                   lambda name: [_answer(asked[name], its_own(asked[name], numbers))])
        return [*answers, *missing, *without]
    if label is None or given and len({"k3", "omega"} & numbers.keys()) == 1:
        return _all_found(scene, _level(numbers), label)
    if given and not {"k3", "omega"} & numbers.keys():
        raise ValuesError(f"{label} needs k3 or omega: give one of them with l, or both")
    if "omega" in numbers and sign_of_constant(numbers["omega"]) == 0:
        return [_answer(report_of(potential, AT_REST),
                        {name: x for name, x in numbers.items() if name != "omega"})]
    return [_answer(report_of(potential, E3.label), numbers)]


def _all_found(scene: System, numbers: Mapping[str, Expr], label: str | None) -> list[Answer | Missing]:
    """Every relative equilibrium of a label, or of all.

    At a rate at which those of a tilt are not found, E1 and E2, and why.
    """
    try:
        return [_found(branch) for branch in branches_at(scene, numbers)
                if label in (None, branch.label)]
    except ScopeError as error:
        if label is not None or "omega" not in numbers:
            raise
        poles = [pole for s in POLES if (pole := pole_at(scene, s, numbers)) is not None]
        if not poles:
            raise
        return [*map(_found, poles), Missing(E3.label, str(error))]


def _level(numbers: Mapping[str, Expr]) -> dict[str, Expr]:
    """The numbers with pi3_0 = I3 omega3_0 in place of omega3_0."""
    level = dict(numbers)
    if {"omega3_0", "I3"} <= level.keys():
        level["pi3_0"] = level.pop("omega3_0") * level["I3"]
    return level


def _answer(report: Report, numbers: Mapping[str, Expr]) -> Answer:
    decision = report.verdict(numbers)
    return Answer(report.equilibrium.label, report.equilibrium.at, decision,
                  report.itself(numbers) if decision.modulo else None)


def _found(branch: Branch) -> Answer:
    """A relative equilibrium that was found."""
    place = {"k3": branch.k3, "omega": branch.omega, "sigma": branch.sigma, "pi3": branch.pi3}
    at_pole = branch.k3 is not None and branch.label in FAMILIES and FAMILIES[branch.label].pole
    at = branch.k3 if at_pole else symbol("k3")
    return Answer(branch.label, at, branch.decision, branch.itself, place)


def answers_data(answers: Sequence[Answer | Missing]) -> dict[str, Any]:
    """The answers as data for JSON."""
    return {"equilibria": [a.data() if isinstance(a, Missing) else
        {"label": a.label} | {name: number_data(x) for name, x in a.place.items()}
                           | {"decision": decision_data(a.decision)}
        | ({"itself": decision_data(a.itself)} if a.itself else {}) for a in answers]}
