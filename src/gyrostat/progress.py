"""A bar on standard error while something long is under way."""
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from time import monotonic

Told = Callable[[int, int], object]                        # is called with what is done, and with all there is

WIDTH, PAUSE = 30, 0.1                                     # characters of a bar; seconds from one to the next


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


@contextmanager
def telling(progress: Told | bool | None, name: str) -> Iterator[Told]:
    """What to call as work goes on: the function given, nothing for False, else a bar on a terminal, wiped at the end."""
    bar = Progress(progress is not False)
    try:
        yield progress if callable(progress) else partial(bar.show, name)
    finally:
        bar.wipe()
