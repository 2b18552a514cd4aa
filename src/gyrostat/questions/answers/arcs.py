"""Answers decide for a body in U = c·k if no number of its motion is given: the arcs of rotations."""
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from sympy import Abs, Expr, factor_terms

from ..._lazy import loaded
from ...algebra.reals.exact import sign_of_constant
from ...errors import ValuesError
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import names_of_scene
from ...notation import symbol
from ...printing.blocks import Block, Heading, sentence
from ...printing.formats.json_data import decision_data, number_data, strings
from ...printing.glossary import term_blocks
from ...printing.results.decision import note_blocks
from ...stability.criteria.number_notes import scene_note
from ...stability.criteria.numbers_asked import unknown
from ...stability.decision import Rung
from ..scene_texts import Asked, scene_of
from .equilibrium_labels import named

if TYPE_CHECKING:
    from ...equilibria.curves.arc import Arc

OF_MOTION = frozenset(("omega", "C1", "k1", "k2", "k3", "kc", "pi1_0", "pi2_0", "pi3_0", "pic_0", "omega3_0"))


def arcs_at(asked: Asked, label: str | None, numbers: Mapping[str, Expr]) -> "Sequence[Arc]":
    """Every arc of permanent rotations; none if something else is asked, or if U is not c·k.

    Raises
    ------
    ValuesError
        a name is none of the scene or of its motion
    """
    scene = scene_of(asked)
    U = scene.potential
    if named(asked, label and [label]) or U is None or scene.kind is not Kind.FIELD or scene.unspecified:
        return []
    own = {s.name for s in names_of_scene(scene)}
    if not numbers.keys() >= own or numbers.keys() & OF_MOTION:
        return []
    if any(x.free_symbols & set(scene.space.coordinates) for x in map(U.value, filter(None, U.gradient()))):
        return []
    for name in numbers.keys() - own:
        raise ValuesError(unknown(name, sorted(own), "the scene"))
    found: Sequence[Arc] = loaded("equilibria.curves.staude:staude_cone")(scene).arcs(numbers)
    return found


def arcs_blocks(arcs: "Sequence[Arc]") -> list[Block]:
    """Ends, direction, rate and verdicts of each; where they are split, and the terms."""
    result_blocks = loaded("printing.results.beyond_reports:result_blocks")
    found = [*(block for n, arc in enumerate(arcs, 1)
               for block in (Heading(f"permanent rotations, arc {n}"), *result_blocks(arc))), *_splits(arcs)]
    return [*found, *term_blocks(found), *note_blocks(scene_note(arcs[0].scene, {}))]


def _splits(arcs: "Sequence[Arc]") -> list[Block]:
    """Where an arc is split although the verdict does not change."""
    rungs = {piece.decision.rung for arc in arcs for piece in arc.pieces}
    if not rungs & {Rung.TWIST, Rung.TWIST_POSITIVE, Rung.TWIST_NEGATIVE}:
        return []
    zeros = "" if Rung.TWIST in rungs else ", and where D₄ = 0"
    return [Heading("Where an arc is split"), sentence(
        "Where gyroscopic forces stabilise the rotations, an arc is split at the resonances 1:2 and 1:3 of "
        f"the two frequencies{zeros}. The pieces do not contain these points.")]


def _along(arc: "Arc") -> dict[str, Any]:
    """The unit vector k and the square of the rate, in the parameter; with a rotor k is in sigma, too."""
    if not arc.both_ways:
        return {"k": strings(arc.k), "omega_squared": str(arc.omega_squared)}
    between = loaded("algebra.solving.roots:between")
    inside = {arc.parameter: between(arc.low, arc.high)}   # what has a sign keeps it along the arc
    square = arc.omega_squared.replace(Abs, lambda x: x * sign_of_constant(x.xreplace(inside)))
    k = (factor_terms(x.xreplace({symbol("omega")**-2: 1 / square})) for x in arc.k)
    return {"k": strings(k), "omega_squared": str(square)}


def arcs_data(arcs: "Sequence[Arc]") -> dict[str, Any]:
    """The arcs as data for JSON; of an infinite number the decimal is none."""
    note = scene_note(arcs[0].scene, {})
    return {"arcs": list(map(_arc, arcs))} | ({"note": note} if note else {})


def _arc(arc: "Arc") -> dict[str, Any]:
    """With the circles that it crosses, if any."""
    ends = [{"k": list(map(number_data, end.k)), "omega": number_data(end.omega)} for end in arc.ends]
    pieces = [{"low": number_data(piece.low), "high": number_data(piece.high),
               "decision": decision_data(replace(piece.decision, note=""))} for piece in arc.pieces]
    circles = [{"k": list(map(number_data, circle.directions[0])),
                "omega": number_data(circle.rates["omega"]), "locus": circle.locus} for circle in arc.circles]
    return {"parameter": str(arc.parameter), "low": number_data(arc.low), "high": number_data(arc.high),
            **_along(arc), "ends": ends, "pieces": pieces} | ({"circles": circles} if circles else {})
