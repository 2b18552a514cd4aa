"""Writes the results of a verb to standard output, or to a file whose suffix says its kind."""
import argparse
import errno
import os
import re
import shutil
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from importlib.resources import as_file, files
from io import TextIOWrapper
from pathlib import Path
from textwrap import wrap
from types import MappingProxyType
from typing import Any, TextIO

from ..charts import progress
from ..errors import ValuesError, needed
from ..printing.files import written

PICTURES, FILMS = (".png", ".jpg", ".svg", ".pdf"), (".gif", ".mp4")
FORMATS = tuple(kind.removeprefix(".") for kind in PICTURES)
WIDTH_IN, DPI = 3.4, 300                               # inches of a printed column; dots per inch
UNITS = {"in": 1.0, "mm": 1 / 25.4, "cm": 1 / 2.54}
LEAST, WIDEST, FEWEST, FINEST = 1.0, 40.0, 20, 2400    # inches; dots per inch
MARGIN = 0.05                                          # inches above and below what is on a picture
# the modules of each kind of file, and the extras that bring them
EXTRAS = {**dict.fromkeys((*PICTURES, *FILMS), {"matplotlib": "plot"}),
          ".nc": {"xarray": "charts", "netCDF4": "charts"}, ".zarr": {"zarr": "charts", "dask": "charts"}}


NARROWEST, WIDTH = 60, 100                             # columns of a text; of one that goes to no terminal
BESIDE = 12                                            # columns of the names beside facts


class Output:
    """Standard output, or a file that is there when all of it is written."""

    def __init__(self, path: str | None):
        self.path = path
        self.file: TextIO | None = None
        self.stack = ExitStack()

    def __enter__(self) -> "Output":
        return self

    def __exit__(self, *error: Any) -> None:
        self.stack.__exit__(*error)

    def __call__(self, text: str) -> None:
        """Write the text; to standard output at once."""
        if self.path is None:
            printed(text)
            return
        if self.file is None:
            new = self.stack.enter_context(written(self.path))
            self.file = self.stack.enter_context(open(new, "w", encoding="utf-8"))  # noqa: SIM115
        self.file.write(text)

    @property
    def width(self) -> int:
        """The columns of a text: 100 in a file, otherwise those of standard output."""
        return columns() if self.path is None else WIDTH

    def noted(self, note: str) -> None:
        """Write what is unusual, if anything, to standard error: a picture has no place for it."""
        if note:
            print(fact("note", note), file=sys.stderr)


def columns() -> int:
    """The columns of whatever is printed: COLUMNS if it is set, those of the terminal, or 100 in a pipe."""
    return _shown_on(on_terminal()) or WIDTH


def _shown_on(terminal: bool) -> int:
    """The columns of a terminal, or COLUMNS if it is set; 0 for a pipe without COLUMNS."""
    if not (terminal or os.environ.get("COLUMNS")):
        return 0
    return max(NARROWEST, shutil.get_terminal_size().columns)


def fact(name: str, text: str) -> str:
    """A line of standard error, the text beside its name."""
    return fitted(f"{name:<{BESIDE}}{text}", " " * BESIDE)


def fitted(line: str, indent: str) -> str:
    """The line in the columns of a terminal; in a file it stays one line, as a record of a log."""
    if not (width := _shown_on(progress.on_terminal())):
        return line
    return "\n".join(wrap(line, width, subsequent_indent=indent, break_long_words=False,
                          break_on_hyphens=False))


@contextmanager
def standard_streams() -> Iterator[None]:
    """Open the null device for each closed stream, so that no file gets its number.

    A character of a help text that the terminal cannot show becomes a question mark.
    """
    for number in (0, 1, 2):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)             # the lowest number that is free
    if isinstance(sys.stdout, TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")
    try:
        yield
    finally:
        try:
            if sys.stdout is not None:
                sys.stdout.flush()
        except OSError as error:                       # of a help text, what a verb writes is flushed at once
            silenced()
            if not isinstance(error, BrokenPipeError):
                told(f"cannot write to standard output: {error.strerror}")
                sys.exit(2)


def on_terminal() -> bool:
    """Whether standard output is a terminal."""
    return sys.stdout is not None and sys.stdout.isatty()


def printed(text: str) -> None:
    """Write to standard output at once, in UTF-8 where its own encoding has no λ."""
    if sys.stdout is None:
        raise OSError(errno.EBADF, "it is closed")
    try:
        text.encode(sys.stdout.encoding or "utf-8")
    except UnicodeEncodeError:
        sys.stdout.reconfigure(encoding="utf-8")  # type: ignore[union-attr]
    progress.taken()
    print(text, end="", flush=True)


def internal(error: BaseException, most: int) -> str:
    """The name of an error that is a bug, with so many characters of its text."""
    text = " ".join(str(error).split())[:most]
    name = f"internal error, {type(error).__name__}"
    return f"{name}: {text}" if text else name


def told(text: str) -> None:
    """Write a line to standard error, if that can be written, without what a terminal would obey."""
    text = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in " ".join(text.split()))
    progress.taken()
    if sys.stderr is not None:
        with suppress(OSError, ValueError):
            print(fitted(f"gyrostat: {text}", "  "), file=sys.stderr, flush=True)


