"""Deals the lines of a batch to processes that work side by side, and brings their answers in order."""
import argparse
from collections import deque
from collections.abc import Iterator, Sequence
from math import inf
from select import select
from time import monotonic, sleep

from .batch_lines import Answer, Numbered
from .batch_worker import Worker

# seconds in which answers gather, as to wake up for each of them takes time; and seconds that each line takes
# at least, so that no process is out of lines meanwhile
GATHER, QUICKEST = 0.005, 0.00005
LEAST = 4                                              # lines that are dealt at once, if there are as many


class Team:
    """Processes that answer lines; they are ended at the end of the block.

    Parameters
    ----------
    given : argparse.Namespace
        of gyrostat decide; processes is how many
    """

    def __init__(self, given: argparse.Namespace):
        self.workers = [Worker(given) for _ in range(given.processes)]

    def __enter__(self) -> "Team":
        return self

    def __exit__(self, *_: object) -> None:
        for worker in self.workers:
            worker.end()

    def start(self) -> None:
        """Start one of them; a ValuesError if the options are wrong for every line."""
        self.workers[0].start()

    def answers(self, lines: Sequence[Numbered]) -> Iterator[list[Answer]]:
        """The answers to the lines, in order, as many at a time as there are."""
        left, found, first = deque(lines), dict[int, Answer](), True
        wanted = deque(n for n, _ in lines)
        while wanted:
            self._deal(left)
            if not first:
                fewest = min(len(worker.lines) for worker in self.workers if worker.lines)
                sleep(min(GATHER, QUICKEST * fewest))
            found.update((answer[0], answer) for answer in self._come())
            first, there = False, list[Answer]()
            while wanted and wanted[0] in found:
                there.append(found.pop(wanted.popleft()))
            if there:
                yield there

    def _deal(self, left: deque[Numbered]) -> None:
        """Give lines to all who have none: smaller and smaller parts, so that all end at the same time."""
        for worker in self.workers:
            if left and not worker.lines:
                count = len(self.workers)
                most = len(left) if count == 1 else max(LEAST, len(left) // (2 * count))
                worker.send([left.popleft() for _ in range(min(most, len(left)))])

    def _come(self) -> Iterator[Answer]:
        """The answers that are there, when there are some."""
        busy = {worker.start(): worker for worker in self.workers if worker.lines}
        late = min(worker.late for worker in busy.values())
        there = select(list(busy), [], [], None if late == inf else max(late - monotonic(), 0))[0]
        for place, worker in busy.items():
            if place in there:
                yield from worker.come()
            elif worker.late <= monotonic():
                yield worker.give_up()
