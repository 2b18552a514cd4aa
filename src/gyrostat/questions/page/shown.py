"""Gives what a page shows of a scene: conditions, verdicts, a chart, a motion, copies."""
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from ...arguments import checked, several
from ...equilibria.search import relative_equilibria
from ...errors import GyrostatError, ValuesError, brief
from ...mechanics.families.scene_tables import SceneTable
from ...notation import jet
from ...printing.blocks import Block, prose
from ...printing.formats.latex_names import Names
from ...printing.results.beyond_reports import result_blocks
from ...printing.results.boundary import undecided
from ...printing.results.decision import damped_block, decision_blocks, reason_block
from ...printing.results.document import conditions_blocks, point_blocks, report_blocks, whole_blocks
from ...printing.results.normal_form import form_blocks
from ...stability.report.report import Report
from ..answers.between_criteria import between, between_blocks
from ..answers.closed_wells import safe_kick
from .chart_edges import edges
from .chosen import EVERY, POINT, Chosen, chosen
from .copies import latex, program, scene_file
from .programs import ONE, Data, charted, doubles, moving
from .typeset import named, typeset

_LEVELS = {"M": "on a sphere of the angular momentum", "omega": "of a rate about the vertical",
           "k3": "of a tilt", "pi3_0 C1": "on a level of the momenta", "C1": "on a level of the momentum",
           "": "at rest in the frame of the orbit"}


@checked
def show(scene: Mapping[str, Any], want: str, *more: Any) -> dict[str, Any]:
    """Show a scene as the page in a browser does: what is asked of its equilibrium, typeset in LaTeX.

    Parameters
    ----------
    scene : mapping
        the keys of a scene file, texts or whole numbers; an equilibrium may be "every", with the names of a
        level: "every omega", "every pi3_0 C1"
    want : str
        one of WANTED: analysed (the equilibria, and the conditions of the one that is chosen), decided,
        derived, opened (what decides between the conditions), survived (a kick), copied, charted, edges,
        moving
    *more : list
        of charted and edges the two axes, of edges the ends of each too

    Returns
    -------
    dict
        an answer of schema/shown.json

    Raises
    ------
    ValuesError
        unless it is one of WANTED

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = {"potential": "m0*k3", "inertia": ["I1", "I1", "I3"],
    ...        "equilibrium": "E1"}
    >>> gs.questions.show(top, "analysed")["axes"]
    ['I1', 'm0', 'pi3_0']
    >>> values = {"I1": 1, "I3": 2, "m0": 1, "pi3_0": 3}
    >>> gs.questions.show(top | {"values": values}, "decided")["verdict"]
    'STABLE'
    """
    if want not in _ANSWERS:
        raise ValuesError(f"{brief(want)} is nothing that is shown: ask for {', '.join(WANTED)}")
    if len(more) != (wanted := _MORE.get(want, 0)):
        raise ValuesError(f"{want} is asked with {len(more)} lists beside the scene: give {wanted}")
    given = SceneTable({"values": scene.get("values", {})}).table["values"]
    return _ANSWERS[want](chosen(scene), given, *more)


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
        found = _listed(asked, values)
        return {"found": [{"verdict": verdict, "blocks": typeset(blocks)} for verdict, blocks in found],
                "doubles": doubles(values)}
    decision, damped = asked.report.verdict(values), asked.report.verdict(values, damped=True)
    return {"verdict": decision.verdict.name, "damped": damped.verdict.name, "doubles": doubles(values),
            "blocks": typeset([*decision_blocks(decision, asked.equilibrium.at), reason_block(decision),
                               damped_block(decision, damped)])}


def _survived(asked: Chosen, given: Mapping[str, str]) -> Data:
    """The kick that a stable equilibrium survives, where a formula has it."""
    values = _own(asked, given)
    stable = not asked.every and asked.report.verdict(values).stable
    return {"blocks": typeset(safe_kick(asked.report, values) if stable else [])}


