"""Birkhoff's normal form as a user gets it, and the verdicts that rest on it."""
import json

import pytest
from commands import run
from sympy import Rational, S, numer, real_roots, simplify, sqrt, together

import gyrostat as gs
from gyrostat.errors import GyrostatError, ScopeError

E1 = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))


def at_point(inertia, k, rotor, slopes, omega):
    """The report of a permanent rotation in U = c·k."""
    k = [Rational(x, 3) for x in k]
    U = gs.general_potential(lambda *x: sum(Rational(c) * y for c, y in zip(slopes, x)))
    scene = gs.assemble(gs.Gyrostat(inertia, rotor), U)
    return gs.analyze(gs.equilibrium(scene, (*(omega * I * x for I, x in zip(inertia, k)), *k)))


CASES = [((3, 5, 4), (2, 1, 2), (0, 0, 0), (0, "2/3", "2/3"), -1, "691181/6156000"),
         ((4, 6, 3), (-2, 1, 2), (0, 0, 0), ("-2/3", 1, 0), -1, "132018846107/417696761664"),
         ((6, 3, 4), (1, -2, 2), (0, 0, 0), (1, 0, "2/3"), -1, "132018846107/417696761664"),
         ((6, 4, 3), (1, 2, 2), (0, 0, 0), (1, "2/3", 0), 1, "132018846107/417696761664"),
         ((3, 4, 5), (1, 2, -2), (-1, 2, -1), ("4/3", "-2/3", -1), -1, "157719110778286087/5657877481052160")]


@pytest.mark.few(1)
@pytest.mark.parametrize("inertia, k, rotor, slopes, omega, D4", CASES)
def test_numbers_found_in_another_chart(inertia, k, rotor, slopes, omega, D4):
    """Exact rational numbers, the same in relabelled and reflected axes."""
    report = at_point(inertia, k, rotor, slopes, omega)
    form = report.normal_form({})
    assert form.twists == (Rational(D4),)
    (w1, w2), c = form.frequencies, {(m, n): x for m, n, x in form.coefficients}
    assert simplify(c[2, 0] * w2**2 - c[1, 1] * w1 * w2 + c[0, 2] * w1**2 - form.twists[0]) == 0
    decision = report.verdict({})
    assert decision.verdict is gs.Verdict.STABLE and decision.notion == "Lyapunov (Arnold-Moser)"
    assert f"{float(Rational(D4)):.5g}"[:5] in decision.reason and decision.pointwise


def test_the_sleeping_body_of_three_moments():
    """I = (5, 4, 3), m0 = 1: a maximum held where 400 (p² − 4q) = 324 W² − 636 W + 1 > 0, W = ω²; at 1:3
    |K4| = 1.07793073387 > R = 0.00772954273.
    """
    scene = gs.assemble(gs.Gyrostat((5, 4, 3), (0, 0, 0)), gs.general_potential(lambda x, y, z: z))
    report = gs.analyze(gs.equilibrium(scene, (0, 0, 3 * gs.symbol("omega3_0"), 0, 0, 1)))
    W = Rational(53, 54) + 10 * sqrt(7) / 27
    assert report.verdict({"omega3_0": sqrt(W - Rational(1, 10**6))}).verdict is gs.Verdict.UNSTABLE
    assert "D4" in report.verdict({"omega3_0": sqrt(W + Rational(1, 10**6))}).reason
    assert report.verdict({"omega3_0": 3}).verdict is gs.Verdict.STABLE
    p, q = report.linearization.coefficients
    spins = real_roots(numer(together(9 * p**2 - 100 * q)))
    decision = report.verdict({"omega3_0": next(w for w in spins if abs(w.evalf() - 5.1959) < 1e-3)})
    assert decision.verdict is gs.Verdict.STABLE and decision.scope == "on its level of C1"
    assert decision.reason.endswith("resonance 1:3, |D4| = 1.07793 > R = 0.00772954")


def test_a_sleeping_top():
    """I1 = 1, I3 = 1/2, m0 = 2, π3 = 3: frequencies 5 and −4 about the body's axis, exact to degree 6."""
    form = E1.normal_form({"I1": 1, "I3": "1/2", "l": 0, "m0": 2, "pi3_0": 3}, 6)
    assert form.frequencies == (5, -4) and form.resonances == ()
    assert [c for *_, c in form.coefficients[:3]] == [Rational(5, 2), 3, 1]
    assert form.twists == (125, 6522)


@pytest.mark.parametrize("values, words", [
    ({"pi3_0": 1}, "E1 is unstable there"), ({"pi3_0": sqrt(8)}, "E1 is degenerate there"),
    ({"pi3_0": 3, "I3": None}, "E1 needs I3"),
])
def test_where_there_is_none(values, words):
    """One sentence that says what fails."""
    numbers = {"I1": 1, "I3": S.Half, "l": 0, "m0": 2} | values
    with pytest.raises(GyrostatError, match=words):
        E1.normal_form({name: x for name, x in numbers.items() if x is not None})


def test_a_free_body_has_none():
    """One degree of freedom."""
    free = gs.analyze(gs.principal_rotation(gs.assemble(gs.Gyrostat((3, 2, 1), (0, 0, 0))), 3))
    with pytest.raises(ScopeError, match="one degree of freedom"):
        free.normal_form({"omega3_0": 1})


def test_a_resonance_of_low_order():
    """1:2 where the cubic terms do not vanish."""
    with pytest.raises(ScopeError, match="degree = 5"):
        E1.normal_form({"I1": 1, "I3": 1, "l": 0, "m0": 2, "pi3_0": 3}, 5)
    assert E1.normal_form({"I1": 1, "I3": 1, "l": 0, "m0": 2, "pi3_0": 3}).resonances == ((1, 2),)


@pytest.mark.parametrize("values", [(Rational(3, 4), Rational(11, 16), 3),
                                    (Rational(1, 4), Rational(-195, 4), 1)],
                         ids=["opposite", "equal"])
def test_a_resonance_that_a_body_of_revolution_does_not_feel(values):
    """1:3, frequencies of opposite and of equal signs: exact to degree 6, as next to it."""
    values = dict(zip(("I3", "m0", "pi3_0"), values)) | {"I1": 1, "l": 0}
    form = E1.normal_form(values, 6)
    near = E1.normal_form(values | {"m0": values["m0"] + Rational(1, 10**12)}, 6)
    assert form.resonances == ((1, 3),) and near.resonances == ()
    assert (form.frequencies[0] * form.frequencies[1] > 0) == (values["m0"] < 0)
    for one, other in ((form.frequencies, near.frequencies), (form.twists, near.twists),
                       ([c for *_, c in form.coefficients], [c for *_, c in near.coefficients])):
        assert [float(x) for x in one] == pytest.approx([float(x) for x in other], rel=1e-6)


def test_on_the_command_line(capsys):
    """Text and JSON say the same numbers."""
    numbers = ("--potential", "m0*k3", "--set", "I1=1", "I3=1/2", "l=0", "m0=2", "pi3_0=3")
    _, said, _ = run(capsys, "--equilibrium", "E1", *numbers, "--normal-form", "6", verb="decide")
    assert "ω₂ = −4" in said and "D₆ = 6522" in said and "c₁₂ = −24" in said
    _, said, _ = run(capsys, "--equilibrium", "E1", *numbers, "--normal-form", "4", "--format", "json",
                     verb="decide")
    assert json.loads(said)["twists"] == {"D4": {"exact": "125", "decimal": 125.0}}
    assert "name it, or give its point" in run(capsys, *numbers, "--normal-form", "4", verb="decide")[2]
