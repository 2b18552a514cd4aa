"""What internal damping makes of an equilibrium, as it is shown: in report, conditions and decide."""
import json

import pytest
from commands import decide, run

import gyrostat as gs

TOP = ["--potential", "m0*k3", "--equilibrium", "E1", "--set", "I1=1", "I3=1.6", "l=0", "m0=1"]
BOX = ["--potential", "none", "--set", "I1=1", "I2=2", "I3=3", "l1=0", "l2=0", "l3=0"]


@pytest.mark.parametrize(("spin", "line"), [
    ("1.2", "Unstable, under internal damping too: 2 growing modes."),
    ("1.27", "Stable, and destroyed by internal damping: 2 growing modes."),
    ("1.3", "Stable, and stays so under internal damping.")])
@pytest.mark.parametrize("verb", ["report", "decide"])
def test_the_line_an_engineer_looks_for(capsys, verb, spin, line):
    """Of the sleeping top: by itself from 1.25 on, under damping from 1.29 on."""
    _, out, _ = run(capsys, *TOP, f"omega3_0={spin}", verb=verb)
    assert f"  {line}\n" in out


def test_what_is_not_decided_has_its_reason(capsys):
    """I3 is no name of the verdict of E1, but of that under damping; a precession is no equilibrium then."""
    _, out, _ = decide(capsys, *TOP[:4], "--set", "I1=1", "l=0", "m0=1", "pi3_0=3", "--full")
    assert "Stable; undecided under internal damping: give I3 to decide.\n" in out
    _, out, _ = decide(capsys, "--potential", "m0*k3", "--set", "I1=2", "I3=1", "l=1", "m0=1/2", "pi3_0=1",
                       "k3=1/3", "--full")
    assert "Stable; with internal damping it is no equilibrium, because ω turns in the body.\n" in out
    _, out, _ = decide(capsys, "--potential", "b*k3^2", "--equilibrium", "E1", "--set", "I1=1", "I3=2",
                       "l=-3", "b=0", "omega3_0=1")
    assert "undecided under internal damping: the damping does not reach every motion" in out


def test_the_criterion_has_a_line_and_its_scope(capsys):
    """In report and conditions; the scope once for each equilibrium of a report."""
    _, out, _ = run(capsys, "--potential", "m0*k3", "--equilibrium", "E1")
    assert ("Under internal damping (secular):\n    I₃ π₃⁰ l > (π₃⁰)² (I₁ − I₃) + I₃² m₀\n" in out
            and " ".join(out.split()).count("friction at a support") == 1)
    _, out, _ = run(capsys, "--potential", "none", verb="conditions")
    assert ("Under internal damping:\n    (I₃ ω₃⁰ + l) (ω₃⁰ (I₁ − I₃) − l) < 0\n"
            "    (I₃ ω₃⁰ + l) (ω₃⁰ (I₂ − I₃) − l) < 0\n" in out)


@pytest.mark.parametrize("verb", ["report", "decide"])
def test_damping_as_data(capsys, verb):
    """The decision with the number of growing modes, beside the one without damping."""
    _, out, _ = run(capsys, *TOP, "omega3_0=1.27", "--format", "json", verb=verb)
    (found,) = json.loads(out)["equilibria"]
    assert found["decision"]["verdict"] == "STABLE" and "growing" not in found["decision"]
    damped = found["damped_decision"]
    assert (damped["verdict"], damped["growing"], damped["notion"]) == ("UNSTABLE", 2, "secular")
    if verb == "report":
        assert found["damped"]["notion"] == "secular"
        assert found["damped"]["any_of"][0]["all_of"][0]["strict"]


def test_every_rotation_of_a_momentum(capsys):
    """How fast the small motions are; |M| by its option, or by its name."""
    _, out, err = decide(capsys, *BOX, "--momentum", "6", "--format", "json")
    assert decide(capsys, *BOX, "M=6", "--format", "json")[1] == out and not err
    found = [(x["place"]["pi1"], x["place"]["pi3"], x["frequencies"], x["growth_rate"],
              x["damped_decision"]["growing"]) for x in json.loads(out)["equilibria"]]
    assert found[::2] == [(0, -6, [2], None, 0), (0, 0, [], 3**0.5, 1), (-6, 0, [2 * 3**0.5], None, 2)]
    _, out, _ = decide(capsys, *BOX, "--momentum", "6", "--full")
    assert "    frequency₁ = 2 √3 ≈ 3.464\n" in out and "Δ" not in out
    status, _, err = decide(capsys, *TOP, "omega3_0=2", "--momentum", "6")
    assert status == 2 and "M" in err


@pytest.mark.few(3)
@pytest.mark.parametrize(("inertia", "rotor", "radius"), [
    ((1, 2, 3), (0, 0, 0), 2), ((1, 2, 3), (0, 0, 3), 2), ((2, 2, 1), (0, 0, 0), 1),
    ((1, 1, 2), (0, 0, 0), 1), ((2, 2, 1), (0, 0, "1/2"), 3), ((1, 2, 3), (0, 0, "2"), 3),
    ((1, 2, 3), (0, 0, "1"), 3), ((3, 2, 1), (0, 0, "-3"), 3),
    ((2, 2, 2), (0, 0, 0), 1), ((1, 2, 3), ("1/2", 1, "1/3"), 3)])
def test_rotations_on_a_sphere_are_decided_as_reports_are(inertia, rotor, radius):
    """The same verdict under damping, and as many growing modes."""
    scene = gs.assemble(gs.Gyrostat(inertia, rotor))
    for found in gs.relative_equilibria(scene, {"M": radius}):
        if not all(x.is_rational for x in found.point):
            continue
        wanted = gs.analyze(found.equilibrium).verdict({}, damped=True)
        assert (found.damped.verdict, found.damped.growing) == (wanted.verdict, wanted.growing)
