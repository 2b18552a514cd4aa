"""Answers the lines of a batch in another process, each within a time.

If a line takes longer, the process is ended, and another one takes the next line.
"""
import argparse
import json
import math
import multiprocessing
import pickle
import signal
import warnings
from collections import deque
from collections.abc import Iterator, Sequence
from socket import socket, socketpair
from time import monotonic
from typing import Any

from ...errors import GyrostatError, ValuesError
from ...questions.answers.answer_list import answers_data
from ...questions.answers.answers import answers_at
from ..output import internal
from ..time_limit import held_back, left_alone, limited
from .batch_lines import READ, Answer, Numbered, Questions

# a message is an object of JSON after a blank, or after ! if a line is not answered
READY = b" \n"                                         # of a process that waits for lines
_JSON = json.JSONEncoder(allow_nan=False)              # json.dumps makes an encoder for each answer


def reason(error: BaseException) -> str:
    """Why a line is not answered: what the library says, or a bug by its name."""
    if isinstance(error, GyrostatError):
        return str(error)
    if isinstance(error, MemoryError):
        return "there is not enough memory for this line"
    return f"{internal(error, 200)}; it is a bug, please report it"


def serve(place: socket, other: socket, given: argparse.Namespace) -> None:
    """Answer the lines that come, in order, until there are no more."""
    other.close()                                      # of the process that asks: with it this one ends
    left_alone()
    limited(given.timeout)
    try:
        questions = Questions(given)
    except Exception as error:
        place.sendall(b"!%b\n" % refusal(0, reason(error))[1])
        return
    place.sendall(READY)
    lines = place.makefile("rb")
    try:
        while True:
            limited(None)
            for n, line in pickle.load(lines):
                limited(given.timeout)
                try:
                    data = answers_data(answers_at(*questions.of(line)))
                    message = f" {_JSON.encode({'line': n} | data)}\n".encode()
                # every line answers for itself, whatever it brings about
                except Exception as error:
                    message = b"!%b\n" % refusal(n, reason(error))[1]
                place.sendall(message)
    except (EOFError, OSError):                        # nobody is there any more
        return


def refusal(n: int, why: str) -> Answer:
    """The answer to a line that is not answered."""
    return n, _JSON.encode({"line": n, "error": why}).encode(), why


def _why(message: bytes) -> str | None:
    """Why a line is not answered, as a message says; None if it is answered."""
    return str(json.loads(message[1:])["error"]) if message.startswith(b"!") else None


class Worker:
    """A process that answers lines; it is started when it is needed.

    Parameters
    ----------
    given : argparse.Namespace
        of gyrostat decide; timeout in seconds, None for none

    Attributes
    ----------
    lines : deque of (int, bytes)
        that it was given and has not answered
    late : float
        when the time for the first of them is over
    """

    def __init__(self, given: argparse.Namespace):
        self.given = given
        self.process: Any = None
        self.place: socket | None = None
        self.lines, self.late, self.part = deque[Numbered](), math.inf, b""

    def start(self) -> socket:
        """The connection to the process; a ValuesError if the options are wrong for every line."""
        if self.place is not None:
            return self.place
        methods = multiprocessing.get_all_start_methods()
        context: Any = multiprocessing.get_context("fork" if "fork" in methods else "spawn")
        self.place, theirs = socketpair()
        self.process = context.Process(target=serve, args=(theirs, self.place, self.given), daemon=True)
        with held_back(), warnings.catch_warnings():
            # of threads beside: the new process uses nothing of theirs
            warnings.simplefilter("ignore", DeprecationWarning)
            self.process.start()
        theirs.close()
        self.place.settimeout(self.given.timeout)
        try:
            first = self.place.makefile("rb").readline()
        except TimeoutError:
            raise ValuesError(f"--potential and --set are not understood within {self.given.timeout:g} "
                              "s: write them more simply") from None
        except ConnectionError:
            first = b""
        if not first:
            raise ValuesError(f"--potential and --set: {self._gone()}")
        if (why := _why(first)) is not None:
            raise ValuesError(why)
        self.place.settimeout(None)
        return self.place

    def send(self, lines: Sequence[Numbered]) -> None:
        """Give lines to the process, which has none."""
        while lines:
            try:
                self.start().sendall(pickle.dumps(lines))
                break
            except ConnectionError:                    # it was ended between the lines: another one is asked
                self.end()
        self.lines = deque(lines)
        self._waits()

    def come(self) -> Iterator[Answer]:
        """The answers that are there, some at least; if the process is gone, why its line has none."""
        try:
            data = self.start().recv(READ)
        except ConnectionError:
            data = b""
        if not data:
            yield self._without(self._gone())
            return
        *whole, self.part = (self.part + data).split(b"\n")
        for message in whole:
            yield self.lines.popleft()[0], message[1:], _why(message)
        self._waits()

    def give_up(self) -> Answer:
        """The refusal of the line that takes too long."""
        self.end()
        return self._without(f"no answer within {self.given.timeout:g} s")

    def _without(self, why: str) -> Answer:
        """The refusal of a line that ended the process; another one answers those after it."""
        (n, _), *others = self.lines
        self.send(others)
        return refusal(n, why)

    def _waits(self) -> None:
        """Begin the time for a line."""
        self.late = math.inf if self.given.timeout is None else monotonic() + self.given.timeout

    def _gone(self) -> str:
        """Why the process is gone."""
        self.process.join()
        code = self.process.exitcode
        self.end()
        if code == -getattr(signal, "SIGALRM", 0):
            return f"no answer within {self.given.timeout:g} s"
        return (f"internal error, the process ended with status {code}; "
                "there is too little memory, or it is a bug")

    def end(self) -> None:
        """End the process, whatever it does."""
        if self.place is not None:
            self.process.kill()
            self.process.join()
            self.process.close()
            self.place.close()
            self.place, self.part = None, b""
