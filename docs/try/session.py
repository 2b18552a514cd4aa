"""What the page asks of the library: one function, JSON in, JSON out."""
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

from copies import latex, program, scene_file
from programs import charted, edges, moving
from sympy import MatrixBase

import gyrostat as gs
from gyrostat.errors import GyrostatError
from gyrostat.mechanics.families import E3, PERMANENT, POLES, PRINCIPAL
from gyrostat.mechanics.family import Family
from gyrostat.mechanics.reduction import reducible
from gyrostat.mechanics.scene_tables import SceneTable
from gyrostat.mechanics.system import System
from gyrostat.notation import symbol
from gyrostat.printing.article import NARROW, inline
from gyrostat.printing.blocks import Block, Display, Heading, Rows, Sentence, sentence
from gyrostat.printing.decision import damped_block, decision_blocks
from gyrostat.printing.document import conditions_blocks, point_blocks, report_blocks, whole_blocks
from gyrostat.printing.latex import display, tex
from gyrostat.printing.linebreaks import broken, width
from gyrostat.printing.names import Names
from gyrostat.stability.report import Decision, Report

Data = dict[str, Any]


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
    family : Family
        one of them
    """

    table: Mapping[str, Any]
    scene: System
    families: Sequence[Family]
    family: Family

    @cached_property
    def report(self) -> Report:
        """Of the equilibrium."""
        return gs.analyze(self.family.of(self.scene, self.table.get("spin", "pi3_0"),
                                         self.table.get("eliminate")))

    @cached_property
    def names(self) -> list[str]:
        """What a verdict needs, and that under internal damping."""
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


@lru_cache(maxsize=32)
def chosen(without: str) -> Chosen:
    """What a scene without values names; the first of its families where it names none that it may have."""
    table = json.loads(without)
    read = SceneTable(table)
    scene = read.system
    families: Sequence[Family] = PRINCIPAL
    if scene.potential is not None:
        families = (*POLES.values(), E3 if reducible(scene) else PERMANENT)
    return Chosen(table, scene, families, read.family if read.family in families else families[0])


def _analysed(asked: Chosen, _: Mapping[str, str]) -> Data:
    """The equilibria of a scene, and of the one that is chosen all that holds without numbers."""
    name = asked.family.asked_for
    found = {"chosen": name, "equilibria": [
        {"name": family.asked_for, "title": family.title or family.label,
         "why": asked.without.get(family.asked_for, "")} for family in asked.families]}
    if name in asked.without:
        return {**found, "error": asked.without[name]}
    names = Names()
    return {**found, "point": _blocks(point_blocks(asked.report.equilibrium)),
            "conditions": _blocks(conditions_blocks(asked.report)[1:]),
            "names": [{"name": name, "tex": tex(symbol(name), names)} for name in asked.names],
            "axes": list(asked.report.required)}


def _decided(asked: Chosen, given: Mapping[str, str]) -> Data:
    """The verdict at the values of the scene, with its reason, and under internal damping."""
    values = {name: text for name, text in given.items() if name in asked.names}
    decision, damped = asked.report.verdict(values), asked.report.verdict(values, damped=True)
    return {"verdict": decision.verdict.name, "damped": damped.verdict.name,
            "blocks": _blocks([*decision_blocks(decision, asked.report.equilibrium.at), _reason(decision),
                               damped_block(decision, damped)])}


def _derived(asked: Chosen, _: Mapping[str, str]) -> Data:
    """The way to the conditions: bracket, equations of motion, linearisation, second variation."""
    return {"blocks": _blocks(whole_blocks(asked.scene, report_blocks(asked.report)))}


def _copied(asked: Chosen, given: Mapping[str, str]) -> Data:
    """The same as LaTeX, as Python, and as a scene file."""
    values = {name: text for name, text in given.items() if name in asked.names}
    return {"latex": latex(asked.report), "python": program(asked.scene, asked.family, asked.table, values),
            "scene": scene_file({**asked.table, "equilibrium": asked.family.asked_for}, values)}


def _charted(asked: Chosen, _: Mapping[str, str], axes: Sequence[str]) -> Data:
    """What the page computes of a chart in two names."""
    return charted(asked.report, axes)


def _bounded(asked: Chosen, given: Mapping[str, str], axes: Sequence[str],
             ends: Sequence[Sequence[str]]) -> Data:
    """The boundary of that chart."""
    values = {name: text for name, text in given.items() if name in asked.names}
    return edges(asked.report, values, axes, ends)


def _moving(asked: Chosen, _: Mapping[str, str]) -> Data:
    """What the page computes of a motion, the numbers that it needs as they are written."""
    found, names = moving(asked.report), Names()
    listed = [{"name": name, "tex": tex(symbol(name), names)} for name in found.get("names", ())]
    return {**found, "names": listed}


WANTED = {"analysed": _analysed, "decided": _decided, "derived": _derived, "copied": _copied,
          "charted": _charted, "edges": _bounded, "moving": _moving}


def _reason(decision: Decision) -> Sentence:
    return sentence(f"Reason{f' ({decision.notion})' if decision.notion else ''}: {decision.reason}.")


def _blocks(blocks: Sequence[Block]) -> list[Data]:
    """Headings, sentences and displays, their formulas in LaTeX."""
    names = Names()
    return [_block(block, names) for block in blocks]


def _block(block: Block, names: Names) -> Data:
    if isinstance(block, Heading):
        return {"heading": block.title, "level": block.level}
    if isinstance(block, Display):
        return {"display": _lines(block, names)}
    if isinstance(block, Rows):
        return {"title": block.title,
                "rows": [[_parts(cell, None, names) for cell in row] for row in block.rows]}
    return {"sentence": _parts(block.parts, block.at, names)}


def _lines(block: Display, names: Names) -> str:
    """A display, broken where it is wider than a column."""
    whole = display(block, names)
    if isinstance(block.value, MatrixBase) or width(whole) <= NARROW:
        return whole
    return r"\begin{aligned} & " + r" \\ & \quad ".join(broken(whole, NARROW)) + r" \end{aligned}"


def _parts(parts: Sequence[Any], at: Any, names: Names) -> list[dict[str, str]]:
    """Prose and formulas."""
    return [{"text": part} if isinstance(part, str) else {"tex": inline(tex(part, names, at))}
            for part in parts]