def silenced() -> None:
    """Discard what goes to standard output, which cannot be written, and what is still held back."""
    with suppress(OSError, ValueError, AttributeError):    # there is none, or it is no file
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def file_of(out: Output, what: str, kinds: Sequence[str], names: str,
            extras: Mapping[str, str] = MappingProxyType({})) -> Path:
    """The file to write, if its suffix is known and the packages that it needs are installed."""
    if out.path is None:
        raise ValuesError(f"--output is missing, and a {what} is written to a file: name {names}")
    path = Path(out.path)
    if path.suffix not in kinds:
        raise ValuesError(f"--output {path} has none of the suffixes that are known here: name {names}")
    needed({**extras, **EXTRAS.get(path.suffix, {})})
    path.parent.stat()                                 # raises OSError where there is no such folder
    return path


@contextmanager
def printed_look() -> Iterator[None]:
    """Draw pictures with the letters, sizes and lines of a paper."""
    from matplotlib import style
    # in an archive, too, where Matplotlib does not find it by its name
    with as_file(files("gyrostat.plotting") / "paper.mplstyle") as path, style.context(path):
        yield


def save_picture(figure: Any, path: Path, kind: str | None = None, dpi: int = DPI) -> None:
    """Write a Matplotlib figure: exactly as wide as it is, and as high as what is on it.

    Default of the kind: the suffix of the path.
    """
    from matplotlib.transforms import Bbox
    figure.draw_without_rendering()
    drawn, width = figure.get_tightbbox(), figure.get_size_inches()[0]
    left = 0.0 if 0 <= drawn.x0 and drawn.x1 <= width else (drawn.x0 + drawn.x1 - width) / 2
    box = Bbox([[left, drawn.y0 - MARGIN], [left + width, drawn.y1 + MARGIN]])
    with written(path) as new:
        figure.savefig(new, format=kind or path.suffix.removeprefix("."), dpi=dpi, bbox_inches=box)


def picture_options(verb: argparse.ArgumentParser) -> None:
    """Add the options of a file with a picture."""
    verb.add_argument("--output", metavar="FILE", help="write to a .png, .jpg, .svg or .pdf")
    verb.add_argument("--format", choices=FORMATS,
                      help="the kind of the file; default: that of its name")
    look_options(verb)


def look_options(verb: argparse.ArgumentParser) -> None:
    """Add the options of how a picture looks: its width, its dots per inch, and whether it has a title."""
    verb.add_argument("--width", type=_inches, default=WIDTH_IN, metavar="WIDTH",
                      help=f"the width in inches, or with its unit: 3.4, 86mm, 8.6cm; default {WIDTH_IN} in")
    verb.add_argument("--dpi", type=_dots, default=DPI, metavar="N",
                      help=f"dots per inch of .png and .jpg; default {DPI}")
    verb.add_argument("--no-title", action="store_false", dest="title",
                      help="write no title; in Python caption(ax) gives its text for a paper")


def _inches(text: str) -> float:
    """A width in inches."""
    found = re.fullmatch(r"(\d+(?:\.\d*)?|\.\d+) *(in|mm|cm)?", text.strip())
    width = float(found[1]) * UNITS[found[2] or "in"] if found else 0.0
    if not LEAST <= width <= WIDEST:
        raise argparse.ArgumentTypeError(f"{text} is no width: give {LEAST:g} to {WIDEST:g} inches, or the "
                                         "same in mm or cm, as 3.4, 86mm, 8.6cm")
    return width


def _dots(text: str) -> int:
    """Dots per inch."""
    if not re.fullmatch(r"[0-9]{1,4}", text) or not FEWEST <= int(text) <= FINEST:
        raise argparse.ArgumentTypeError(f"{text} is no number of dots per inch: give a whole number, "
                                         f"{FEWEST} to {FINEST}")
    return int(text)
