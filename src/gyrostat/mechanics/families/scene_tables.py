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
from ...algebra.text.quantities import not_mixed
from ...algebra.text.tensors import rows_of
from ...errors import PublishedError, brief
from ...notation import symbol
from ..scenes.body import Gyrostat
from ..scenes.coupled import CoupledPotential
from ..scenes.entered_potential import axial_potential, general_potential
from ..scenes.potential import Potential
from ..scenes.system import System, assemble
from .family import Family
from .named_families import called, in_words, known_families
from .scene_entries import READ, texts_of

if TYPE_CHECKING:
    from ..scenes.rotors import Rotor

LISTS = ("inertia", "gyrostatic_momentum", "point", "state", "release", "integrals")    # of texts or numbers
KEYS = {*LISTS, "products", "rotors", "lumped", "orbit", "pointing", "direction", "potential", "values",
        "equilibrium", "spin", "eliminate", "angles", "vertical", "given", "parameters"}
HELD = "held"                                          # the momentum that holds a satellite Earth-pointing
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
        if name in READ:
            return READ[name](value)
        if name == "lumped":
            if not isinstance(value, bool):
                raise PublishedError(f"lumped = {brief(value)}: write true or false")
            return value
        if name in ("inertia", "gyrostatic_momentum") and isinstance(value, str):
            value = rows_of(value)
        if name == "inertia" and isinstance(value, list) and any(isinstance(row, list) for row in value):
            return [texts_of(name, row) for row in value]
        if name in LISTS:
            return texts_of(name, value)
        if not isinstance(value, str):
            raise PublishedError(f"{name} = {brief(value)}: write a text, in quotation marks")
        return value

    @cached_property
    def body(self) -> Gyrostat:
        """The gyrostat; without entries it is a rigid body with three moments."""
        inertia: list[Any] = self.table.get("inertia", ["I1", "I2", "I3"])
        momentum: list[str] = self.table.get("gyrostatic_momentum", ["0", "0", "0"])
        rotors = self.table.get("rotors", [])
        not_mixed(self.quantities)
        products = self.table.get("products", "negative")
        if momentum == [HELD]:
            if "orbit" not in self.table:
                raise PublishedError(f"gyrostatic_momentum = {HELD} is that of a satellite, and this body is "
                                     "in no orbit: give an orbit, or three numbers")
            axes = self.table.get("pointing", [1, 2, 3])
            free = [symbol("l") if abs(axes[1]) == n else 0 for n in (1, 2, 3)]
            hold = loaded("mechanics.families.holding_rotor:earth_pointing_gyrostat")
            return hold(Gyrostat(inertia, free, products), self.potential, *axes)
        if not rotors:
            return Gyrostat(inertia, momentum, products)
        make = loaded("mechanics.scenes.rotors:gyrostat_with_rotors")
        return make(inertia, self.rotors, lumped=self.table["lumped"], products=products)

    @property
    def quantities(self) -> list[tuple[str, Any]]:
        """The numbers of body, orbit and values, with their names; all have a unit, or none has."""
        table = self.table
        flat = [x for row in table.get("inertia", ()) for x in (row if isinstance(row, list) else [row])]
        return [*(("inertia", x) for x in flat),
                *(("gyrostatic_momentum", x) for x in table.get("gyrostatic_momentum", ())),
                *((name, x) for rotor in table.get("rotors", ()) for name, x in rotor.items()),
                *((f"orbit {name}", x) for name, x in table.get("orbit", {}).items()),
                *table.get("values", {}).items()]

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
            return make(**self.table["orbit"], potential=other)
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
