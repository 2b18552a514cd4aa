"""The command line: output, verdicts, errors, exit status."""
import io
import json
import os
import subprocess
import sys
import threading
from argparse import Namespace
from functools import cache

import pytest

import gyrostat
from gyrostat.cli.batch_lines import question
from gyrostat.cli.options import report_for
from gyrostat.cli.parser import main
from gyrostat.errors import PublishedError, ValuesError
from gyrostat.mechanics.families import FAMILIES
from gyrostat.mechanics.family import Family
from gyrostat.published import check
from gyrostat.published.scenes import Scene

TOP = ["--set", "I1=1", "--set", "I3=1.6", "--set", "l=0", "--set", "m0=1"]


def run(capsys, *arguments, verb="report"):
    status = main([verb, *arguments])
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


@pytest.mark.parametrize(("spin", "verdict"),
                         [("1.3", "Lyapunov stable"), ("1.25", "Lyapunov stable"), ("1.2", "unstable")])
def test_an_unstable_body_is_an_answer(capsys, spin, verdict):
    """Exit status 0 whatever the verdict."""
    status, out, _ = run(capsys, "--potential", "m0*k3", "--equilibrium", "E1", *TOP, "--set",
                         f"omega3_0={spin}")
    assert status == 0 and f"Verdict: {verdict}" in out


def test_json(capsys):
    """Stable keys; the criteria as data; the decision where there are numbers for it."""
    _, out, _ = run(capsys, "--potential", "m0*k3", *TOP, "--set", "pi3_0=3", "--format", "json")
    data = json.loads(out)
    assert [e["label"] for e in data["equilibria"]] == ["E1", "E2", "E3"]
    (condition,) = data["equilibria"][0]["sufficient"]["any_of"][0]["all_of"]
    assert condition["margin"] == "-4*I1*m0 + l**2 + 2*l*pi3_0 + pi3_0**2" and condition["strict"] is True
    assert data["equilibria"][0]["decision"]["verdict"] == "STABLE"
    assert "decision" not in data["equilibria"][2]


def test_free_body(capsys):
    """--potential none: three coordinates, no field."""
    status, out, _ = run(capsys, "--potential", "none", "--set", "I1=1", "--set", "I2=2", "--set", "I3=3",
                         "--set", "l=0",
                         "--set", "omega3_0=1")
    assert status == 0 and "so(3)*" in out and "Lyapunov stable" in out


def test_the_tilt_is_solved_where_l_is_given(capsys):
    """E3 from m0, l and ω, without k3; at rest only where no numbers are set."""
    heavy = ["--potential", "m0*k3 + m1/2*(I3 - I1)*k3**2", "--equilibrium", "E3"]
    status, out, _ = run(capsys, *heavy, *(f"--set={s}"
                                           for s in ("I1=2", "I3=1", "l=1", "m0=1/2", "m1=1/4", "omega=1")))
    assert status == 0
    assert "Verdict: Lyapunov stable modulo the flow of π₃" in out
    assert "At rest" not in out
    assert "at rest" not in out
    assert "E3 at rest" in run(capsys, *heavy)[1]
    assert "E3 at rest" not in run(capsys, "--potential", "m0*k3")[1]


@pytest.mark.slow
def test_any_terminal():
    """A terminal whose encoding has no λ gets UTF-8; a reader that stops early is no error."""
    command = [sys.executable, "-m", "gyrostat", "report", "--equilibrium", "E1"]
    out = subprocess.run(command, capture_output=True, check=True,
                         env={**os.environ, "PYTHONIOENCODING": "cp1252"}).stdout
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
    (["--potential", "__import__('os').system('true')"], "cannot read"),
    (["--potential", "9**9**9"], "exponent"),
    (["--potential", "k3.real"], "grammar"), (["--potential", "m0"], "does not depend on k3"),
    (["--potential", "k1*k3"], "depends on k1"),
    (["--potential", ""], "too early"), (["--set", "I1"], "NAME=VALUE"),
    (["--set", "I1=1", "--set", "I1=2"], "twice"),
    (["--set", "I1=nan"], "not finite"), (["--set", "I1=__import__('os')"], "cannot read"),
    (["--set", "mass=1"], "no parameter mass"), (["--set", "I1=1"], "not enough"),
    (["--set", "I1=-1", *TOP[4:], "--set", "pi3_0=1",
     "--set", "dU=1"], "no parameter m0"), (["--set", "pi3_0=1", "--set", "omega3_0=1"], "both"),
    (["--potential", "none", "--equilibrium", "E1"], "needs a field"),
    (["--equilibrium", "E1", "--set", "I1=-1", "--set", "l=0", "--set", "pi3_0=1", "--set", "dU=1"],
     "must be positive"),
    (["--equilibrium", "E3", "--set", "I1=1", "--set", "I3=1", "--set", "l=0", "--set", "omega=1", "--set",
      "d2U=1", "--set", "k3=2"],
     "exists only where")])
