"""What the page asks of the library: one function, JSON in, JSON out."""
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from importlib import import_module
from typing import Any

from copies import latex, program, scene_file
from edges import edges
from programs import charted, doubles, moving
from typeset import named, typeset

import gyrostat as gs
from gyrostat.algebra.text.grammar import parse
from gyrostat.errors import GyrostatError
from gyrostat.mechanics.equilibrium.equilibrium import Equilibrium
from gyrostat.mechanics.equilibrium.unit_vectors import direction_in
from gyrostat.mechanics.families.family import Family
from gyrostat.mechanics.families.named_families import (
    E3,
    EARTH_POINTING,
    PERMANENT,
    POLES,
    PRECESSIONS,
    PRINCIPAL,
)
from gyrostat.mechanics.families.scene_tables import SceneTable
from gyrostat.mechanics.scenes.kind import Kind
from gyrostat.mechanics.scenes.system import System, names_of_scene
from gyrostat.notation import jet
from gyrostat.printing.formats.latex_names import Names
from gyrostat.printing.results.boundary import undecided
from gyrostat.printing.results.decision import damped_block, decision_blocks, reason_block
from gyrostat.printing.results.document import conditions_blocks, point_blocks, report_blocks, whole_blocks
from gyrostat.stability.report.report import Report

Data = dict[str, Any]

POINT = "point"                                        # an equilibrium by its coordinates
EVERY = "every"                                        # all of a scene, at the numbers that the rest names
ONE = "a picture is of one equilibrium: choose one"
_LEVELS = {"M": "on a sphere of the angular momentum", "omega": "of a rate about the vertical",
           "k3": "of a tilt", "pi3_0 C1": "on a level of the momenta", "C1": "on a level of the momentum",
           "": "at rest in the frame of the orbit"}


def answer(question: str) -> str:
    """The answer to a question, an object with `want`, one of WANTED, and `scene`, the keys of a scene file.

    Parameters
    ----------
    question : str

    Returns
    -------
    str
        an object; with `error` where the library refuses, in its own words
    """
    try:
        asked = json.loads(question)
        table = asked["scene"]
        given = SceneTable({"values": table.get("values", {})}).table["values"]
        without = json.dumps({name: value for name, value in table.items() if name != "values"})
        return json.dumps(WANTED[asked["want"]](chosen(without), given, *asked.get("more", ())))
    except GyrostatError as error:
        return json.dumps({"error": str(error)})
    except MemoryError:
        return json.dumps({"error": "this needs more memory than a page has: write it more simply, or ask "
                                    "the library on your own machine"})
    except Exception as error:                         # whatever is typed, the page goes on
        return json.dumps({"error": f"internal error, {type(error).__name__}: {str(error)[:200]}; it is a "
                                    "bug, please report it"})


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
        """None of a point, and of all."""
        return next((family for family in self.families if family.asked_for == self.name), None)

    @property
    def every(self) -> bool:
        """Whether all are asked for."""
        return self.name.startswith(EVERY)

    @cached_property
    def equilibrium(self) -> Equilibrium:
        """Of the family, or the point."""
        if self.family is None:
            return gs.equilibrium(self.scene, list(map(parse, self.table[POINT])))
        direction = self.table.get("direction")
        return self.family.of(self.scene, self.table.get("spin", "pi3_0"), self.table.get("eliminate"),
                              direction and direction_in(direction), self.table.get("pointing"))

    @cached_property
    def report(self) -> Report:
        """Of the equilibrium."""
        return gs.analyze(self.equilibrium)

    @cached_property
    def names(self) -> list[str]:
        """What a verdict needs, and that under internal damping; or the list of all."""
        if self.every:
            level = self.name.split()[1:]
            return [*sorted(str(name) for name in names_of_scene(self.scene) if str(name) not in level),
                    *level]
        return list(dict.fromkeys((*self.report.required, *self.report.secular.required)))

    @cached_property
    def without(self) -> dict[str, str]:
        """Why the scene does not have a family, by what it is asked for."""
        found = {}
        for family in self.families:
            try:
                family.of(self.scene)
            except GyrostatError as error:
                found[family.asked_for] = str(error)
        return found

    @cached_property
    def levels(self) -> Sequence[str]:
        """What may be given for all equilibria of the scene."""
        U = self.scene.potential
        if U is None:
            return ("M",)
        if self.scene.kind is Kind.ORBIT:
            return ("",)
        if not U.given:
            return ()
        return ("omega", "k3", "pi3_0 C1") if self.scene.kind is Kind.REVOLUTION else ("omega", "C1")


