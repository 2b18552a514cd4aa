"""The command line: output, verdicts, errors, exit status."""
import json
import os
import subprocess
import sys

import pytest

import gyrostat
from gyrostat.cli import main

TOP = ["--set", "I1=1", "--set", "I3=1.6", "--set", "l=0", "--set", "m0=1"]


def run(capsys, *arguments):
    status = main(["report", *arguments])
    captured = capsys.readouterr()
    return status, captured.out, captured.err


def test_report_of_any_field(capsys):
    """Without arguments: bracket, E1, E2, E3 and their conditions."""
    status, out, err = run(capsys)
    assert status == 0 and err == ""
    for line in ("(π₃⁰ + l)² ≥ 4 I₁ U′(1)", "(π₃⁰ + l)² > −4 I₁ U′(−1)",
                 "(l − ω k₃ (2 I₁ − I₃))² + I₁ (1 − k₃²) (I₁ ω² + U″(k₃)) > 0", "|k₃| < 1"):
        assert line in out


def test_rumiantsev(capsys):
    """The heavy gyrostat in the rate ω3, as Rumiantsev wrote it, and the Newtonian field."""
    _, out, _ = run(capsys, "--potential", "m0*k3", "--equilibrium", "E1", *TOP, "--set", "omega3_0=1.3")
    assert "(I₃ ω₃⁰ + l)² > 4 I₁ m₀" in out and "Verdict: Lyapunov stable" in out and "E2" not in out
    assert "(I₃ ω₃⁰ + l)² − 4 I₁ m₀ = 204/625\n" in out
    _, out, _ = run(capsys, "--potential", "m0*k3 + m1/2*(I3 - I1)*k3**2", "--equilibrium", "E3")
    assert "k₃ = (ω l − m₀)/((ω² − m₁) (I₁ − I₃))" in out


@pytest.mark.parametrize(("spin", "verdict"), [("1.3", "Lyapunov stable"), ("1.25", "undecided"), ("1.2", "unstable")])
def test_an_unstable_body_is_an_answer(capsys, spin, verdict):
    """Exit status 0 whatever the verdict."""
    status, out, _ = run(capsys, "--potential", "m0*k3", "--equilibrium", "E1", *TOP, "--set", f"omega3_0={spin}")
    assert status == 0 and f"Verdict: {verdict}" in out


def test_json(capsys):
    """Stable keys; the criteria as data; the decision where there are numbers for it."""
    _, out, _ = run(capsys, "--potential", "m0*k3", *TOP, "--set", "pi3_0=3", "--format", "json")
    data = json.loads(out)
    assert [e["label"] for e in data["equilibria"]] == ["E1", "E2", "E3"]
    (condition,) = data["equilibria"][0]["sufficient"]["any_of"][0]["all_of"]
    assert condition["margin"] == "-4*I1*m0 + l**2 + 2*l*pi3_0 + pi3_0**2" and condition["strict"] is True
    assert data["equilibria"][0]["decision"]["verdict"] == "STABLE" and "decision" not in data["equilibria"][2]


def test_free_body(capsys):
    """--potential none: three coordinates, no field."""
    status, out, _ = run(capsys, "--potential", "none", "--set", "I1=1", "--set", "I2=2", "--set", "I3=3", "--set", "l=0",
                         "--set", "omega3_0=1")
    assert status == 0 and "so(3)*" in out and "Lyapunov stable" in out


def test_the_tilt_is_solved_where_l_is_given(capsys):
    """E3 from m0, l and ω, without k3; at rest only where no numbers are set."""
    heavy = ["--potential", "m0*k3 + m1/2*(I3 - I1)*k3**2", "--equilibrium", "E3"]
    status, out, _ = run(capsys, *heavy, *(f"--set={s}" for s in ("I1=2", "I3=1", "l=1", "m0=1/2", "m1=1/4", "omega=1")))
    assert status == 0 and "Verdict: Lyapunov stable modulo the flow of π₃" in out and "At rest" not in out and "at rest" not in out
    assert "E3 at rest" in run(capsys, *heavy)[1] and "E3 at rest" not in run(capsys, "--potential", "m0*k3")[1]