def test_bad_input_exits_2(capsys, arguments, why):
    """A clear error on stderr, nothing on stdout, no traceback."""
    status, out, err = run(capsys, *arguments)
    assert status == 2
    assert out == ""
    assert err.startswith("gyrostat: ")
    assert why in err
    assert "Traceback" not in err


def test_usage(capsys):
    """--help has examples, --version the version, an unknown verb exits 2."""
    helped = [([verb, "--help"], 0) for verb in ("report", "conditions", "decide", "chart", "verify")]
    for arguments, status in (*helped, (["--help"], 0), (["--version"], 0), (["fly"], 2), ([], 2)):
        with pytest.raises(SystemExit) as stop:
            main(arguments)
        assert stop.value.code == status
    out = capsys.readouterr().out
    assert "gyrostat report --potential" in out and f"gyrostat {gyrostat.__version__}" in out


@pytest.mark.slow
def test_the_module_runs():
    """python -m gyrostat is the command."""
    run = subprocess.run([sys.executable, "-m", "gyrostat", "--version"], capture_output=True, text=True,
                         check=True)
    assert run.stdout.strip() == f"gyrostat {gyrostat.__version__}"


def verify(capsys, *arguments):
    return run(capsys, *arguments, verb="verify")


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


findings = cache(lambda source: check([source]))


@pytest.fixture
def checked_once(monkeypatch):
    """The sources are checked by the first test that asks for them."""
    monkeypatch.setattr("gyrostat.cli.verify.check",
                        lambda sources, progress=None: [f for source in sources for f in findings(source)])


def test_verify_text(capsys):
    """A table by source; what is wrong with what is right, and where.

    No progress where standard error is no terminal.
    """
    status, out, err = verify(capsys, "AR")
    assert status == 0
    assert err == ""
    assert "39 confirmed, 5 misprint, 2 unchecked" in out
    assert out.endswith("46 statements, all as expected\n")
    assert "printed:   (I2 - I3)*omega1*omega2" in out and "right:     (I2 - I3)*omega2*omega3" in out


def test_verify_json(capsys, checked_once):
    """The documented keys; a misprint has its counterexample."""
    _, out, _ = verify(capsys, "AR", "--format", "json")
    data = json.loads(out)["statements"]
    assert set(data[0]) == {"source", "key", "where", "quantity", "kind", "printed", "derived", "status",
                            "expected", "difference",
                            "counterexample", "not_sharp", "remark", "note"}
    (wrong,) = (d for d in data if d["key"] == "2K-dot")
    assert wrong["status"] == "misprint"
    assert set(wrong["counterexample"]) == {"values", "printed", "derived", "confirmation"}
    assert wrong["derived"] == "dot(vector_pi, vector_omega)" and wrong["difference"][0]["entry"] is None


def test_verify_latex(capsys, checked_once):
    """A table of errata, of misprints only, as a document or a fragment."""
    _, out, _ = verify(capsys, "AR", "EA", "--format", "latex")
    assert r"\begin{longtable}" in out
    assert r"\omega_{2} \omega_{3}" in out
    assert "K-constant" not in out
    assert "norm" not in out
    _, part, _ = verify(capsys, "AR", "--format", "latex", "--fragment")
    assert part.startswith("% needs amsmath, array and longtable\n" + r"\begingroup")
    assert r"\documentclass" not in part


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
    _, out, err = verify(capsys, "AR")
    assert "#" in err and "AR" in err and err.rstrip(" ").endswith("\r") and "#" not in out


def test_conditions_and_fragments(capsys):
    """Existence, conditions and ladder as text, table or data; a fragment of the report.

    What does not go together is refused.
    """
    _, out, _ = run(capsys, "--equilibrium", "E1", verb="conditions")
    assert "Necessary:" in out and "(π₃⁰ + l)² > 4 I₁ U′(1)" in out and "−c₃ ∝ U′(1) + U″(1)" in out
    assert "Scene" not in out and "E2" not in out
    _, out, _ = run(capsys, verb="conditions")
    assert "|k₃| < 1" in out and "E2" in out and "E3" in out
    _, out, _ = run(capsys, "--format", "latex", "--fragment", verb="conditions")
    assert out.startswith("% needs amsmath and array\n" + r"\begin{tabular}")
    assert "E3" in out
    assert r"$-c_{3} \propto U'(1) + U''(1)$" in out
    assert out.endswith("of an odd power at E3 both are unstable.\\par\n")
    _, out, _ = run(capsys, "--equilibrium", "E1", "--format", "latex", "--fragment")
    assert r"\documentclass" not in out and r"\begin{equation}" in out
    for verb in ("report", "conditions"):
        status, out, err = run(capsys, "--fragment", verb=verb)
        assert status == 2 and out == "" and "--format latex" in err


