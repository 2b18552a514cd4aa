"""--scene FILE#NAME: the [scene.NAME] table of a file, in the place of the options that are left out."""
import argparse
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from ...algebra.text.inputs import name_of, toml_of
from ...algebra.text.spelling import names_in
from ...errors import GyrostatError, PublishedError, ValuesError, brief
from ...mechanics.families.circular_orbit import orbital_rate
from ...mechanics.families.scene_tables import NONE, SceneTable, scene_tables
from .options import SPINS, numbers_of, unless_given

# what a file means where it does not say it, as for a formula
BODY: dict[str, Any] = {"inertia": ["I1", "I2", "I3"], "gyrostatic_momentum": ["0", "0", "0"],
                        "potential": NONE}
# what an option of that name has too
TEXTS = (*BODY, "spin", "eliminate", "point", "state", "integrals", "orbit", "pointing",
         "direction", "release")
REPEATED = ("integrals",)                              # texts of an option that may be repeated
# of two one is given, and one goes before the other
NAMING, STARTING = frozenset({"equilibrium", "point"}), frozenset({"state", "release"})
SEVERAL = ("report", "conditions")                     # verbs that take more than one --equilibrium


def with_scene(given: argparse.Namespace) -> argparse.Namespace:
    """The options, and where they are left out what the file of --scene says.

    A number of the file gives way to one of --set and to an axis; its equilibrium, or its point, to either;
    and with a text that gives way go the numbers that it alone names.
    """
    if getattr(given, "scene", None) is None:
        return given
    options, table = vars(given), {**BODY, **_table(given.scene)}
    if "orbit" in table and "orbit" not in options:
        raise ValuesError(f"the scene {given.scene} is in orbit, and {given.kind} is of a free body: name "
                          "another scene; of a satellite plot eigenvalues draws the spectrum, chart the "
                          "verdicts")
    taken = {name for name, x in options.items() if x is not None}
    if options.get("equilibrium") or options.get("point"):
        taken |= NAMING
    if STARTING & taken:
        taken |= STARTING
    asked: dict[str, Any] = {name: table[name] if name in REPEATED else _text(table[name])
                             for name in TEXTS if name in table and name in options.keys() | BODY
                             and name not in taken}
    if "equilibrium" in table and not taken & NAMING:
        asked["equilibrium"] = [table["equilibrium"]] if given.verb in SEVERAL else table["equilibrium"]
    names = {*numbers_of(given.values), *_axes(given)}
    if SPINS & names:
        asked.pop("spin", None)
    left = _names(table[name] for name in TEXTS if name in table and name not in asked)
    if "equilibrium" in table and "equilibrium" not in options:
        left |= SPINS                                  # of E1 or E2, which the verb does not ask for
    kept = _names(str(x) for x in (*asked.values(), *(options.get(name) for name in TEXTS)))
    values = unless_given(table.get("values", {}), names | (left - kept))
    return argparse.Namespace(**{**options, **asked, "values": [
        *(f"{name}={x}" for name, x in values.items()), *given.values]})


def _table(place: str) -> Mapping[str, Any]:
    """The entries of FILE#NAME, its rotors as a tensor and a momentum."""
    scene = scene_of_file(place)
    family = {} if scene.family is None else {"equilibrium": scene.family.asked_for}
    return {**_without_rotors(scene), **family}


def scene_of_file(place: str) -> SceneTable:
    """The table of FILE#NAME, or the only one of FILE."""
    file, _, name = place.rpartition("#") if "#" in place else (place, "", "")
    path = Path(file)
    tables = scene_tables(toml_of(path), path)
    known = ", ".join(tables)
    if not tables:
        raise PublishedError(f"{path}: has no [scene.NAME] table: write [scene.top] and below it "
                             'potential = "m0*k3"')
    if name and name not in tables:
        raise PublishedError(f"{path}: has no scene {brief(name)[1:-1]}: its scenes are {known}")
    if not name and len(tables) > 1:
        raise PublishedError(f"{path}: has several scenes, {known}: name one, --scene "
                             f"{path}#{next(iter(tables))}")
    name = name or next(iter(tables))
    try:
        scene = SceneTable(tables[name])
        _ = scene.system, scene.family                     # what is wrong in it is said of the file
        return scene
    except GyrostatError as error:
        raise PublishedError(f"{path}: scene.{name}: {error}") from None


def _without_rotors(scene: SceneTable) -> dict[str, Any]:
    """The table, the body with its rotors as a tensor and a momentum, in orbit the free ones in U too."""
    table = {name: value for name, value in scene.table.items() if name not in ("rotors", "lumped")}
    if "rotors" in scene.table:
        table["inertia"] = [[str(x) for x in row] for row in scene.body.tensor.tolist()]
        table["gyrostatic_momentum"] = list(map(str, scene.body.gyrostatic_momentum))
        if "orbit" in table:                               # numbers of SI, as the tensor
            table["orbit"] = {"rate": str(orbital_rate(scene.system))}
            table["potential"] = _beside(scene, table["orbit"])
    return table


def _beside(scene: SceneTable, orbit: Mapping[str, str]) -> str:
    """What acts beside the gravity gradient of the tensor, none if nothing does."""
    whole, gradient = scene.potential, SceneTable({"orbit": orbit}).potential
    assert whole is not None and gradient is not None
    other = (whole.expression - gradient.expression).expand()
    return NONE if other == 0 else str(other)


def _text(value: Any) -> str:
    """As an option has it; the rows of a tensor with ; between them."""
    if isinstance(value, str):
        return value
    if isinstance(value, dict):
        return ",".join(f"{name}={text}" for name, text in value.items())
    return ";".join(map(_text, value)) if isinstance(value[0], list) else ",".join(map(str, value))


def _names(texts: Iterable[Any]) -> set[str]:
    """What reads as a name in them."""
    return {name for text in texts for name in names_in(_text(text))}


def _axes(given: argparse.Namespace) -> list[str]:
    """The names of the axes."""
    texts = [getattr(given, "x", None), getattr(given, "y", None), *(getattr(given, "axis", None) or ())]
    return [name_of(text.partition("=")[0].strip()) for text in texts if text is not None]
