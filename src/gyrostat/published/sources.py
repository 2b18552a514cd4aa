"""Reads files of published formulas, exactly as they are printed, and checks their format."""
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any

from ..algebra.text.inputs import is_name, toml_of
from ..arguments import checked
from ..errors import GyrostatError, PublishedError, article, brief
from ..mechanics.families.scene_tables import scene_tables
from .scenes import Scene
from .statements import KINDS, Statement

SOURCES = ("VV2003", "N2025", "EA", "AR", "literature", "windows", "satellites")
_HERE = resources.files(__package__)                     # a folder, or part of an archive
MOST = 40                                              # abbreviations, values or constants of a formula
_REQUIRED = ("key", "where", "quantity", "printed", "kind")
_OPTIONAL: Mapping[str, Any] = {"scene": str, "note": str, "let": dict, "at": dict, "given": str,
                                "constants": list, "corrected": (str, list)}
COMPUTING = (ArithmeticError, AttributeError, LookupError, NotImplementedError, RecursionError, TypeError,
             ValueError)


@dataclass(frozen=True)
class Source:
    """One file of published formulas.

    Parameters
    ----------
    name, title : str
    statements : tuple of Statement
    expected : mapping of key to status
        "misprint" or "unchecked"; everything else is expected to be confirmed
    expects : bool
        whether the file says what is expected; one of your own does if it has a table [expected]

    Examples
    --------
    >>> import gyrostat as gs
    >>> source = gs.published.load("AR")
    >>> source.name, len(source.statements), source.expected["2K-dot"]
    ('AR', 46, 'misprint')
    """

    name: str
    title: str
    statements: tuple[Statement, ...]
    expected: Mapping[str, str] = field(hash=False)
    expects: bool = True


@checked
def load(source: str | Path) -> Source:
    """Load the statements of a source, by its name or by the path of a TOML file.

    Parameters
    ----------
    source : str or Path
        VV2003, N2025, EA, AR, literature, windows, satellites; or a path ending in .toml

    Returns
    -------
    Source

    Raises
    ------
    PublishedError
        there is no such source, or the file does not follow the format; the message names file and key

    Examples
    --------
    >>> import gyrostat as gs
    >>> statement = gs.published.load("VV2003").statements[0]
    >>> statement.kind, statement.where
    ('equilibrium', '§1, first display')
    """
    if str(source) in SOURCES:
        return _own(str(source))
    path = Path(source)
    if path.suffix != ".toml":
        raise PublishedError(f"{source} is not a source: give {', '.join(SOURCES)}, or the path of a .toml "
                             "file")
    return _read(path, None)


@cache
def _own(name: str) -> Source:
    expected = toml_of(_HERE / "expected.toml")
    return _read(_HERE / f"{name}.toml", expected.get(name, {}))


def _read(path: Path | Traversable, expected: Mapping[str, Any] | None) -> Source:
    data = toml_of(path)
    header = data.get("source")
    if not isinstance(header, dict) or not all(isinstance(header.get(field), str)
                                               for field in ("name", "title")):
        raise PublishedError(f"{path}: has no [source] table with name and title: "
                             "docs/reference/published.md has an example")
    if unknown := set(data) - {"source", "scene", "formula", "expected"}:
        raise PublishedError(f"{path}: has the unknown tables {', '.join(sorted(unknown))}: a file has "
                             "source, scene, formula, expected")
    tables, listed, status = scene_tables(data, path), data.get("formula", []), data.get("expected", {})
    if (
        not isinstance(listed, list)
        or not all(isinstance(entry, dict) for entry in listed)
        or not isinstance(status, dict)
    ):
        raise PublishedError(f"{path}: formulas are [[formula]] tables, and one [expected] table "
                             "says what is expected: see docs/reference/published.md")
    scenes, faults = {"": Scene()}, list[str]()
    for name, entries in tables.items():
        try:
            with _at(path, f"scene.{name}"):
                scenes[name] = Scene(entries)
        except PublishedError as error:
            faults.append(str(error).removeprefix(f"{path}: "))
    for entry in listed:
        key = brief(str(entry.get("key", "a formula without a key")))[1:-1]
        faults += [f"{key}: {fault}" for fault in _faults(entry, header, ("", *tables))]
    if faults:
        raise PublishedError(f"{path}: {first_of(faults)}")
    statements = [_statement(path, header, scenes, entry) for entry in listed]
    keys = [s.key for s in statements]
    if twice := {key for key, times in Counter(keys).items() if times > 1}:
        raise PublishedError(f"{path}: the keys {', '.join(sorted(twice))} occur twice: give each formula "
                             "its own")
    table = status if expected is None else expected
    if not set(table) <= {"misprint", "unchecked"} or not all(
            isinstance(keys, list) and all(isinstance(key, str) for key in keys) for keys in table.values()):
        raise PublishedError(f"{path}: expected has lists of keys under misprint and unchecked, and "
                             "nothing else")
    status = {key: name for name in ("misprint", "unchecked") for key in table.get(name, ())}
    if unknown := set(status) - set(keys):
        raise PublishedError(f"{path}: a status is expected of {', '.join(sorted(unknown))}, but there is "
                             "no such key")
    return Source(header["name"], header["title"], tuple(statements), status,
                  expected is not None or "expected" in data)


