"""Reads scenes from tables of texts, as a [scene.NAME] of a TOML file: body, field, equilibrium, numbers."""
from collections.abc import Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..._cached import cached_property
from ..._lazy import loaded
from ...algebra.text.grammar import parse
from ...algebra.text.inputs import Written, is_name
from ...algebra.text.quantities import not_mixed
from ...errors import PublishedError, brief
from ...notation import symbol
from ..equilibrium.unit_vectors import STEREOGRAPHIC
from ..scenes.body import Gyrostat
from ..scenes.coupled import CoupledPotential
from ..scenes.entered_potential import axial_potential, general_potential
from ..scenes.potential import Potential
from ..scenes.system import System, assemble
from .family import Family
from .named_families import called, in_words, known_families

if TYPE_CHECKING:
    from ..scenes.rotors import Rotor

LISTS = ("inertia", "gyrostatic_momentum", "point", "state", "release", "integrals")    # of texts or numbers
# of each rotor, texts or numbers but for the axis
ROTOR = ("axis", "axial", "transverse", "rate", "momentum")
ORBIT = ("rate", "mu", "radius")                      # of an orbit, texts or numbers
KEYS = {*LISTS, "rotors", "lumped", "orbit", "pointing", "direction", "potential", "values", "equilibrium",
        "spin", "eliminate", "angles", "vertical", "given", "parameters"}
NONE, AXIAL, GENERAL = "none", "U(k3)", "U(k1,k2,k3)"   # potentials that are no expressions


@dataclass(frozen=True)
class SceneTable:
    """One [scene.NAME] table: a body, a field, and what else is said of them.

    Parameters
    ----------
    table : mapping
        as in the file; numbers in it are kept as the texts that they are written as
    """

    table: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "table", {name: self.entry(name, value)
                                           for name, value in self.table.items()})
        if {"point", "equilibrium"} <= self.table.keys():
            raise PublishedError("point and equilibrium are both given: leave out one of the two")
        if {"rotors", "gyrostatic_momentum"} <= self.table.keys():
            raise PublishedError("rotors and gyrostatic_momentum are both given: leave out one of the two")
        if ("rotors" in self.table) != ("lumped" in self.table):
            raise PublishedError("rotors and lumped must both be given: write lumped = true if the "
                                 "inertia includes that of the rotors, lumped = false if it does not")

    def entry(self, name: str, value: Any) -> Any:
        """Return what is kept of an entry of the file, its numbers as texts."""
        if name not in KEYS:
            near = get_close_matches(str(name), sorted(KEYS), 1)
            meant = f"did you mean {near[0]}? " if near else ""
            raise PublishedError(f"a scene has no entry {brief(str(name))[1:-1]}: {meant}its entries are "
                                 f"{', '.join(sorted(KEYS))}")
        if name in _READ:
            return _READ[name](value)
        if name == "lumped":
            if not isinstance(value, bool):
                raise PublishedError(f"lumped = {brief(value)}: write true or false")
            return value
        if name == "inertia" and isinstance(value, list) and any(isinstance(row, list) for row in value):
            return [_texts(name, row) for row in value]
        if name in LISTS:
            return _texts(name, value)
        if not isinstance(value, str):
            raise PublishedError(f"{name} = {brief(value)}: write a text, in quotation marks")
        return value

    @cached_property
    def body(self) -> Gyrostat:
        """The gyrostat; without entries it is a rigid body with three moments."""
        inertia: list[Any] = self.table.get("inertia", ["I1", "I2", "I3"])
        momentum: list[str] = self.table.get("gyrostatic_momentum", ["0", "0", "0"])
        rotors = self.table.get("rotors", [])
        flat = [x for row in inertia for x in (row if isinstance(row, list) else [row])]
        not_mixed([*(("inertia", x) for x in flat), *(("gyrostatic_momentum", x) for x in momentum),
                   *((name, x) for rotor in rotors for name, x in rotor.items()),
                   *((f"orbit {name}", x) for name, x in self.table.get("orbit", {}).items()),
                   *self.table.get("values", {}).items()])
        if not rotors:
            return Gyrostat(inertia, momentum)
        make = loaded("mechanics.scenes.rotors:gyrostat_with_rotors")
        return make(inertia, self.rotors, lumped=self.table["lumped"])

    @cached_property
    def rotors(self) -> "tuple[Rotor, ...]":
        """The rotors that the table has."""
        rotors = self.table.get("rotors", [])
        return tuple(loaded("mechanics.scenes.rotors:Rotor")(**rotor) for rotor in rotors)

    @cached_property
    def potential(self) -> Potential | CoupledPotential | None:
        """The potential: none, U(k3), U(k1, k2, k3), or an expression in k3, or in k1, k2, k3.

        In orbit it is that of the gravity gradient, with an expression in n1, …, r3 beside it.
        """
        text = self.table.get("potential", NONE)
        bare = "".join(text.split())
        if "orbit" in self.table:
            if bare in (AXIAL, GENERAL):
                raise PublishedError(f"potential = {bare} is unspecified, and in orbit the gravity gradient "
                                     "acts: leave it out, or write an expression in n1, n2, n3, r1, r2, r3")
            other = 0 if bare == NONE else parse(text)
            make = loaded("mechanics.families.circular_orbit:circular_orbit")
            return make(**self.table["orbit"], potential=other, rotors=self.rotors)
        if bare == NONE:
            return None
        if bare in (AXIAL, GENERAL):
            return axial_potential() if bare == AXIAL else general_potential()
        expression = parse(text)
        if expression.free_symbols & {symbol("k1"), symbol("k2")}:
            return general_potential(expression)
        return axial_potential(expression)

    @cached_property
    def family(self) -> Family | None:
        """The family of equilibria that the table asks for: E1 or upright, axis 1 and so on."""
        asked, families = self.table.get("equilibrium"), known_families()
        if asked is not None and called(asked, families) is None:
            raise PublishedError(f"equilibrium = {brief(asked)}: give {in_words(families)}")
        return None if asked is None else called(asked, families)

    @cached_property
    def system(self) -> System:
        """The Lie-Poisson system."""
        return assemble(self.body, self.potential, self.table.get("integrals", ()))