def test_conditions_as_data(capsys):
    """The keys of the report that are about conditions, with the ladder, and its last power."""
    _, out, _ = run(capsys, "--potential", "m0*k3 + m1*k3**2", "--format", "json", verb="conditions")
    e1, _, e3, _ = json.loads(out)["equilibria"]
    assert set(e1) == {"label", "positive", "eliminated", "parameters", "necessary", "sufficient", "boundary"}
    assert [(r["power"], r["margin"], r["escapes"]) for r in e1["boundary"]["rungs"]] == [
        (3, "m0 + 4*m1", False),
        (4, "-m1", False),
    ]
    assert e1["boundary"]["last"] == 4 and e3["boundary"]["rungs"][0]["escapes"] is True
    _, out, _ = run(capsys, "--potential", "none", "--format", "json", verb="conditions")
    assert json.loads(out)["equilibria"][0]["boundary"] is None


def test_conditions_at_numbers(capsys):
    """Numbers take the place of their names.

    What the family expresses by the others, or where it does not exist, is refused.
    """
    heavy = ["--potential", "m0*k3", "--set", "I1=1", "--set", "m0=3"]
    _, out, _ = run(capsys, *heavy, "--equilibrium", "E1", verb="conditions")
    assert "(π₃⁰ + l)² > 12" in out and "−c₃ ∝ 1" in out and "h − π₃²/(2 I₃) − 3 k₃" in out
    _, out, _ = run(capsys, *heavy, "--equilibrium", "E2", verb="conditions")
    assert "Necessary: always." in out and "−c₃" not in out
    _, out, _ = run(capsys, *heavy, "--set", "omega3_0=1", "--set", "I3=2", "--set", "l=1", "--equilibrium",
                    "E1", verb="conditions")
    assert "Necessary: never." in out and "Sufficient: no information" in out
    _, out, _ = run(capsys, "--potential", "m0*k3 + m1*k3**2", "--set", "k3=1/2", "--equilibrium", "E3",
                    verb="conditions")
    assert out.splitlines()[2] == "    ω ≠ 0" and "g = 2 I₁ (1 − k₃²)" in out and "−c₃ ∝ −m₀ − 2 m₁" in out
    for arguments, why in ((["--set", "k3=2", "--equilibrium", "E3", "--potential", "m0*k3"],
                            "exists only where 1 - k3**2 > 0"),
                           (["--set", "dU=1"], "derivative of U"), (["--set", "mass=1"], "no parameter mass"),
                           (["--set", "l=1", "--potential", "k3**4", "--equilibrium", "E3"],
                            "expresses l by")):
        status, out, err = run(capsys, *arguments, verb="conditions")
        assert status == 2 and out == "" and why in err


def test_the_report_shows_what_decides_between_the_criteria(capsys):
    """The reduced motion and its ladder; an end where U is rational.

    Of an asymmetric body nothing is claimed.
    """
    _, out, _ = run(capsys)
    for line in ("I₁² k̇₃² = g", "g = 2 I₁ (1 − k₃²) (h − π₃²/(2 I₃) − U(k₃)) − (C₁ − k₃ (π₃ + l))²",
                 "−c₅ ∝ 2 U‴(1) + U⁽⁴⁾(1)",
                 "k₃ = x − 1", "(supercritical)", "to any order", "of an even power",
                 "∂σ/∂ω = (2 ω k₃ (I₁ − I₃) − l)/(I₃ ω)",
                 "(l − 2 ω k₃ (I₁ − I₃))²", "I₁ = I₃, l = 0, ω ≠ 0"):
        assert line in out
    assert "nothing is claimed" not in out and "c₆" not in out
    _, out, _ = run(capsys, "--potential", "k3**2", "--equilibrium", "E1")
    assert "−c₃ ∝ 1" in out and "c₄ x⁴ + …" in out and "−c₄" not in out and "all vanish" not in out
    _, out, _ = run(capsys, "--potential", "a*k3 + b*k3**4", "--equilibrium", "E1")
    assert "−c₄ ∝ −b" in out
    assert "−c₅" not in out
    assert "If all vanish, every k₃ nearby is a motion: unstable." in " ".join(out.split())
    _, out, _ = run(capsys, "--potential", "exp(a*k3)", "--equilibrium", "E2")
    assert "up to x²⁴" in out and "−c₄ ∝ −a² (3 − 2 a)" in out
    assert "nothing is claimed" not in out
    assert "momentum\n  sphere decides to fourth order" in run(capsys, "--potential", "none")[1]
    from gyrostat import Gyrostat, analyze, assemble, general_potential, upright
    asymmetric = assemble(Gyrostat(gyrostatic_momentum=(0, 0, 0)),
                          general_potential(lambda x, y, z: z + x**2))
    assert "nothing is claimed" in str(analyze(upright(asymmetric)))


