"""Several processes answer a batch as one does: the same lines, in the same order, each within its time."""
import ctypes
import io
import os
import signal
import subprocess
import sys
from argparse import Namespace
from collections import deque

import pytest

from gyrostat.cli.batch import batch_worker
from gyrostat.cli.batch.batch_team import LEAST, Team
from gyrostat.cli.parser import main

TOPS = ["--equilibrium", "E1", "--potential", "m0*k3", "--set", "I1=1", "--set", "I3=1.6", "--set", "l=0",
        "--set", "m0=1"]


def answered(monkeypatch, capsys, lines, *arguments):
    """Status, standard output and standard error of a batch."""
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"\n".join(lines))))
    status = main(["decide", *TOPS, "--batch", "-", *arguments])
    captured = capsys.readouterr()
    return status, captured.out, captured.err


@pytest.fixture
def acting(monkeypatch):
    """Lines with pi3_0 = 7 or more do what is asked for, all others are answered as ever."""
    answers_at = batch_worker.answers_at

    def patch(act):
        monkeypatch.setattr(batch_worker, "answers_at", lambda *asked: act(int(asked[2]["pi3_0"]))
                            if asked[2].get("pi3_0", 0) >= 7 else answers_at(*asked))
    return patch


@pytest.mark.slow
def test_several_processes_write_what_one_writes(monkeypatch, capsys):
    """Byte for byte, blank and bad lines included."""
    lines = [b'{"pi3_0": "%d/7"}' % n if n % 5 else b"bad" if n % 2 else b"" for n in range(60)]
    one = answered(monkeypatch, capsys, lines)
    assert one[0] == 2 and one[1].count("\n") == 54 and one[2].count("\n") == 6
    for count in ("2", "3"):
        assert answered(monkeypatch, capsys, lines, "--processes", count) == one


def test_answers_that_come_in_pieces_are_put_together(monkeypatch, capsys):
    """A connection carries bytes, not lines."""
    lines = [b'{"pi3_0": "%d/7"}' % n for n in range(5)]
    whole = answered(monkeypatch, capsys, lines)
    monkeypatch.setattr(batch_worker, "READ", 300)
    assert answered(monkeypatch, capsys, lines, "--processes", "2") == whole


@pytest.mark.parametrize("count", [1, 2])
def test_all_of_them_work(monkeypatch, capsys, acting, count):
    """Each answers a share."""
    def tell(_):
        raise ZeroDivisionError(os.getpid())
    acting(tell)
    _, out, _ = answered(monkeypatch, capsys, [b'{"pi3_0": 7}'] * 40, "--processes", str(count))
    of_process = [line.rpartition("ZeroDivisionError: ")[2] for line in out.splitlines()]
    assert len(of_process) == 40 and len(set(of_process)) == count
    assert min(map(of_process.count, of_process)) >= LEAST


@pytest.mark.slow
def test_a_line_that_hangs_or_kills_stops_no_other(monkeypatch, capsys, acting):
    """It is named; lines after it in its share go to a new process, those of others wait for nobody."""
    def act(number):
        if number == 7:
            ctypes.PyDLL(None).sleep(60)
        os.kill(os.getpid(), signal.SIGKILL)
    acting(act)
    numbers = [3, 7, 3, 3, 8, 8, *[3] * 14]
    lines = [b'{"pi3_0": %d}' % n for n in numbers]
    status, out, err = answered(monkeypatch, capsys, lines, "--processes", "2", "--timeout", "1.5")
    assert status == 2
    assert [f'"line": {n}, ' in line for n, line in enumerate(out.splitlines(), 1)] == [True] * len(lines)
    assert [("error" in line) for line in out.splitlines()] == [n != 3 for n in numbers]
    assert [line.partition(":")[2][:24] for line in err.splitlines()] == [
        " line 2: no answer withi", " line 5: internal error,", " line 6: internal error,"]


def test_shares_get_smaller(monkeypatch):
    """A half of what is left over all, never less than a few, so that all end at the same time."""
    team = Team(Namespace(processes=2, timeout=None))
    dealt = []
    for worker in team.workers:
        monkeypatch.setattr(worker, "send", lambda lines: dealt.append(len(lines)))
    left = deque((n, b"") for n in range(100))
    while left:
        team._deal(left)
    assert sum(dealt) == 100 and dealt == sorted(dealt, reverse=True)
    assert dealt[:3] == [25, 18, 14] and dealt[-2] == LEAST


@pytest.mark.parametrize("count", ["0", "-1", "257"])
def test_a_number_of_processes_that_cannot_be(monkeypatch, capsys, count):
    """None, or more than a machine has."""
    status, out, err = answered(monkeypatch, capsys, [], "--processes", count)
    assert (status, out) == (2, "") and f"--processes is {count}" in err


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="a new process inherits what is open")
def test_a_process_ends_with_the_one_that_asks():
    """Even if that one is killed: nobody else holds its end of the connection."""
    script = ("import os, signal\nfrom argparse import Namespace\n"
              "from gyrostat.cli.batch.batch_worker import Worker\n"
              "Worker(Namespace(potential='m0*k3', values=[], timeout=None)).start()\n"
              "os.kill(os.getpid(), signal.SIGKILL)\n")
    # its standard output ends when the last process that has it does
    ended = subprocess.run([sys.executable, "-c", script], stdout=subprocess.PIPE, timeout=60, check=False)
    assert ended.returncode == -signal.SIGKILL
