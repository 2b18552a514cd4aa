"""Reads files and lines from outside, and refuses first what would make their parsers slow or deep."""
import json
import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, NoReturn

from ...errors import GyrostatError, PublishedError, ValuesError, brief, printable
from .spelling import character, spelled

# bytes of a file of formulas and of a line of numbers; characters of a name
FILE, LINE, NAME = 500_000, 100_000, 60
# of brackets, on a line, outside of texts; characters of a number or key
DEPTH, DOTS, WORD = 20, 16, 200
_TEXTS = re.compile(r'"""(?:\\.|[^\\])*?"""' r"|'''.*?'''" r'|"(?:\\.|[^"\\\n])*"' r"|'[^'\n]*'|#[^\n]*",
                    re.DOTALL)


@dataclass(frozen=True)
class Written:
    """A number with a point or an exponent in a TOML file, as it is written there: no float is made of it."""

    text: str

    def __repr__(self) -> str:
        return self.text


@lru_cache(maxsize=512)
def name_of(text: str) -> str:
    """Return the name of a parameter that a text is, in ASCII, π₃⁰ as pi3_0; "" if it is none."""
    return spelled(text) if len(text) <= NAME else ""


def unknown_letter(text: str) -> str:
    """Return what to say about the first letter of a name that no name has; "" if there is none."""
    strange = [c for c in text if c.isalpha() and not c.isascii() and not spelled(c)]
    return f", {character(strange[0])} is in no name" if strange else ""


def is_name(text: str) -> bool:
    """Tell whether a text is the name of a parameter, in ASCII."""
    return text != "" and name_of(text) == text


def toml_of(path: Path | Traversable) -> dict[str, Any]:
    """Return the tables of a TOML file.

    Raises
    ------
    PublishedError
        it cannot be read, is not TOML, or is larger, deeper or longer-worded than a file of formulas can be
    """
    try:
        with path.open("rb") as file:
            data = file.read(FILE + 1)
        text = data.decode("utf-8-sig")
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or getattr(error, "reason", None) or str(error)
        todo = "give a text file in UTF-8" if isinstance(error, UnicodeError) else "check the path"
        raise PublishedError(f"{path}: cannot be read ({why}): {todo}") from None
    if len(data) > FILE:
        raise PublishedError(f"{path}: is longer than {FILE} bytes: split it into several files")
    bare, depth = _TEXTS.sub('""', text), 0
    for bracket in re.findall(r"[\[\]{}]", bare):
        if (depth := depth + (1 if bracket in "[{" else -1)) > DEPTH:
            raise PublishedError(f"{path}: its brackets are nested more than {DEPTH} deep: formulas are "
                                 "texts, or lists of lists of them")
    if any(line.count(".") > DOTS for line in bare.splitlines()):
        raise PublishedError(f"{path}: a line has more than {DOTS} dots outside of quotation marks: write "
                             "[scene.NAME] and key = \"…\"")
    if long := re.search(rf"[\w+-]{{{WORD}}}", bare):
        raise PublishedError(f"{path}: {brief(long[0])} is longer than {WORD} characters: write a text in "
                             "quotation marks")
    try:
        tables = tomllib.loads(text.replace("\r\n", "\n"), parse_float=_written)
    except (ValueError, RecursionError) as error:      # a TOMLDecodeError is one
        raise PublishedError(f"{path}: is not TOML: {error}") from None
    if steering := next((text for text in _texts(tables) if printable(text) != text), None):
        raise PublishedError(f"{path}: {brief(steering)} holds a control character: leave it out")
    return tables


def _written(number: str) -> Written:
    """Return a number of TOML, without the _ between its digits."""
    if not any(map(str.isdigit, number)):
        raise ValueError(f"{number} is not a number: give a finite number")
    return Written(number.replace("_", ""))


def _texts(value: Any) -> Iterator[str]:
    """Yield all keys and texts."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        yield from value
        for inner in value.values():
            yield from _texts(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from _texts(inner)


def json_object(line: bytes) -> dict[str, Any]:
    """Return the object of a line, its numbers as the text that they are written as.

    Raises
    ------
    ValuesError
        it is not one JSON object of numbers and texts, each name given once
    """
    if len(line) > LINE:
        raise ValuesError(f"it is not JSON of less than {LINE} bytes: an object has a few names and "
                          f"numbers, {{\"I1\": 1.6}}")
    if _brackets(line) > DEPTH and _brackets(re.sub(rb'"(?:\\.|[^"\\])*"', b"", line)) > DEPTH:
        raise ValuesError("it is not JSON of numbers alone, but has lists or objects in it: write an "
                          "object, {\"I1\": 1.6}")
    try:
        own = _JSON.decode(line.decode(json.detect_encoding(line), "surrogatepass"))
    except GyrostatError:
        raise
    except json.JSONDecodeError as error:
        raise ValuesError(f"it is not JSON: {error.msg} at character {error.pos + 1}; write an object, "
                          f"{{\"I1\": 1.6}}") from None
    except (ValueError, RecursionError) as error:
        raise ValuesError(f"it is not JSON: {error}") from None
    if not isinstance(own, dict):
        raise ValuesError(f"it is not an object: write {{\"I1\": 1.6}}, not "
                          f"{printable(line[:20].decode(errors='replace').strip())}")
    return own


def _brackets(line: bytes) -> int:
    return line.count(b"[") + line.count(b"{")


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    own: dict[str, Any] = {}
    for name, value in pairs:
        if name in own:
            raise ValuesError(f"{brief(name)[1:-1]} is given twice: give it once")
        own[name] = value
    return own


def _refused(constant: str) -> NoReturn:
    raise ValuesError(f"{constant} is not a number: give a finite number")


# json.loads makes a decoder for each line
_JSON = json.JSONDecoder(object_pairs_hook=_once, parse_float=str, parse_int=str, parse_constant=_refused)
