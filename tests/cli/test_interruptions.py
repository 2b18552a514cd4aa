"""The command line ended from outside: Ctrl-C, time, terminals that are none, full disks, an archive."""
import os
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import pytest

import gyrostat
from gyrostat.cli import time_limit as watch

TOPS = ["--equilibrium", "E1", "--potential", "m0*k3", "--set", "I1=1", "--set", "I3=1.6", "--set", "l=0",
        "--set", "m0=1"]
COMMAND = [sys.executable, "-m", "gyrostat"]
# a field of degree 1260: the roots take hours
NUMBERS = ("I1=2**(1/7)", "I3=2**(1/12)", "l=5**(1/3)", "omega=7**(1/5)")
ENDLESS = ["decide", "--potential", "k3**4 - k3**2/2",
           *(word for number in NUMBERS for word in ("--set", number))]


def ended(arguments, after, number=signal.SIGINT, folder=None, **more):
    """The command, ended by a signal to its group so long after something is on its way.

    A shell lets what it starts in the background ignore SIGINT, and a child inherits that.
    """
    with subprocess.Popen([*COMMAND, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          stdin=subprocess.PIPE, cwd=folder, start_new_session=True,
                          preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL), **more) as running:
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


def test_where_a_process_cannot_be_doubled(capsys, monkeypatch):
    """Another interpreter does the work: its exit status, or 2 where it takes too long."""
    monkeypatch.delattr(watch.os, "fork")
    monkeypatch.setattr(watch.subprocess, "run",
                        lambda command, timeout: subprocess.CompletedProcess(command, 1))
    with pytest.raises(SystemExit) as stop:
        watch.watched("verify", 3.0, None)
    assert (stop.value.code, capsys.readouterr().err) == (1, "")

    def late(command, timeout):
        raise subprocess.TimeoutExpired(command, timeout)
    monkeypatch.setattr(watch.subprocess, "run", late)
    with pytest.raises(SystemExit) as stop:
        watch.watched("verify", 3.0, None)
    assert stop.value.code == 2 and "no answer within 3 s" in capsys.readouterr().err


def working(running):
    """Wait until the command has a process that works."""
    children = Path(f"/proc/{running.pid}/task/{running.pid}/children")
    for _ in range(600):
        if children.exists() and children.read_text().strip():
            return int(children.read_text().split()[0])
        time.sleep(0.1)
    raise AssertionError("no process works")


@pytest.mark.slow
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
    assert run.stderr.startswith("gyrostat: no answer within 0.5 s: give more time, --timeout 5")


@pytest.mark.slow
@pytest.mark.parametrize(("arguments", "redirected", "why"), [
    (["conditions"], ">&-", "cannot write to standard output: it is closed"),
    (["conditions"], "> /dev/full", "No space left on device"),
    (["decide", *TOPS, "--batch", "-"], "<&-", "standard input, which is closed"),
    (["conditions", "--output", "/dev/full"], "", "cannot write /dev/full: No space left"),
    (["conditions", "--output", "/"], "", "cannot write /: Is a directory: check the path"),
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
            if path.suffix in (".py", ".toml", ".txt", ".mplstyle"):
                archive.write(path, path.relative_to(source.parent))

    def run(*command):
        return subprocess.run([*COMMAND, *command], capture_output=True, text=True, cwd=tmp_path,
                              env={**os.environ, "PYTHONPATH": str(tmp_path / "gyrostat.zip"),
                                   "PYTHONSAFEPATH": "1"})

    found = run("verify", "AR")
    assert found.returncode == 0 and "\n46 statements: 39 confirmed" in found.stdout, found.stderr
    drawn = run("plot", "staude-cone", "--potential", "k1+k2+k3", "--inertia", "1,2,3",
                "--gyrostatic-momentum", "0,0,0", "--output", "cone.png")
    assert drawn.returncode == 0 and (tmp_path / "cone.png").read_bytes().startswith(b"\x89PNG"), drawn.stderr
