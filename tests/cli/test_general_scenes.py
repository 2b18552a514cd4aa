"""U(k1, k2, k3), three moments, any rotor and claimed points, in every verb as in Python."""
import json

import numpy as np
import pytest
from commands import run

import gyrostat as gs
from gyrostat.printing.formats.json_data import report_data

FIELD = ["--potential", "a*k1*k2 + k3"]
SETS = {"I1": "1", "I2": "2", "I3": "3", "l": "1/2", "a": "1", "w": "5/2"}
ROTOR = {"I1": "1", "I2": "2", "I3": "3", "l1": "0", "l2": "0", "l3": "1/2", "a": "1"}
POINT = ["--point", "0,0,I3*w,0,0,1"]


def sets(numbers):
    return [f"--set={name}={value}" for name, value in numbers.items()]


@pytest.fixture(scope="module")
def claimed():
    """The report of the same point in Python."""
    a, l, w, I3 = map(gs.symbol, ("a", "l", "w", "I3"))
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, l)),
                        gs.general_potential(lambda k1, k2, k3: a * k1 * k2 + k3))
    return gs.analyze(gs.equilibrium(scene, (0, 0, I3 * w, 0, 0, 1)))


def test_a_claimed_point_is_reported(capsys, claimed):
    """The derivation of Python, with the decision where there are numbers."""
    status, out, err = run(capsys, *FIELD, *POINT, *sets(SETS), "--format", "json")
    data = json.loads(out)
    (found,) = data["equilibria"]
    assert (status, err) == (0, "") and found.pop("decision")["verdict"] == claimed.verdict(SETS).verdict.name
    assert found.pop("damped_decision")["growing"] == claimed.verdict(SETS, damped=True).growing
    assert found == json.loads(json.dumps(report_data(claimed)))
    assert data["hamiltonian"] == "a*k1*k2 + k3 + pi3**2/(2*I3) + pi2**2/(2*I2) + pi1**2/(2*I1)"
    _, out, _ = run(capsys, *FIELD, *POINT)
    assert "(π₁, π₂, π₃, k₁, k₂, k₃) = (0, 0, I₃ w, 0, 0, 1)" in out and "Verdict" not in out


@pytest.mark.parametrize("spin", ["5/2", "1", "1/10", "-2"])
def test_decisions_at_a_claimed_point(capsys, claimed, spin):
    """Verdict, margins and reason of Python."""
    numbers = SETS | {"w": spin}
    _, out, _ = run(capsys, *FIELD, *POINT, *sets(numbers), "--format", "json", verb="decide")
    ((found,), decision) = json.loads(out)["equilibria"], claimed.verdict(numbers)
    assert found["label"] == "E" and found["decision"]["verdict"] == decision.verdict.name
    assert found["decision"]["margins"] == {str(margin): str(value) for margin, value in decision.margins}


@pytest.mark.slow
def test_conditions_of_a_claimed_point(capsys, claimed):
    """Both criteria, and the values of a name."""
    _, out, _ = run(capsys, *FIELD, *POINT, "--format", "json", verb="conditions")
    (found,) = json.loads(out)["equilibria"]
    assert found["parameters"] == list(claimed.parameters) == ["I1", "I2", "I3", "a", "l", "w"]
    fixed = {name: x for name, x in SETS.items() if name != "l"}
    _, out, _ = run(capsys, *FIELD, *POINT, *sets(fixed), "--solve-for", "l", verb="conditions")
    wanted = gs.stabilizing_set(claimed, "l", fixed)
    assert out.startswith("E\n═\n") and out.rstrip().endswith(str(wanted).splitlines()[-1].strip())


