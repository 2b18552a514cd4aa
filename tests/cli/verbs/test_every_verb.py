"""The command line: reports, usage, errors, exit status; one more family in every verb."""
import json
import os
import subprocess
import sys
from argparse import Namespace

import pytest
from commands import run

import gyrostat
from gyrostat.cli.batch.batch_lines import Questions
from gyrostat.cli.parser import main, parser
from gyrostat.errors import PublishedError, ValuesError
from gyrostat.mechanics.families.family import Family
from gyrostat.mechanics.families.named_families import FAMILIES
from gyrostat.published.scenes import Scene
from gyrostat.questions.answers.equilibria import report_for
from gyrostat.questions.scene_texts import Asked

TOP = ["--set", "I1=1", "--set", "I3=1.6", "--set", "l=0", "--set", "m0=1"]


def test_report_of_any_field(capsys):
    """Without arguments: bracket, E1, E2, E3 and their conditions."""
    status, out, err = run(capsys)
    assert status == 0 and err == ""
    for line in ("(π₃⁰ + l)² ≥ 4 I₁ U′(1)", "(π₃⁰ + l)² > −4 I₁ U′(−1)",
                 "(l − ω k₃ (2 I₁ − I₃))² + I₁ (1 − k₃²) (I₁ ω² + U″(k₃)) > 0", "|k₃| < 1"):
        assert line in out


@pytest.mark.slow
def test_rumiantsev(capsys):
    """The heavy gyrostat in the rate ω3, as Rumiantsev wrote it, and the Newtonian field."""
    _, out, _ = run(capsys, "--potential", "m0*k3", "--equilibrium", "E1", *TOP, "--set", "omega3_0=1.3")
    assert "(I₃ ω₃⁰ + l)² > 4 I₁ m₀" in out and "E2" not in out
    assert out.startswith("Verdicts at these numbers\n")
    assert "(I₃ ω₃⁰ + l)² − 4 I₁ m₀ = 204/625\n" in out
    _, out, _ = run(capsys, "--potential", "m0*k3 + m1/2*(I3 - I1)*k3**2", "--equilibrium", "E3")
    assert "k₃ = (ω l − m₀)/((ω² − m₁) (I₁ − I₃))" in out


@pytest.mark.parametrize(("spin", "verdict"),
                         [("1.3", "Lyapunov stable"), ("1.25", "Lyapunov stable"), ("1.2", "unstable")])
def test_an_unstable_body_is_an_answer(capsys, spin, verdict):
    """Exit status 0 whatever the verdict."""
    status, out, _ = run(capsys, "--potential", "m0*k3", "--equilibrium", "E1", *TOP, "--set",
                         f"omega3_0={spin}")
    assert status == 0 and f"\n  E1: {verdict}; " in out


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
    assert "E3: Lyapunov stable modulo the flow of π₃" in out
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
    (["--potential", "k1*k3", "--equilibrium", "E1"], "E1 is not an equilibrium"),
    (["--potential", ""], "too early"), (["--set", "I1"], "NAME=VALUE"),
    (["--set", "I1=1", "--set", "I1=2"], "twice"),
    (["--set", "I1=nan"], "not finite"), (["--set", "I1=__import__('os')"], "cannot read"),
    (["--set", "mass=1"], "no parameter mass"), (["--set", "I1=1"], "not enough"),
    (["--set", "I1=-1", *TOP[4:], "--set", "pi3_0=1",
     "--set", "dU=1"], "no parameter m0"), (["--set", "pi3_0=1", "--set", "omega3_0=1"], "both"),
    (["--potential", "none", "--equilibrium", "E1"], "is one in a field"),
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


def test_the_help_of_motion_names_its_kinds_of_files(capsys):
    """Of the other verbs that write to a file there is one kind."""
    for verb in ("report", "conditions", "decide", "motion", "verify"):
        with pytest.raises(SystemExit):
            main([verb, "--help"])
        said = " ".join(capsys.readouterr().out.split())
        assert ("instead of the terminal: motion.csv, .nc" in said) == (verb == "motion")


@pytest.mark.slow
def test_the_module_runs():
    """python -m gyrostat is the command."""
    run = subprocess.run([sys.executable, "-m", "gyrostat", "--version"], capture_output=True, text=True,
                         check=True)
    assert run.stdout.strip() == f"gyrostat {gyrostat.__version__}"