def scene_tables(data: Mapping[str, Any], path: Path | Traversable) -> dict[str, dict[str, Any]]:
    """Return the [scene.NAME] tables of a file."""
    tables = data.get("scene", {})
    if not isinstance(tables, dict) or not all(isinstance(table, dict) for table in tables.values()):
        raise PublishedError(f"{path}: scene is not made of [scene.NAME] tables: write [scene.top] and below "
                             'it potential = "m0*k3"')
    return tables


def _parameters(value: Any) -> list[str]:
    """Return the names in a list."""
    if not isinstance(value, list) or not all(isinstance(text, str) for text in value):
        raise PublishedError(f"parameters = {brief(value)}: write a list of texts, in quotation marks")
    for text in value:
        if not is_name(text):
            raise PublishedError(f"the parameter {brief(text)} is not a name: letters, digits and _ make one")
    return value


def _texts(name: str, value: Any) -> list[str]:
    """Return a list of numbers or texts as texts."""
    if isinstance(value, list) and None not in (texts := [_text(x) for x in value]):
        return [text for text in texts if text is not None]
    raise PublishedError(f'{name} = {brief(value)}: write a list of numbers, or of texts in quotation '
                         f'marks, {name} = [1, 1, "1/3"]')


def _rotors(value: Any) -> list[dict[str, Any]]:
    """Return for each rotor its texts by their names."""
    if not isinstance(value, list) or not value or not all(isinstance(rotor, dict) for rotor in value):
        raise PublishedError(f"rotors = {brief(value)}: write a list of tables, rotors = [{{ "
                             'axis = [0, 1, 0], axial = "0.05 kg m^2", rate = "3000 rpm" }]')
    for rotor in value:
        if unknown := [name for name in rotor if name not in ROTOR]:
            raise PublishedError(f"a rotor has no entry {unknown[0]}: its entries are {', '.join(ROTOR)}")
        if missing := [name for name in ("axis", "axial") if name not in rotor]:
            raise PublishedError(f"a rotor has no {missing[0]}: write {missing[0]} = "
                                 + ("[0, 1, 0]" if missing[0] == "axis" else '"0.05 kg m^2"'))
    return [{name: _texts(name, x) if name == "axis" else _texts(name, [x])[0] for name, x in rotor.items()}
            for rotor in value]