def decide(capsys, *arguments):
    return run(capsys, *arguments, verb="decide")


def settings(**numbers):
    return [f"--set={name}={value}" for name, value in numbers.items()]


HEAVY = ["--potential", "m0*k3"]


@pytest.mark.parametrize(("potential", "spin", "verdict", "why"), [
    ("m0*k3", "1.25", "Lyapunov stable", "supercritical"),
    ("m0*k3", "1.2", "unstable", "Reason (spectral): an eigenvalue"),
    ("m0*k3", "1.3", "Lyapunov stable", "definite"),
    ("m0*k3 - m0*(k3 - 1)**2", "1.25", "unstable", "Reason (Lyapunov): on the boundary")])
def test_decide_one_equilibrium(capsys, potential, spin, verdict, why):
    """Verdict, margins, notion and reason.

    Exit status 0 whatever it is, and unstable where the boundary says so.
    """
    status, out, err = decide(capsys, "--equilibrium", "E1", "--potential", potential, *TOP, "--set",
                              f"omega3_0={spin}")
    assert (status, err) == (0, "") and f"Verdict: {verdict};" in out and why in out
    assert "(I₃ ω₃⁰ + l)² − 4 I₁ m₀ = " in out or potential != "m0*k3"
    assert "The point itself" not in out


def test_decide_as_data(capsys):
    """The keys of a decision, with its note."""
    _, out, _ = decide(capsys, "--equilibrium", "E1", *HEAVY, *settings(I1=1, I3=9, l=0, m0=1, pi3_0=3),
                       "--format", "json")
    (e1,) = json.loads(out)["equilibria"]
    assert set(e1) == {"label", "decision"}
    assert set(e1["decision"]) == {"verdict", "notion", "modulo", "reason", "margins", "note"}
    assert e1["decision"]["verdict"] == "STABLE" and "no rigid body" in e1["decision"]["note"]


def test_decide_the_tilted_point_itself(capsys):
    """E3 is decided modulo the spin and, besides, as a point: not Lyapunov stable."""
    status, out, _ = decide(capsys, "--equilibrium", "E3", *settings(I1=4, I3=5, l=2, omega=1, k3=0, d2U=1))
    assert status == 0
    assert "Verdict: Lyapunov stable modulo the flow of π₃;" in out
    assert "The point itself: unstable;" in out
    assert "Jordan block" in out and "∂σ/∂k3" in out
    _, out, _ = decide(capsys, "--equilibrium", "E3", "--potential", "k3**2",
                       *settings(I1=4, I3=5, l=2, omega=0, k3=0))
    assert "E3 at rest" in out and "at any rate σ" in out


def test_decide_every_tilt(capsys):
    """E3 by ω and l, or by k3 and l: every one there is, exact and as a decimal."""
    cubic = ["--equilibrium", "E3", "--potential", "m0*k3 + a*k3**3",
             *settings(I1=2, I3=1, l=1, m0="1/2", a="1/3")]
    _, out, _ = decide(capsys, *cubic, "--set", "omega=1", "--format", "json")
    (e3,) = json.loads(out)["equilibria"]
    assert e3["k3"] == {"exact": "-1/2 + sqrt(3)/2", "decimal": 0.36602540378443865}
    assert e3["omega"]["exact"] == "1"
    assert e3["decision"]["modulo"] == ["pi3"] and e3["itself"]["verdict"] == "UNSTABLE"
    _, out, _ = decide(capsys, *cubic, "--set", "k3=1/10")
    assert out.count("Verdict") == 2 and out.count("The point itself") == 2 and "k₃ = 1/10 ≈ 0.1" in out
    status, out, _ = decide(capsys, "--equilibrium", "E3", *HEAVY, *settings(I1=2, I3=1, l=1, m0=9, omega=1))
    assert status == 0 and out.strip() == "No such relative equilibrium exists at these numbers."


