"""What the options name: exact numbers, a scene, its equilibria and their reports."""
import contextlib
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeVar

from sympy import Expr

from ..algebra.grammar import parse
from ..algebra.inputs import is_name
from ..algebra.numbers import exact_number
from ..errors import EquilibriumError, GyrostatError, ValuesError, brief
from ..mechanics.body import Gyrostat, symmetric_gyrostat
from ..mechanics.families import E3, E3_AT_REST, FAMILIES, PRINCIPAL, in_a_field
from ..mechanics.potentials import axial_potential, general_potential
from ..mechanics.system import System, assemble
from ..notation import jet, symbol
from ..printing.blocks import Block, Heading, prose
from ..stability.analysis import analyze
from ..stability.report import Report
from ..stability.values import names_in, unknown

ROTOR = ("l1", "l2", "l3")
LONGEST = 10**7                                        # values of an axis, rows of a table
AXIS = PRINCIPAL[2].label
AT_REST = E3_AT_REST.label
Found = TypeVar("Found")


def numbers_of(settings: Sequence[str]) -> dict[str, Expr]:
    """The numbers of --set NAME=VALUE."""
    numbers: dict[str, Expr] = {}
    for setting in settings:
        name, equals, value = setting.partition("=")
        name = name.strip()
        if not equals or not is_name(name):
            raise ValuesError(f"--set {brief(setting)[1:-1]} is not NAME=VALUE: write, for example, --set "
                              "I1=1.6")
        if name in numbers:
            raise ValuesError(f"--set gives {name} twice: give it once")
        numbers[name] = exact_number(value, name)
    one_spin(numbers)
    return numbers


def one_spin(numbers: Mapping[str, Expr]) -> None:
    """Refuse both names of the spin."""
    if {"pi3_0", "omega3_0"} <= numbers.keys():
        raise ValuesError("both pi3_0 and omega3_0 = pi3_0/I3 are given: give one of them")


@lru_cache(maxsize=64)
def scene_of(potential: str | None) -> System:
    """The scene of --potential EXPR."""
    if potential is not None and potential.strip() == "none":
        return assemble(Gyrostat(gyrostatic_momentum=(0, 0, symbol("l"))))
    return assemble(symmetric_gyrostat(), axial_potential(None if potential is None else parse(potential)))


def body_of(potential: str | None, names: Collection[str]) -> System:
    """The scene of a body by the names that have numbers: I1, I3, or I1, I2, I3; l, or l1, l2, l3."""
    if potential is None:
        raise ValuesError('--potential is missing, and an unspecified U moves nothing: write --potential '
                          '"m0*k3", or none for a free body')
    field = None if potential.strip() == "none" else parse(potential)
    aside = field is not None and not field.free_symbols.isdisjoint(map(symbol, ("k1", "k2")))
    three, rotor = aside or field is None or "I2" in names, [name for name in ROTOR if name in names]
    if rotor and "l" in names:
        raise ValuesError(f"both l and {rotor[0]} are given, l is the rotor along axis 3: give l, or "
                          f"{', '.join(ROTOR)}")
    body = Gyrostat([symbol(name) for name in ("I1", "I2" if three else "I1", "I3")],
                    [symbol(name) for name in ROTOR] if rotor else [0, 0, symbol("l")])
    scene = assemble(body, None if field is None else general_potential(field) if aside
                     else axial_potential(field))
    parameters = scene.potential.parameters if scene.potential else ()
    if missing := [name for name in names_in([*body.inertia, *body.gyrostatic_momentum, *parameters])
                   if name not in names]:
        moments, momentum = (f"({', '.join(map(str, entries))})"
                             for entries in (body.inertia, body.gyrostatic_momentum))
        raise ValuesError(f"--set gives no number for {', '.join(missing)}, and the body has the moments "
                          f"{moments}, the rotor {momentum}: "
                          f"add --set {missing[0]}=…")
    return scene


def axis_of(option: str, text: str, form: str = "NAME=LOW:HIGH:COUNT",
            count: int = 0) -> tuple[str, Expr, Expr, int]:
    """Name, ends and number of values of an axis.

    Its COUNT may be left out where the form has it in brackets.
    """
    name, equals, values = text.partition("=")
    name, ends = name.strip(), [value.strip() for value in values.split(":")]
    if not equals or not is_name(name) or len(ends) not in {form.count(":") + 1, 2 if "[" in form else 0}:
        raise ValuesError(f"{option} {brief(text)} is not {form}: write, for example, {option} "
                          f"l=-2:2{':400' if 'COUNT' in form else ''}")
    if ends[2:] and (not ends[2].isdecimal() or len(ends[2]) > 20 or not 2 <= int(ends[2]) <= LONGEST):
        raise ValuesError(f"{option} has the COUNT {brief(ends[2])[1:-1]}: give a whole number, 2 to "
                          f"{LONGEST}; one value goes to --set")
    low, high = (exact_number(end, name) for end in ends[:2])
    return name, low, high, int(ends[2]) if ends[2:] else count