@pytest.mark.slow
def test_the_report_shows_what_decides_between_the_criteria(capsys):
    """The reduced motion and its ladder; an end where U is rational.

    For an asymmetric body neither condition decides there.
    """
    _, out, _ = run(capsys)
    for line in ("I₁² k̇₃² = g", "g = 2 I₁ (1 − k₃²) (h − π₃²/(2 I₃) − U(k₃)) − (C₁ − k₃ (π₃ + l))²",
                 "−c₅ ∝ 2 U‴(1) + U⁽⁴⁾(1)",
                 "k₃ = x − 1", "(supercritical)", "to any order", "If n is even",
                 "∂σ/∂ω = (2 ω k₃ (I₁ − I₃) − l)/(I₃ ω)",
                 "(l − 2 ω k₃ (I₁ − I₃))²", "I₁ = I₃, l = 0, ω ≠ 0"):
        assert line in out
    assert "neither decides" not in out and "c₆" not in out
    _, out, _ = run(capsys, "--potential", "k3**2", "--equilibrium", "E1")
    assert "−c₃ ∝ 1" in out and "c₄ x⁴ + …" in out and "−c₄" not in out and "If all are 0" not in out
    _, out, _ = run(capsys, "--potential", "a*k3 + b*k3**4", "--equilibrium", "E1")
    assert "−c₄ ∝ −b" in out
    assert "−c₅" not in out
    assert "If all are 0, k₃ may stay at each value nearby, and" in " ".join(out.split())
    _, out, _ = run(capsys, "--potential", "exp(a*k3)", "--equilibrium", "E2")
    assert "up to x²⁴" in out and "−c₄ ∝ −a² (3 − 2 a)" in out
    assert "neither decides" not in out
    assert "momentum\n  sphere decides to fourth order" in run(capsys, "--potential", "none")[1]
    from gyrostat import Gyrostat, analyze, assemble, general_potential, upright
    asymmetric = assemble(Gyrostat(gyrostatic_momentum=(0, 0, 0)),
                          general_potential(lambda x, y, z: z + x**2))
    assert "neither decides" in str(analyze(upright(asymmetric)))


@pytest.fixture
def asleep(monkeypatch):
    """A family more: E1 under another label, made without a choice of names."""
    def make(scene):
        return gyrostat.equilibrium(scene, gyrostat.upright(scene).point, label="E4")
    monkeypatch.setitem(FAMILIES, "E4", Family("E4", "asleep", "asleep on its point", make, pole=1,
                                               asked_for="E4", source="Klein & Sommerfeld 1897"))
    monkeypatch.setattr("gyrostat.cli.parser.parser", parser.__wrapped__)  # the kept one knows no E4


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
    given = Namespace(potential=None, equilibrium=None, point=None, values=[])
    line = Questions(given).of(b'{"equilibrium": "E4", "I1": 1}')
    assert line[1] == "E4"
    with pytest.raises(SystemExit):
        main(["chart", "--help"])
    assert "E4 or asleep" in " ".join(capsys.readouterr().out.split())
    assert Scene({"potential": "U(k3)", "equilibrium": "asleep"}).equilibrium.label == "E4"
    with pytest.raises(PublishedError, match="permanent-rotation, earth-pointing, .*, conical, E4 or"):
        assert Scene({"potential": "U(k3)", "equilibrium": "E5"}).equilibrium
    with pytest.raises(ValuesError, match="name E1, E2, E3, permanent-rotation or E4"):
        report_for("chart", Asked().of_body(()), None, {})


def test_the_answer_comes_first_and_what_adds_nothing_last(capsys):
    """The verdicts before the scene; in each equilibrium the identities of dropped conditions at its end."""
    _, out, _ = run(capsys, "--potential", "m0*k3", *TOP, "--set", "pi3_0=3")
    assert out.index("E1: Lyapunov stable") < out.index("E2: Lyapunov stable") < out.index("Scene\n═")
    for verb in ("report", "conditions"):
        _, out, _ = run(capsys, "--equilibrium", "E1", verb=verb)
        assert out.count("adds nothing to the necessary condition") == 1
        assert out.index("Under internal damping") < out.index("adds nothing")