def _derived(asked: Chosen, _: Mapping[str, str]) -> Data:
    """The way to the conditions: bracket, equations of motion, linearisation, second variation."""
    return {"blocks": typeset(whole_blocks(asked.scene, [] if asked.every else report_blocks(asked.report)))}


def _opened(asked: Chosen, given: Mapping[str, str]) -> Data:
    """What decides between the conditions."""
    return {"blocks": [] if asked.every else typeset(_between(asked.report, _own(asked, given)))}


def _copied(asked: Chosen, given: Mapping[str, str]) -> Data:
    """The same as LaTeX, as Python, and as a scene file."""
    values = _own(asked, given)
    table = {**asked.table, **({"equilibrium": asked.name} if asked.family else {})}
    found = {"python": program(asked.scene, asked.family, asked.table, values),
             "scene": scene_file(table, values, asked.name if asked.every else "")}
    blocks = ([block for _, its in _listed(asked, values) for block in its]
              if asked.every else conditions_blocks(asked.report))
    return {"latex": latex(asked.scene, blocks), **found}


def _charted(asked: Chosen, _: Mapping[str, str], axes: Sequence[str]) -> Data:
    """What the page computes of a chart in two names."""
    return {"why": ONE} if asked.every else charted(asked.report, _names(axes))


def _bounded(asked: Chosen, given: Mapping[str, str], axes: Sequence[str],
             ends: Sequence[Sequence[str]]) -> Data:
    """The boundary of that chart."""
    pairs = [several(pair, "ends", 2) for pair in several(ends, "ends", 2)]
    names = _names(axes)
    return {"points": []} if asked.every else edges(asked.report, _own(asked, given), names, pairs)


def _names(axes: Any) -> tuple[str, ...]:
    """The names of the two axes of a chart."""
    names = several(axes, "axes", 2)
    if not all(isinstance(name, str) for name in names):
        raise ValuesError(f'the axes are {brief(axes)}: give two names, ["I1", "l"]')
    return names


def _moving(asked: Chosen, _: Mapping[str, str]) -> Data:
    """What the page computes of a motion and of the body, the numbers that they need as they are written."""
    eq, names = None if asked.every else asked.equilibrium, Names()
    found = moving(eq.system if eq else asked.scene, eq)
    return {**found, "names": [named(asked.scene, name, names) for name in found["names"]]}


def _listed(asked: Chosen, values: Mapping[str, str]) -> list[tuple[str, list[Block]]]:
    """The verdict of each equilibrium; where it is, the reason, and what internal damping makes of it."""
    return [(found.decision.verdict.name, [*result_blocks(found), reason_block(found.decision),
                                           damped_block(found.decision, found.damped)])
            for found in relative_equilibria(asked.scene, values)]


def _between(report: Report, values: Mapping[str, str]) -> Sequence[Block]:
    """If gyroscopic forces may stabilise it: the normal form at numbers, and D4 along the family."""
    found = between(report)
    if found is None:
        return []
    try:
        form = form_blocks(report.normal_form(values))
    except GyrostatError as error:
        form = [prose(f"No normal form at these numbers: {error}.")]
    return [*form, *between_blocks(found)]


def _own(asked: Chosen, given: Mapping[str, str]) -> dict[str, str]:
    """The values that the question takes; for an unspecified U every derivative, too."""
    jets = asked.scene.unspecified and not asked.every
    return {name: text for name, text in given.items() if name in asked.names or jets and jet(name)}


_ANSWERS: Mapping[str, Callable[..., Data]] = {
    "analysed": _analysed, "decided": _decided, "derived": _derived, "opened": _opened,
    "copied": _copied, "survived": _survived, "charted": _charted, "edges": _bounded, "moving": _moving}
_MORE = {"charted": 1, "edges": 2}                     # the axes, and their ends
WANTED = tuple(_ANSWERS)