@lru_cache(maxsize=32)
def chosen(without: str) -> Chosen:
    """What a scene without values names; its first equilibrium where it names none that it may have."""
    table = json.loads(without)
    name = table.get("equilibrium")
    if isinstance(name, str) and name.startswith(EVERY):
        table.pop("equilibrium")
    read = SceneTable(table)
    scene = read.system
    families: Sequence[Family] = PRINCIPAL
    if scene.kind is Kind.ORBIT:
        families = (EARTH_POINTING, *(PRECESSIONS if scene.body.is_of_revolution() else ()))
    elif scene.kind is not Kind.FREE:
        families = (*POLES.values(), E3 if scene.kind is Kind.REVOLUTION else PERMANENT)
    found = Chosen(read.table, scene, families, POINT)
    if POINT in table:
        return found
    if name in [f"{EVERY} {level}".strip() for level in found.levels]:
        return replace(found, name=name)
    first = next((f for f in families if f.asked_for not in found.without), families[0])
    return replace(found, name=(read.family if read.family in families else first).asked_for)


def _analysed(asked: Chosen, _: Mapping[str, str]) -> Data:
    """The equilibria of a scene, and of the one that is chosen all that holds without numbers."""
    name, family, names = asked.name, asked.family, Names()
    found: Data = {
        "chosen": name, "made_with": POINT if name == POINT else family.made_with if family else "",
        "equilibria": [{"name": f.asked_for, "title": f.title or f.label,
                        "why": asked.without.get(f.asked_for, "")} for f in asked.families] + [
            {"name": POINT, "title": "by its coordinates", "why": ""}] + [
            {"name": f"{EVERY} {level}".strip(), "title": f"equilibrium {_LEVELS[level]}", "why": ""}
            for level in asked.levels]}
    if name in asked.without:
        return {**found, "error": asked.without[name]}
    if not asked.every:
        found |= {"place": ", ".join(map(str, asked.equilibrium.point)),
                  "open": undecided(asked.report) and not asked.report.between,
                  "point": typeset(point_blocks(asked.equilibrium)),
                  "conditions": typeset(conditions_blocks(asked.report)[1:])}
    return {**found, "names": [named(asked.scene, name, names) for name in asked.names],
            "axes": [] if asked.every else list(asked.report.required)}


def _decided(asked: Chosen, given: Mapping[str, str]) -> Data:
    """The verdict at the values of the scene, with its reason, and under internal damping; or all."""
    values = _own(asked, given)
    if asked.every:
        found = import_module("every").listed(asked.scene, values)
        return {"found": [{"verdict": verdict, "blocks": typeset(blocks)} for verdict, blocks in found],
                "doubles": doubles(values)}
    decision, damped = asked.report.verdict(values), asked.report.verdict(values, damped=True)
    return {"verdict": decision.verdict.name, "damped": damped.verdict.name, "doubles": doubles(values),
            "blocks": typeset([*decision_blocks(decision, asked.equilibrium.at), reason_block(decision),
                               damped_block(decision, damped)])}


def _derived(asked: Chosen, _: Mapping[str, str]) -> Data:
    """The way to the conditions: bracket, equations of motion, linearisation, second variation."""
    return {"blocks": typeset(whole_blocks(asked.scene, [] if asked.every else report_blocks(asked.report)))}


def _opened(asked: Chosen, given: Mapping[str, str]) -> Data:
    """What decides between the conditions."""
    return {"blocks": [] if asked.every else typeset(
        import_module("every").open_between(asked.report, _own(asked, given)))}


def _copied(asked: Chosen, given: Mapping[str, str]) -> Data:
    """The same as LaTeX, as Python, and as a scene file."""
    values = _own(asked, given)
    table = {**asked.table, **({"equilibrium": asked.name} if asked.family else {})}
    found = {"python": program(asked.scene, asked.family, asked.table, values),
             "scene": scene_file(table, values, asked.name if asked.every else "")}
    blocks = ([block for _, its in import_module("every").listed(asked.scene, values) for block in its]
              if asked.every else conditions_blocks(asked.report))
    return {"latex": latex(asked.scene, blocks), **found}


def _charted(asked: Chosen, _: Mapping[str, str], axes: Sequence[str]) -> Data:
    """What the page computes of a chart in two names."""
    return {"why": ONE} if asked.every else charted(asked.report, axes)


def _bounded(asked: Chosen, given: Mapping[str, str], axes: Sequence[str],
             ends: Sequence[Sequence[str]]) -> Data:
    """The boundary of that chart."""
    return {"points": []} if asked.every else edges(asked.report, _own(asked, given), axes, ends)


def _moving(asked: Chosen, _: Mapping[str, str]) -> Data:
    """What the page computes of a motion, the numbers that it needs as they are written."""
    found, names = {"why": ONE} if asked.every else moving(asked.report), Names()
    return {**found, "names": [named(asked.scene, name, names) for name in found.get("names", ())]}


def _own(asked: Chosen, given: Mapping[str, str]) -> dict[str, str]:
    """The values that the question takes; of an unspecified U, every derivative."""
    U = asked.scene.potential
    jets = U is not None and not U.given and not asked.every
    return {name: text for name, text in given.items() if name in asked.names or jets and jet(name)}


WANTED = {"analysed": _analysed, "decided": _decided, "derived": _derived, "opened": _opened,
          "copied": _copied, "charted": _charted, "edges": _bounded, "moving": _moving}
