"""A bar on standard error while something long is under way."""
import mmap
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from time import monotonic

# is called with what is done, and with all there is
Told = Callable[[int, int], object]

WIDTH, PAUSE = 30, 0.1                                     # characters of a bar; seconds from one to the next
# seconds until anything is drawn: shorter work needs no bar
QUIET = 2.0
# one byte that a process shares with the one that waits for it: whether the one that works has the terminal
_shared: list[mmap.mmap] = []


class Progress:
    """A line on a terminal or below a cell of a notebook, for work that takes longer than some seconds.

    It is drawn again a few times a second, and wiped at the end.
    """

    def __init__(self, shown: bool = True):
        self.shown = shown and (on_terminal() or in_notebook())
        self.length, self.next = 0, monotonic() + QUIET

    def show(self, name: str, done: int, total: int | None = None) -> None:
        """Draw a bar, or a counter if the total is not known."""
        if not self.shown or monotonic() < self.next:
            return
        taken()
        if total:
            filled = WIDTH * done // total
            self.draw(f"{name:<12} [{'#' * filled}{'.' * (WIDTH - filled)}] {done}/{total}")
        else:
            self.draw(f"{name:<12} {done}")
        self.next = monotonic() + PAUSE

    def draw(self, line: str) -> None:
        """Draw the line in the place of the one before."""
        print("\r" + line.ljust(self.length), end="", file=sys.stderr, flush=True)
        self.length = len(line)

    def wipe(self) -> None:
        """Wipe the line, so that nothing is left of it."""
        if self.length:
            print("\r" + " " * self.length + "\r", end="", file=sys.stderr, flush=True)
        self.length, self.next = 0, 0.0


class Waiting(Progress):
    """The line of a process that waits for another: how long that one has been working.

    It is drawn until the other process takes the terminal for itself.
    """

    def __init__(self, name: str) -> None:
        super().__init__()
        self.name, self.begin = name, monotonic()
        _shared[:] = [mmap.mmap(-1, 1)]

    def tick(self) -> None:
        """Draw the line, if it is time for it."""
        if self.shown and not _shared[0][0] and (passed := monotonic() - self.begin) >= QUIET:
            self.draw(f"{self.name}: still working, {passed:.0f} s, Ctrl-C ends it")

    def wipe(self) -> None:
        if not _shared[0][0]:
            super().wipe()


def on_terminal() -> bool:
    """Tell whether standard error is a terminal."""
    return sys.stderr is not None and sys.stderr.isatty()


def in_notebook() -> bool:
    """Tell whether standard error is shown below a cell of a notebook."""
    return type(sys.stderr).__module__ == "ipykernel.iostream"


def taken() -> None:
    """Take the terminal for this process: the line of the one that waits for it is wiped."""
    if _shared and not _shared[0][0]:
        _shared[0][0] = 1
        if on_terminal():
            print("\r" + " " * 60 + "\r", end="", file=sys.stderr, flush=True)


@contextmanager
def telling(progress: Told | bool | None, name: str) -> Iterator[Told]:
    """Yield what to call as work goes on.

    It is the function given, or a bar, wiped at the end; if progress is False, it draws nothing.
    """
    bar = Progress(progress is not False)
    try:
        yield progress if callable(progress) else partial(bar.show, name)
    finally:
        bar.wipe()
