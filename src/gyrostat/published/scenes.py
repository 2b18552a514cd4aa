"""Builds the scene of a published formula from its table: body, field, equilibrium or Euler angles."""
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sympy import Expr, Symbol

from .._cached import cached_property
from ..algebra.text.grammar import parse
from ..algebra.text.inputs import is_name
from ..errors import PublishedError, brief
from ..mechanics.equilibrium.claimed_point import equilibrium
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..mechanics.families.named_families import E3, PERMANENT
from ..mechanics.families.scene_tables import NONE, SceneTable
from ..mechanics.scenes.body import Gyrostat
from ..mechanics.scenes.coupled import CoupledPotential, coupled_potential
from ..mechanics.scenes.potential import Potential
from ..mechanics.scenes.system import System
from ..mechanics.scenes.vehicles import underwater_vehicle
from ..notation import jet, symbol

BODY = ("inertia", "products", "gyrostatic_momentum", "rotors", "lumped")
VEHICLE = ("mass", "coupling", "weight")
DERIVED = "derived_"                                   # before a name that a paper has for something else


@dataclass(frozen=True)
class Scene(SceneTable):
    """A [scene.NAME] table: a body, a field, and perhaps an equilibrium or Euler angles.

    Only formulas have a field in two directions or a vehicle. A state and values serve the command line; no
    formula is about them.

    Parameters
    ----------
    table : mapping
        as in the file
    """

    def entry(self, name: str, value: Any) -> Any:
        """Return what is kept of an entry of the file; directions and vehicle are for formulas alone."""
        if name == "directions":
            return _directions(value)
        return _vehicle(value) if name == "vehicle" else super().entry(name, value)

    @cached_property
    def hull(self) -> Gyrostat:
        """The body of the table; that of a vehicle has J, which is not the tensor of its momenta."""
        return SceneTable({name: self.table[name] for name in BODY if name in self.table}).body

    @cached_property
    def parameters(self) -> frozenset[Symbol]:
        """The names of the body and the field."""
        potential = self.system.potential if "orbit" in self.table else self.potential
        return self.body.symbols | self.hull.symbols | set(potential.parameters if potential else ())

    @cached_property
    def letters(self) -> set[str]:
        """The names of the paper: those of body and field, those the file declares, and the time."""
        return {s.name for s in self.parameters} | set(self.table.get("parameters", ())) | {"t"}

    def derived(self, name: str) -> str:
        """Return the name of a derived quantity, with a prefix if the paper uses it for something else."""
        return DERIVED + name if name in self.letters else name

    @cached_property
    def body(self) -> Gyrostat:
        """The gyrostat."""
        return self.system.body if "vehicle" in self.table else super().body

    @cached_property
    def potential(self) -> Potential | CoupledPotential | None:
        """The potential of the field; for two directions, an expression in their components."""
        if "vehicle" in self.table:
            return self.system.potential
        if "directions" in self.table:
            return coupled_potential(parse(self.table.get("potential", "0")), self.table["directions"])
        return super().potential

    @cached_property
    def system(self) -> System:
        """The Lie-Poisson system."""
        if "vehicle" not in self.table:
            return super().system
        if self.table.get("potential", NONE) != NONE:
            raise PublishedError("a vehicle has its weight, and no other potential: leave potential out")
        given = {name: _parsed(value) for name, value in self.table["vehicle"].items()}
        return underwater_vehicle(self.hull.tensor, **given,
                                  gyrostatic_momentum=self.hull.gyrostatic_momentum)

    @cached_property
    def equilibrium(self) -> Equilibrium | None:
        """The equilibrium: of the family that the table asks for, or at its point; None without either."""
        if self.claimed:
            return equilibrium(self.system, self.claimed)
        if self.family is PERMANENT:
            raise PublishedError('equilibrium = "permanent rotation": a formula is about one direction: '
                                 'write the point, ["w*I1*3/5", "0", "w*I3*4/5", "3/5", "0", '
                                 '"4/5"], and in U the slope that it has there')
        spin, eliminated = self.table.get("spin", "pi3_0"), self.table.get("eliminate")
        return None if self.family is None else self.family.of(
            self.system, spin, eliminated, pointing=self.table.get("pointing"))

    @cached_property
    def claimed(self) -> tuple[Expr, ...]:
        """The point that its formulas are about; () without one."""
        return tuple(map(parse, self.table.get("point", ())))

    @property
    def point(self) -> tuple[Expr, ...]:
        """The coordinates of the equilibrium; E3 is taken at any k, not only at k2 = 0."""
        eq = self.equilibrium
        if eq is None:
            return ()
        if eq.label != E3.label:
            return eq.point
        k = [symbol(f"k{i}") for i in (1, 2, 3)]
        return (*(moment * symbol("omega") * x for moment, x in zip(self.body.moments, k)), *k)

    def finish(self, expression: Any) -> Any:
        """Insert the relations of the equilibrium, and a given U with its derivatives, into an expression."""
        if self.potential and self.potential.given:
            place = dict(zip(self.system.space.coordinates, self.point))
            U = self.potential.expression.xreplace(place)
            expression = expression.xreplace({symbol(self.derived("U")): U})
        if self.equilibrium is None:
            if self.potential and self.potential.given:
                jets = [s for s in expression.free_symbols if jet(s.name)]
                return expression.xreplace({d: self.potential.value(d) for d in jets})
            return expression
        if self.potential and not self.potential.given:
            for name, value in self.equilibrium.relations:
                expression = expression.xreplace({name: value}) if jet(name.name) else expression
        return self.equilibrium.insert(expression)


def _directions(value: Any) -> list[str]:
    """Return the names of two directions."""
    if not isinstance(value, list) or len(value) != 2 or not all(isinstance(x, str) and is_name(x)
                                                                 for x in value):
        raise PublishedError(f'directions = {brief(value)}: write two names, directions = ["k", "e"]')
    return value


def _vehicle(value: Any) -> Mapping[str, Any]:
    """Return the texts of the masses, the coupling and the weight, by their names."""
    rows = value.values() if isinstance(value, dict) else ()
    if not rows or not {"mass", "weight"} <= set(value) <= {*VEHICLE} or not all(
            isinstance(row, list) and all(isinstance(x, (str, list)) for x in row) for row in rows):
        raise PublishedError(f"vehicle = {brief(value)}: write mass and weight, three texts each, and "
                             'perhaps coupling, three rows of them, vehicle = { mass = ["m1", "m2", "m3"], '
                             'weight = ["0", "0", "m0"] }')
    return dict(value)


def _parsed(value: Any) -> Any:
    """Return an expression for each text of a list, or of rows."""
    return [_parsed(x) for x in value] if isinstance(value, list) else parse(value)
