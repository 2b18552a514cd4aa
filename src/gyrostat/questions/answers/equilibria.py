"""The equilibria that are asked for, by their labels or by a point, and their reports."""
import contextlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TypeVar

from sympy import Expr, ImmutableMatrix, Symbol

from ..._lazy import loaded
from ...algebra.text.grammar import parse
from ...errors import EquilibriumError, GyrostatError, ValuesError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.families.named_families import E3, E3_AT_REST, FAMILIES, PRINCIPAL
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System, at_numbers, names_of_scene
from ...notation import jet, symbol
from ...printing.blocks import Block, Heading, prose
from ...stability.criteria.numbers_asked import unknown
from ...stability.report.analysis import analyze
from ...stability.report.report import Report
from ..given_numbers import spin_of
from ..scene_texts import Asked, direction_of, one_for_each, pointing_of, scene_of
from .equilibrium_labels import CLAIMED, by_point, labels, labels_in_words, likely, named

AT_REST = E3_AT_REST.label
MOST = 4                                               # names that a message lists
Names = Mapping[str, Expr | None]                      # numbers, None for a name that an axis gives
Found = TypeVar("Found")


def labels_of(asked: Asked, given: Sequence[str] | None,
              numbers: Names) -> tuple[Sequence[str], list["Missing"]]:
    """The equilibria that are named; if none is, those that a scene is known to have.

    For a body of revolution in U(k3) these are the families, for a free body with its rotor along axis 3 the
    rotation about it. For any other scene they are the families that are equilibria there; that others have
    to be named is said.
    """
    if wanted := named(asked, given):
        return wanted, []
    scene = scene_of(asked)
    if scene.kind is Kind.REVOLUTION:
        return labels(), []
    principal = not isinstance(scene.body.inertia, ImmutableMatrix)
    if scene.kind is Kind.FREE and principal and not any(scene.body.gyrostatic_momentum[:2]):
        return (PRINCIPAL[2].label,), []
    held, decide, why = [], "", ""
    if scene.kind is Kind.ORBIT:
        decide = "; decide finds all if every name has a number" + _without(scene, numbers)
    elif scene.kind is Kind.FREE:
        decide = "; decide finds all if every name and M have a number"
    elif not scene.unspecified:
        decide = ("; decide finds those of a rate omega, a level C1 or a direction k1, k2, k3 if every name "
                  "has a number")
    for family in likely(scene):
        try:
            held.append(report_at(asked, family.label, numbers).equilibrium.label)
        except EquilibriumError as error:
            why = why or str(error)
    if scene.kind is Kind.ORBIT and not held and loaded(
            "mechanics.families.circular_orbit:by_gradient_alone")(scene):
        speed = "solve for the speed of a wheel, or " if asked.rotors else ""
        return held, [Missing("Equilibria", f"{why}; {speed}decide at numbers")]
    others = "Other equilibria" if held else "Equilibria"
    return held, [Missing(others, f"{others} of this scene are not looked for: give {by_point(scene)}, in "
                          f"numbers or expressions{decide}")]


def _without(scene: System, numbers: Names) -> str:
    """Name those without a number, if others have one and they are few."""
    left = sorted({s.name for s in names_of_scene(scene)} - numbers.keys())
    if not numbers or not left or len(left) > MOST:
        return ""
    return f", and {', '.join(left)} {'has' if len(left) == 1 else 'have'} none"


def some(labels: Sequence[str], missing: Sequence["Missing"]) -> None:
    """Refuse a scene of which no equilibrium is known."""
    if not labels:
        raise ValuesError(missing[0].why)


@lru_cache(maxsize=256)
def report_of(asked: Asked, label: str, spin: str = "pi3_0") -> Report:
    """The report of one equilibrium, whatever the numbers, derived once."""
    return analyze(_equilibrium(asked, label, spin, {}))


def report_at(asked: Asked, label: str, numbers: Names) -> Report:
    """The report of one equilibrium.

    If the point is not an equilibrium for all numbers, the report is made at those that are given.
    """
    spin = asked.spin or spin_of(numbers)
    try:
        return report_of(asked, label, spin)
    except EquilibriumError:
        own = names_of_scene(scene_of(asked)).union(*(x.free_symbols for x in _point(asked)))
        known = {symbol(name): x for name, x in numbers.items() if x is not None and symbol(name) in own}
        if not known:
            raise
        return analyze(_equilibrium(asked, label, spin, known))


def _equilibrium(asked: Asked, label: str, spin: str, known: Mapping[Symbol, Expr]) -> Equilibrium:
    """The equilibrium of that label, with numbers that hold on it."""
    scene, held = scene_of(asked), tuple(known.items())
    if label == CLAIMED:
        return Equilibrium(CLAIMED, scene, _point(asked), held)
    eliminate = asked.eliminate if label == E3.label else None
    here = at_numbers(scene, known) if known else scene
    eq = FAMILIES[label].of(here, spin, eliminate, direction_of(asked), pointing_of(asked.pointing))
    return replace(eq, system=scene, relations=(*eq.relations, *held)) if known else eq


