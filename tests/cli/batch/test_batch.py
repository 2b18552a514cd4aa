"""gyrostat decide --batch: an answer for each line, in order, as the lines come."""
import io
import json
import os
import subprocess
import sys
import threading
from argparse import Namespace

import pytest
from commands import decide
from sympy import Rational

from gyrostat.cli.batch import batch_lines
from gyrostat.cli.parser import main

TOPS = ["--equilibrium", "E1", "--potential", "m0*k3", "--set", "I1=1", "--set", "I3=1.6", "--set", "l=0",
        "--set", "m0=1"]
LINES = [b'{"omega3_0": 1.25}', b"", b'{"omega3_0": 1.2499999999999999999}', b"nonsense",
         b'{"omega3_0": "5/4", "m0": 2}', b"[1]",
         b'{"m0": 1, "m0": 1, "omega3_0": 1}', b'{"omega3_0": NaN}', b'{"mass": 1, "omega3_0": 1}', b"{}",
         b'{"omega3_0": [1]}',
         b'{"I1": -1, "omega3_0": 1}', b'{"equilibrium": "E7"}', b'{"potential": 1, "omega3_0": 1}',
         b'{"omega3_0": 1e999999}',
         b"[" * 100000, b'{"\xff": 1}', b'{"\\ud800": 1}', b'{"pi3_0": 1, "omega3_0": 1}',
         b'{"pi3_0": 2, "equilibrium": "E2"}',
         b'{"potential": "none", "equilibrium": "E1"}',
         b'{"potential": "m0*k3 - m0*(k3 - 1)**2", "omega3_0": 1.25}']
GOOD = {1: "STABLE", 3: "UNSTABLE", 5: "UNSTABLE", 20: "STABLE", 22: "UNSTABLE"}


def batch(capsys, monkeypatch, lines, *arguments):
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"\n".join(lines))))
    status, out, err = decide(capsys, *TOPS, "--batch", "-", *arguments)
    return status, [json.loads(line) for line in out.splitlines()], err


@pytest.mark.slow
def test_a_batch(capsys, monkeypatch):
    """A line of output for each line that is not blank, in order.

    A number is the decimal it is written as; a bad line stops no other.
    """
    status, results, err = batch(capsys, monkeypatch, LINES)
    assert status == 2 and [r["line"] for r in results] == [n for n, line in enumerate(LINES, 1) if line]
    decided = {r["line"]: r["equilibria"][0]["decision"]["verdict"] for r in results if "error" not in r}
    assert decided == GOOD and all(set(r) == {"line", "error"} for r in results if r["line"] not in GOOD)
    for n, why in ((4, "not JSON"), (6, "not an object"), (7, "m0 is given twice"),
                   (8, "NaN is not a number"), (9, "no parameter mass"),
                   (10, "E1 needs"), (11, "not a real number"), (12, "must be positive"), (13, "E7"),
                   (14, "no parameter m0"),
                   (15, "too long"), (16, "not JSON"), (17, "not JSON"), (18, "is not a name"), (19, "both"),
                   (21, "is one in a field")):
        assert why in next(r["error"] for r in results if r["line"] == n) and f"gyrostat: line {n}: " in err
    assert len(err.splitlines()) == len(results) - len(GOOD)


def test_a_batch_of_good_lines(capsys, monkeypatch):
    """Exit status 0, nothing on standard error; without lines nothing comes."""
    assert batch(capsys, monkeypatch, LINES[:3])[::2] == (0, "")
    assert batch(capsys, monkeypatch, []) == (0, [], "")


def test_a_batch_overrides_what_is_set(capsys, monkeypatch):
    """--set is the default of every line, whichever name of the spin the line has."""
    status, results, _ = batch(capsys, monkeypatch, [b"{}", b'{"omega3_0": 1.2}', b'{"pi3_0": 1.2}'],
                               "--set", "omega3_0=1.3")
    assert status == 0
    assert [r["equilibria"][0]["decision"]["verdict"] for r in results] == ["STABLE", "UNSTABLE", "UNSTABLE"]


@pytest.mark.slow
def test_reports_are_derived_once(capfd, monkeypatch):
    """One derivation for each potential, equilibrium and name of the spin."""
    from gyrostat.questions.answers import equilibria as scenes
    scenes.report_of.cache_clear()
    analyze = scenes.analyze
    monkeypatch.setattr(scenes, "analyze", lambda eq: print(eq.label, file=sys.stderr, flush=True)
                        or analyze(eq))
    lines = [b'{"omega3_0": 1}', b'{"pi3_0": 1}', b'{"pi3_0": 1, "equilibrium": "E2"}'] * 20
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"\n".join(lines))))
    assert main(["decide", *TOPS, "--batch", "-"]) == 0
    assert capfd.readouterr().err.split() == ["E1", "E1", "E2"]        # of the process that answers


