"""gyrostat decide --batch: a decision for each line of a file, as it is read."""
import argparse
import contextlib
import json
import os
import stat
import sys
from collections.abc import Iterator, Mapping
from typing import Any, BinaryIO, NoReturn

from sympy import Expr

from ..errors import GyrostatError, ValuesError
from ..expressions import exact_number
from ..progress import Progress
from .decide import answers_at, answers_data
from .output import Output
from .scenes import LABELS, numbers_of, one_spin, scene_of

SPINS = {"pi3_0", "omega3_0"}


def run(given: argparse.Namespace, out: Output) -> int:
    """Write an object for each line, in order; 0, or 2 if a line was bad."""
    defaults = numbers_of(given.values)
    scene_of(given.potential)                          # a wrong one would be wrong in every line
    if given.format != "json" and given.format is not None:
        raise ValuesError(f"--batch writes JSON, --format is {given.format}: leave out one of the two")
    status, progress = 0, Progress(not out.on_terminal)
    with _opened(given.batch, given.output) as file:
        details = os.fstat(file.fileno()) if file is not sys.stdin.buffer else None
        total, read = details.st_size if details and stat.S_ISREG(details.st_mode) else None, 0
        out("")
        for n, line in enumerate(file, 1):
            read += len(line)
            if line.strip():
                result: dict[str, Any] = {"line": n}
                try:
                    result |= answers_data(answers_at(*_question(line, given, defaults)))
                except GyrostatError as error:
                    status = 2
                    result["error"] = str(error)
                    progress.wipe()
                    print(f"gyrostat: line {n}: {error}", file=sys.stderr)
                out(json.dumps(result) + "\n")
            progress.show("decide", n if total is None else read, total)
    progress.wipe()
    return status


@contextlib.contextmanager
def _opened(path: str, output: str | None) -> Iterator[BinaryIO]:
    """The lines, of a file or of standard input."""
    if path == "-":
        yield sys.stdin.buffer
        return
    if output is not None and os.path.exists(path) and os.path.exists(output) and os.path.samefile(path, output):
        raise ValuesError(f"--batch and --output are the same file, {path}: write to another one")
    with contextlib.ExitStack() as stack:
        try:
            file = stack.enter_context(open(path, "rb"))
        except OSError as error:
            raise ValuesError(f"cannot read {path}: {error.strerror}") from None
        yield file


def _question(line: bytes, given: argparse.Namespace, defaults: Mapping[str, Expr]) -> tuple[str | None, str | None, dict[str, Expr]]:
    """Potential, equilibrium and numbers of a line."""
    own = _object(line)
    potential, label = own.pop("potential", given.potential), own.pop("equilibrium", given.equilibrium)
    if not isinstance(potential, str | None) or label not in (None, *LABELS):
        raise ValuesError(f"potential = {potential!r}, equilibrium = {label!r}: a potential is a text in the grammar of --potential, an "
                          f"equilibrium one of {', '.join(LABELS)}")
    if wrong := [name for name in own if not name.isidentifier()]:
        raise ValuesError(f"{wrong[0]!r} is not a name: write {{\"I1\": 1.6}}")
    numbers = {name: exact_number(value, name) for name, value in own.items()}
    one_spin(numbers)
    kept = {name: x for name, x in defaults.items() if not (name in SPINS and SPINS & numbers.keys())}
    return potential, label, kept | numbers


def _object(line: bytes) -> dict[str, Any]:
    """The object of a line, its numbers as the text that they are written as."""
    try:
        own = json.loads(line, object_pairs_hook=_once, parse_float=str, parse_int=str, parse_constant=_refused)
    except GyrostatError:
        raise
    except json.JSONDecodeError as error:
        raise ValuesError(f"it is not JSON: {error.msg} at character {error.pos + 1}; write an object, {{\"I1\": 1.6}}") from None
    except (UnicodeDecodeError, RecursionError) as error:
        raise ValuesError(f"it is not JSON: {error}") from None
    if not isinstance(own, dict):
        raise ValuesError(f"it is not an object: write {{\"I1\": 1.6}}, not {line[:20].decode(errors='replace').strip()}")
    return own


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    own = dict(pairs)
    if len(own) < len(pairs):
        names = [name for name, _ in pairs]
        raise ValuesError(f"{next(name for name in names if names.count(name) > 1)} is given twice: give it once")
    return own


def _refused(constant: str) -> NoReturn:
    raise ValuesError(f"{constant} is not a number: give a finite number")
