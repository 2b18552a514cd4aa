"""Published formulas where gyroscopic forces hold a maximum: the normal form, and claims refuted there."""
import random

import pytest
from exceptional_rotations import in_resonance, terms, with_form
from published.read_again import is_shown
from published.written_sources import CLAIM, written
from slow import sampled
from sympy import Float
from window_scenes import windows

import gyrostat as gs
from gyrostat.published import check
from gyrostat.published.independent.arnold import Oscillations, stability
from gyrostat.published.independent.counterexample import Model
from gyrostat.published.scenes import Scene

UPRIGHT = """gyrostatic_momentum = ["0", "0", "l"]
potential = "m0*k3 + m1/2*(I1*k1**2 + I2*k2**2 + I3*k3**2)"
equilibrium = "E1"
spin = "omega3_0"
"""
A1 = ("(I3 - I1)*(omega3_0**2 - m1) + l*omega3_0 - m0 > 0 and "
      "(I3 - I2)*(omega3_0**2 - m1) + l*omega3_0 - m0 > 0")
HELD = """inertia = ["3", "5", "4"]
potential = "2/3*k2 + 2/3*k3"
point = ["-2", "-5/3", "-8/3", "2/3", "1/3", "2/3"]
"""
NAMED = 'inertia = ["1", "2", "3"]\npotential = "{name}*k3"\nequilibrium = "E1"\n'


def finding(tmp_path, scene, quantity, printed, kind="identity", extra=""):
    text = '[source]\nname = "mine"\ntitle = "t"\n[scene.s]\n' + scene + "\n"
    text += CLAIM.format(key="a", quantity=quantity, printed=printed, kind=kind) + extra
    (found,) = check([written(tmp_path, text)])
    return found


@pytest.mark.slow
@pytest.mark.parametrize("claim", ["necessary for stability", "necessary and sufficient for stability"])
def test_energy_casimir_is_not_necessary(tmp_path, claim):
    """A point in the window where the condition fails, stable by Arnold's theorem; read again."""
    found = finding(tmp_path, UPRIGHT, claim, A1, "condition")
    example = found.outcome.counterexample
    assert found.status == "misprint" and (example.printed, example.derived) == ("fails", "stable")
    assert "D4 = " in example.confirmation and "Arnold-Moser" in example.confirmation
    assert is_shown(found) is True
    values = dict(example.values)
    report = gs.analyze(found.statement.scene.equilibrium)
    assert report.verdict(values).notion == "Lyapunov (Arnold-Moser)"


@pytest.mark.slow
def test_a_maximum_is_not_unstable(tmp_path):
    """Both squares of the amended potential negative do not suffice for instability."""
    printed = A1.replace(" > 0", " < 0")
    found = finding(tmp_path, UPRIGHT, "sufficient for instability", printed, "condition")
    example = found.outcome.counterexample
    assert (example.printed, example.derived) == ("holds", "stable")
    assert is_shown(found) is True


def test_a_condition_is_necessary_without_windows(tmp_path):
    """Of a body of revolution only equality is missing, and that is what is said."""
    scene = 'inertia = ["I1", "I1", "I3"]\npotential = "m0*k3"\nequilibrium = "E1"\n'
    found = finding(tmp_path, scene, "necessary and sufficient for stability", "pi3_0**2 > 4*I1*m0",
                    "condition")
    assert "only if equality is allowed" in found.outcome.derived


@pytest.mark.few(3)
@pytest.mark.parametrize(("quantity", "printed", "kind", "expected"), [
    ("D4", "691181/6156000", "identity", "confirmed"), ("D4", "691182/6156000", "identity", "misprint"),
    ("D6", "-0.251501038061", "number", "confirmed"), ("D6", "-0.251501038062", "number", "misprint"),
    ("frequency_1*frequency_2", "-sqrt(q)", "identity", "confirmed"),
    ("frequency_1*frequency_2", "sqrt(q)", "identity", "misprint"),
    ("birkhoff_20*frequency_2**2 - birkhoff_11*frequency_1*frequency_2 + birkhoff_02*frequency_1**2", "D4",
     "identity", "confirmed"),
    ("birkhoff_11", "-2.04017443885", "number", "confirmed"), ("birkhoff_11", "2.0402", "number", "misprint"),
    ("stability", "stable", "statement", "confirmed"), ("stability", "unstable", "statement", "misprint")])
def test_normal_form_as_a_quantity(tmp_path, quantity, printed, kind, expected):
    """Signed frequencies, coefficients, D4 and D6 at numbers; what is wrong is shown from the motions."""
    found = finding(tmp_path, HELD, quantity, printed, kind)
    assert found.status == expected
    assert (found.outcome.counterexample is None) == (expected == "confirmed")


