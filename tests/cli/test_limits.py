"""The command line at its limits.

Time, interruptions, exceptions of others, terminals that are none, full disks.
"""
import ctypes
import errno
import io
import json
import os
import random
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import pytest

import gyrostat
from gyrostat.cli import batch_worker, report, watch
from gyrostat.cli.parser import main

TOPS = ["--equilibrium", "E1", "--potential", "m0*k3", "--set", "I1=1", "--set", "I3=1.6", "--set", "l=0",
        "--set", "m0=1"]
COMMAND = [sys.executable, "-m", "gyrostat"]
# a field of degree 1260: the roots take hours
NUMBERS = ("I1=2**(1/7)", "I3=2**(1/12)", "l=5**(1/3)", "omega=7**(1/5)")
ENDLESS = ["decide", "--potential", "k3**4 - k3**2/2",
           *(word for number in NUMBERS for word in ("--set", number))]


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


def test_a_line_that_takes_too_long(capsys, monkeypatch, answering):
    """It is ended in compiled code too, and named; every other line is answered, in order; exit status 2."""
    answering(lambda: ctypes.PyDLL(None).sleep(60))    # no Python until it returns
    status, found, err = batch(monkeypatch, capsys, [GOOD, BAD, GOOD, GOOD], "--timeout", "1.5")
    assert status == 2
    assert [r["line"] for r in found] == [1, 2, 3, 4]
    assert err == "gyrostat: line 2: not within 1.5 s\n"
    assert [r.get("error") for r in found] == [None, "not within 1.5 s", None, None]


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
    from gyrostat.cli.batch_lines import Kept
    keep, kept = Kept.__call__, []

    def interrupting(self, n, text):
        keep(self, n, text)
        kept.append(n)
        if len(kept) == 3:
            raise KeyboardInterrupt
    monkeypatch.setattr(Kept, "__call__", interrupting)
    assert main([*command, str(out)]) == 130
    said = (f"gyrostat: interrupted; the answers up to line 3 are in {out}.part; "
            "the same command with --from 4 goes on\n")
    assert capsys.readouterr().err == said and out.read_text() == "old\n"
    monkeypatch.setattr(Kept, "__call__", keep)
    assert main([*command, str(out), "--from", "4"]) == 0
    assert out.read_text() == (tmp_path / "whole.jsonl").read_text()
    assert not (tmp_path / "out.jsonl.part").exists()


def test_a_full_disk_keeps_whole_lines(capsys, monkeypatch, tmp_path):
    """One line says how to go on; the old file is as it was."""
    (given := tmp_path / "tops.jsonl").write_bytes(b"\n".join([GOOD] * 3))
    (out := tmp_path / "out.jsonl").write_text("old\n")
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


@pytest.mark.parametrize(("raised", "status", "said"), [
    (ValueError("of\nflint"), 2, "internal error, ValueError: of flint; it is a bug"),
    (MemoryError(), 2, "not enough memory"),
    (KeyboardInterrupt(), 130, "interrupted; nothing is kept"),
    (OSError(errno.ENOSPC, "No space"), 2, "cannot write to standard output")])
def test_the_last_resort(capsys, monkeypatch, raised, status, said):
    """One line for whatever comes, and a traceback where it is asked for."""
    def run(given, out):
        raise raised
    monkeypatch.setattr(report, "run", run)
    assert main(["report"]) == status
    err = capsys.readouterr().err
    assert said in err and len(err.splitlines()) == 1
    monkeypatch.setenv("GYROSTAT_DEBUG", "1")
    if isinstance(raised, ValueError):
        with pytest.raises(ValueError, match="flint"):
            main(["report"])


@pytest.mark.parametrize("text", ["0", "-1", "nan", "inf", "1e400", "soon", ""])
def test_a_time_is_positive_seconds(capsys, text):
    """Or none."""
    with pytest.raises(SystemExit) as stop:
        main(["report", f"--timeout={text}"])
    assert stop.value.code == 2 and "is no time: give seconds" in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [
    ["decide", "--potential", "m0*k3", "--set", "I1=2", "--set", "I3=1", "--set", "l=1", "--set", "m0=1/2",
     "--set", "omega=1e400"],
    ["report", "--equilibrium", "E1", *TOPS[2:], "--set", "pi3_0=1e400"],
    ["decide", *TOPS, "--set", "omega3_0=1e-400"]])