def test_decide_all_that_the_numbers_allow(capsys):
    """Without --equilibrium: what a rate, or a tilt and a spin, allow; else those whose names are set."""
    top = [*HEAVY, *settings(I1=2, I3=1, l=0, m0=3), "--format", "json"]

    def labels(*more):
        return [
            e["label"]
            for e in json.loads(decide(capsys, *top, *settings(**dict(m.split("=") for m in more)))[1])[
                "equilibria"
            ]
        ]

    assert labels("omega=2") == ["E1", "E3", "E2"]
    assert labels("pi3_0=4") == labels("omega3_0=4") == ["E1", "E2"]
    assert labels("k3=1/2", "pi3_0=6") == labels("k3=1/2", "omega3_0=6") == ["precession", "precession"]
    wheel = [*HEAVY, *settings(I1=2, I3=4, l=0, m0=3, k3="1/2"), "--format", "json"]
    assert decide(capsys, *wheel, "--set=omega3_0=2") == decide(capsys, *wheel, "--set=pi3_0=8")
    _, out, _ = decide(capsys, "--potential", "none", *settings(I1=1, I2=2, I3=3, l=0, omega3_0=1))
    assert "rotation about axis 3" in out and "Lyapunov stable" in out


@pytest.mark.parametrize(("arguments", "why"), [
    ([], "not enough"), (["--equilibrium", "E1", "--set", "I1=1"], "E1 needs"),
    (["--equilibrium", "E3", *HEAVY, *TOP], "k3 or omega"),
    (["--equilibrium", "E1", *HEAVY, *TOP, "--set", "pi3_0=1", "--set", "k3=1"], "no parameter k3"),
    (["--equilibrium", "E1", "--potential", "none"], "needs a field"),
    (["--set", "pi3_0=1", "--set", "omega3_0=1"], "both"),
    (["--equilibrium", "E3", *HEAVY, *TOP, "--set", "k3=1/2", "--set", "omega=1"], "not on E3"),
    (["--potential", "exp(k3)", *TOP[:6], "--set", "pi3_0=1", "--set", "C1=1"], "roots are not found"),
    (["--set", "mass=1"], "no parameter mass"),
    (["--batch", "/nowhere/at.all"], "cannot read"), (["--batch", "-", "--format", "text"], "writes JSON"),
    (["--batch", "-", "--potential", "k3.real"], "grammar"),
    (["--batch", "-", "--set", "I1=x"], "contains the names")])
def test_decide_bad_input_exits_2(capsys, arguments, why):
    """A clear error on stderr, nothing on stdout."""
    status, out, err = decide(capsys, *arguments)
    assert status == 2
    assert out == ""
    assert err.startswith("gyrostat: ")
    assert why in err
    assert "Traceback" not in err


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
                   (21, "needs a field")):
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


def test_reports_are_derived_once(capfd, monkeypatch):
    """One derivation for each potential, equilibrium and name of the spin."""
    from gyrostat.cli import options as scenes
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


def conditions(capsys, *arguments):
    status = main(["conditions", *arguments])
    captured = capsys.readouterr()
    return status, captured.out, captured.err


def test_solve_for_the_rotor(capsys):
    """Which l stabilises: E1 in closed form, as text and JSON.

    E3 in U' affine by its existence, of a polynomial along its tilts.
    """
    status, out, _ = conditions(capsys, "--potential", "m0*k3", "--equilibrium", "E1", "--solve-for", "l")
    assert status == 0 and "Stable for m₀ > 0: l ≤ −π₃⁰ − 2 √(I₁ m₀) or l ≥ 2 √(I₁ m₀) − π₃⁰." in out
    _, out, _ = conditions(capsys, "--potential", "m0*k3", "--equilibrium", "E1", "--solve-for", "l",
                           "--format", "json")
    (solved,) = json.loads(out)["equilibria"]
    assert solved["label"] == "E1" and solved["name"] == "l" and solved["parts"][0]["meaning"] == "stable"
    above = solved["parts"][0]["cases"][2]
    assert above["when"] == [{"expression": "m0", "compared_with_0": ">"}]
    assert above["intervals"][0] == {"low": "-oo", "low_if": [], "high": "-2*sqrt(I1)*sqrt(m0) - pi3_0",
                                     "high_if": ["1"], "tilt": None}
    _, out, _ = conditions(capsys, "--potential", "m0*k3", "--equilibrium", "E3", "--solve-for", "l")
    assert "ω² (I₁ − I₃) ≠ 0" in out and "It exists: m₀/ω − |I₁ − I₃| |ω| < l < |I₁ − I₃| |ω| + m₀/ω." in out
    numbers = ["--set", "I1=2", "--set", "I3=1", "--set", "omega=1"]
    _, out, _ = conditions(capsys, "--potential", "k3**5 - k3**2 + k3", "--equilibrium", "E3", "--solve-for",
                           "l", *numbers)
    assert "0.723697637602… ≤ l < 7 (k₃ from 0.368403149864… to −1)" in " ".join(out.split())
    newton = ["--potential", "m0*k3 + m1/2*(I3 - I1)*k3**2", "--equilibrium", "E3", "--solve-for", "l"]
    _, out, _ = conditions(capsys, *newton, *numbers, "--set", "m0=1", "--set", "m1=5")
    assert "9/5 < l < 5 (k₃ from −1/5 to −1) or −3 < l < −9/11 (k₃ from 1 to 5/11)" in " ".join(out.split())


