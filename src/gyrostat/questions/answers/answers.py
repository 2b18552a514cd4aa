"""Answers decide: for the equilibrium that is named, or for all that the numbers allow."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from sympy import Expr

from ..._lazy import loaded
from ...algebra.reals.exact import sign_of_constant
from ...equilibria.relative_equilibrium import RelativeEquilibrium
from ...equilibria.search import relative_equilibria
from ...errors import GyrostatError, ScopeError, ValuesError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.families.named_families import E3, EARTH_POINTING, POLES
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System, at_numbers, names_of_scene
from ...notation import symbol
from ...printing.formats.si_units import RATE, unit_of
from ...stability.decision import Decision
from ...stability.report.report import Report, both_verdicts
from ..scene_texts import Asked, scene_of
from .equilibria import (
    AT_REST,
    Missing,
    enough,
    its_own,
    known_names,
    labels_of,
    of_each,
    report_at,
    report_of,
    some,
)
from .equilibrium_labels import named

if TYPE_CHECKING:
    from ...stability.normal_forms.d4_along_family import Window
    from ...stability.normal_forms.normal_form import NormalForm

SPREAD = "no well is found of equilibria that take every value of a tilt or of a rate"
# with these numbers of the motion all are found
MOTION = ({"omega"}, {"k3"}, {"pi3_0", "C1"}, {"k3", "pi3_0"})


@dataclass(frozen=True)
class Answer:
    """One equilibrium with its decisions; if it was found, with its place and its rates.

    damped is None if it is no equilibrium under internal damping; itself is about the point, if the decision
    is modulo a flow; listed says whether it is one of all that were found, so that its place tells
    which; claimed is one that was named, with its numbers.
    """

    label: str
    at: Expr
    decision: Decision
    damped: Decision | None
    itself: Decision | None
    found: RelativeEquilibrium | None = None
    listed: bool = False
    claimed: tuple[Equilibrium, Mapping[str, Expr]] | None = None

    @property
    def placed(self) -> Sequence[tuple[Sequence[str], Sequence[Expr | None]]]:
        """The names of its place with their numbers, not yet written out; none if it was named."""
        return self.found.form.placed if self.found is not None and self.listed else ()

    @property
    def place(self) -> dict[str, Expr | None]:
        """What tells it from the others that were found, by name; nothing if it was named."""
        return self.found.place if self.found is not None and self.listed else {}

    @property
    def at_point(self) -> RelativeEquilibrium | None:
        """What was found, unless the place takes every value: the frequencies change along it."""
        described = self.found.form.described if self.found is not None and self.listed else ()
        return None if any(value is None for _, value in described) else self.found

    @property
    def well(self) -> Any:
        """The well of what was found, or of what was named, in its list; or why there is none."""
        try:
            found = self.at_point or (self.claimed and loaded("equilibria.in_its_list:in_its_list")(
                *self.claimed))
        except GyrostatError as error:
            return str(error)
        return SPREAD if found is None else found.well

    @property
    def rates(self) -> dict[str, Expr]:
        """Frequencies and growth rate by name."""
        if self.at_point is None:
            return {}
        rates = {f"frequency_{n}": x for n, x in enumerate(self.at_point.frequencies, 1)}
        growth = self.at_point.growth_rate
        return rates if growth is None else rates | {"growth_rate": growth}

    def unit_of(self, name: str) -> str:
        """The unit in SI of a place or a rate.

        The notation table has σ as a multiplier; for a body of revolution it is a rate.
        """
        turns = self.found.rates if self.found is not None else {}
        return RATE if name in turns or name.startswith("frequency") else unit_of(name)


def answers_at(asked: Asked, label: str | None, numbers: Mapping[str, Expr]) -> list[Answer | Missing]:
    """The equilibrium that is named, or all that the numbers allow.

    For one that does not exist in this field, the reason is given.
    """
    scene, wanted = scene_of(asked), named(asked, label and [label])
    if wanted == (E3.label,) and asked.eliminate is None and scene.kind is Kind.REVOLUTION:
        return _tilted(asked, numbers)
    if wanted:
        return [_answer(asked, wanted[0], numbers)]
    own = {s.name for s in names_of_scene(scene)}
    if "omega" in numbers and {"pi3_0", "omega3_0", "C1"} & numbers.keys() - own:
        raise ValuesError("omega and a momentum are both given: give omega, or pi3_0 and C1, or k3 and "
                          "pi3_0; or name the equilibrium")
    if scene.kind is Kind.REVOLUTION:
        if not scene.unspecified and (_level(scene, numbers).keys() - own) & set().union(*MOTION) in MOTION:
            return _all_found(scene, _level(scene, numbers), None)
    elif _asks_for_all(scene, numbers):
        return [_found(found) for found in relative_equilibria(scene, numbers)]
    return _of_labels(asked, numbers)


def normal_form_of(asked: Asked, label: str | None, numbers: Mapping[str, Expr],
                   degree: int) -> "NormalForm | Window":
    """The normal form at the equilibrium that is named; of degree 4, D4 in names without a number."""
    wanted = named(asked, label and [label])
    if not wanted:
        raise ValuesError(f"a normal form of degree {degree} is that of one equilibrium, and none is named: "
                          "name it, or give its point")
    report = report_at(asked, wanted[0], numbers)
    if degree == 4 and not numbers.keys() >= set(report.compared):
        return report.window(numbers)
    return report.normal_form(numbers, degree)


def _of_labels(asked: Asked, numbers: Mapping[str, Expr]) -> list[Answer | Missing]:
    """Decide those equilibria of known families for which all names are set."""
    wanted, others = labels_of(asked, None, numbers)
    some(wanted, others)
    if len(wanted) == 1 and not others:
        return [_answer(asked, wanted[0], numbers)]
    reports, missing = of_each(wanted, lambda name: [report_at(asked, name, numbers)])
    known_names(asked, reports, numbers)
    whole = [r for r, decided in zip(reports, enough(reports, numbers)) if decided]
    answers, without = of_each([r.equilibrium.label for r in whole], lambda name: [
        _decided(r, its_own(r, numbers)) for r in whole if r.equilibrium.label == name])
    return [*answers, *missing, *without, *others]


def _tilted(asked: Asked, numbers: Mapping[str, Expr]) -> list[Answer | Missing]:
    """Decide E3 of a body of revolution: the one that is named, or every one of a tilt or a rate."""
    scene = scene_of(asked)
    if not scene.unspecified:
        if len({"k3", "omega"} & numbers.keys()) == 1:
            return _all_found(scene, _level(scene, numbers), E3.label)
        if not {"k3", "omega"} & numbers.keys():
            raise ValuesError("E3 needs k3 or omega: give one of them with l, or both")
    if "omega" in numbers and sign_of_constant(numbers["omega"]) == 0:
        return [_decided(report_of(asked, AT_REST),
                         {name: x for name, x in numbers.items() if name != "omega"})]
    return [_answer(asked, E3.label, numbers)]


def _asks_for_all(scene: System, numbers: Mapping[str, Expr]) -> bool:
    """Whether the numbers ask for every equilibrium.

    They do for a free body if they give M, in a field if they give a rate, a level or a tilt, and for a
    satellite in orbit if every name has one.
    """
    own = numbers.keys() - {s.name for s in names_of_scene(scene)}
    if scene.kind is Kind.FREE:
        return "M" in own
    if scene.kind is Kind.ORBIT:
        return numbers.keys() >= {s.name for s in names_of_scene(scene)}
    return not scene.unspecified and any(
        name in ("omega", "C1") or name[:1] == "k" and name[1:] in ("1", "2", "3", "c") for name in own)


def _all_found(scene: System, numbers: Mapping[str, Expr], label: str | None) -> list[Answer | Missing]:
    """Every relative equilibrium of a label, or of all labels.

    If those with a tilt are not found at this rate, E1 and E2 are given, and the reason.
    """
    try:
        return [_found(found) for found in relative_equilibria(scene, numbers)
                if label in (None, found.label)]
    except ScopeError as error:
        if label is not None or "omega" not in numbers:
            raise
        pole_at = loaded("equilibria.finders.revolution:pole_at")
        poles = [pole for s in POLES if (pole := pole_at(scene, s, numbers)) is not None]
        if not poles:
            raise
        return [*(_found(RelativeEquilibrium(pole)) for pole in poles), Missing(E3.label, str(error))]


def _level(scene: System, numbers: Mapping[str, Expr]) -> dict[str, Expr]:
    """The numbers with pi3_0 = I3 omega3_0 instead of omega3_0."""
    level, moment = dict(numbers), scene.body.moments[2]
    if "omega3_0" in level and {s.name for s in moment.free_symbols} <= level.keys():
        level["pi3_0"] = level.pop("omega3_0") * moment.xreplace({symbol(n): x for n, x in numbers.items()})
    return level


def _answer(asked: Asked, label: str, numbers: Mapping[str, Expr]) -> Answer:
    """Decide the equilibrium of that label."""
    return _decided(report_at(asked, label, numbers), numbers)


def _decided(report: Report, numbers: Mapping[str, Expr]) -> Answer:
    decision, damped = both_verdicts(report, numbers)
    return Answer(report.equilibrium.label, report.equilibrium.at, decision, damped,
                  report.itself(numbers) if decision.modulo else None, _librations(report, numbers),
                  claimed=(report.equilibrium, numbers))


def _librations(report: Report, numbers: Mapping[str, Expr]) -> RelativeEquilibrium | None:
    """An Earth-pointing satellite, every name of which has a number, as one of all its attitudes."""
    eq = report.equilibrium
    if eq.label != EARTH_POINTING.label:
        return None
    known = {symbol(name): x for name, x in numbers.items()}
    if not names_of_scene(eq.system) <= known.keys():
        return None
    form = loaded("equilibria.finders.orbital_form:OrbitalForm")
    return RelativeEquilibrium(form(at_numbers(eq.system, known), eq.point[3:6], eq.point[6:]))


def _found(found: RelativeEquilibrium) -> Answer:
    """The answer for an equilibrium that was found."""
    return Answer(found.form.heading, found.form.at, found.decision, found.damped, found.itself, found,
                  listed=True)
