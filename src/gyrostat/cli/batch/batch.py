"""gyrostat decide --batch: a decision for each line of a file, as it is read."""
import argparse
from typing import BinaryIO

from ...charts.progress import Progress
from ...errors import ValuesError
from ..output import Output, on_terminal, told
from ..time_limit import interrupted
from .batch_lines import Kept, numbered, opened, size_of
from .batch_team import Team

PROCESSES = 256


def run(given: argparse.Namespace, out: Output) -> int:
    """Write an object for each line, in order; 0, or 2 if a line was bad."""
    if given.format != "json" and given.format is not None:
        raise ValuesError(f"--batch writes JSON, and --format is {given.format}: leave out one of the two")
    if not 1 <= given.processes <= PROCESSES:
        raise ValuesError(f"--processes is {given.processes}, and 1 to {PROCESSES} processes answer a batch: "
                          "give as many as the machine has cores")
    with opened(given.batch, given.output) as file, Team(given) as team:
        team.start()                                   # wrong options are said before anything is written
        with Kept(given.output, given.start) as kept:
            return _each(given, file, team, kept)


def _each(given: argparse.Namespace, file: BinaryIO, team: Team, kept: Kept) -> int:
    status, total, read = 0, size_of(file), 0
    progress = Progress(given.output is not None or not on_terminal())
    try:
        for lines in numbered(file):
            asked = [(n, line) for n, line in lines if n >= given.start and line.strip()]
            for answers in team.answers(asked):
                kept(answers)
                for n, _, error in answers:
                    if error is not None:
                        status = 2
                        progress.wipe()
                        told(f"line {n}: {error}")
                progress.show("decide", answers[-1][0] if total is None else read, total)
            read += sum(len(line) + 1 for _, line in lines)
            progress.show("decide", lines[-1][0] if total is None else min(read, total), total)
        kept.ended()
    except BrokenPipeError:                            # nobody reads on
        raise
    except OSError as error:
        raise OSError(error.errno, f"{error.strerror}; {kept.until_now()}") from None
    except KeyboardInterrupt as error:
        raise interrupted(error, kept.until_now()) from None
    finally:
        progress.wipe()
    return status

