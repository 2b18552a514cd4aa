"""Reads from a table a scene, the families that it may have, and the equilibrium that is chosen."""
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from ..._cached import cached_property
from ...algebra.text.grammar import parse
from ...errors import GyrostatError
from ...mechanics.equilibrium.claimed_point import equilibrium
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.unit_vectors import direction_in
from ...mechanics.families.family import Family
from ...mechanics.families.named_families import E3, PERMANENT
from ...mechanics.families.scene_tables import SceneTable
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System, names_of_scene
from ...stability.report.analysis import analyze
from ...stability.report.report import Report
from ..answers.equilibrium_labels import likely

POINT = "point"                                        # an equilibrium by its coordinates
EVERY = "every"                                        # all of a scene, at the numbers that the rest names
_LEVELS = {Kind.FREE: ("M",), Kind.ORBIT: ("",), Kind.REVOLUTION: ("omega", "k3", "pi3_0 C1")}


@dataclass(frozen=True)
class Chosen:
    """A scene, the families that it may have, and the one that is asked for.

    Parameters
    ----------
    table : mapping
        of a scene file, without values
    scene : System
    families : sequence of Family
    name : str
        of one of them, or POINT, or EVERY and what is given
    """

    table: Mapping[str, Any]
    scene: System
    families: Sequence[Family]
    name: str

    @property
    def family(self) -> Family | None:
        """The family that is asked for; None for a point, and if all are asked for."""
        return next((family for family in self.families if family.asked_for == self.name), None)

    @property
    def every(self) -> bool:
        """Whether all are asked for."""
        return self.name.startswith(EVERY)

    @cached_property
    def equilibrium(self) -> Equilibrium:
        """The equilibrium of the family, or at the point."""
        if self.family is None:
            return equilibrium(self.scene, list(map(parse, self.table[POINT])))
        direction = self.table.get("direction")
        return self.family.of(self.scene, self.table.get("spin", "pi3_0"), self.table.get("eliminate"),
                              direction and direction_in(direction), self.table.get("pointing"))

    @cached_property
    def report(self) -> Report:
        """The report of the equilibrium."""
        return analyze(self.equilibrium)

    @cached_property
    def names(self) -> list[str]:
        """The names that both verdicts need, or those that the list of all needs."""
        if self.every:
            level = self.name.split()[1:]
            return [*sorted(str(name) for name in names_of_scene(self.scene) if str(name) not in level),
                    *level]
        return list(dict.fromkeys((*self.report.required, *self.report.secular.required)))

    @cached_property
    def without(self) -> dict[str, str]:
        """Why the scene does not have a family, by the name of the family."""
        found = {}
        for family in self.families:
            try:
                family.of(self.scene)
            except GyrostatError as error:
                found[family.asked_for] = str(error)
        return found

    @cached_property
    def levels(self) -> Sequence[str]:
        """The names by which a level may be given for all equilibria of the scene."""
        return () if self.scene.unspecified else _LEVELS.get(self.scene.kind, ("omega", "C1"))


def chosen(scene: Mapping[str, Any]) -> Chosen:
    """What a scene asks for, whatever its values; if it may have no such equilibrium, its first one."""
    table = {name: value for name, value in scene.items() if name != "values"}
    name, every = table.get("equilibrium"), ""
    if isinstance(name, str) and name.startswith(EVERY):
        every = table.pop("equilibrium")
    return _chosen(json.dumps(SceneTable(table).table), every)


@lru_cache(maxsize=32)
def _chosen(texts: str, every: str) -> Chosen:
    read = SceneTable(json.loads(texts))
    scene = read.system
    families = tuple(likely(scene))
    if scene.kind not in (Kind.FREE, Kind.ORBIT):
        families += (E3 if scene.kind is Kind.REVOLUTION else PERMANENT,)
    found = Chosen(read.table, scene, families, POINT)
    if POINT in read.table:
        return found
    if every in [f"{EVERY} {level}".strip() for level in found.levels]:
        return replace(found, name=every)
    first = next((f for f in families if f.asked_for not in found.without), families[0])
    return replace(found, name=next((f for f in families if f == read.family), first).asked_for)
