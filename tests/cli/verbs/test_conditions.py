"""gyrostat conditions: existence, conditions and ladder as text, table or data, at numbers."""
import json

from commands import run


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
    assert out.startswith("% needs amsmath and array\n" + r"\begin{table}[htbp]")
    assert "E3" in out
    assert r"$-c_{3} \propto U'(1) + U''(1)$" in out
    assert "if $n$ is odd, the equilibrium is\nunstable" in out and "are its derivatives.\\par\n" in out
    _, out, _ = run(capsys, "--equilibrium", "E1", "--format", "latex", "--fragment")
    assert r"\documentclass" not in out and r"\begin{equation}" in out
    for verb in ("report", "conditions"):
        status, out, err = run(capsys, "--fragment", verb=verb)
        assert status == 2 and out == "" and "--format latex" in err


def test_conditions_in_the_symbols_of_a_paper(capsys):
    """--symbols several or one at a time, --label; what is no setting is refused; texts explain symbols."""
    _, out, _ = run(capsys, "--equilibrium", "E1", "--format", "latex", "--symbols", "I1=A", "l=\\sigma",
                    "--symbols", "U=V", "--label", "top", verb="conditions")
    assert r"$(\pi_3^0 + \sigma)^{2} > 4 A V'(1)$" in out and r"\label{top:conditions}" in out
    for settings, why in ((["I1"], "--symbols I1 is not NAME=LATEX"), (["l=A", "l=B"], "gives l twice"),
                          (["I1=\\input{x}"], "is not one symbol"), (["U=V", "p0=V"], "both be V")):
        status, out, err = run(capsys, "--format", "latex", "--symbols", *settings)
        assert status == 2 and out == "" and why in err
    _, out, _ = run(capsys, "--potential", "a*k3", "--equilibrium", "E1", verb="conditions")
    assert "    U        potential, U = a k₃\n    a        a real parameter\n" in out
    assert "    π₃⁰      angular momentum of the locked body, axis 3, at the equilibrium\n" in out
    assert "ω" not in out


def test_conditions_as_data(capsys):
    """The keys of the report that are about conditions, with the ladder, and its last power."""
    _, out, _ = run(capsys, "--potential", "m0*k3 + m1*k3**2", "--format", "json", verb="conditions")
    e1, _, e3, _ = json.loads(out)["equilibria"]
    assert set(e1) == {"label", "positive", "eliminated", "parameters", "necessary", "sufficient", "boundary",
                       "damped"}
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
    assert "  It exists if:\n    ω ≠ 0\n" in out and "    l = (" in out
    assert "g = 2 I₁ (1 − k₃²)" in out and "−c₃ ∝ −m₀ − 2 m₁" in out
    for arguments, why in ((["--set", "k3=2", "--equilibrium", "E3", "--potential", "m0*k3"],
                            "exists only where 1 - k3**2 > 0"),
                           (["--set", "dU=1"], "derivative of U"), (["--set", "mass=1"], "no parameter mass"),
                           (["--set", "l=1", "--potential", "k3**4", "--equilibrium", "E3"],
                            "expresses l by")):
        status, out, err = run(capsys, *arguments, verb="conditions")
        assert status == 2 and out == "" and why in err
