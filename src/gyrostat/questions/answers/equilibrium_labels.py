"""Finds the labels of equilibria: of those that are named, and of those that a scene is known to have."""
from collections.abc import Collection, Sequence

from ..._lazy import loaded
from ...errors import ValuesError
from ...mechanics.families.family import Family
from ...mechanics.families.named_families import (
    EARTH_POINTING,
    FAMILIES,
    POLES,
    PRECESSIONS,
    PRINCIPAL,
    known_of,
)
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System
from ..scene_texts import Asked, scene_of

AXIS = "mechanics.equilibrium.recognition:axis_of_satellite"
CLAIMED = "E"                                          # of an equilibrium that is given by its point


def named(asked: Asked, given: Sequence[str] | None) -> tuple[str, ...]:
    """The labels of the equilibria that are named, in that order, or that of the point; else none."""
    if asked.point is not None:
        if given:
            raise ValuesError(f"a point and the equilibrium {given[0]} are both given, and one is decided: "
                              "leave out one of the two")
        return (CLAIMED,)
    scene = scene_of(asked)
    known = {family.asked_for: family for family in FAMILIES.values()} if given else {}
    for text in given or ():
        family = known[text]
        if scene.kind in family.kinds:
            continue
        if Kind.ORBIT in family.kinds:
            raise ValuesError(f"the equilibrium {text} is one of a satellite in orbit, and this body is in "
                              "no orbit: give an orbit, for example omega0")
        if scene.kind is Kind.FREE:
            raise ValuesError(f"the equilibrium {text} is one in a field, and this body is free: give a "
                              f"potential, or name {labels_in_words(scene)}")
        what = "a free body" if Kind.FREE in family.kinds else "a body in a field fixed in space"
        lies = (f"in the orbit {asked.orbit}" if scene.kind is Kind.ORBIT
                else f"in the field {asked.potential}")
        raise ValuesError(f"the equilibrium {text} is one of {what}, and this body is {lies}: name "
                          f"{labels_in_words(scene)}, or give {by_point(scene)}")
    return tuple(dict.fromkeys(known[text].label for text in given or ()))


def by_point(scene: System) -> str:
    """How an equilibrium of a scene is given by its coordinates."""
    return f"its point {','.join(str(x).upper() for x in scene.space.coordinates)}"


def labels() -> tuple[str, ...]:
    """The labels of the equilibria of a body of revolution in U(k3)."""
    return tuple(family.label for family in known_of(Kind.REVOLUTION) if family.pole or family.tilted)


def labels_in_words(scene: System) -> str:
    """The names by which the families of such scenes are asked for, as a list in words."""
    *others, last = (family.asked_for for family in known_of(scene.kind))
    return f"{', '.join(others)} or {last}"


def likely(scene: System) -> Collection[Family]:
    """The families that are tried if none is asked for."""
    if scene.kind is Kind.ORBIT:
        return (EARTH_POINTING, *(PRECESSIONS if loaded(AXIS)(scene.body) else ()))
    return PRINCIPAL if scene.kind is Kind.FREE else POLES.values()
