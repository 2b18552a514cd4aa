"""Answers the lines of a batch in another process, each within a time.

If a line takes longer, the process is ended, and another one takes the next line.
"""
import argparse
import json
import multiprocessing
import os
import signal
import warnings
from collections.abc import Iterator, Sequence
from multiprocessing.connection import Connection
from select import select
from typing import Any

from ...errors import GyrostatError, ValuesError
from ...questions.answers.answer_list import answers_data
from ...questions.answers.answers import answers_at
from ..output import internal
from ..time_limit import held_back, left_alone, limited
from .batch_lines import Questions

# an object of JSON, and the reason where the line is not answered
Answer = tuple[str, str | None]
_JSON = json.JSONEncoder(allow_nan=False)              # json.dumps makes an encoder for each answer


def reason(error: BaseException) -> str:
    """Why a line is not answered: what the library says, or a bug by its name."""
    if isinstance(error, GyrostatError):
        return str(error)
    if isinstance(error, MemoryError):
        return "there is not enough memory for this line"
    return f"{internal(error, 200)}; it is a bug, please report it"


def serve(connection: Connection, given: argparse.Namespace) -> None:
    """Answer the lines that come, in order, until there are no more."""
    left_alone()
    limited(given.timeout)
    try:
        questions = Questions(given)
    except Exception as error:
        connection.send(reason(error))
        return
    connection.send(None)
    try:
        while True:
            limited(None)
            for n, line in connection.recv():
                limited(given.timeout)
                try:
                    data = answers_data(answers_at(*questions.of(line)))
                    answer: Answer = _JSON.encode({"line": n} | data), None
                # every line answers for itself, whatever it brings about
                except Exception as error:
                    answer = refusal(n, reason(error))
                connection.send(answer)
    except (EOFError, OSError):                        # nobody is there any more
        return


def refusal(n: int, why: str) -> Answer:
    """The answer to a line that is not answered."""
    return _JSON.encode({"line": n, "error": why}), why


def _within(connection: Connection, seconds: float | None) -> bool:
    """Whether something comes within the time.

    If select knows pipes, it is used: connection.poll makes a selector for each call.
    """
    if os.name == "nt":
        return connection.poll(seconds)
    return bool(select([connection.fileno()], [], [], seconds)[0])


class Worker:
    """A process that answers lines; it is started when it is needed.

    Parameters
    ----------
    given : argparse.Namespace
        of gyrostat decide; timeout in seconds, None for none
    """

    def __init__(self, given: argparse.Namespace):
        self.given = given
        self.process: Any = None
        self.connection: Connection | None = None

    def __enter__(self) -> "Worker":
        return self

    def __exit__(self, *_: object) -> None:
        self.end()

    def start(self) -> Connection:
        """The connection to the process; a ValuesError if the options are wrong for every line."""
        if self.connection is not None:
            return self.connection
        methods = multiprocessing.get_all_start_methods()
        context: Any = multiprocessing.get_context("fork" if "fork" in methods else "spawn")
        self.connection, theirs = multiprocessing.Pipe()
        self.process = context.Process(target=serve, args=(theirs, self.given), daemon=True)
        with held_back(), warnings.catch_warnings():
            # of threads beside: the new process uses nothing of theirs
            warnings.simplefilter("ignore", DeprecationWarning)
            self.process.start()
        theirs.close()
        try:
            if not self.connection.poll(self.given.timeout):
                raise ValuesError(f"--potential and --set are not understood within {self.given.timeout:g} "
                                  "s: write them more simply")
            if (why := self.connection.recv()) is not None:
                raise ValuesError(why)
        except EOFError:
            raise ValuesError(f"--potential and --set: {self._gone()}") from None
        return self.connection

    def answers(self, lines: Sequence[tuple[int, bytes]]) -> Iterator[Answer]:
        """The answer to each of the lines, as they come."""
        limit, done = self.given.timeout, 0
        while done < len(lines):
            connection = self.start()
            try:
                connection.send(lines[done:])
            except ConnectionError:                    # it was ended between the lines: another one is asked
                self.end()
                continue
            for n, _ in lines[done:]:
                done += 1
                try:
                    if _within(connection, limit):
                        yield connection.recv()
                        continue
                    self.end()
                    yield refusal(n, f"no answer within {limit:g} s")
                except (EOFError, ConnectionError):    # the process is gone
                    yield refusal(n, self._gone())
                break

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
        if self.connection is not None:
            self.process.kill()
            self.process.join()
            self.process.close()
            self.connection.close()
            self.connection = None