def test_any_terminal():
    """A terminal whose encoding has no λ gets UTF-8; a reader that stops early is no error."""
    command = [sys.executable, "-m", "gyrostat", "report", "--equilibrium", "E1"]
    out = subprocess.run(command, capture_output=True, check=True, env={**os.environ, "PYTHONIOENCODING": "cp1252"}).stdout
    assert "λ⁴" in out.decode("utf-8")
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as piped:
        piped.stdout.close()                           # long before the first line is written
        assert piped.stderr.read() == b"" and piped.wait() == 0


def test_output_file(capsys, tmp_path):
    """LaTeX into a file; a folder that does not exist is an error without a traceback."""
    status, out, _ = run(capsys, "--format", "latex", "--output", str(tmp_path / "report.tex"))
    assert status == 0 and out == "" and r"\end{document}" in (tmp_path / "report.tex").read_text()
    status, _, err = run(capsys, "--output", str(tmp_path / "missing" / "report.tex"))
    assert status == 2 and "cannot write" in err


@pytest.mark.parametrize(("arguments", "why"), [
    (["--potential", "__import__('os').system('true')"], "cannot read"), (["--potential", "9**9**9"], "exponent"),
    (["--potential", "k3.real"], "grammar"), (["--potential", "m0"], "does not depend on k3"), (["--potential", "k1*k3"], "depends on k1"),
    (["--potential", ""], "too early"), (["--set", "I1"], "NAME=VALUE"), (["--set", "I1=1", "--set", "I1=2"], "twice"),
    (["--set", "I1=nan"], "contains the names"), (["--set", "I1=__import__('os')"], "cannot read"),
    (["--set", "mass=1"], "no parameter mass"), (["--set", "I1=1"], "not enough"), (["--set", "I1=-1", *TOP[4:], "--set", "pi3_0=1",
     "--set", "dU=1"], "no parameter m0"), (["--set", "pi3_0=1", "--set", "omega3_0=1"], "both"),
    (["--potential", "none", "--equilibrium", "E1"], "needs a field"),
    (["--equilibrium", "E1", "--set", "I1=-1", "--set", "l=0", "--set", "pi3_0=1", "--set", "dU=1"], "must be positive"),
    (["--equilibrium", "E3", "--set", "I1=1", "--set", "I3=1", "--set", "l=0", "--set", "omega=1", "--set", "d2U=1", "--set", "k3=2"],
     "exists only where")])
def test_bad_input_exits_2(capsys, arguments, why):
    """A clear error on stderr, nothing on stdout, no traceback."""
    status, out, err = run(capsys, *arguments)
    assert status == 2 and out == "" and err.startswith("gyrostat: ") and why in err and "Traceback" not in err


def test_usage(capsys):
    """--help has examples, --version the version, an unknown verb exits 2."""
    for arguments, status in ((["--help"], 0), (["report", "--help"], 0), (["--version"], 0), (["fly"], 2), ([], 2)):
        with pytest.raises(SystemExit) as stop:
            main(arguments)
        assert stop.value.code == status
    out = capsys.readouterr().out
    assert "gyrostat report --potential" in out and f"gyrostat {gyrostat.__version__}" in out


