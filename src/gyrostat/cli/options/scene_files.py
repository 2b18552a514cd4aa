"""Fills the options that are not given from the table [scene.NAME] of a file: --scene FILE#NAME."""
import argparse
from collections.abc import Collection, Iterable
from dataclasses import fields
from pathlib import Path
from typing import Any

from ...algebra.text.inputs import name_of, toml_of
from ...algebra.text.quantities import not_mixed
from ...algebra.text.spelling import names_in
from ...errors import GyrostatError, PublishedError, ValuesError, brief
from ...mechanics.families.scene_tables import SceneTable, scene_tables
from ...questions.given_numbers import SPINS, numbers_of, unless_given
from ...questions.scene_texts import (
    BODY,
    REPEATED,
    Asked,
    asked_value,
    entries_of,
    table_of,
    text_of,
)
from .axis_option import ends_of

# keys for which there is an option of the same name
TEXTS = (*BODY, "products", "rotors", "lumped", "spin", "eliminate", "point", "state", "integrals", "orbit",
         "pointing", "direction", "release")
# of each group one is given; an option for one overrides the others in the file
NAMING, STARTING = frozenset({"equilibrium", "point"}), frozenset({"state", "release"})
TURNING = frozenset({"rotors", "gyrostatic_momentum", "lumped"})
SEVERAL = ("report", "conditions")                     # verbs that take more than one --equilibrium


def with_scene(given: argparse.Namespace) -> argparse.Namespace:
    """The options, completed by the file of --scene.

    Options override the file: --set and an axis override a number, --equilibrium and --point override its
    equilibrium or its point. If a text of the file is overridden, the numbers that it alone names are
    dropped.
    """
    if getattr(given, "scene", None) is None:
        return given
    options, table = vars(given), entries_of(scene_of_file(given.scene))
    if "orbit" in table and "orbit" not in options:
        raise ValuesError(f"the scene {given.scene} is in orbit, and {given.kind} shows a free body: name "
                          "another scene; of a satellite plot draws attitudes, librations, smelt-plane and "
                          "eigenvalues, and chart the verdicts")
    taken = {name for name, x in options.items() if x is not None}
    if options.get("equilibrium") or options.get("point"):
        taken |= NAMING
    if STARTING & taken:
        taken |= STARTING
    if {"rotors", "gyrostatic_momentum"} & taken:
        taken |= TURNING
    if "inertia" in taken:
        taken.add("products")
    asked: dict[str, Any] = {name: asked_value(name, table[name])
                             for name in TEXTS if name in table and name in options.keys() | BODY
                             and name not in taken}
    if "equilibrium" in table and not taken & NAMING:
        asked["equilibrium"] = [table["equilibrium"]] if given.verb in SEVERAL else table["equilibrium"]
    names = {*numbers_of(given.values), *map(_name, _axes(given))}
    if SPINS & names:
        asked.pop("spin", None)
    left = _names(table[name] for name in TEXTS if name in table and name not in asked)
    if "equilibrium" in table and "equilibrium" not in options:
        left |= SPINS                                  # of E1 or E2, which the verb does not ask for
    kept = _names(str(x) for x in (*asked.values(), *(options.get(name) for name in TEXTS)))
    values = unless_given(table.get("values", {}), names | (left - kept))
    return argparse.Namespace(**{**options, **asked, "values": [
        *(f"{name}={x}" for name, x in values.items()), *given.values]})


def asked_of(given: argparse.Namespace, names: Collection[str]) -> Asked:
    """What the options ask, with the body to which the names belong."""
    texts: dict[str, Any] = {entry.name: getattr(given, entry.name, None) for entry in fields(Asked)}
    for name in REPEATED:
        texts[name] = None if texts[name] is None else tuple(texts[name])
    asked = Asked(**texts).of_body(names)
    settings = [text.partition("=")[::2] for text in getattr(given, "values", ())]
    not_mixed([*table_of(asked).quantities, *((name_of(name.strip()), x) for name, x in settings),
               *((_name(text), end) for text in _axes(given) for end in ends_of(text))])
    return asked


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
        raise PublishedError(f"{path}: has no scene {brief(name)[1:-1]}: name one of its scenes, {known}")
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


def _names(texts: Iterable[Any]) -> set[str]:
    """The names that occur in the texts."""
    return {name for text in texts for name in names_in(text_of(text))}


def _axes(given: argparse.Namespace) -> list[str]:
    """The texts of the axes."""
    texts = [getattr(given, "x", None), getattr(given, "y", None), *(getattr(given, "axis", None) or ())]
    return [text for text in texts if text is not None]


def _name(text: str) -> str:
    """The name of an axis."""
    return name_of(text.partition("=")[0].strip())
