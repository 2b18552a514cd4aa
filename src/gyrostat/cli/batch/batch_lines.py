"""Reads the lines of a batch as they come, finds what each asks, and keeps the answers."""
import argparse
import contextlib
import os
import stat
import sys
from collections.abc import Iterator, Sequence
from functools import lru_cache, partial
from pathlib import Path
from typing import Any, BinaryIO

from sympy import Expr

from ...algebra.text.inputs import LINE, json_object, name_of
from ...algebra.text.numbers import exact_number
from ...errors import ValuesError, brief
from ...mechanics.families.named_families import called, in_words, known_families
from ...printing.files import moved, replaceable
from ...questions.given_numbers import numbers_of, one_spin, unless_given
from ...questions.scene_texts import Asked, scene_of
from ..options.scene_files import asked_of
from ..output import printed

READ = 2**18                                           # bytes that are read at a time
SCENES = 256                                           # that are kept, of lines that ask the same of them
Numbered = tuple[int, bytes]
# the number of a line, an object of JSON, and the reason if the line is not answered
Answer = tuple[int, bytes, str | None]


@contextlib.contextmanager
def opened(path: str, output: str | None) -> Iterator[BinaryIO]:
    """The lines, of a file or of standard input."""
    if path == "-":
        if sys.stdin is None:
            raise ValuesError("--batch - reads standard input, which is closed: give a file")
        yield sys.stdin.buffer
        return
    if (
        output is not None
        and os.path.exists(path)
        and os.path.exists(output)
        and os.path.samefile(path, output)
    ):
        raise ValuesError(f"--batch and --output are the same file, {path}, and it would be written while "
                          "it is read: give --output another file")
    with contextlib.ExitStack() as stack:
        try:
            file = stack.enter_context(open(path, "rb"))
        except OSError as error:
            raise ValuesError(f"cannot read {path}: {error.strerror}: check the path") from None
        yield file


def size_of(file: BinaryIO) -> int | None:
    """The size of a file in bytes; None if it is not known, as for a pipe."""
    try:
        details = os.fstat(file.fileno())
    except (OSError, ValueError):                      # no file of the system
        return None
    return details.st_size if stat.S_ISREG(details.st_mode) else None


def numbered(file: Any) -> Iterator[list[Numbered]]:
    """The lines with their numbers, from 1 on, as many at a time as there are without waiting.

    A line that is too long is cut.
    """
    n, parts, length = 1, list[bytes](), 0
    while data := _read(file):
        first, *rest = data.split(b"\n")
        parts, length = [*parts, first[:LINE + 1 - length]] if length <= LINE else parts, length + len(first)
        if not rest:
            continue
        whole = [b"".join(parts), *rest[:-1]]
        parts, length = [rest[-1]], len(rest[-1])
        yield list(enumerate(whole, n))
        n += len(whole)
    if length:
        yield [(n, b"".join(parts))]


def _read(file: Any) -> bytes:
    try:
        return bytes(file.read1(READ))
    except OSError as error:
        raise ValuesError(f"cannot read --batch: {error.strerror}") from None


class Questions:
    """What lines ask: scene, equilibrium and numbers of each, on top of what the options give.

    Parameters
    ----------
    given : argparse.Namespace
        of gyrostat decide
    """

    def __init__(self, given: argparse.Namespace):
        self.given, self.defaults = given, numbers_of(given.values)
        # the rule are lines that name the same equilibrium and give numbers to the same names
        self._family = lru_cache(maxsize=SCENES)(partial(called, families=known_families()))
        self._asked = lru_cache(maxsize=SCENES)(self._asked_by)
        scene_of(asked_of(given, self.defaults))       # a wrong one would be wrong in every line

    def of(self, line: bytes) -> tuple[Asked, str | None, dict[str, Expr]]:
        """Scene, equilibrium and numbers of a line."""
        own = json_object(line)
        named = "equilibrium" in own
        potential = own.pop("potential", self.given.potential)
        label = own.pop("equilibrium", self.given.equilibrium)
        family = self._family(label) if isinstance(label, str) else None
        if potential is not None and not isinstance(potential, str) or label is not None and family is None:
            raise ValuesError(f"the line has potential = {brief(potential)} and equilibrium = "
                              f"{brief(label)}, of which one is not understood: give a potential as a text, "
                              f"as of --potential, and the equilibrium as {in_words(known_families())}")
        if wrong := [name for name in own if not name_of(name)]:
            raise ValuesError(f"{brief(wrong[0])} is not a name, and a line gives numbers to names: write "
                              "{\"I1\": 1.6}")
        numbers = {name_of(name): exact_number(value, name) for name, value in own.items()}
        if len(numbers) < len(own):
            raise ValuesError(f"{brief(', '.join(own))[1:-1]} gives a name twice: give it once")
        one_spin(numbers)
        numbers = unless_given(self.defaults, numbers) | numbers
        asked = self._asked(potential, None if named else self.given.point, tuple(numbers))
        return asked, None if family is None else family.asked_for, numbers

    def _asked_by(self, potential: str | None, point: str | None, names: tuple[str, ...]) -> Asked:
        """What is asked if numbers are given for these names."""
        own_scene = argparse.Namespace(**{**vars(self.given), "potential": potential, "point": point})
        return asked_of(own_scene, names)


class Kept:
    """Writes answers as they come.

    They go to standard output, or to FILE.part, which takes the place of FILE when all are there.

    Parameters
    ----------
    path : str or None
        FILE; None for standard output
    start : int
        the first line; after 1 the answers of an interrupted batch are continued
    """

    def __init__(self, path: str | None, start: int):
        self.path, self.whole, self.last, self.length = path, True, start - 1, 0
        self.file: BinaryIO | None = None
        if path is None:
            return
        self.place = Path(os.path.realpath(path))
        self.whole = not replaceable(self.place)       # a pipe takes the lines itself
        self.part = self.place if self.whole else self.place.with_name(f"{self.place.name}.part")
        goes_on = start > 1 and not self.whole
        self.file = open(self.part, "ab" if goes_on else "wb")  # noqa: SIM115 (ended closes it)
        if not self.whole:
            self.length = self.file.tell()

    def __enter__(self) -> "Kept":
        return self

    def __exit__(self, *_: object) -> None:
        if self.file is not None:
            with contextlib.suppress(OSError):         # it was said when it was written
                self.file.close()

    def __call__(self, answers: Sequence[Answer]) -> None:
        """Keep some answers, at once."""
        data = b"".join(b"%b\n" % text for _, text, _ in answers)
        if self.file is None:
            printed(data.decode())
        else:
            self.file.write(data)
            self.file.flush()
        self.last, self.length = answers[-1][0], self.length + len(data)

    def ended(self) -> None:
        """Close the file: all lines are there, and FILE.part takes the place of FILE."""
        if self.file is not None:
            self.file.close()
            if not self.whole:
                moved(self.part, self.place)

    def until_now(self) -> str:
        """What is kept of a batch that is ended, whole lines, and how to go on."""
        if self.file is not None and not self.whole:
            with contextlib.suppress(OSError):         # what is written, but not yet counted
                os.ftruncate(self.file.fileno(), self.length)
            if not self.length:
                self.part.unlink(missing_ok=True)
        if not self.last:
            return "no line was answered"
        where = "written" if self.whole else f"in {self.path}.part"
        return (f"the answers up to line {self.last} are {where}; "
                f"the same command with --from {self.last + 1} goes on")