def first_of(texts: Sequence[str], most: int = 20, sign: str = "; ") -> str:
    """Return the first of the texts in a row, and how many there are besides."""
    return sign.join([*texts[:most], *([f"and {len(texts) - most} more"] if len(texts) > most else [])])


@contextmanager
def _at(path: Path | Traversable, key: str) -> Iterator[None]:
    """Name in each error the file and the key to which it belongs."""
    try:
        yield
    except GyrostatError as error:
        raise PublishedError(f"{path}: {brief(key)[1:-1]}: {error}") from None
    except COMPUTING as error:
        why = f"it cannot be computed ({brief(str(error))}): simplify it"
        raise PublishedError(f"{path}: {brief(key)[1:-1]}: {why}") from error


def _texts(value: Any) -> bool:
    """Return whether a value is a text, a table of texts, or a list of texts or of lists of texts."""
    if isinstance(value, dict):
        return all(isinstance(text, str) for text in value.values())
    if isinstance(value, list):
        return all(isinstance(x, str) or isinstance(x, list) and all(isinstance(y, str) for y in x)
                   for x in value)
    return isinstance(value, str)


def _faults(entry: Mapping[str, Any], header: Mapping[str, Any], scenes: Collection[str]) -> Iterator[str]:
    """Yield what is wrong with the entries of a formula, each fault with what to do."""
    if missing := [field for field in _REQUIRED if field not in entry]:
        yield f"lacks {', '.join(missing)}: a formula has {', '.join(_REQUIRED)}"
    if unknown := [field for field in entry if field not in _REQUIRED and field not in _OPTIONAL]:
        yield f"has the unknown entry {', '.join(unknown)}: there are {', '.join((*_REQUIRED, *_OPTIONAL))}"
    right = {name: value for name, value in entry.items() if _is_of_its_type(name, value)}
    for name in (name for name in entry if name not in right):
        yield (f"{name} = {brief(entry[name])} is {article(type(entry[name]))}: write it as in the example "
               "of docs/reference/published.md")
    if not right.get("key", "").isprintable():
        yield "key has more than one line: write a name"
    if right.get("kind", KINDS[0]) not in KINDS:
        yield f"kind = {brief(right['kind'])}: the kinds are {', '.join(KINDS)}"
    if not all(map(is_name, right.get("let", ()))):
        yield f"let = {brief(right['let'])}: abbreviations are names of letters, digits and _"
    if many := [field for field in ("let", "at", "constants") if len(right.get(field, ())) > MOST]:
        yield f"{', '.join(many)} has more than {MOST} entries: split the formula"
    scene = right.get("scene", header.get("scene", ""))
    if not isinstance(scene, str) or scene not in scenes:
        yield f"scene = {brief(scene)} is not in the file: its scenes are {', '.join(filter(None, scenes))}"


def _is_of_its_type(name: str, value: Any) -> bool:
    """Return whether the value of an entry is a text, a list or a table, as that entry has to be."""
    wanted = _OPTIONAL.get(name, (str, list) if name in ("quantity", "printed") else str)
    return name not in (*_REQUIRED, *_OPTIONAL) or isinstance(value, wanted) and _texts(value)


def _statement(path: Path | Traversable, header: Mapping[str, Any], scenes: Mapping[str, Scene],
               entry: Mapping[str, Any]) -> Statement:
    name = entry.get("scene", header.get("scene", ""))
    fields = {**entry, "scene": scenes[name], "constants": tuple(entry.get("constants", ()))}
    return Statement(source=header["name"], file=str(path), **fields)