def test_a_point_that_is_one_at_the_numbers_only(capsys):
    """l1 = l2 = 0: claimed with the numbers that are set; refused at others."""
    at = [*FIELD, "--point", "0,0,p,0,0,1"]
    _, out, _ = run(capsys, *at, *sets(ROTOR | {"p": "15/2"}), "--format", "json", verb="decide")
    (found,) = json.loads(out)["equilibria"]
    assert found["decision"]["verdict"] == "STABLE"
    _, out, _ = run(capsys, *at, *sets(ROTOR), verb="conditions")
    assert "p" in out and "l₁" not in out
    status, _, err = run(capsys, *at, *sets(ROTOR | {"l2": "1/10"}), verb="decide")
    assert status == 2 and "E is not an equilibrium: dpi1/dt = p/30" in err


@pytest.mark.slow
def test_charts_of_general_scenes(capsys, tmp_path, claimed):
    """The arrays of Python; what holds at the numbers only keeps them in the record."""
    xr = pytest.importorskip("xarray")
    axes = ["--x", "w=-3:3:12", "--y", "l=-2:2:9"]
    fixed = {name: SETS[name] for name in ("I1", "I2", "I3", "a")}
    path = str(tmp_path / "chart.nc")
    assert run(capsys, *FIELD, *POINT, *axes, *sets(fixed), "--output", path, verb="chart") == (0, "", "")
    wanted = gs.charts.stability_chart(claimed, x=("w", np.linspace(-3, 3, 12)),
                                       y=("l", np.linspace(-2, 2, 9)), fixed=fixed)
    with xr.open_dataset(path) as found:
        xr.testing.assert_identical(found.load(), wanted)
        verdicts = found.verdict.values
    assert set(verdicts.flat) == {-1, 1}
    rest = {name: x for name, x in ROTOR.items() if name != "l3"}
    turned = ["--point", "0,0,3*w,0,0,1", "--x", "w=-3:3:12", "--y", "l3=-2:2:9"]
    assert run(capsys, *FIELD, *turned, *sets(rest), "--output", path, verb="chart") == (0, "", "")
    with xr.open_dataset(path) as found:
        assert (found.verdict.values == verdicts).all() and float(found.l1) == 0 and float(found.I2) == 2


@pytest.mark.slow
def test_the_spectrum_of_a_claimed_point(capsys, tmp_path, monkeypatch):
    """Along a name of the point, whatever holds at the numbers only; but for the title."""
    monkeypatch.setattr("gyrostat.plotting.eigenvalues.of_scene", lambda *_: ([], []))
    pictures = [tmp_path / "one.png", tmp_path / "other.png"]
    for path, numbers in zip(pictures, ({**SETS}, ROTOR)):
        numbers = {name: x for name, x in numbers.items() if name != "w"}
        assert run(capsys, "eigenvalues", *FIELD, *POINT, *sets(numbers), "--x", "w=1:3:30", "--output",
                   str(path), verb="plot")[0] == 0
    assert pictures[0].read_bytes() == pictures[1].read_bytes()


@pytest.mark.slow
def test_without_a_point(capsys):
    """The scene, the poles where they are equilibria, and how to name the others."""
    status, out, _ = run(capsys, *FIELD)
    assert status == 0 and "π̇₃ = π₁ π₂ (I₁ − I₂)/(I₁ I₂)" in out
    assert "E1: spinning about the upward vertical" in out and "E2: " in out and "E3" not in out
    assert "Other equilibria of this scene are not looked for: give its point PI1,PI2,PI3,K1,K2,K3" in out
    for form in ([], ["--format", "latex"], ["--format", "json"]):
        status, out, _ = run(capsys, "--potential", "k1*k3", *form)
        assert status == 0 and "Equilibria of this scene are not looked for" in out and "E1" not in out
    for verb in ("conditions", "decide"):
        status, out, err = run(capsys, "--potential", "k1*k3", verb=verb)
        assert (status, out) == (2, "") and err.startswith("gyrostat: Equilibria of this scene are not ")
    _, out, _ = run(capsys, *FIELD, *sets(ROTOR | {"pi3_0": "15/2"}), verb="decide")
    assert out.startswith("2 relative equilibria: 2 stable.") and "1  E1     1  stable" in out