@pytest.mark.few(1)
@pytest.mark.parametrize(("scene", "at"), [
    ('inertia = ["2", "2", "1"]\npotential = "k3 + k3**2/2 + k3**4/5"\nequilibrium = "E1"\n', 'pi3_0 = "9"'),
    (UPRIGHT, 'I1 = "5", I2 = "4", I3 = "3", l = "1/2", m0 = "1", m1 = "0", omega3_0 = "sqrt(5)"')])
@pytest.mark.parametrize("name", ["D4", "D6", "frequency_2", "birkhoff_02"])
def test_what_is_wrong_is_shown_from_the_motions(tmp_path, scene, at, name):
    """A body of revolution, and irrational numbers: the two routes agree, or the check would stop."""
    found = finding(tmp_path, scene, name, "7", "number", f"at = {{ {at} }}\n")
    assert found.status == "misprint" and "Newton and Euler" in found.outcome.counterexample.confirmation


def test_names_without_numbers(tmp_path):
    """D4 is a number: at gives one for each name, and the sentence names them."""
    with pytest.raises(ValueError, match="E1 needs I1 .*: give a number for each"):
        finding(tmp_path, UPRIGHT, "D4", "0")
    unspecified = 'potential = "U(k3)"\ninertia = ["2", "2", "1"]\nequilibrium = "E1"\n'
    with pytest.raises(ValueError, match="give the scene a potential in k1, k2, k3"):
        finding(tmp_path, unspecified, "D4", "0", extra='at = { pi3_0 = "9", dU = "1", d2U = "1" }\n')
    at = 'at = { I1 = "5", I2 = "4", I3 = "3", l = "0", m0 = "1", m1 = "0", omega3_0 = "2" }\n'
    assert finding(tmp_path, UPRIGHT, "D4", "0", extra=at).outcome.counterexample.derived > 0


@pytest.mark.few(2)
@pytest.mark.parametrize("name", ["p", "q", "D4", "h"])
def test_a_parameter_with_the_name_of_a_quantity(tmp_path, name):
    """A quantity asks for a let that says which of the two is meant."""
    with pytest.raises(ValueError, match=f"quantity has {name}, a letter of the scene .*: say which by let"):
        finding(tmp_path, NAMED.format(name=name), name, name)
    own = finding(tmp_path, NAMED.format(name=name), name, name, extra=f'let = {{ {name} = "{name}" }}\n')
    assert own.status == "confirmed" and own.outcome.derived == gs.symbol(name)
    assert finding(tmp_path, NAMED.format(name=name), "k3", "1").status == "confirmed"


@pytest.mark.slow
def test_an_unknown_function_beside_the_normal_form(tmp_path):
    """The functions are offered; names that need numbers are not derived for it."""
    with pytest.raises(ValueError, match=r"entyr in a \(did you mean entry\?\)"):
        finding(tmp_path, UPRIGHT, "entyr(jacobian, 1, 1)", "0")


def scene_of(rotation):
    """The scene of a file."""
    field = " + ".join(f"({c})*k1**{a}*k2**{b}*k3**{d}" for (a, b, d), c in rotation.field.items())
    pi = [m - l for m, l in zip(rotation.momentum, rotation.rotor)]
    return Scene({"inertia": [str(rotation.tensor[n][n]) for n in range(3)],
                  "gyrostatic_momentum": list(map(str, rotation.rotor)), "potential": field,
                  "point": [str(x) for x in (*pi, *rotation.k)]})


@pytest.mark.slow
@pytest.mark.parametrize("quadratic", [False, True])
def test_twists_are_those_of_the_motions(quadratic, full):
    """D4 and D6 of the library, from how the frequencies of Newton and Euler's motions change."""
    drawn = windows(random.Random(5), quadratic)
    for _ in range(sampled(100, full, 8)):
        rotation = next(drawn)
        form = gs.analyze(rotation.equilibrium()).normal_form({}, 6)
        at = Oscillations(Model(scene_of(rotation), {}))
        for order, twist in zip((4, 6), form.twists):
            assert abs(twist.evalf(25) / Float(at.twist(order).str(25, radius=False), 25) - 1) < 1e-18


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [2, 3])
def test_resonances_are_those_of_the_motions(ratio, full):
    """Unstable where the slower oscillation drives the faster one."""
    seen = set()
    for seed in range(sampled(100, full, 12)):
        rng = random.Random(seed)
        given, K = in_resonance(rng, 1, ratio)
        rotation = with_form(*given, K, *terms(rng))
        decision = gs.analyze(rotation.equilibrium()).verdict({})
        sign, _ = stability(Model(scene_of(rotation), {}))
        assert sign == (-1 if decision.verdict is gs.Verdict.UNSTABLE else 0)
        seen.add(sign)
    assert seen == ({-1} if ratio == 2 else {-1, 0})