def test_solve_for_with_numbers(capsys):
    """Numbers for some names are inserted, numbers for all give exact ends.

    omega3_0 is the spin where it is asked for.
    """
    _, out, _ = conditions(capsys, "--potential", "m0*k3", "--equilibrium", "E1", "--solve-for", "m0",
                           "--set", "I1=1", "--set", "l=0")
    assert "Stable: m₀ < (π₃⁰)²/4; m₀ = (π₃⁰)²/4 too where (π₃⁰)² > 0." in out
    _, out, _ = conditions(capsys, "--potential", "m0*k3", "--equilibrium", "E1", "--solve-for", "omega3_0",
                           "--set", "I1=1",
                           "--set", "I3=1.6", "--set", "l=0", "--set", "m0=1")
    assert "Stable: ω₃⁰ ≤ −5/4 or ω₃⁰ ≥ 5/4." in out
    _, out, _ = conditions(capsys, "--potential", "exp(k3)", "--equilibrium", "E1", "--solve-for", "l",
                           "--set", "I1=1", "--set", "pi3_0=1")
    assert "l ≤ −1 − 2 exp(1/2)" in out
    _, out, _ = conditions(capsys, "--potential", "m0*k3", "--solve-for", "l", "--format", "latex",
                           "--fragment")
    assert out.startswith("% needs amsmath\n")
    assert r"\sqrt{I_1 m_0}" in out
    assert "<" not in out.replace("$<$", "").replace(" < ", "")


@pytest.mark.parametrize(("arguments", "why"), [
    (["--solve-for", "mass"], "no parameter mass"),
    (["--potential", "m0*k3", "--solve-for", "l", "--set", "l=1"], "leave out one of the two"),
    (["--potential", "m0*k3 + m1/2*(I3 - I1)*k3**2", "--equilibrium", "E1", "--solve-for", "I1"],
     "give numbers"),
    (["--potential", "k3**3", "--equilibrium", "E3", "--solve-for", "k3"], "give numbers"),
    (["--potential", "exp(k3)", "--equilibrium", "E3", "--solve-for", "l"], "ties l to the other names")])
def test_what_cannot_be_solved_is_said(capsys, arguments, why):
    """A name that is unknown or given, a form that is not solved: exit status 2 and what to do."""
    status, out, err = conditions(capsys, *arguments)
    assert status == 2 and out == "" and why in err


def test_what_is_solved_is_shown_beside_what_is_not(capsys):
    """E1 and E2 in pi3_0, which E3 does not have: a line says so; JSON has it under error."""
    status, out, _ = conditions(capsys, "--potential", "m0*k3", "--solve-for", "pi3_0")
    assert status == 0
    assert out.count("Stable for m₀ = 0: π₃⁰ ≠ −l.") == 2
    assert "E3 has no parameter pi3_0" in out
    _, out, _ = conditions(capsys, "--potential", "m0*k3", "--solve-for", "pi3_0", "--format", "json")
    assert [("error" in e, e["label"]) for e in json.loads(out)["equilibria"]] == [
        (False, "E1"),
        (False, "E2"),
        (True, "E3"),
    ]
    _, out, _ = conditions(capsys, "--potential", "m0*k3", "--equilibrium", "E3", "--solve-for", "k3",
                           "--set", "I1=2", "--set", "I3=1",
                           "--set", "m0=3", "--set", "l=1", "--set", "omega=1")
    assert "Stable: no k₃." in out and "l = (ω² k₃ (I₁ − I₃) + m₀)/ω" in out


def test_numbers_that_contradict_each_other(capsys):
    """omega and a momentum name different points: refused unless an equilibrium is named."""
    status = main(["decide", "--potential", "m0*k3",
                   *(f"--set={s}" for s in ("I1=2", "I3=1", "m0=3", "l=1", "pi3_0=1", "omega=2"))])
    captured = capsys.readouterr()
    assert status == 2 and captured.out == "" and "omega and a momentum are both given" in captured.err


SPINS = ["--potential", "m0*k3", "--equilibrium", "E1", "--x", "pi3_0=-4:4:40", "--y", "l=-2:2:30", "--set",
         "I1=1", "--set", "m0=1/3"]


def chart(capsys, *arguments):
    status = main(["chart", *arguments])
    captured = capsys.readouterr()
    return status, captured.out, captured.err


@pytest.mark.parametrize(("kind", "start"), [("png", b"\x89PNG"), ("pdf", b"%PDF"), ("svg", b"<?xml")])
def test_a_chart_as_a_picture(capsys, tmp_path, kind, start):
    """The kind is that of the name; a file that is there is written again."""
    path = tmp_path / f"chart.{kind}"
    path.write_text("old")
    assert chart(capsys, *SPINS, "--output", str(path)) == (0, "", "")
    assert path.read_bytes().startswith(start) and path.stat().st_size > 5000


