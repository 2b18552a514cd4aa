"""What a formula of a published file is about.

A scene, and what the library derives for each of its names.
"""
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sympy import Expr

from ..algebra.grammar import parse
from ..algebra.inputs import is_name
from ..errors import PublishedError, brief
from ..kept import cached_property
from ..mechanics.body import Gyrostat
from ..mechanics.equilibria import Equilibrium
from ..mechanics.families import E3, FAMILIES
from ..mechanics.potential import Potential
from ..mechanics.potentials import axial_potential, general_potential
from ..mechanics.system import System, assemble
from ..notation import jet, symbol

KEYS = {"inertia", "gyrostatic_momentum", "potential", "equilibrium", "spin", "eliminate", "angles",
        "vertical", "given", "parameters"}


@dataclass(frozen=True)
class Scene:
    """One [scene.NAME] table: a body, a field, perhaps an equilibrium or Euler angles.

    Parameters
    ----------
    table : mapping
        as in the file
    """

    table: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if unknown := set(self.table) - KEYS:
            raise PublishedError(f"a scene has no entry {', '.join(sorted(unknown))}: its entries are "
                                 f"{', '.join(sorted(KEYS))}")
        for name, value in self.table.items():
            listed = name in ("inertia", "gyrostatic_momentum", "parameters")
            texts = value if listed and isinstance(value, list) else [value]
            if isinstance(value, list) != listed or not all(isinstance(text, str) for text in texts):
                raise PublishedError(f"{name} = {brief(value)}: write "
                                     f"{'a list of texts' if listed else 'a text'}, in quotation marks")
        for name in self.table.get("parameters", ()):
            if not is_name(name):
                raise PublishedError(f"the parameter {brief(name)} is not a name: letters, digits and _ "
                                     "make one")

    @cached_property
    def body(self) -> Gyrostat:
        """The gyrostat; without entries a rigid body with three moments."""
        inertia, rotor = (
            self.table.get("inertia", ["I1", "I2", "I3"]),
            self.table.get("gyrostatic_momentum", ["0", "0", "0"]),
        )
        return Gyrostat(tuple(map(parse, inertia)), tuple(map(parse, rotor)))

    @cached_property
    def potential(self) -> Potential | None:
        """none, U(k3), U(k1, k2, k3), or an expression in k3, or in k1, k2, k3."""
        text = self.table.get("potential", "none")
        if text == "none":
            return None
        if text in ("U(k3)", "U(k1, k2, k3)"):
            return axial_potential() if text == "U(k3)" else general_potential()
        expression = parse(text)
        return (
            general_potential(expression)
            if expression.free_symbols & {symbol("k1"), symbol("k2")}
            else axial_potential(expression)
        )

    @cached_property
    def system(self) -> System:
        """The Lie-Poisson system."""
        return assemble(self.body, self.potential)

    @cached_property
    def equilibrium(self) -> Equilibrium | None:
        """Of the family that the table asks for: E1, E2, E3, axis 1 and so on."""
        asked = self.table.get("equilibrium")
        if asked is None:
            return None
        known = {family.asked_for: family for family in FAMILIES.values() if family.asked_for}
        if asked not in known:
            *others, last = known
            raise PublishedError(f"equilibrium = {brief(asked)}: give {', '.join(others)} or {last}")
        return known[asked].of(self.system, self.table.get("spin", "pi3_0"), self.table.get("eliminate"))

    @property
    def point(self) -> tuple[Expr, ...]:
        """The equilibrium; E3 at any k, not only at k2 = 0."""
        eq = self.equilibrium
        if eq is None:
            return ()
        if eq.label != E3.label:
            return eq.point
        k = [symbol(f"k{i}") for i in (1, 2, 3)]
        return (*(moment * symbol("omega") * x for moment, x in zip(self.body.inertia, k)), *k)

    def finish(self, expression: Any) -> Any:
        """On the family: the relations of the equilibrium, a given U and its derivatives inserted."""
        if self.potential and self.potential.given:
            expression = expression.xreplace({symbol("U"): self.potential.expression.xreplace(dict(zip(
                self.system.space.coordinates, self.point)))})
        if self.equilibrium is None:
            if self.potential and self.potential.given:
                jets = [s for s in expression.free_symbols if jet(s.name)]
                return expression.xreplace({d: self.potential.value(d) for d in jets})
            return expression
        if self.potential and not self.potential.given:
            for name, value in self.equilibrium.relations:
                expression = expression.xreplace({name: value}) if jet(name.name) else expression
        return self.equilibrium.insert(expression)
