"""Runs a verb in a process of its own, ends it when its time is over, and handles signals to both."""
import os
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from select import select
from time import monotonic
from typing import Any

from ..charts.progress import Waiting
from ..printing.files import cleared
from .output import told

# seconds after which a process ends itself that nobody has ended
GRACE = 1.0
ENDING = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]


class Interrupted(KeyboardInterrupt):
    """Raised when a signal asks the process to end.

    Parameters
    ----------
    status : int
        the exit status: 128 plus the number of the signal
    kept : str
        what is kept, and how to go on; empty if nothing is
    """

    def __init__(self, status: int, kept: str = ""):
        super().__init__(kept)
        self.status, self.kept = status, kept


def interrupted(error: KeyboardInterrupt, kept: str) -> Interrupted:
    """The same with what is kept."""
    return Interrupted(getattr(error, "status", 130), kept)


@contextmanager
def signals() -> Iterator[None]:
    """Raise an exception for SIGTERM and SIGHUP, as for Ctrl-C.

    After the block everything is said, and Ctrl-C is ignored.
    """
    def end(number: int, _: Any) -> None:
        raise Interrupted(128 + number)

    for number in ENDING:
        if signal.getsignal(number) is signal.SIG_DFL:    # not under nohup
            signal.signal(number, end)
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        for number in ENDING:
            signal.signal(number, signal.SIG_DFL)


@contextmanager
def held_back() -> Iterator[None]:
    """Hold signals back until the block ends."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, *ENDING})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def left_alone() -> None:
    """Ignore Ctrl-C in a process that another one waits for: it goes to both, and the other answers it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    for number in ENDING:
        signal.signal(number, signal.SIG_DFL)
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT, *ENDING})


def limited(seconds: float | None) -> None:
    """Let the system end this process after so many seconds and some grace; None stands for no limit."""
    if hasattr(signal, "setitimer"):
        signal.setitimer(signal.ITIMER_REAL, 0.0 if seconds is None else seconds + GRACE)


def watched(verb: str, seconds: float, output: str | None) -> None:
    """Return in a new process, which does the work.

    This one waits for it, ends it when its time is over, and exits as it does.
    """
    if not hasattr(os, "fork"):                        # Windows
        sys.exit(_repeated(verb, seconds, sys.argv[1:]))
    line, (reading, writing) = Waiting(verb), os.pipe()
    with held_back():
        process = os.fork()
        if process == 0:
            # the other end is open as long as this process is there
            os.close(reading)
            left_alone()
            limited(seconds)
            return
    os.close(writing)
    try:
        status = _waited(process, reading, monotonic() + seconds, line)
    except KeyboardInterrupt:
        _ended(process)
        _tidied(output, process)
        line.wipe()
        raise
    line.wipe()
    if status is None:
        _ended(process)
    if status is None or status < 0:
        _tidied(output, process)
    if status is None or status == -signal.SIGALRM:
        told(too_long(seconds))
    elif status < 0:
        told(f"the computation was ended by signal {-status}, {signal.strsignal(-status)}; there may be too "
             "little memory: ask for less")
    os._exit(status if status is not None and status >= 0 else 2)


def too_long(seconds: float) -> str:
    """The message for a time that is over."""
    return (f"no answer within {seconds:g} s: give more time, --timeout {10 * seconds:g} or --timeout none, "
            "or simpler numbers")


def _waited(process: int, reading: int, end: float, line: Waiting) -> int | None:
    """Wait for the process: how it ended, or None if it still works when its time is over."""
    while (left := end - monotonic()) > 0:
        if select([reading], [], [], min(left, 0.5))[0]:
            return os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
        line.tick()
    return None


def _ended(process: int) -> None:
    """Kill the process, which may just have ended."""
    with suppress(ProcessLookupError, ChildProcessError):
        os.kill(process, signal.SIGKILL)
        os.waitpid(process, 0)


def _tidied(output: str | None, process: int) -> None:
    """Remove what the process has not finished."""
    if output is not None:
        cleared(Path(os.path.realpath(output)).parent, process)


def _repeated(verb: str, seconds: float, arguments: Sequence[str]) -> int:
    """Run the verb in another interpreter, on a system that cannot fork a process."""
    try:
        return subprocess.run([sys.executable, "-m", "gyrostat", *arguments, "--timeout=none"],
                              timeout=seconds).returncode
    except subprocess.TimeoutExpired:
        told(too_long(seconds))
        return 2
