"""What a formula of a published file is about.

A scene, and what the library derives for each of its names.
"""
from dataclasses import dataclass
from typing import Any

from sympy import Expr

from ..algebra.grammar import parse
from ..errors import PublishedError
from ..kept import cached_property
from ..mechanics.claimed import equilibrium
from ..mechanics.equilibria import Equilibrium
from ..mechanics.families import E3, PERMANENT
from ..mechanics.scene_tables import SceneTable
from ..notation import jet, symbol


@dataclass(frozen=True)
class Scene(SceneTable):
    """One [scene.NAME] table: a body, a field, perhaps an equilibrium or Euler angles.

    A state and values are for the command line, no formula is about them.

    Parameters
    ----------
    table : mapping
        as in the file
    """

    @cached_property
    def equilibrium(self) -> Equilibrium | None:
        """Of the family that the table asks for, or its point."""
        if self.claimed:
            return equilibrium(self.system, self.claimed)
        if self.family is PERMANENT:
            raise PublishedError('equilibrium = "permanent rotation": a formula is about one direction; '
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
        """The equilibrium; E3 at any k, not only at k2 = 0."""
        eq = self.equilibrium
        if eq is None:
            return ()
        if eq.label != E3.label:
            return eq.point
        k = [symbol(f"k{i}") for i in (1, 2, 3)]
        return (*(moment * symbol("omega") * x for moment, x in zip(self.body.moments, k)), *k)

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
