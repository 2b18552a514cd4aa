"""--equilibrium permanent-rotation: its conditions, verdicts and refusals, from what is printed."""
import json

import pytest
from commands import run

FAMILY = "--equilibrium", "permanent-rotation", "--potential", "c1*k1+c2*k2+c3*k3"
NUMBERS = "I1=3", "I2=4", "I3=5", "omega=-1", "l1=-1", "l2=2", "l3=-1", "sigma=-2"


def test_the_conditions_and_the_names_they_are_written_in(capsys):
    """t, s, p, q, each defined; k is a unit vector. As text, LaTeX and data."""
    status, out, _ = run(capsys, *FAMILY, "--gyrostatic-momentum", "l1,l2,l3", verb="conditions")
    assert status == 0
    for line in ("    k₁² + k₂² + k₃² = 1", "    p² ≥ 4 q", "    t > 0", "    s > 0",
                 "    K₁₁ = v₁²/J − I₁ ω² − σ", "    A₁₂ = −I₁ I₂ k₁ k₂/J", "    q = J s/(I₁ I₂ I₃)"):
        assert f"{line}\n" in out
    assert "∇U = ω² I k + ω l + σ k" in out
    _, out, _ = run(capsys, *FAMILY, "--format", "latex", verb="conditions")
    assert r"k_1^{2} + k_2^{2} + k_3^{2} = 1" in out and r"$\omega$: rate about the vertical" in out
    assert r"t > 0 \;\land\; s > 0" in out and r"K_{12} = \frac{v_{1} v_{2}}{J}" in out
    _, out, _ = run(capsys, *FAMILY, "--format", "json", verb="conditions")
    (family,) = json.loads(out)["equilibria"]
    assert family["label"] == "permanent rotation" and family["definitions"]["q"] == "J*s/(I1*I2*I3)"
    assert list(family["definitions"])[:4] == ["J", "v1", "v2", "v3"]
    _, out, _ = run(capsys, *FAMILY, "--format", "json")
    (family,) = json.loads(out)["equilibria"]
    assert family["relations"]["c1"] == "I1*k1*omega**2 + k1*sigma" and family["definitions"]["t"]


@pytest.mark.parametrize(("direction", "place"), [
    ([], ["k1=1/3", "k2=2/3", "k3=-2/3"]), (["--direction", "1/3,2/3,-2/3"], []),
    (["--direction", "stereographic"], ["u1=1", "u2=2"])])
@pytest.mark.few(1)
def test_one_rotation_in_three_ways(capsys, direction, place):
    """A maximum that gyroscopic forces hold, and damping destroys."""
    status, out, _ = run(capsys, *FAMILY, *direction, "--set", *NUMBERS, *place, verb="decide")
    assert status == 0 and "Reason (Lyapunov (Arnold-Moser)): " in out and "D4 = " in out
    assert "Stable, and destroyed by internal damping: 2 growing modes." in " ".join(out.split())
    assert ("    p = 479/540\n" in out) == bool(place)          # in names, unless all is in numbers


def test_a_family_with_one_parameter_of_u(capsys):
    """m0 k3 of a body with three moments; the equations that leave m0 out are checked."""
    field = "--equilibrium", "permanent-rotation", "--potential", "m0*k3", "--inertia", "I1,I2,I3"
    numbers = "I1=3", "I2=4", "I3=5", "k1=3/5", "k2=0", "k3=4/5", "omega=1", "l=0"
    status, out, _ = run(capsys, *field, "--set", *numbers, "sigma=-3", verb="decide")
    assert status == 0 and "    s = −378/2675\n" in out
    status, _, err = run(capsys, *field, "--set", *numbers, "sigma=-2", verb="decide")
    assert status == 2 and "the point is not on permanent rotation" in err


@pytest.mark.parametrize(("verb", "options", "why"), [
    ("conditions", ["--direction", "1,1,1"], "|k|² − 1 = 2: k is a direction"),
    ("conditions", ["--direction", "1,0"], "give three expressions that make a unit"),
    ("conditions", ["--direction", "k1,0,0"], "direction depends on k1, the direction of the field"),
    ("conditions", ["--potential", "k1+k2"], "no parameter that ∇U(k) determines"),
    ("conditions", ["--potential", "U(k3)"], "this scene has U = U(k3): use U(k1, k2, k3)"),
    ("conditions", ["--potential", "none"], "is one in a field"),
    ("conditions", ["--set", "k1=1/2"], "give a direction in place of numbers"),
    ("decide", ["--set", *NUMBERS, "k1=1", "k2=1", "k3=0"], "k = (1, 1, 0) has |k|² − 1 = 1"),
    ("chart", ["--set", "I1=1", "--x", "k1=0:1:9", "--y", "k2=0:1:9", "--output", "x.png"],
     "--direction stereographic")])
def test_what_is_refused_in_one_sentence(capsys, verb, options, why):
    status, out, err = run(capsys, *FAMILY, *options, verb=verb)
    assert (status, out) == (2, "") and why in err and err.count("\n") == 1