def test_the_module_runs():
    """python -m gyrostat is the command."""
    run = subprocess.run([sys.executable, "-m", "gyrostat", "--version"], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == f"gyrostat {gyrostat.__version__}"


def verify(capsys, *arguments):
    status = main(["verify", *arguments])
    captured = capsys.readouterr()
    return status, captured.out, captured.err


OWN = """[source]
name = "mine"
title = "A paper of my own"

[scene.top]
inertia = ["I1", "I1", "I3"]
potential = "m0*k3"
equilibrium = "E1"
spin = "omega3_0"

[[formula]]
key = "stable"
where = "eq. (1)"
quantity = "sufficient for stability"
printed = "(I3*omega3_0)**2 > 2*I1*m0"
kind = "condition"
scene = "top"
"""


def test_verify_text(capsys):
    """A table by source; what is wrong with what is right, and where; no progress where standard error is no terminal."""
    status, out, err = verify(capsys, "AR")
    assert status == 0 and err == "" and "39 confirmed, 5 misprint, 2 unchecked" in out and out.endswith("46 statements, all as expected\n")
    assert "printed:   (I2 - I3)*omega1*omega2" in out and "right:     (I2 - I3)*omega2*omega3" in out


def test_verify_json(capsys):
    """The documented keys; a misprint has its counterexample."""
    _, out, _ = verify(capsys, "AR", "--format", "json")
    data = json.loads(out)
    assert set(data[0]) == {"source", "key", "where", "quantity", "kind", "printed", "derived", "status", "expected", "difference",
                            "counterexample", "note"}
    (wrong,) = (d for d in data if d["key"] == "2K-dot")
    assert wrong["status"] == "misprint" and set(wrong["counterexample"]) == {"values", "printed", "derived", "confirmation"}
    assert wrong["derived"] == "dot(vector_pi, vector_omega)" and wrong["difference"][0]["entry"] is None


def test_verify_latex(capsys):
    """A table of errata, of misprints only, as a document or a fragment."""
    _, out, _ = verify(capsys, "AR", "EA", "--format", "latex")
    assert r"\begin{longtable}" in out and r"\omega_{2} \omega_{3}" in out and "K-constant" not in out and "norm" not in out
    _, part, _ = verify(capsys, "AR", "--format", "latex", "--fragment")
    assert part.startswith("% needs amsmath, array and longtable\n" + r"\begingroup") and r"\documentclass" not in part


def test_verify_a_file_of_ones_own(capsys, tmp_path):
    """Exit status 1 where a formula is not as expected, 2 where it cannot be read, with file and key."""
    path = tmp_path / "mine.toml"
    path.write_text(OWN)
    status, out, _ = verify(capsys, str(path))
    assert status == 1 and "expected: confirmed" in out and "1 of 1 are not as expected: mine:stable" in out
    assert "I₃² (ω₃⁰)² > 4 I₁ m₀" in out and "has the real part" in " ".join(out.split())
    path.write_text(OWN.replace("2*I1*m0", "4*I1*m0"))
    assert verify(capsys, str(path))[0] == 0
    path.write_text(OWN.replace("2*I1*m0", "4*I1*mass"))
    status, out, err = verify(capsys, str(path))
    assert status == 2 and out == "" and f"{path}: stable: " in err and "mass is not a name" in err
    assert verify(capsys, "VV2004")[0] == 2


def test_progress_on_a_terminal(capsys, monkeypatch):
    """A bar on standard error, wiped at the end."""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    _, out, err = verify(capsys, "EA")
    assert "#" in err and "EA" in err and err.rstrip(" ").endswith("\r") and "#" not in out


def test_conditions_and_fragments(capsys):
    """Only the conditions, as text or as a table; a fragment of the report; what does not go together is refused."""
    _, out, _ = run(capsys, "--conditions", "--equilibrium", "E1")
    assert "Necessary:" in out and "(π₃⁰ + l)² > 4 I₁ U′(1)" in out and "Scene" not in out
    _, out, _ = run(capsys, "--conditions", "--format", "latex", "--fragment")
    assert out.startswith("% needs amsmath and array\n" + r"\begin{tabular}") and "E3" in out
    _, out, _ = run(capsys, "--equilibrium", "E1", "--format", "latex", "--fragment")
    assert r"\documentclass" not in out and r"\begin{equation}" in out
    for arguments, why in ((["--fragment"], "--format latex"), (["--conditions", "--format", "json"], "leave out one")):
        status, out, err = run(capsys, *arguments)
        assert status == 2 and out == "" and why in err
