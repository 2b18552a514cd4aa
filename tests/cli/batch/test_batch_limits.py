"""A batch at its limits: lines that take too long, end their process, or are bad in every way."""
import ctypes
import errno
import io
import json
import os
import random
import signal
import sys

import pytest

from gyrostat.cli.batch import batch_lines, batch_worker
from gyrostat.cli.parser import main

TOPS = ["--equilibrium", "E1", "--potential", "m0*k3", "--set", "I1=1", "--set", "I3=1.6", "--set", "l=0",
        "--set", "m0=1"]


def batch(monkeypatch, capsys, lines, *arguments):
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"\n".join(lines))))
    status = main(["decide", *TOPS, "--batch", "-", *arguments])
    captured = capsys.readouterr()
    return status, [json.loads(line) for line in captured.out.splitlines()], captured.err


@pytest.fixture
def answering(monkeypatch):
    """Lines with pi3_0 = 7 do what is asked for, all others are answered as ever."""
    answers_at = batch_worker.answers_at

    def patch(act):
        monkeypatch.setattr(batch_worker, "answers_at", lambda potential, label, numbers: act()
                            if numbers.get("pi3_0") == 7 else answers_at(
            potential, label, numbers))
    return patch


GOOD, BAD = b'{"pi3_0": 3}', b'{"pi3_0": 7}'


@pytest.mark.slow
def test_a_line_that_takes_too_long(capsys, monkeypatch, answering):
    """It is ended in compiled code too, and named; every other line is answered, in order; exit status 2."""
    answering(lambda: ctypes.PyDLL(None).sleep(60))    # no Python until it returns
    status, found, err = batch(monkeypatch, capsys, [GOOD, BAD, GOOD, GOOD], "--timeout", "1.5")
    assert status == 2
    assert [r["line"] for r in found] == [1, 2, 3, 4]
    assert err == "gyrostat: line 2: no answer within 1.5 s\n"
    assert [r.get("error") for r in found] == [None, "no answer within 1.5 s", None, None]


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", [RecursionError, MemoryError, OverflowError, ValueError, ZeroDivisionError,
                                  AssertionError])
def test_every_exception_is_recorded_in_its_line(capsys, monkeypatch, answering, kind):
    """Whatever is raised, by whom ever."""
    def act():
        raise kind("of flint\nin two lines")
    answering(act)
    status, found, err = batch(monkeypatch, capsys, [GOOD, BAD, GOOD])
    assert status == 2
    assert ["error" in r for r in found] == [False, True, False]
    assert len(err.splitlines()) == 1
    assert (
        "not enough memory" in err
        if kind is MemoryError
        else f"internal error, {kind.__name__}: of flint in two lines" in err
    )


def test_a_process_that_dies_is_an_error_of_its_line(capsys, monkeypatch, answering):
    """The system may end it, or flint."""
    answering(lambda: os.kill(os.getpid(), signal.SIGKILL))
    status, found, err = batch(monkeypatch, capsys, [BAD, GOOD])
    assert status == 2
    assert "the process ended with status -9" in found[0]["error"]
    assert "equilibria" in found[1]


def test_an_interrupted_batch_goes_on(capsys, monkeypatch, tmp_path):
    """What was answered is kept beside the file, which is as it was.

    --from goes on, and the whole is that of one run.
    """
    (given := tmp_path / "tops.jsonl").write_bytes(b"\n".join(b'{"pi3_0": %d}' % n for n in range(1, 8)))
    out, command = tmp_path / "out.jsonl", ["decide", *TOPS, "--batch", str(given), "--output"]
    assert main([*command, str(tmp_path / "whole.jsonl")]) == 0
    out.write_text("old\n")
    keep = batch_lines.Kept.__call__

    def interrupting(self, answers):
        keep(self, answers)
        if self.last == 3:
            raise KeyboardInterrupt
    monkeypatch.setattr(batch_lines.Kept, "__call__", interrupting)
    monkeypatch.setattr(batch_lines, "READ", 1)            # one line after another
    assert main([*command, str(out)]) == 130
    said = (f"gyrostat: interrupted; the answers up to line 3 are in {out}.part; "
            "the same command with --from 4 goes on\n")
    assert capsys.readouterr().err == said and out.read_text() == "old\n"
    monkeypatch.setattr(batch_lines.Kept, "__call__", keep)
    assert main([*command, str(out), "--from", "4"]) == 0
    assert out.read_text() == (tmp_path / "whole.jsonl").read_text()
    assert not (tmp_path / "out.jsonl.part").exists()