def labels_of(scene: System, given: Sequence[str] | None) -> Sequence[str]:
    """The equilibria of --equilibrium, in the order given; all of them where it is left out."""
    if scene.potential is None and given:
        raise ValuesError(f"--equilibrium {given[0]} needs a field, --potential none has none: leave out "
                          "one of the two")
    if scene.potential is None:
        return (AXIS,)
    return tuple(dict.fromkeys(given)) if given else labels()


def labels() -> tuple[str, ...]:
    """The labels that --equilibrium takes."""
    return tuple(family.label for family in in_a_field())


def spin_of(numbers: Mapping[str, Expr]) -> str:
    """The name of the spin of E1 and E2."""
    return "omega3_0" if "omega3_0" in numbers else "pi3_0"


@lru_cache(maxsize=256)
def report_of(potential: str | None, label: str, spin: str = "pi3_0") -> Report:
    """The report of one equilibrium, derived once."""
    return analyze(FAMILIES[label].of(scene_of(potential), spin))


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

    The reasons raised where there is nothing of any.
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


def reports_of(potential: str | None, labels: Sequence[str],
               numbers: Mapping[str, Expr]) -> tuple[list[Report], list[Missing]]:
    """The reports of several equilibria, as the numbers ask for them, and why there is none of the others."""
    return of_each(labels, lambda label: _tilted(potential, numbers) if label == E3.label else [
        report_of(potential, label, spin_of(numbers))])


def report_for(what: str, potential: str | None, equilibrium: str | None,
               names: Mapping[str, Expr]) -> Report:
    """The report of the one equilibrium that a chart or a picture is of."""
    scene = scene_of(potential)
    if scene.potential is not None and equilibrium is None:
        raise ValuesError(f"--equilibrium is missing, a {what} is of one: name "
                          f"{', '.join(labels()[:-1])} or {labels()[-1]}")
    (report, *_), _ = reports_of(potential, labels_of(scene, equilibrium and [equilibrium]), names)
    return report


def _tilted(potential: str | None, numbers: Mapping[str, Expr]) -> list[Report]:
    """E3; its tilt eliminated where l is set and k3 is not.

    Without numbers the tilt at rest of a given U too, if there is one.
    """
    scene = scene_of(potential)
    if scene.potential and scene.potential.given:
        with contextlib.suppress(EquilibriumError):
            if "l" in numbers and "k3" not in numbers:
                return [analyze(E3.of(scene, eliminate="k3"))]
            if not numbers and report_of(potential, AT_REST).equilibrium.eliminated in ("k3", None):
                return [report_of(potential, E3.label), report_of(potential, AT_REST)]
    return [report_of(potential, E3.label)]


def known_names(reports: Sequence[Report], numbers: Mapping[str, Expr]) -> None:
    """Refuse a name that none of the reports has."""
    known = {name for report in reports for name in report.parameters}
    free_jet = any(r.equilibrium.system.potential and not r.equilibrium.system.potential.given
                   for r in reports)
    for name in numbers:
        if name not in known and not (free_jet and jet(name)):
            raise ValuesError(unknown(name, sorted(known), "the scene"))


def enough(reports: Sequence[Report], numbers: Mapping[str, Expr]) -> list[bool]:
    """Whether all names that a verdict needs are set, for each report; for one at least they must be."""
    missing = [[name for name in report.required if name not in numbers] for report in reports]
    if all(missing):
        wanted = "; ".join(f"{r.equilibrium.label}: {', '.join(names)}" for r, names in zip(reports, missing))
        raise ValuesError(f"these numbers are not enough for a verdict, set also, for {wanted}" + (
            " (or omega3_0 in place of pi3_0)" if "pi3_0" in wanted else ""))
    return [not names for names in missing]


def its_own(report: Report, numbers: Mapping[str, Expr]) -> dict[str, Expr]:
    """Those of the numbers that the report takes; of an unspecified U, every derivative."""
    potential = report.equilibrium.system.potential
    jets = potential is not None and not potential.given
    return {n: x for n, x in numbers.items() if n in report.parameters or (jets and jet(n))}
