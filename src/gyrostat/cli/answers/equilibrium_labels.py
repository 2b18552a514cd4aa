"""The labels of equilibria: those that are named, and those that a scene is known to have."""
from collections.abc import Collection, Sequence

from ...errors import ValuesError
from ...mechanics.families.circular_orbit import in_orbit
from ...mechanics.families.family import Family
from ...mechanics.families.named_families import (
    EARTH_POINTING,
    FAMILIES,
    POLES,
    PRECESSIONS,
    PRINCIPAL,
    known_where,
)
from ...mechanics.scenes.system import System
from ..options.scene_texts import Asked, scene_of

CLAIMED = "E"                                          # of the point of --point


def named(asked: Asked, given: Sequence[str] | None) -> tuple[str, ...]:
    """The labels of --equilibrium in the order given, or that of --point; none where both are left out."""
    if asked.point is not None:
        if given:
            raise ValuesError(f"--point and --equilibrium {given[0]} are both given: leave out one of the "
                              "two")
        return (CLAIMED,)
    scene, known = scene_of(asked), {f.asked_for: f for f in FAMILIES.values()}
    here = where(scene)
    for text in given or ():
        family = known[text]
        if family.where == here:
            continue
        if family.where == "orbit":
            raise ValuesError(f"--equilibrium {text} is of a satellite in orbit, and this body is in none: "
                              "add --orbit omega0")
        if here == "free":
            raise ValuesError(f"--equilibrium {text} needs a field, --potential none has none: leave out one "
                              "of the two")
        what = "a free body" if family.where == "free" else "a body in a field fixed in space"
        lies = (f"--orbit {asked.orbit} is an orbit" if here == "orbit"
                else f"--potential {asked.potential} is a field")
        raise ValuesError(f"--equilibrium {text} is of {what}, {lies}: name {labels_in_words(scene)}, or a "
                          f"point, {by_point(scene)}")
    return tuple(dict.fromkeys(known[text].label for text in given or ()))


def where(scene: System) -> str:
    """The families that a scene has: those in a "field", "free" or in "orbit"."""
    return "free" if scene.potential is None else "orbit" if in_orbit(scene) else "field"


def by_point(scene: System) -> str:
    """The option that names an equilibrium of a scene by its coordinates."""
    return f"--point {','.join(str(x).upper() for x in scene.space.coordinates)}"


def labels() -> tuple[str, ...]:
    """The labels of the equilibria of a body of revolution in U(k3)."""
    return tuple(family.label for family in known_where("field") if family.pole or family.tilted)


def labels_in_words(scene: System) -> str:
    """What the families of such scenes are asked for, as a list in words."""
    *others, last = (family.asked_for for family in known_where(where(scene)))
    return f"{', '.join(others)} or {last}"


def likely(scene: System) -> Collection[Family]:
    """The families that are tried where none is asked for."""
    if in_orbit(scene):
        return (EARTH_POINTING, *(PRECESSIONS if scene.body.is_of_revolution() else ()))
    return POLES.values() if scene.potential else PRINCIPAL