def _point(asked: Asked) -> tuple[Expr, ...]:
    """The point that is given; () if none is."""
    if asked.point is None:
        return ()
    return tuple(map(parse, one_for_each("the point", asked.point, scene_of(asked))))


@dataclass(frozen=True)
class Missing:
    """An equilibrium of which nothing can be said, and why."""

    label: str
    why: str

    def blocks(self) -> list[Block]:
        """A heading and a sentence."""
        return [Heading(self.label),
                prose(f"{'' if self.why.startswith(self.label) else 'Not answered: '}{self.why}")]

    def data(self) -> dict[str, str]:
        """For JSON."""
        return {"label": self.label, "error": self.why}


def of_each(labels: Sequence[str], make: Callable[[str], list[Found]]) -> tuple[list[Found], list[Missing]]:
    """What there is of each equilibrium, and why there is nothing of the others.

    If there is nothing of any, the reasons are raised.
    """
    found, missing, errors = list[Found](), list[Missing](), list[GyrostatError]()
    for label in labels:
        try:
            found += make(label)
        except GyrostatError as error:
            missing.append(Missing(label, str(error)))
            errors.append(error)
    if found or not errors:
        return found, missing
    if len(reasons := list(dict.fromkeys(m.why for m in missing))) == 1:
        raise errors[0]
    raise ValuesError("; ".join(reasons))


def reports_of(asked: Asked, labels: Sequence[str], numbers: Names) -> tuple[list[Report], list[Missing]]:
    """The reports of several equilibria, as the numbers ask for them, and why there is none of the others."""
    return of_each(labels, lambda label: _tilted(asked, numbers) if label == E3.label else [
        report_at(asked, label, numbers)])


def report_for(what: str, asked: Asked, given: str | None, numbers: Names) -> Report:
    """The report of the one equilibrium that a chart or a picture is of."""
    scene = scene_of(asked)
    wanted, missing = labels_of(asked, given and [given], numbers)
    if not named(asked, given and [given]) and (scene.kind not in (Kind.FREE, Kind.ORBIT) or len(wanted) > 1):
        raise ValuesError(f"no equilibrium is named, and a {what} shows one: name "
                          f"{labels_in_words(scene)}, or give {by_point(scene)}")
    some(wanted, missing)
    (report, *_), _ = reports_of(asked, wanted, numbers)
    eq = report.equilibrium
    if "l" in eq.eliminated and "l" in numbers and "k3" not in numbers:
        raise ValuesError("E3 may have several tilts k3 at one l and omega, and a "
                          f"{what} shows one: give k3 instead of l = {dict(eq.relations)[symbol('l')]}")
    return report


def _tilted(asked: Asked, numbers: Names) -> list[Report]:
    """The reports of E3; if l is set, its relation gives the tilt, or a parameter of U that is not set.

    Without numbers the tilt at rest of a given U is added, if there is one.
    """
    scene = scene_of(asked)
    if scene.kind is not Kind.REVOLUTION:
        raise ValuesError("E3 is a family of bodies of revolution in U(k3), and this scene is none of them: "
                          f"give {by_point(scene)}")
    if scene.potential and scene.potential.given and asked.eliminate is None:
        free = [name for name in ("k3", *map(str, scene.potential.parameters)) if name not in numbers]
        for name in free if "l" in numbers else ():
            with contextlib.suppress(EquilibriumError):
                return [analyze(E3.of(scene, eliminate=name))]
        with contextlib.suppress(EquilibriumError):
            if not numbers and report_of(asked, AT_REST).equilibrium.eliminated in (("k3",), ()):
                return [report_of(asked, E3.label), report_of(asked, AT_REST)]
    return [report_at(asked, E3.label, numbers)]


def known_names(asked: Asked, reports: Sequence[Report], numbers: Names) -> None:
    """Refuse a name that neither the scene nor one of the reports has."""
    scene = scene_of(asked)
    known = {name for report in reports for name in report.parameters} | set(map(str, names_of_scene(scene)))
    for name in numbers:
        if name not in known and not (scene.unspecified and jet(name)):
            raise ValuesError(unknown(name, sorted(known), "the scene"))


def enough(reports: Sequence[Report], numbers: Mapping[str, Expr]) -> list[bool]:
    """Whether all names that a verdict needs are set, for each report; for one at least they must be."""
    missing = [[name for name in report.compared if name not in numbers] for report in reports]
    if all(missing):
        wanted = "; ".join(f"{r.equilibrium.label}: {', '.join(names)}" for r, names in zip(reports, missing))
        raise ValuesError(f"these numbers are not enough for a verdict: set also, for {wanted}" + (
            " (or omega3_0 in place of pi3_0)" if "pi3_0" in wanted else ""))
    return [not names for names in missing]


def its_own(report: Report, numbers: Mapping[str, Expr]) -> dict[str, Expr]:
    """Those of the numbers that the report takes; for an unspecified U every derivative, too."""
    jets = report.equilibrium.system.unspecified
    return {n: x for n, x in numbers.items() if n in report.parameters or (jets and jet(n))}
