"""gyrostat decide: verdict, margins, notion and reason of what the numbers allow."""
import json
import math

import pytest
from commands import decide

from gyrostat.cli.parser import main

TOP = ["--set", "I1=1", "--set", "I3=1.6", "--set", "l=0", "--set", "m0=1"]


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
    assert set(e1) == {"number", "label", "locus", "place", "attitude", "frequencies",
                       "frequencies_per_orbit", "growth_rate", "doubling_time", "decision",
                       "damped_decision", "itself"}
    assert e1["place"] == {} and e1["frequencies"] is e1["growth_rate"] is e1["itself"] is None
    assert set(e1["decision"]) == {"verdict", "notion", "modulo", "level", "locus", "rung", "proved",
                                   "reason", "margins", "certificate", "note"}
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
    """E3 by ω and l, or by k3 and l: every one there is, as a decimal, and exact if asked for."""
    cubic = ["--equilibrium", "E3", "--potential", "m0*k3 + a*k3**3",
             *settings(I1=2, I3=1, l=1, m0="1/2", a="1/3")]
    _, out, _ = decide(capsys, *cubic, "--set", "omega=1", "--format", "json", "--exact")
    (e3,) = json.loads(out)["equilibria"]
    assert e3["place"]["k3"] == 0.36602540378443865                    # −1/2 + √3/2
    assert e3["exact"]["k3"] == {"polynomial": "2*x**2 + 2*x - 1",
                                 "interval": ["0.366025403784438646", "0.366025403784438647"]}
    assert e3["exact"]["omega"] == {"polynomial": "x - 1", "interval": ["1", "1"]}
    assert e3["decision"]["modulo"] == ["pi3"] and e3["itself"]["verdict"] == "UNSTABLE"
    _, out, _ = decide(capsys, *cubic, "--set", "k3=1/10")
    assert out.count("Verdict") == 2 and out.count("The point itself") == 2 and "k₃ = 1/10\n" in out
    status, out, _ = decide(capsys, "--equilibrium", "E3", *HEAVY, *settings(I1=2, I3=1, l=1, m0=9, omega=1))
    assert status == 0 and out.strip() == "No such relative equilibrium exists at these numbers."


def test_frequencies_change_along_a_continuum(capsys):
    """U = k3²/4, I = (1, 1, 3), ω = 1/2: every tilt rests, with λ² = −3/4 at k3 = 0 and −57/100 at 3/5."""
    body = ["--potential", "k3^2/4", *settings(I1=1, I3=3, l=0, omega="1/2")]
    _, out, _ = decide(capsys, *body, "--format", "json")
    e1, every, e2 = json.loads(out)["equilibria"]
    assert (every["label"], every["locus"]) == ("E3", "every k3 from −1 to 1")
    assert every["place"]["k3"] is every["frequencies"] is every["growth_rate"] is None
    assert e1["frequencies"] and e2["frequencies"]
    _, out, _ = decide(capsys, *body, "--full")
    assert out.count("frequency₁ = 1/2") == out.count("frequency") == 2 and "k₃ = any" in out


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
    (["--equilibrium", "E1", "--potential", "none"], "is one in a field"),
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


def test_numbers_that_contradict_each_other(capsys):
    """omega and a momentum name different points: refused unless an equilibrium is named."""
    status = main(["decide", "--potential", "m0*k3",
                   *(f"--set={s}" for s in ("I1=2", "I3=1", "m0=3", "l=1", "pi3_0=1", "omega=2"))])
    captured = capsys.readouterr()
    assert status == 2 and captured.out == "" and "omega and a momentum are both given" in captured.err


@pytest.mark.slow
def test_a_rate_with_pi_in_a_quartic_field(capsys):
    """The tilt is the root of a polynomial over ℚ(π): k3 (4 k3² − 1) = ω (I1 ω k3 − l − I3 ω k3), ω = 2π."""
    status = main(["decide", "--potential", "k3**4 - k3**2/2", "--set", "I1=2", "--set", "I3=1", "--set",
                   "l=1", "--set", "omega=2*pi",
                   "--format", "json"])
    answers = json.loads(capsys.readouterr().out)["equilibria"]
    assert status == 0 and [a["label"] for a in answers] == ["E1", "E3", "E2"]
    assert [a["decision"]["verdict"] for a in answers] == ["STABLE"] * 3
    k3, rate = answers[1]["place"]["k3"], 2 * math.pi
    assert 4 * k3**3 - k3 + rate * (2 * rate * k3 - 1 - rate * k3) == pytest.approx(0, abs=1e-13)