def test_a_name_without_a_number_is_said(capsys):
    """Of a satellite in an orbit whose other names have one."""
    status, out, err = run(capsys, "--orbit", "1", "--inertia", "3,2,1", "--gyrostatic-momentum", "0,0,0",
                           "--potential", "f*(x*t1 + z*t3)", *sets({"f": 1, "x": 2}), verb="decide")
    assert (status, out) == (2, "") and err.endswith("if every name has a number, and z has none\n")


def test_every_permanent_rotation(capsys):
    """At a rate, in text and as data; each is one where M × ω + k × ∇U vanishes. In a direction too."""
    body = {"I1": 1, "I2": 2, "I3": 3, "l1": 0, "l2": 0, "l3": "1/2"}
    given = ["--potential", "k1 + 2*k2 + k3", *sets(body)]
    _, out, _ = run(capsys, *given, "--set", "omega=2", "--full", verb="decide")
    assert out.count("permanent rotation\n") == 4 and out.count("the amended potential has a ") == 4
    assert out.index("Lyapunov stable") < out.index("saddle") and "2 growing modes" in out
    assert out.count("frequency₁ = ") == 3 and out.count("frequency₂ = ") == out.count("growth_rate = ") == 2
    _, out, _ = run(capsys, *given, "--set", "omega=2", "--format", "json", verb="decide")
    for each in json.loads(out)["equilibria"]:
        k = [each["place"][name] for name in ("k1", "k2", "k3")]
        omega = [2 * float(x) for x in k]
        M, g = [omega[0], 2 * omega[1], 3 * omega[2] + 0.5], (1, 2, 1)
        for a, b in ((1, 2), (2, 0), (0, 1)):
            torque = M[a] * omega[b] - M[b] * omega[a] + float(k[a]) * g[b] - float(k[b]) * g[a]
            assert abs(torque) < 1e-9, each
    one = [*sets({"k1": "-1/8", "k2": "-1/2", "k3": "sqrt(47)/8"})]
    _, out, _ = run(capsys, *given, *one, verb="decide")
    assert "ω = 2" in out and "Lyapunov stable" in out


@pytest.mark.slow
def test_on_a_level(capsys):
    """Roots of a long polynomial are printed as decimals; C1 = M·k at them."""
    body = {"I1": 1, "I2": 2, "I3": 3, "l1": "1/2", "l2": 0, "l3": "1/3", "C1": 2}
    _, out, _ = run(capsys, "--potential", "k1 + 2*k2 + k3", *sets(body), "--full", verb="decide")
    assert "CRootOf" not in out and max(map(len, out.splitlines())) <= 100
    names = "k₁", "k₂", "k₃", "ω"
    shown = [line.split(" = ")[1].replace("−", "-").rstrip("…") for line in out.splitlines() if " = " in line]
    assert len(shown) == 12 and all(f"    {name} = " in out for name in names)
    for k1, k2, k3, omega in (map(float, shown[n:n + 4]) for n in (0, 6)):
        assert abs(omega * (k1**2 + 2 * k2**2 + 3 * k3**2) + k1 / 2 + k3 / 3 - 2) < 1e-4     # six digits


def test_an_unspecified_field_of_three_components(capsys):
    """Its scene is printed; a point needs a torque that vanishes."""
    status, out, _ = run(capsys, "--potential", "U(k1, k2, k3)", "--gyrostatic-momentum", "l1,l2,l3")
    assert status == 0 and "∂₂U" in out and "Equilibria of this scene are not looked for" in out
    status, _, err = run(capsys, "--potential", "U(k1,k2,k3)", "--point", "0,0,1,0,0,1")
    assert status == 2 and "E is not an equilibrium: dpi1/dt = -dU_2" in err


