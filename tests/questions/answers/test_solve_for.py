"""gyrostat conditions --solve-for: which value of a parameter stabilises."""
import json

import pytest
from commands import run


def conditions(capsys, *arguments):
    return run(capsys, *arguments, verb="conditions")


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
    assert "0.723697… ≤ l < 7 (k₃ from 0.368403… to −1)" in " ".join(out.split())
    newton = ["--potential", "m0*k3 + m1/2*(I3 - I1)*k3**2", "--equilibrium", "E3", "--solve-for", "l"]
    _, out, _ = conditions(capsys, *newton, *numbers, "--set", "m0=1", "--set", "m1=5")
    assert "9/5 < l < 5 (k₃ from −1/5 to −1) or −3 < l < −9/11 (k₃ from 1 to 5/11)" in " ".join(out.split())


def test_solve_for_with_numbers(capsys):
    """Numbers for some names are inserted, numbers for all give exact ends.

    omega3_0 is the spin where it is asked for.
    """
    _, out, _ = conditions(capsys, "--potential", "m0*k3", "--equilibrium", "E1", "--solve-for", "m0",
                           "--set", "I1=1", "--set", "l=0")
    assert "Stable: m₀ < (π₃⁰)²/4; m₀ = (π₃⁰)²/4 too if (π₃⁰)² > 0." in out
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