def test_a_full_disk_keeps_whole_lines(capsys, monkeypatch, tmp_path):
    """One line says how to go on; the old file is as it was."""
    (given := tmp_path / "tops.jsonl").write_bytes(b"\n".join([GOOD] * 3))
    (out := tmp_path / "out.jsonl").write_text("old\n")
    monkeypatch.setattr(batch_lines, "READ", 1)            # one line after another
    flush, count = io.BufferedWriter.flush, []

    class Full(io.BufferedWriter):
        def flush(self):
            flush(self)
            count.append(1)
            if len(count) == 2:
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    opened = open
    monkeypatch.setattr("builtins.open", lambda path, mode="r", **more: Full(io.FileIO(path, mode))
                        if str(path).endswith(
        ".part") else opened(path, mode, **more))
    assert main(["decide", *TOPS, "--batch", str(given), "--output", str(out)]) == 2
    assert (
        f"cannot write {out}: No space left on device; the answers up to line 1 are in {out}.part"
        in capsys.readouterr().err
    )
    assert out.read_text() == "old\n" and len((tmp_path / "out.jsonl.part").read_text().splitlines()) == 1


def test_a_long_line_is_refused_and_forgotten(capsys, monkeypatch):
    """Of a line without an end only the beginning is held."""
    status, found, err = batch(monkeypatch, capsys, [b"[" * 3_000_000, GOOD])
    assert status == 2
    assert "not JSON of less than 100000 bytes" in found[0]["error"]
    assert "equilibria" in found[1]


PIECES = ["null", "true", "NaN", "Infinity", "-1", "0", "1e400", "1e-400", "1" * 5000, '"1/3"', '"sqrt(2)"',
          '"1/0"', '"0/0"', '"zoo"',
          '"nan"', '"__import__(\'os\')"', '"9**9**9"', '"\\u0000"', '"\\u001b[31m"', '"\\ud800"', '""',
          '" "', "[]", "[1]", "{}",
          '{"a": 1}', "[" * 2000, '"' + "(" * 3000 + '"', '"E1"', '"E7"', '"m0*k3"', '"none"',
          '"k3**99"', '"1/(k3-1)"', '"sqrt(k3)"', '"k1*k3"',
          '"tan(k3)"', '"exp(k3)"', '"m0*k3 + m1*k3**2"', '"3.5"', '"-7/2"', '"１"', '"π"']
NAMES = ["I1", "I3", "l", "m0", "pi3_0", "omega3_0", "omega", "k3", "potential", "equilibrium", "mass", "",
         "1", "a b", "\\u001b[2J", "d2U",
         "C1", "lambda", "x" * 300]


def bad_line(chance):
    pairs = [f'"{chance.choice(NAMES)}": {chance.choice(PIECES)}' for _ in range(chance.randrange(4))]
    line = "{" + ", ".join(pairs) + "}"
    if chance.random() < 0.2:
        line = line[: chance.randrange(len(line) + 1)] + chance.choice(
            ["", "\x00", "}", ",", "\x1b[31m", "\ufeff"]
        )
    return line.encode() if chance.random() < 0.9 else bytes(chance.randrange(256)
                                                             for _ in range(40)).replace(b"\n", b"")


@pytest.mark.slow
def test_lines_of_every_kind_of_badness(capfd, monkeypatch, tmp_path):
    """Each that is not blank is answered, in order, in JSON without constants, and nothing but its error
    reaches the terminal.
    """
    chance = random.Random(13)
    lines = [bad_line(chance) for _ in range(300)]
    (given := tmp_path / "bad.jsonl").write_bytes(b"\n".join(lines))
    assert main(["decide", "--potential", "m0*k3", *TOPS[4:], "--batch", str(given), "--timeout", "2"]) == 2
    out, err = capfd.readouterr()

    def refused(constant):
        raise AssertionError(constant)
    found = [json.loads(line, parse_constant=refused) for line in out.splitlines()]
    assert [r["line"] for r in found] == [n for n, line in enumerate(lines, 1) if line.strip()]
    assert all(set(r) in ({"line", "error"}, {"line", "equilibria"}) for r in found) and len(found) > 290
    assert err.count("\n") == sum("error" in r for r in found)
    assert err.replace("\n", "").isprintable()
    assert "Traceback" not in err