def test_a_chart_as_data(capsys, tmp_path):
    """netCDF and Zarr hold the chart of the library at the numbers of the command line.

    NetCDF is written again, Zarr is continued.
    """
    import numpy as np
    import xarray as xr

    import gyrostat as gs
    from gyrostat.charts.chart import stability_chart
    top = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    wanted = stability_chart(top, x=("pi3_0", np.linspace(-4, 4, 40)), y=("l", np.linspace(-2, 2, 30)),
                             fixed={"I1": "1", "m0": "1/3"})
    for kind in ("nc", "nc", "zarr", "zarr"):
        path = str(tmp_path / f"chart.{kind}")
        assert chart(capsys, *SPINS, "--output", path) == (0, "", "")
        with xr.open_dataset(path) if kind == "nc" else xr.open_zarr(path, consolidated=False) as found:
            xr.testing.assert_identical(found.drop_vars("complete", errors="ignore").compute(), wanted)
    status, out, err = chart(capsys, *SPINS, "--axis", "I3=1:2:3", "--output", path)
    assert status == 2 and out == "" and "is the store of another chart" in err


@pytest.mark.parametrize(("arguments", "dims"), [
    (["--potential", "none", "--x", "omega3_0=0:1:3", "--y", "l=0:1:4", "--set", "I1=1", "--set", "I2=2",
      "--set", "I3=3"],
     ("l", "omega3_0")),
    (["--potential", "m0*k3", "--equilibrium", "E2", "--x", "omega3_0=0:1:3", "--y", "l=0:1:4", "--axis",
      "m0=-1:sqrt(2):2", "--axis",
      "I1=1:2:2", "--set", "I3=1"], ("m0", "I1", "l", "omega3_0")),
    (["--potential", "m0*k3 + m1/2*(I3 - I1)*k3**2", "--equilibrium", "E3", "--x", "l=0:1:3", "--y",
      "omega=1:2:4", "--set", "I1=2",
      "--set", "I3=1", "--set", "m0=1", "--set", "m1=1/4"], ("omega", "l"))])
def test_axes_of_a_chart(capsys, tmp_path, arguments, dims):
    """A free body; the other name of the spin, and further axes.

    E3 with its tilt eliminated, because l is an axis.
    """
    import xarray as xr
    assert chart(capsys, *arguments, "--output", str(tmp_path / "chart.nc")) == (0, "", "")
    with xr.open_dataset(tmp_path / "chart.nc") as found:
        assert found.verdict.dims == dims
        if "m0" in dims:
            assert found.m0.values.tolist() == [-1.0, 2**0.5]


@pytest.mark.parametrize(("arguments", "why"), [
    ([], "--output is missing, a chart goes to a file: name a picture, chart.png, .pdf or .svg; data, "
         "chart.nc or chart.zarr"),
    (["--output", "chart.txt"], "of no kind"), (["--output", "missing/chart.png"], "cannot write"),
    (["--output", "missing/chart.zarr"], "cannot write"), (["--output", "missing/chart.nc"], "No such file"),
    (["--axis", "I3=1:2:3", "--output", "chart.png"], "a picture has two axes"),
    (["--axis", "I3=1:2:1000000", "--output", "chart.nc"], "1200000000 points are more than"),
    (["--x", "l=1:2:3", *["--output", "c.nc"]],
     "l is an axis twice"), (["--x", "pi3_0=1:2", "--output", "c.nc"], "NAME=LOW:HIGH:COUNT"),
    (["--x", "pi3_0=1:1:9", "--output", "c.nc"],
     "not strictly monotonic"), (["--x", "pi3_0=1:2:1", "--output", "c.nc"], "COUNT 1"),
    (["--x", "pi3_0=0:1:x", "--output", "c.nc"], "COUNT x"),
    (["--x", "pi3_0=0:__import__('os'):9", "--output", "c.nc"], "cannot read"),
    (["--set", "l=1", "--output", "c.nc"], "l is given twice"),
    (["--set", "mass=1", "--output", "c.nc"], "no parameter mass"),
    (["--set", "omega3_0=1", "--output", "c.nc"], "both"),
    (["--potential", "m0*k3**2 + m1*k3", "--output", "c.nc"], "E1 needs m1"),
    (["--potential", "none", "--output", "c.nc"], "needs a field"),
    (["--backend", "numba", "--set", "I1=-1", "--output", "c.nc"], "gives I1 twice")])
