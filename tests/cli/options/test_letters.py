"""Letters of a user that are the library's too, on every way that a scene is given."""
import json
import re
from unicodedata import normalize

import pytest
from commands import decide, run
from sympy import pi

import gyrostat as gs
from gyrostat.errors import GyrostatError, ScopeError
from gyrostat.plotting import draw_energy_momentum

TOP = ["--set", "I1=1", "I3=1.6", "l=0"]


def verdicts(capsys, *arguments):
    """Of each equilibrium that decide answers."""
    status, out, err = decide(capsys, *arguments, "--format", "json")
    assert status == 0, err
    return [found["decision"]["verdict"] for found in json.loads(out)["equilibria"]]


def test_a_lever_is_not_the_rotor(capsys):
    """With l = 1 `M*g*l*k3` was STABLE, with the lever named R it is not; l is refused with such a letter."""
    asked = ["--set", "I1=1", "I3=1.6", "M=1", "g=1", "omega3_0=1.2", "--equilibrium", "E1"]
    status, out, err = decide(capsys, "--potential", "M*g*l*k3", "--set", "l=1", *asked)
    assert (status, out) == (2, "") and "l, the gyrostatic momentum of the rotor" in err
    assert "as in U = L*M*g*k3" in err and err.count("\n") == 1
    assert verdicts(capsys, "--potential", "M*g*L*k3", "--set", "L=1", "l=0", *asked) == ["UNSTABLE"]


@pytest.mark.few(2)
@pytest.mark.parametrize("letter", ["C1", "M", "h", "C", "p", "t1", "D4", "U"])
def test_a_letter_of_the_print_is_the_users(capsys, tmp_path, letter):
    """Options, a file, a batch and Python take it for the parameter, as they take c."""
    wanted = [["UNSTABLE"], ["UNSTABLE", "STABLE"]]
    for name in ("c", letter):
        field = ["--potential", f"{name}*k3", *TOP]
        found = [verdicts(capsys, *field, f"{name}=3", "omega3_0=1", "--equilibrium", "E1"),
                 verdicts(capsys, *field, f"{name}=3", "omega=1")]
        assert found == wanted
        lines, scene = tmp_path / "one.jsonl", tmp_path / "one.toml"
        lines.write_text(json.dumps({name: 3, "omega": 1}), encoding="utf-8")
        _, out, _ = decide(capsys, *field, "--batch", str(lines))
        assert [each["decision"]["verdict"] for each in json.loads(out)["equilibria"]] == wanted[1]
        scene.write_text(f'[scene.one]\npotential = "{name}*k3"\ninertia = ["I1", "I1", "I3"]\n'
                         f'values = {{ I1 = 1, I3 = 1.6, {name} = 3, omega3_0 = 1 }}\n', encoding="utf-8")
        assert verdicts(capsys, "--scene", str(scene), "--equilibrium", "E1") == wanted[0]
        top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(gs.symbol(name) * gs.symbol("k3")))
        branches = gs.relative_equilibria(top, {"I1": 1, "I3": "1.6", "l": 0, name: 3, "omega": 1})
        assert [branch.decision.verdict.name for branch in branches] == wanted[1]


def test_a_level_is_not_asked_of_a_scene_with_that_letter(capsys):
    """C1 = 3 is the parameter; a level of C1, the amended potential, the sphere of radius M say so."""
    status, out, err = decide(capsys, "--potential", "C1*k3", *TOP, "C1=3", "pi3_0=1")
    assert status == 2 or "C1 = 3" not in out
    k1, k3, C1, M = map(gs.symbol, ("k1", "k3", "C1", "M"))
    top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(C1 * k3))
    body = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(C1 * k1 + 2 * k3))
    free = gs.assemble(gs.Gyrostat((1, 2, M), (0, 0, 0)))
    for ask in (lambda: gs.relative_equilibria(top, {"I1": 1, "I3": 1, "l": 0, "C1": 3, "pi3_0": 1}),
                lambda: gs.relative_equilibria(body, {"C1": 3}),
                lambda: gs.amended_potential(body).expression,
                lambda: gs.amended_potential(body).critical_points({"C1": 3}),
                lambda: gs.relative_equilibria(free, {"M": 3}),
                lambda: draw_energy_momentum(top, {"I1": 1, "I3": 1, "l": 0, "C1": 3, "p_psi": 1})):
        with pytest.raises(ScopeError, match=r"has a parameter (C1|M), and here .* such as (c1|m)$"):
            ask()
    named = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(gs.symbol("c") * k1 + 2 * k3))
    ours, theirs = (gs.relative_equilibria(scene, {name: 3, "omega": 1})
                    for scene, name in ((body, "C1"), (named, "c")))
    assert [(*x.directions, x.decision.verdict) for x in ours] == [
        (*x.directions, x.decision.verdict) for x in theirs]


@pytest.mark.parametrize("arguments", [
    ("--potential", "m0*k3*cos(t)", "--equilibrium", "upright"),
    ("--potential", "m0*k3", "--inertia", "1,1,2+t"), ("--orbit", "n*t"),
    ("--potential", "m0*k3", "--gyrostatic-momentum", "0,0,h*t"),
    ("--potential", "k1+k2*cos(time)"), ("--potential", "none", "--inertia", "I1*exp(-t),I2,I3"),
    ("--orbit", "1", "--potential", "t*r1^2"),
    ("--potential", "m0*k3", "--point", "0,0,t,0,0,1"),
    ("--potential", "c1*k1+c2*k2+c3*k3", "--direction", "sin(t),0,cos(t)",
     "--equilibrium", "permanent-rotation")])
