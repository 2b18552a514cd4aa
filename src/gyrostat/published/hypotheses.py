"""Lists the hypotheses of a published statement: its scene, its equilibrium, and what it is claimed under."""
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from sympy import Expr

from ..mechanics.scenes.coupled import CoupledPotential
from ..mechanics.scenes.potential import DIRECTIONS
from ..notation import symbol
from .scenes import Scene
from .statements import Statement


class Printed(str):
    """A formula that stands in the file: text shows it as it is, LaTeX typesets it."""


Row = tuple[str, tuple[str | Expr, ...]]               # a name, then words and formulas in their order


def hypotheses(statement: Statement) -> list[Row]:
    """Return what is assumed, in rows of words and formulas, which each format writes in its own way.

    Examples
    --------
    >>> import gyrostat as gs
    >>> source = gs.published.load("VV2003")
    >>> statement = next(s for s in source.statements if s.key == "E1-sufficient")
    >>> for name, pieces in hypotheses(statement):
    ...     print(name, "|", *pieces, sep="")
    body|moments of inertia I1, I1, I3, positive
    rotor|gyrostatic momentum (0, 0, l)
    field|U(k3), unspecified
    point|E1, (pi1, pi2, pi3, k1, k2, k3) = (0, 0, pi3_0, 0, 0, 1)
    """
    scene, claims_existence = statement.scene, statement.quantity == "existence"
    found = [*_body(scene), *_field(scene), *_equilibrium(scene, claims_existence)]
    given = [text for text in (scene.table.get("given"), statement.given) if text]
    found += [("given", (Printed(" and ".join(dict.fromkeys(given))),))] if given else []
    own = (("with", statement.let), ("at", statement.at))
    return found + [(name, _assigned(texts, Printed)) for name, texts in own if texts]


def _body(scene: Scene) -> Iterator[Row]:
    """Yield the moments or the tensor, and the rotor."""
    body = scene.hull
    if len(body.entries) > 3:
        yield "body", ("inertia tensor with the rows ",
                       *_joined([("(", *_joined(row), ")") for row in body.tensor.tolist()]))
    else:
        positive = any(moment.free_symbols for moment in body.moments)
        yield "body", ("moments of inertia ", *_joined(body.moments), ", positive" if positive else "")
    if any(body.gyrostatic_momentum):
        yield "rotor", ("gyrostatic momentum (", *_joined(body.gyrostatic_momentum), ")")


def _field(scene: Scene) -> Iterator[Row]:
    """Yield what acts on the body; for kinematics, the angles."""
    table, potential = scene.table, scene.potential
    if "angles" in table:
        vertical = table.get("vertical")
        yield "motion", ("described by Euler angles ", "-".join(table["angles"]),
                         *((", free, the momentum ", Printed(vertical), " along z") if vertical else ()))
    if "orbit" in table:
        beside = table.get("potential", "none")
        yield "field", ("gravity gradient in a circular orbit, ", *_assigned(table["orbit"]),
                        *(() if beside == "none" else (", and the energy ", Printed(beside))))
    elif "vehicle" in table:
        yield "field", ("vehicle in a fluid, ", *_assigned(table["vehicle"]))
    elif isinstance(potential, CoupledPotential):
        yield "field", (symbol("U"), " = ", potential.expression,
                        f", directions {', '.join(potential.directions)}")
    elif potential is None and "angles" not in table:
        yield "field", ("none, the body is free",)
    elif potential and potential.given:
        yield "field", (symbol("U"), " = ", potential.expression)
    elif potential:
        directions = DIRECTIONS[2:] if potential.axial else DIRECTIONS
        yield "field", (symbol("U"), "(", *_joined(directions), "), unspecified")


def _equilibrium(scene: Scene, claims_existence: bool) -> Iterator[Row]:
    """Yield the point, what makes it an equilibrium, and where it exists unless existence is the claim."""
    if (eq := scene.equilibrium) is None:
        return
    name = "" if scene.claimed else f"{eq.label}, "
    yield "point", (f"{name}(", *_joined(scene.system.space.coordinates), ") = (", *_joined(scene.point), ")")
    if eq.relations:
        yield "relations", _joined([(symbol, " = ", value) for symbol, value in eq.relations])
    if (exists := [e for e in eq.existence() if not e.is_positive]) and not claims_existence:
        yield "exists if", _joined([(e, " > 0") for e in exists], " and ")


def _joined(entries: Iterable[Any], sign: str = ", ") -> tuple[str | Expr, ...]:
    """Return entries, each one piece or several, with a sign between them."""
    found: list[str | Expr] = []
    for entry in entries:
        found += [sign] if found else []
        found += entry if isinstance(entry, tuple) else [entry]
    return tuple(found)


def _assigned(texts: Mapping[str, Any], name_as: type[str] = str) -> tuple[str | Expr, ...]:
    """Return names with the texts that the file gives them; name_as is Printed if they stand in formulas."""
    return _joined([(name_as(name), " = ", *_printed(text)) for name, text in texts.items()])


def _printed(text: Any) -> tuple[str | Expr, ...]:
    """Return a text of the file, or a list of texts in brackets."""
    return (Printed(text),) if isinstance(text, str) else ("[", *_joined(map(_printed, text)), "]")
