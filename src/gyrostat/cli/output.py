"""Where a verb writes: its results to a file or standard output, its progress to standard error."""
import sys
from time import monotonic
from typing import TextIO

WIDTH, PAUSE = 30, 0.1                                     # characters of a bar; seconds from one to the next


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


class Progress:
    """A line on a terminal, drawn again a few times a second and wiped at the end; nothing where there is no terminal."""

    def __init__(self, shown: bool = True):
        self.shown = shown and sys.stderr.isatty()
        self.length, self.next = 0, 0.0

    def show(self, name: str, done: int, total: int | None = None) -> None:
        """A bar, or a counter where the total is not known."""
        if not self.shown or monotonic() < self.next:
            return
        filled = WIDTH * done // total if total else 0
        line = f"{name:<12} [{'#' * filled}{'.' * (WIDTH - filled)}] {done}/{total}" if total else f"{name:<12} {done}"
        print("\r" + line.ljust(self.length), end="", file=sys.stderr, flush=True)
        self.length, self.next = len(line), monotonic() + PAUSE

    def wipe(self) -> None:
        """Nothing is left of it."""
        if self.length:
            print("\r" + " " * self.length + "\r", end="", file=sys.stderr, flush=True)
        self.length, self.next = 0, 0.0
