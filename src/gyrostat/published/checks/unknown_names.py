"""Finds the unknown names in the statements of a source, and refuses them all at once."""
from collections.abc import Iterator, Set
from difflib import get_close_matches

from ...errors import GyrostatError, PublishedError
from ..language import unknown_names
from ..names.derived_names import names
from ..scenes import Scene
from ..sources import COMPUTING, Source, first_of
from ..statements import Statement
from .comparisons import NEVER, sides_of

FORMULAS = ("identity", "family", "number")            # kinds of which the quantity is a formula
PRINTED = ("identity", "family", "equilibrium", "solution")                 # and what is printed


def refuse_unknown_names(source: Source) -> None:
    """Raise PublishedError if a statement has an unknown name, with every such name of the source.

    A scene that cannot be built is passed over: its own fault is named when its statements are checked.
    """
    names_by_scene = dict[int, frozenset[str]]()
    affected = set[int]()                              # scenes of statements with an unknown name
    keys, hints = dict[str, list[str]](), dict[str, str]()
    for s in source.statements:
        if id(s.scene) not in names_by_scene:
            names_by_scene[id(s.scene)] = _names_of(s.scene)
        known = names_by_scene[id(s.scene)]
        for name in dict.fromkeys(_unknown(s, known)) if known else ():
            keys.setdefault(name, []).append(s.key)
            hints.setdefault(name, _hint(name, s, known))
            affected.add(id(s.scene))
    if not keys:
        return
    listed = first_of([f"{name} in {first_of(where, 5, ', ')}{hints[name]}" for name, where in keys.items()])
    example = next((name for name in keys if not hints[name]), next(iter(keys)))
    page = "docs/reference/published.md lists the names of each kind of scene"
    offered = page if len(affected) > 1 else (
        "the names of the scene are " + ", ".join(sorted(names_by_scene[affected.pop()])))
    raise PublishedError(
        f"{source.statements[0].file}: unknown names: {listed}: a statement has the names of its scene and "
        f'its own abbreviations: correct the names, define abbreviations, let = {{ {example} = "…" }}, or '
        f'declare letters of the scene, parameters = ["{example}"]; {offered}')


def _hint(name: str, s: Statement, known: frozenset[str]) -> str:
    """What an unknown name may be; "" if nothing is like it."""
    if name in s.let:
        return " (an abbreviation that is read later: first given and at, then let in its order)"
    if name == "l" and "gyrostatic_momentum" not in s.scene.table:
        return ' (the scene has no rotor: gyrostatic_momentum = ["0", "0", "l"])'
    near = get_close_matches(name, sorted(known | s.let.keys()), 1)
    return f" (did you mean {near[0]}?)" if near else ""


def _names_of(scene: Scene) -> frozenset[str]:
    """The names of a scene; none if it cannot be built."""
    try:
        return frozenset(names(scene, {}))
    except (GyrostatError, *COMPUTING):
        return frozenset()


def _unknown(s: Statement, of_scene: frozenset[str]) -> Iterator[str]:
    """The unknown names of a statement, as often as they stand in it."""
    for text in (*s.at, *s.at.values()):
        yield from unknown_names(text, of_scene)
    for text in (s.scene.table.get("given", ""), s.given):
        yield from _in_condition(text, of_scene)
    own = set(of_scene)
    for name, text in s.let.items():
        yield from unknown_names(text, own)
        own.add(name)
    claimed = [text for text in (s.printed, s.corrected) if text is not None]
    for text in _texts([*([s.quantity] if s.kind in FORMULAS else []),
                        *(claimed if s.kind in PRINTED else [])]):
        yield from unknown_names(text, own)
    for text in _texts(claimed if s.kind == "condition" else []):
        yield from _in_condition(text, own)


def _in_condition(text: str, known: Set[str]) -> Iterator[str]:
    """The unknown names between the signs of a condition, which may be that something holds never."""
    for sides, _ in sides_of(text) if text != NEVER else ():
        for side in sides:
            yield from unknown_names(side, known | {"abs"})


def _texts(value: object) -> Iterator[str]:
    """The texts in a list of lists, or a text alone."""
    if isinstance(value, list):
        for entry in value:
            yield from _texts(entry)
    elif isinstance(value, str):
        yield value
