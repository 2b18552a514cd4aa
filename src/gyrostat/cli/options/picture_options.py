"""How a picture is written: --format, --width, --dpi, --no-title."""
import argparse
from pathlib import Path
from typing import Any, NamedTuple

from ...errors import ValuesError
from ..output import FORMATS, PICTURES, WIDTH_IN, Output, file_of, save_picture

HEIGHT = 3.0                                           # inches of a picture of the default width
MOST = 12_000                                          # dots across; they are held in memory


class Form(NamedTuple):
    """The file of a picture: its place and kind, its width in inches, its dots an inch, and whether it has a
    title.
    """

    path: Path
    kind: str
    width: float
    dpi: int
    title: bool

    def figure(self) -> Any:
        """An empty figure of that width."""
        from matplotlib.figure import Figure
        return Figure(figsize=(self.width, self.width * HEIGHT / WIDTH_IN))

    def save(self, figure: Any) -> None:
        """Write the figure."""
        if not self.title:
            for ax in figure.axes:
                ax.set_title("")
        save_picture(figure, self.path, self.kind, self.dpi)


def form_of(given: argparse.Namespace, out: Output) -> Form:
    """How the picture is written, once it is known that it can be."""
    refuse_too_many_dots(given)
    name = Path(out.path or "").suffix.removeprefix(".")
    if given.format is None or out.path is None:
        path = file_of(out, "picture", PICTURES, f"{given.kind}.png, .jpg, .svg or .pdf")
        return Form(path, name, given.width, given.dpi, given.title)
    if name in FORMATS and name != given.format:
        raise ValuesError(f"--output {out.path} ends with .{name}, and --format is {given.format}: leave out "
                          "one of the two")
    path = file_of(out, "picture", (Path(out.path).suffix,), "a file", {"matplotlib": "plot"})
    return Form(path, given.format, given.width, given.dpi, given.title)


def refuse_too_many_dots(given: argparse.Namespace) -> None:
    """Raise ValuesError if the width and the dots per inch ask for more dots than a picture may have."""
    if (dots := round(given.width * given.dpi)) > MOST:
        raise ValuesError(f"--width {given.width:g} in at --dpi {given.dpi} is {dots} dots across: give a "
                          f"width and dpi of at most {MOST}")