@pytest.mark.parametrize("verb", ["conditions", "report"])
def test_an_explicit_time_is_refused(capsys, verb, arguments):
    """Wherever a scene has numbers, in one sentence that says why and what to do."""
    status, out, err = run(capsys, *arguments, verb=verb)
    assert (status, out) == (2, "") and err.count("\n") == 1
    assert re.search(r"(t|time), the time: the criteria are for autonomous fields .*: write a constant", err)


def test_an_explicit_time_is_refused_in_python():
    """In every constructor."""
    t, k1, e1 = map(gs.symbol, ("t", "k1", "e1"))
    for make in (lambda: gs.Gyrostat((1, 2, 3), (0, 0, t)), lambda: gs.Gyrostat((1, 2, 3 + t), (0, 0, 0)),
                 lambda: gs.Gyrostat([[2, t, 0], [t, 2, 0], [0, 0, 3]], (0, 0, 0)),
                 lambda: gs.Rotor((0, 0, 1), axial=1, rate=t), lambda: gs.Rotor((0, 0, 1), axial=t),
                 lambda: gs.general_potential(t * k1), lambda: gs.coupled_potential(t * k1),
                 lambda: gs.coupled_potential(0, drift=(t * e1, 0, 0)), lambda: gs.circular_orbit(t),
                 lambda: gs.circular_orbit(mu=t, radius=1),
                 lambda: gs.circular_orbit(potential=t * gs.symbol("n1")),
                 lambda: gs.underwater_vehicle(weight=(0, 0, t)), lambda: gs.lie_poisson((), (0, 0, t)),
                 lambda: gs.underwater_vehicle(coupling=[[t, 0, 0], [0, 0, 0], [0, 0, 0]]),
                 lambda: gs.equilibrium(gs.assemble(gs.Gyrostat()), (t, 0, 0))):
        with pytest.raises(GyrostatError, match="the time: the criteria are for autonomous fields"):
            make()


@pytest.mark.parametrize("field", [None, gs.circular_orbit(1)])
def test_pi_is_the_number_where_a_wheel_is_in_rpm(field):
    """Alone it is never the momentum, in text and in LaTeX: that is M = Iω + l, and has components."""
    scene = gs.assemble(gs.Gyrostat((3, 2, 1), (0, -pi, pi / 6)), field)
    shown, latex = normalize("NFD", str(scene)), gs.to_latex(scene)
    assert "l = (0, −π, π/6); its" in shown and "π\u0307₁ = " in shown and r"\dot{\pi}_1 & =" in latex
    assert ("M = Iω + l" if field is None else "M = (π₁, π₂ − π, π₃ + π/6)") in shown
    assert "M\u0307 = M × ω" in shown and r"\dot{M} = M\times\omega" in latex
    assert not re.search("π\u0307(?![₁₂₃])|= π [+]|∂π|·π", shown)
    assert not re.search(r"dot{\\pi}(?!_)|partial \\pi|= \\pi \+", latex)


def test_sentences_have_the_bodys_own_names():
    """A² k̇₃² = g where the moments are A, A, C; at a tilt, and in a table of LaTeX."""
    A, C, k3 = map(gs.symbol, ("A", "C", "k3"))
    field = gs.axial_potential(gs.symbol("m0") * k3)
    scene = gs.assemble(gs.Gyrostat((A, A, C), (0, 0, gs.symbol("l"))), field)
    upright, inclined = (gs.analyze(family(scene)) for family in (gs.upright, gs.inclined))
    assert "A² k̇₃² = g with" in str(upright) and "I₁" not in str(upright) + str(inclined)
    assert "The only exception is A = C, l = 0, ω ≠ 0 and a constant U." in " ".join(str(inclined).split())
    numbers = gs.assemble(gs.Gyrostat(("6/5", "6/5", 1), (0, 0, 0)), field)
    shown = str(gs.analyze(gs.upright(numbers)))
    assert "36 k̇₃²/25 = g with" in shown and "I₁" not in shown


@pytest.mark.parametrize(("field", "said"), [
    ("m0*k3", {"weight times"}), ("m0*k3 + m1/2*(I3 - I1)*k3^2", {"weight times", "3 g / r"}),
    ("m0*g*z0*k3", set()), ("r*k3", set()), ("m1*k3", set()), ("p0*k3 + mass1*k3^2", set()),
    ("p0^2*(1/mass3 - 1/mass1)/2*k3^2", {"the impulse", "added mass"})])
def test_a_name_has_its_meaning_in_its_own_field(capsys, field, said):
    """Of another field its letters are real parameters, or positive ones."""
    _, out, _ = run(capsys, "--potential", field, "--equilibrium", "E1")
    symbols = out[out.index("Symbols and assumptions"):out.index("E1: spinning")]
    known = {"weight times", "3 g / r", "centre of attraction from the fixed", "the impulse", "added mass"}
    assert {meaning for meaning in known if meaning in symbols} == said