def test_bad_charts_exit_2(capsys, tmp_path, monkeypatch, arguments, why):
    """A clear error on stderr, nothing on stdout, nothing written."""
    monkeypatch.chdir(tmp_path)
    status, out, err = chart(capsys, *SPINS, *arguments)
    assert status == 2
    assert out == ""
    assert err.startswith("gyrostat: ")
    assert why in err
    assert len(err.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []


def test_a_chart_names_its_equilibrium(capsys):
    """Without --equilibrium there is no chart of a body in a field."""
    status, _, err = chart(capsys, *SPINS[:2], *SPINS[4:], "--output", "chart.png")
    assert status == 2 and "--equilibrium is missing" in err


@pytest.mark.parametrize(("missing", "kind", "extra"),
                         [("matplotlib", "png", "plot"), ("netCDF4", "nc", "charts"),
                                                        ("xarray", "zarr", "charts"),
                          ("zarr", "zarr", "charts")])
def test_missing_extras_are_named(capsys, tmp_path, monkeypatch, missing, kind, extra):
    """The pip command, exit status 2."""
    monkeypatch.setitem(sys.modules, missing, None)
    status, out, err = chart(capsys, *SPINS, "--output", str(tmp_path / f"chart.{kind}"))
    assert status == 2
    assert out == ""
    assert f'pip install "gyrostat[{extra}]"' in err
    assert list(tmp_path.iterdir()) == []


def test_progress_of_a_chart(capsys, tmp_path, monkeypatch):
    """A bar on a terminal, of the blocks of a store, wiped at the end."""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr("gyrostat.charts.stores.POINTS", 3 * 40)
    monkeypatch.setattr("gyrostat.charts.progress.PAUSE", 0.0)
    status, out, err = chart(capsys, *SPINS, "--output", str(tmp_path / "chart.zarr"))
    assert status == 0 and out == "" and "chart        [" in err and "] 10/10" in err and err.endswith(" \r")


def test_e1_and_e2_are_decided_where_tilts_are_not_found(capsys):
    """A rate with π in a quartic field: its tilts are no roots that can be named, which is said.

    With JSON too.
    """
    status = main(["decide", "--potential", "k3**4 - k3**2/2", "--set", "I1=2", "--set", "I3=1", "--set",
                   "l=1", "--set", "omega=2*pi",
                   "--format", "json"])
    answers = json.loads(capsys.readouterr().out)["equilibria"]
    assert status == 0 and [a["label"] for a in answers] == ["E1", "E2", "E3"]
    assert [a["decision"]["verdict"] for a in answers[:2]] == ["STABLE", "STABLE"]
    assert "algebraic coefficients" in json.dumps(answers[2])


@pytest.fixture
def asleep(monkeypatch):
    """A family more: E1 under another label, made without a choice of names."""
    def make(scene):
        return gyrostat.equilibrium(scene, gyrostat.upright(scene).point, label="E4")
    monkeypatch.setitem(FAMILIES, "E4", Family("E4", "asleep", "asleep on its point", make, pole=1,
                                               asked_for="E4", source="Klein & Sommerfeld 1897"))


def test_a_family_is_one_entry(capsys, asleep):
    """One more in the registry: reports, conditions, verdicts, batches, help, charts and published scenes."""
    status, out, _ = run(capsys, "--equilibrium", "E4")
    assert status == 0 and "E4: asleep on its point" in out and "(Klein & Sommerfeld 1897)" in out
    assert [e["label"] for e in json.loads(run(capsys, "--format", "json")[1])["equilibria"]] == [
        "E1", "E2", "E3", "E4"]
    numbers = [*TOP, "--set", "pi3_0=3"]
    _, out, _ = run(capsys, "--potential", "m0*k3", "--equilibrium", "E4", *numbers, verb="decide")
    assert out.startswith("E4\n") and "Verdict: Lyapunov stable" in out
    _, out, _ = run(capsys, "--potential", "m0*k3", "--equilibrium", "E4", "--solve-for", "l",
                    "--set", "I1=1", "--set", "m0=1", "--set", "pi3_0=1", verb="conditions")
    assert out.startswith("E4\n") and "l ≥ 1" in out
    line = question(b'{"equilibrium": "E4", "I1": 1}', Namespace(potential=None, equilibrium=None), {})
    assert line[1] == "E4"
    with pytest.raises(SystemExit):
        main(["chart", "--help"])
    assert "{E1,E2,E3,E4}" in capsys.readouterr().out
    assert Scene({"potential": "U(k3)", "equilibrium": "E4"}).equilibrium.label == "E4"
    with pytest.raises(PublishedError, match="give E1, E2, E3, axis 1, axis 2, axis 3 or E4"):
        assert Scene({"potential": "U(k3)", "equilibrium": "E5"}).equilibrium
    with pytest.raises(ValuesError, match="name E1, E2, E3 or E4"):
        report_for("chart", None, None, {})