def test_a_batch_of_files(capsys, tmp_path):
    """From a file to a file; not to itself; an empty one gives an empty one."""
    given, verdicts = tmp_path / "tops.jsonl", tmp_path / "verdicts.jsonl"
    given.write_bytes(b"\n".join(LINES))
    status, out, _ = decide(capsys, *TOPS, "--batch", str(given), "--output", str(verdicts))
    assert status == 2 and out == "" and len(verdicts.read_text().splitlines()) == len(LINES) - 1
    status, _, err = decide(capsys, *TOPS, "--batch", str(given), "--output", str(given))
    assert status == 2 and "the same file" in err and given.read_bytes() == b"\n".join(LINES)
    given.write_bytes(b"")
    assert decide(capsys, *TOPS, "--batch", str(given), "--output", str(verdicts))[0] == 0
    assert verdicts.read_text() == ""
    status, _, err = decide(capsys, *TOPS, "--batch", str(given), "--output", str(tmp_path / "missing" / "x"))
    assert status == 2 and "cannot write" in err


def test_progress_of_a_batch(capsys, monkeypatch, tmp_path):
    """On a terminal a bar by bytes of a file, a counter of standard input, wiped at the end and before a
    message.
    """
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr("gyrostat.charts.progress.QUIET", 0.0)
    monkeypatch.setattr("gyrostat.charts.progress.PAUSE", 0.0)
    given = tmp_path / "tops.jsonl"
    given.write_bytes(b"\n".join(LINES[:4]))
    _, out, err = decide(capsys, *TOPS, "--batch", str(given))
    size = given.stat().st_size
    assert f"] {size}/{size}" in err
    assert "#" in err
    assert "\rgyrostat: line 4" in err
    assert err.endswith(" \r")
    assert "#" not in out
    _, _, err = batch(capsys, monkeypatch, LINES[:3])
    assert "decide       3" in err and "#" not in err and err.endswith(" \r")
    # the lines themselves are the progress
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    assert batch(capsys, monkeypatch, LINES[:3])[2] == ""


@pytest.mark.slow
def test_a_batch_streams():
    """A line is answered before the next one comes; a reader that stops early is no error."""
    command = [sys.executable, "-m", "gyrostat", "decide", *TOPS, "--batch", "-"]
    pipes = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
    with subprocess.Popen(command, **pipes, env={**os.environ, "PYTHONUNBUFFERED": ""}) as running:
        (limit := threading.Timer(60, running.kill)).start()
        for n in (1, 2):
            running.stdin.write(b'{"omega3_0": 1.25}\n')
            running.stdin.flush()
            assert json.loads(running.stdout.readline())["line"] == n
        running.stdout.close()
        running.stdin.write(b'{"omega3_0": 1.25}\n')
        running.stdin.close()
        assert running.stderr.read() == b"" and running.wait() == 0
        limit.cancel()


@pytest.mark.slow
def test_a_batch_flushes_to_its_file(tmp_path):
    """--output is written as the lines come, beside its place until all are there."""
    path = tmp_path / "verdicts.jsonl"
    command = [sys.executable, "-m", "gyrostat", "decide", *TOPS, "--batch", "-", "--output", str(path)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        running.stdin.write(b'{"omega3_0": 1.25}\nnonsense\n')
        running.stdin.flush()
        assert running.stderr.readline().startswith(b"gyrostat: line 2: ")
        assert json.loads(path.with_name("verdicts.jsonl.part").read_text().splitlines()[0])["line"] == 1
        assert not path.exists()
        running.stdin.close()
        assert running.wait() == 2 and [p.name for p in tmp_path.iterdir()] == ["verdicts.jsonl"]


def test_an_equilibrium_or_a_potential_of_another_kind_is_refused(capsys, monkeypatch):
    """Lists, numbers and truth values are no names; a text that names none is quoted."""
    lines = [b'{"equilibrium": ["E1"]}', b'{"equilibrium": true}', b'{"equilibrium": {"E1": 1}}',
             b'{"equilibrium": 5}', b'{"equilibrium": ""}', b'{"potential": {}}', b'{"potential": [1]}']
    status, results, err = batch(capsys, monkeypatch, lines)
    assert status == 2 and "internal error" not in err
    assert len(results) == len(lines) and all("give a potential as a text" in r["error"] for r in results)


def test_lines_that_ask_the_same_share_the_scene(monkeypatch):
    """A line has its own scene, equilibrium and numbers; what only depends on names is found once."""
    asked, find = [], batch_lines.asked_of
    monkeypatch.setattr(batch_lines, "asked_of", lambda *given: asked.append(given) or find(*given))
    questions = batch_lines.Questions(Namespace(potential="m0*k3", equilibrium="E1", point="0,0,pi3_0,0,0,1",
                                                values=["l=0", "pi3_0=1"]))
    first, second = (questions.of(b'{"I1": %d, "m0": "1/2"}' % n) for n in (1, 2))
    assert first[0] is second[0] and first[1:] == ("E1", {"l": 0, "pi3_0": 1, "I1": 1, "m0": Rational(1, 2)})
    assert second[2]["I1"] == 2
    other = questions.of(b'{"I1": 1, "I2": 2, "potential": "k1", "equilibrium": "e2", "omega3_0": 1}')
    assert other[0].inertia == "I1,I2,I3" and other[0].potential == "k1" and other[0].point is None
    assert other[1:] == ("E2", {"l": 0, "I1": 1, "I2": 2, "omega3_0": 1})
    assert len(asked) == 3                             # of the options, of two lines, and of the other one
