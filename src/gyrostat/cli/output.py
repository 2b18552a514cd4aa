"""Where a verb writes its results: standard output, or a file of a kind that is that of its name."""
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, TextIO

from ..errors import ValuesError, optional

PICTURES, FILMS = (".png", ".pdf", ".svg"), (".gif", ".mp4")
EXTRAS = dict.fromkeys((*PICTURES, *FILMS), ("matplotlib", "plot")) | {".nc": ("netCDF4", "charts")}


class Output:
    """Standard output, in UTF-8 where its own encoding has no λ; or a file, opened when the first text is there."""

    def __init__(self, path: str | None):
        self.path = path
        self.file: TextIO | None = None

    @property
    def on_terminal(self) -> bool:
        return self.path is None and sys.stdout.isatty()

    def __call__(self, text: str) -> None:
        """Write the text, at once."""
        if self.path is not None:
            self.file = self.file or open(self.path, "w", encoding="utf-8")  # noqa: SIM115 (close closes it)
            print(text, end="", flush=True, file=self.file)
            return
        try:
            text.encode(sys.stdout.encoding or "utf-8")
        except UnicodeEncodeError:
            sys.stdout.reconfigure(encoding="utf-8")  # type: ignore[union-attr]
        print(text, end="", flush=True)

    def close(self) -> None:
        if self.file:
            self.file.close()


def file_of(out: Output, what: str, kinds: Sequence[str], names: str) -> Path:
    """The file to write, of a kind that there is, and its packages."""
    if out.path is None:
        raise ValuesError(f"--output is missing, a {what} goes to a file: name {names}")
    path = Path(out.path)
    if path.suffix not in kinds:
        raise ValuesError(f"--output {path} is of no kind that is written: name {names}")
    if path.suffix in EXTRAS:
        optional(*EXTRAS[path.suffix])
    path.parent.stat()                                 # raises OSError where there is no such folder
    return path


def save_picture(figure: Any, path: Path) -> None:
    """Write a Matplotlib figure, as large as what is on it."""
    figure.savefig(path, dpi=200, bbox_inches="tight")