def _orbit(value: Any) -> dict[str, str]:
    """Return the rate, or mu and radius, of a table or of an option's text: 0.0011 rad/s, mu=…, radius=…."""
    if isinstance(value, str):
        parts = [part.partition("=") for part in value.split(",")]
        once = len(parts) == len({name.strip() for name, *_ in parts})
        named = once and all(equals for _, equals, _ in parts)
        value = {name.strip(): text.strip() for name, _, text in parts} if named else {"rate": value.strip()}
    elif (text := _text(value)) is not None:
        value = {"rate": text}
    texts = {name: _text(x) for name, x in value.items()} if isinstance(value, dict) else {"": None}
    if not texts or not texts.keys() <= set(ORBIT) or not all(texts.values()):
        raise PublishedError(f'orbit = {brief(value)}: give its rate, orbit = "omega0" or "0.0011 rad/s", or '
                             'mu and radius, that of the Earth and the height, orbit = { mu = '
                             '"398600.4418 km^3/s^2", radius = "6778 km" }')
    return {name: text for name, text in texts.items() if text is not None}


def _pointing(value: Any) -> list[int]:
    """Return the body axes of roll, pitch and yaw."""
    axes = value.split(",") if isinstance(value, str) else value if isinstance(value, list) else []
    texts = [str(_text(x)).strip() for x in axes]
    if sorted(text.removeprefix("-") for text in texts) != ["1", "2", "3"]:
        raise PublishedError(f"pointing = {brief(value)}: give the body axes along roll, pitch and yaw, 1, 2 "
                             "and 3 in some order, negative for one that points the other way, [1, 2, 3]")
    return [int(text) for text in texts]


def _direction(value: Any) -> list[str]:
    """Return three expressions, or the word for all directions by two coordinates."""
    texts = [text.strip() for text in (value.split(",") if isinstance(value, str) else
                                       _texts("direction", value))]
    if len(texts) != 3 and texts != [STEREOGRAPHIC]:
        raise PublishedError(f'direction = {brief(value)}: give three expressions that make a unit vector, '
                             f'["sin(a)", 0, "cos(a)"], or "{STEREOGRAPHIC}"')
    return texts


def _values(value: Any) -> dict[str, str]:
    """Return numbers by their names."""
    if not isinstance(value, dict):
        raise PublishedError(f'values = {brief(value)}: write a table, values = {{ I1 = 1.6, l = "1/3" }}')
    texts = {name: _text(number) for name, number in value.items()}
    for name, text in texts.items():
        if not isinstance(name, str) or not is_name(name):
            raise PublishedError(f"values has {brief(name)}, which is not a name: letters, digits and _ make "
                                 "one")
        if text is None:
            raise PublishedError(f'values.{name} = {brief(value[name])} is not a number: write {name} = 1.6, '
                                 f'or {name} = "sqrt(3)/2"')
    return {name: text for name, text in texts.items() if text is not None}


def _text(value: Any) -> str | None:
    """Return a number or text as it is written, None for anything else."""
    if isinstance(value, Written):
        return value.text
    if isinstance(value, int) and not isinstance(value, bool):
        return str(value)
    return value if isinstance(value, str) else None


_READ = {"values": _values, "rotors": _rotors, "orbit": _orbit, "pointing": _pointing,
         "direction": _direction, "parameters": _parameters}