@pytest.mark.slow
def test_a_body_of_revolution_about_another_axis(capsys):
    """Recognised: all equilibria at a rate, as in Python."""
    scene = gs.assemble(gs.Gyrostat((3, 2, 2), (0, 0, 0)), gs.general_potential(lambda k1, k2, k3: k1))
    body = ["--potential", "k1", "--inertia", "3,2,2", "--gyrostatic-momentum", "0,0,0"]
    _, out, _ = run(capsys, *body, "--set", "omega=2", "--format", "json", verb="decide")
    found, wanted = json.loads(out)["equilibria"], gs.relative_equilibria(scene, {"omega": 2})
    assert [e["label"] for e in found] == [b.label for b in wanted] == ["E1", "E3", "E2"]
    assert [e["decision"]["verdict"] for e in found] == [b.decision.verdict.name for b in wanted]
    assert [e["place"]["k1"] for e in found] == [float(b.form.k3) for b in wanted]
    _, out, _ = run(capsys, *body, "--point", "3*w,0,0,1,0,0")
    assert "9 w² ≥ 8" in out.replace("  ", " ")


@pytest.mark.slow
def test_free_bodies(capsys):
    """A rotation about each axis, and every permanent rotation on a sphere of the momentum."""
    box = ["--potential", "none", "--gyrostatic-momentum", "0,0,0", *sets({"I1": 1, "I2": 2, "I3": 3})]
    for n, verdict in ((1, "STABLE"), (2, "UNSTABLE"), (3, "STABLE")):
        _, out, _ = run(capsys, *box, "--equilibrium", f"axis {n}", "--set", f"omega{n}_0=1", "--format",
                        "json", verb="decide")
        (found,) = json.loads(out)["equilibria"]
        assert found["label"] == f"rotation about axis {n}" and found["decision"]["verdict"] == verdict
    rotor = {"I1": 1, "I2": 2, "I3": 3, "l1": "1/10", "l2": "1/5", "l3": "-1/3", "M": 2}
    _, out, _ = run(capsys, "--potential", "none", *sets(rotor), "--format", "json", verb="decide")
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), ("1/10", "1/5", "-1/3")))
    found, wanted = json.loads(out)["equilibria"], gs.relative_equilibria(scene, {"M": 2})
    assert [e["decision"]["verdict"] for e in found] == [r.decision.verdict.name for r in wanted]
    momenta = [[float(r.point[n]) for n in range(3)] for r in wanted]
    np.testing.assert_allclose([[e["place"][f"pi{n}"] for n in (1, 2, 3)] for e in found], momenta)


@pytest.mark.parametrize(("verb", "arguments", "why"), [
    ("report", ["--potential", "k3", "--point", "0,0,1"], "point 0,0,1 has 3 numbers, and the body has 6"),
    ("report", [*FIELD, *POINT, "--equilibrium", "E1"], "a point and the equilibrium E1 are both given"),
    ("report", [*FIELD, "--point", "0,0,I3*w,0,0,2"], "k is a direction, |k| = 1"),
    ("report", [*FIELD, "--point", "0,0,1,1,0,0"], "E is not an equilibrium"),
    ("report", [*FIELD, "--equilibrium", "E3"], "this scene is none of them: give its point"),
    ("report", [*FIELD, "--equilibrium", "axis 1"], "axis 1 is one of a free body"),
    ("report", ["--inertia", "1,2"], "is not three numbers"),
    ("report", ["--inertia", "1,2,-3"], "-3 is not positive"),
    ("report", ["--potential", "k3", "--set", "l=1", "--set", "l1=2"], "both l and l1 are given"),
    ("decide", [*FIELD, *POINT, *sets(SETS), "--set", "b=1"], "E has no parameter b"),
    ("decide", [*FIELD, *POINT], "E needs I1"),
    ("chart", [*FIELD, "--x", "l=0:1:2", "--y", "a=0:1:2", "--output", "chart.png"],
     "a chart shows one: name E1, E2, E3 or permanent-rotation, or give its point"),
    ("motion", ["--potential", "U(k3)", "--state", "0,0,1,0,0,1", "--until", "1"],
     "no motion follows from an unspecified U"),
    ("motion", ["--potential", "k3", "--until", "1"], "--state is missing")])
def test_bad_input(capsys, verb, arguments, why):
    """One sentence."""
    status, out, err = run(capsys, *arguments, verb=verb)
    assert status == 2 and out == "" and why in err and err.count("\n") == 1
