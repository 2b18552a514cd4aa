"""The labels of equilibria: those that are named, and those that a scene is known to have."""
from collections.abc import Collection, Sequence

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

CLAIMED = "E"                                          # of the point of --point


def named(asked: Asked, given: Sequence[str] | None) -> tuple[str, ...]:
    """The labels of --equilibrium in the order given, or that of --point; none where both are left out."""
    if asked.point is not None:
        if given:
            raise ValuesError(f"--point and --equilibrium {given[0]} are both given: leave out one of the "
                              "two")
        return (CLAIMED,)
    scene, known = scene_of(asked), {f.asked_for: f for f in FAMILIES.values()}
    for text in given or ():
        family = known[text]
        if scene.kind in family.kinds:
            continue
        if Kind.ORBIT in family.kinds:
            raise ValuesError(f"--equilibrium {text} is of a satellite in orbit, and this body is in none: "
                              "add --orbit omega0")
        if scene.kind is Kind.FREE:
            raise ValuesError(f"--equilibrium {text} needs a field, --potential none has none: leave out one "
                              "of the two")
        what = "a free body" if Kind.FREE in family.kinds else "a body in a field fixed in space"
        lies = (f"--orbit {asked.orbit} is an orbit" if scene.kind is Kind.ORBIT
                else f"--potential {asked.potential} is a field")
        raise ValuesError(f"--equilibrium {text} is of {what}, {lies}: name {labels_in_words(scene)}, or a "
                          f"point, {by_point(scene)}")
    return tuple(dict.fromkeys(known[text].label for text in given or ()))


def by_point(scene: System) -> str:
    """The option that names an equilibrium of a scene by its coordinates."""
    return f"--point {','.join(str(x).upper() for x in scene.space.coordinates)}"


def labels() -> tuple[str, ...]:
    """The labels of the equilibria of a body of revolution in U(k3)."""
    return tuple(family.label for family in known_of(Kind.REVOLUTION) if family.pole or family.tilted)


def labels_in_words(scene: System) -> str:
    """What the families of such scenes are asked for, as a list in words."""
    *others, last = (family.asked_for for family in known_of(scene.kind))
    return f"{', '.join(others)} or {last}"


def likely(scene: System) -> Collection[Family]:
    """The families that are tried where none is asked for."""
    if scene.kind is Kind.ORBIT:
        return (EARTH_POINTING, *(PRECESSIONS if scene.body.is_of_revolution() else ()))
    return PRINCIPAL if scene.kind is Kind.FREE else POLES.values()