def test_json_has_no_infinity(capsys, arguments):
    """A number beyond doubles is exact, and null as a decimal."""
    def refused(constant):
        raise AssertionError(constant)
    assert main([*arguments, "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out, parse_constant=refused)
    if "omega=1e400" in arguments:
        assert found["equilibria"][0]["omega"] == {"exact": str(10**400), "decimal": None}


@pytest.mark.parametrize(("verb", "potential", "missing"), [
    ("conditions", "k3**(1/3)", ["E2"]), ("conditions", "1/(k3-1)", ["E1"]),
    ("conditions", "asin(k3)", ["E1", "E2"]),
    ("report", "1/(k3-1)", ["E1"])])
def test_the_others_are_given_where_one_does_not_exist(capsys, verb, potential, missing):
    """And why it does not; in JSON and LaTeX too; asked for alone it is an error."""
    for form in ("text", "latex", "json"):
        assert main([verb, "--potential", potential, "--format", form]) == 0
        out = capsys.readouterr().out
        assert all(f"{label} does not exist: U or one of its derivatives is" in " ".join(out.split())
                   for label in missing)
    labels = {e["label"]: "error" in e for e in json.loads(out)["equilibria"]}
    assert {label: label in missing for label in ("E1", "E2", "E3")}.items() <= labels.items()
    assert main([verb, "--potential", potential, "--equilibrium", missing[0]]) == 2


def test_decide_gives_the_others(capsys):
    """At numbers: of U = 1/(k3 − a) at a = 1 E2 is decided, and E1 says why it is not."""
    numbers = [f"--set={s}" for s in ("I1=1", "I3=1/2", "l=1", "pi3_0=1")]
    for potential, more in (("1/(k3-a)", ["--set=a=1"]), ("1/(k3-1)", [])):
        assert main(["decide", "--potential", potential, *numbers, *more, "--format", "json"]) == 0
        found = {e["label"]: e for e in json.loads(capsys.readouterr().out)["equilibria"]}
        assert found["E2"]["decision"]["verdict"] == "STABLE" and "finite" in found["E1"]["error"]
    assert main(["decide", "--potential", "1/(k3-1)", *numbers]) == 0
    assert "E1 does not exist" in capsys.readouterr().out


def test_no_class_name_is_prose(capsys):
    """What is not solved for says so in words; LaTeX has the reason, with its signs escaped.

    Ω is enough, k3 may stay open.
    """
    top = ["conditions", "--potential", "exp(k3)", "--solve-for", "l"]
    for form in ("text", "latex"):
        assert main([*top, "--format", form]) == 0
        out = " ".join(capsys.readouterr().out.split())
        assert "Error" not in out
        assert "E3 ties l to the other names" in out
        assert "give numbers for I1, omega; k3 may stay open" in out
    assert main(["conditions", "--potential", "m0*k3", "--solve-for", "pi3_0", "--format", "latex"]) == 0
    assert r"E3 has no parameter pi3\_0" in capsys.readouterr().out


def test_a_table_is_read_by_others(capsys, tmp_path):
    """pandas and NumPy; the numbers it is of stand above it."""
    import numpy as np
    pandas = pytest.importorskip("pandas")
    path = tmp_path / "top.csv"
    assert main(["motion", "--potential", "m0*k3",
                 *(f"--set={s}" for s in ("I1=1", "I3=0.6", "l=0.4", "m0=1")), "--state",
                 "0.3,-0.2,10,0.6,0,0.8", "--until", "3", "--count", "4", "--output", str(path)]) == 0
    table = pandas.read_csv(path, comment="#")
    assert (
        list(table.columns)
        == "time pi1 pi2 pi3 k1 k2 k3 omega1 omega2 omega3 q0 q1 q2 q3 phi theta psi".split()
    )
    assert table.iloc[0, :7].tolist() == [0, 0.3, -0.2, 10, 0.6, 0, 0.8]
    with open(path) as file:
        read = np.genfromtxt((line for line in file if line[0] != "#"), delimiter=",", names=True)
    assert read["q0"].tolist() == table["q0"].tolist()
    head = [line[2:].strip() for line in path.read_text().splitlines() if line[0] == "#"]
    assert "inertia = (1, 1, 3/5)" in head
    assert "state = (3/10, -1/5, 10, 3/5, 0, 4/5)" in head
    assert "potential = k3" in head
    assert "omega1 [s-1]: angular velocity of the body, axis 1" in head
    assert f"gyrostat_version = {gyrostat.__version__}" in head


def test_the_old_file_is_kept(capsys, tmp_path, monkeypatch):
    """Of every kind, where writing the new one fails; nothing lies beside it."""
    from matplotlib.animation import PillowWriter
    from matplotlib.figure import Figure
    xarray = pytest.importorskip("xarray")

    def full(*_, **__):
        raise OSError(errno.ENOSPC, "No space left on device")
    for owner, name in ((Figure, "savefig"), (xarray.Dataset, "to_netcdf"), (PillowWriter, "finish")):
        monkeypatch.setattr(owner, name, full)
    box = ["motion", "--potential", "none", *(f"--set={s}" for s in ("I1=1", "I2=2", "I3=5/2", "l=0")),
           "--state", "1/50,2,0",
           "--until", "6", "--count", "2", "--output"]
    cones = ["plot", "cones", "--set", "I1=2", "--set", "I3=1", "--transverse", "1", "--axial", "2",
             "--output"]
    for command, kind in ((box, "png"), (box, "nc"), (box, "gif"), (cones, "svg")):
        (path := tmp_path / f"old.{kind}").write_text("old")
        assert main([*command, str(path)]) == 2 and path.read_text() == "old"
        assert capsys.readouterr().err == f"gyrostat: cannot write {path}: No space left on device\n"
    assert len(list(tmp_path.iterdir())) == 4


def ended(arguments, after, number=signal.SIGINT, folder=None, **more):
    """The command, ended by a signal to its group so long after something is on its way."""
    with subprocess.Popen([*COMMAND, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          stdin=subprocess.PIPE, cwd=folder,
                          start_new_session=True, **more) as running:
        after(running)
        os.killpg(running.pid, number)
        out, err = running.communicate(timeout=60)
    return running.returncode, out, err.decode()


@pytest.mark.parametrize(("number", "status"), [(signal.SIGTERM, 143), (signal.SIGHUP, 129)])
def test_a_signal_has_its_exit_status(number, status):
    """128 and the number, as of a process that it ends."""
    before = signal.getsignal(signal.SIGINT)
    try:
        with pytest.raises(watch.Interrupted) as error, watch.signals():
            signal.raise_signal(number)
    finally:
        signal.signal(signal.SIGINT, before)
    assert error.value.status == watch.interrupted(error.value, "").status == status


def working(running):
    """Wait until the command has a process that works."""
    children = Path(f"/proc/{running.pid}/task/{running.pid}/children")
    for _ in range(600):
        if children.exists() and children.read_text().strip():
            return int(children.read_text().split()[0])
        time.sleep(0.1)
    raise AssertionError("no process works")


@pytest.mark.parametrize("own", [True, False])
def test_what_is_loaded_is_no_garbage(own):
    """The command sets it aside, garbage is collected afterwards; a call from Python changes nothing."""
    code = ("import gc, sys; from gyrostat.cli.parser import main; sys.argv[1:] = ['report', '--set=l=1', "
            f"'--timeout=none']; main({'' if own else 'sys.argv[1:]'}); print(gc.isenabled(), "
            "gc.get_freeze_count())")
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    enabled, frozen = run.stdout.split()
    assert enabled == "True" and (int(frozen) > 10**5 if own else int(frozen) == 0), run.stderr


@pytest.mark.slow
def test_ctrl_c_while_it_is_loaded():
    """One line, exit status 130, no traceback."""
    status, out, err = ended(["report"], lambda running: time.sleep(0.4))
    assert (status, out) == (130, b"")
    assert err.startswith("gyrostat: interrupted")
    assert len(err.splitlines()) == 1


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="the processes are found in /proc")
@pytest.mark.parametrize(("number", "status"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_ctrl_c_while_it_works(number, status):
    """The same, and its process is gone."""
    workers = []
    found = ended(ENDLESS, lambda running: workers.append(working(running)), number)
    assert found == (status, b"", "gyrostat: interrupted; nothing is kept, the same command begins anew\n")
    assert not Path(f"/proc/{workers[0]}").exists()


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="the processes are found in /proc")
def test_a_process_whose_parent_was_killed_ends():
    """By the system, when its time is over."""
    workers = []

    def killed(running):
        workers.append(working(running))
        os.kill(running.pid, signal.SIGKILL)
        for _ in range(100):
            if not Path(f"/proc/{workers[0]}").exists():
                return
            time.sleep(0.1)
        raise AssertionError("it works on")
    ended([*ENDLESS, "--timeout", "3"], killed)


@pytest.mark.slow
def test_a_verdict_that_takes_too_long():
    """One line that says what to do, exit status 2."""
    run = subprocess.run([*COMMAND, *ENDLESS, "--timeout", "0.5"], capture_output=True, text=True)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr.startswith("gyrostat: not within 0.5 s: give it more time, --timeout 5")


@pytest.mark.slow
@pytest.mark.parametrize(("arguments", "redirected", "why"), [
    (["conditions"], ">&-", "cannot write to standard output: it is closed"),
    (["conditions"], "> /dev/full", "No space left on device"),
    (["decide", *TOPS, "--batch", "-"], "<&-", "standard input, which is closed"),
    (["conditions", "--output", "/dev/full"], "", "cannot write /dev/full: No space left"),
    (["conditions", "--output", "/"], "", "cannot write /: Is a directory"),
    (["decide", *TOPS, "--batch", "/"], "", "cannot read /: Is a directory")])
def test_what_cannot_be_written_or_read(arguments, redirected, why):
    """One line, exit status 2, no traceback."""
    run = subprocess.run(["sh", "-c", f'"$@" {redirected}', "sh", *COMMAND, *arguments], capture_output=True,
                         text=True)
    assert run.returncode == 2 and why in run.stderr and len(run.stderr.splitlines()) == 1


@pytest.mark.slow
def test_terminals_without_letters():
    """Help and report where the encoding has nothing but ASCII; all three streams closed."""
    for arguments in (["plot", "--help"], ["decide", "--help"], ["conditions", "--equilibrium", "E1"]):
        run = subprocess.run([*COMMAND, *arguments], capture_output=True,
                             env={**os.environ, "PYTHONIOENCODING": "ascii"})
        assert run.returncode == 0 and run.stderr == b"" and run.stdout
    assert subprocess.run(["sh", "-c", '"$@" <&- >&- 2>&-', "sh", *COMMAND, "conditions"]).returncode == 2


@pytest.mark.slow
def test_from_an_archive(tmp_path):
    """Everything but what compiles needs no folder."""
    source = Path(gyrostat.__file__).parent
    with zipfile.ZipFile(tmp_path / "gyrostat.zip", "w") as archive:
        for path in source.rglob("*"):
            if path.suffix in (".py", ".toml", ".txt"):
                archive.write(path, path.relative_to(source.parent))
    run = subprocess.run([*COMMAND, "verify", "AR"], capture_output=True, text=True, cwd=tmp_path,
                         env={**os.environ, "PYTHONPATH": str(tmp_path / "gyrostat.zip"),
                              "PYTHONSAFEPATH": "1"})
    assert run.returncode == 0 and run.stdout.endswith("46 statements, all as expected\n"), run.stderr


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
