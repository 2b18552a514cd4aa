"""The list of the named families of equilibria, with the words by which they are asked for.

They are upright E1, hanging E2, inclined E3 and its limit at rest, principal rotations of a free body,
permanent rotations; in orbit Earth-pointing, and precessions of a symmetric body. FAMILIES is the one list of
them: a family that is added to it is known to the command line, to documents, to pictures and to published
files. What makes an equilibrium of a family is loaded when one is made.
"""
from collections import Counter
from collections.abc import Collection, Sequence
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Any

from ..scenes.kind import Kind
from .family import Family

if TYPE_CHECKING:
    from ..equilibrium.equilibrium import Equilibrium


def _made(module: str, maker: str, *given: Any, **named: Any) -> "Equilibrium":
    """Return an equilibrium by the maker of that name, in its module."""
    made: Equilibrium = getattr(import_module(f".{module}", __package__), maker)(*given, **named)
    return made


def _pointing(scene: Any, axes: Sequence[int] | None) -> "Equilibrium":
    """Return Earth-pointing for the axes of roll, pitch and yaw in a sequence; default: 1, 2, 3."""
    return _made("circular_orbit", "earth_pointing", scene, *(axes or ()))


VERA_VIGUERA = "Vera & Viguera 2003, §3"
E1 = Family("E1", "upright", "spinning about the upward vertical", partial(_made, "vertical", "upright"),
            VERA_VIGUERA, "spin", 1, asked_for="E1")
E2 = Family("E2", "hanging", "spinning about the downward vertical", partial(_made, "vertical", "hanging"),
            VERA_VIGUERA, "spin", -1, asked_for="E2")
E3 = Family("E3", "inclined", "precessing about the vertical, inclined",
            partial(_made, "tilted", "inclined"), VERA_VIGUERA, "eliminate", asked_for="E3")
E3_AT_REST = Family("E3 at rest", "at rest at a tilt", "tilted, without rotation",
                    partial(_made, "tilted", "static_tilt"), VERA_VIGUERA, "eliminate")
PRINCIPAL = tuple(Family(f"rotation about axis {n}", "principal rotation", "",
                         partial(_made, "principal_rotation", "principal_rotation", axis=n),
                         "Hughes 1986, chapter 6", kinds=(Kind.FREE,), asked_for=f"axis {n}")
                  for n in (1, 2, 3))
PERMANENT = Family("permanent rotation", "permanent-rotation",
                   "turning about the vertical, k fixed in the body",
                   partial(_made, "permanent_rotation", "permanent_rotation"), "Staude 1894", "direction",
                   asked_for="permanent-rotation")
EARTH_POINTING = Family("Earth-pointing", "earth-pointing", "at rest in the frame of the orbit", _pointing,
                        "Hughes 1986, chapters 9 and 10", "pointing", kinds=(Kind.ORBIT,),
                        asked_for="earth-pointing")
PRECESSIONS = tuple(Family(kind, kind, f"the axis {place}", partial(
    _made, "orbital_precession", "orbital_precession", kind=kind), "Likins 1965", kinds=(Kind.ORBIT,),
    asked_for=kind) for kind, place in (
        ("cylindrical", "along the normal of the orbit"),
        ("hyperbolic", "in the plane of the normal and the velocity"),
        ("conical", "in the plane of the normal and the vertical")))
POLES = {1: E1, -1: E2}
FAMILIES = {family.label: family for family in (E1, E2, E3, E3_AT_REST, *PRINCIPAL, PERMANENT, EARTH_POINTING,
                                             *PRECESSIONS)}


def known_families() -> list[Family]:
    """Return the families that are asked for by their label, of a body in a field, free or in orbit."""
    return [family for family in FAMILIES.values() if family.asked_for]


def known_of(kind: Kind) -> list[Family]:
    """Return the families that are asked for by their label in scenes of a kind."""
    return [family for family in known_families() if kind in family.kinds]


def named(families: Collection[Family]) -> dict[str, Family]:
    """Return families by what they are asked for, and by the word of the field if it names only one."""
    words = Counter(family.name for family in families)
    return {**{family.asked_for: family for family in families},
            **{family.name: family for family in families if words[family.name] == 1}}


def called(text: str, families: Collection[Family]) -> Family | None:
    """Return the family that a text names, in large or small letters; None if it names none."""
    return {name.lower(): family for name, family in named(families).items()}.get(text.lower())


def in_words(families: Collection[Family]) -> str:
    """Return the names of families as a list in words: E1 or upright, E2 or hanging."""
    names = named(families)
    return ", ".join(" or ".join(name for name in names if names[name] is family) for family in families)
