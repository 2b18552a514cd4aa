"""Symmetric satellites: cylindrical, hyperbolic and conical precessions, and the motion of the axis."""
from fractions import Fraction as F
from random import Random

import pytest
from slow import sampled
from sympy import Matrix, Rational, nsimplify
from turns import TURNS
from two_directions import Scene, second_variation, sextic

import gyrostat as gs
from gyrostat.mechanics.families.orbital_precession import moving_axis

KINDS = ("cylindrical", "hyperbolic", "conical")
REPORTS = {kind: gs.analyze(gs.orbital_precession(gs.assemble(gs.symmetric_gyrostat(), gs.circular_orbit()),
                                                  kind)) for kind in KINDS}


def drawn(rng, kind):
    """A, C, the rate of the orbit, the height n3 and its complement, the rotor."""
    A, C, w = F(rng.randint(4, 30), 10), F(rng.randint(4, 50), 10), F(rng.randint(1, 9), rng.randint(1, 4))
    t = F(rng.randint(-12, 12), rng.randint(1, 9))
    height, across = 2 * t / (1 + t * t), (1 - t * t) / (1 + t * t)
    if kind == "cylindrical":
        return A, C, w, F(1), F(0), F(rng.randint(-60, 60), 10) * w
    return A, C, w, height, abs(across), (1 if kind == "hyperbolic" else 4) * (A - C) * w * height


def of_table(kind, A, C, w, height, l):
    """h1, h2 and G of the reduced motion of the axis; P = π3 + l."""
    P = C * w * height + l
    if kind == "cylindrical":
        first = w * P - A * w * w
        return first, first + 3 * w * w * (C - A), P - 2 * A * w
    if kind == "hyperbolic":
        return 3 * w * w * (C - A), A * w * w * (1 - height**2), -P
    return -3 * w * w * (C - A), (4 * A - 3 * C) * w * w * (1 - height**2), P - 2 * A * w * height


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_the_table(kind, full):
    """λ⁴ + p λ² + q with p = (h1 + h2)/A + G²/A², q = h1 h2/A²; stable iff h1, h2 > 0, else by the axis.

    The spectrum and the signature of the oracle, which has all nine coordinates, agree; damping loses what is
    no minimum at a rotor of its own, modulo the turn about the axis.
    """
    rng = Random(kind)
    for _ in range(sampled(300, full, 8)):
        A, C, w, height, across, l = drawn(rng, kind)
        if A == C or across == 0 and kind != "cylindrical":
            continue
        h1, h2, G = of_table(kind, A, C, w, height, l)
        p, q = (h1 + h2) / A + G * G / A**2, h1 * h2 / A**2
        n = [across, F(0), height]
        r = {"cylindrical": [F(1), F(0), F(0)], "hyperbolic": [F(0), F(1), F(0)],
             "conical": [-height, F(0), across]}[kind]
        scene = Scene([[1 / (C if i == 2 else A) if i == j else F(0) for j in range(3)] for i in range(3)],
                      [F(0), F(0), l], [[-w if i == j else F(0) for j in range(6)] for i in range(3)],
                      [[3 * w * w * (C if i == 5 else A) if i == j and i > 2 else F(0) for j in range(6)]
                       for i in range(6)], [F(0), F(0), -w * l, F(0), F(0), F(0)])
        state = [*(w * i * x for i, x in zip((A, A, C), n)), *n, *r]
        assert not any(scene.field(state))
        assert sextic(scene, state) == (p, q, 0)
        report = REPORTS[kind]
        names = {"I1": A, "I3": C, "omega0": w} | ({"l": l} if kind == "cylindrical" else {"n3": height})
        decision = report.verdict(names)
        if p < 0 or q < 0 or p * p < 4 * q:
            assert decision.verdict is gs.Verdict.UNSTABLE
        elif h1 > 0 and h2 > 0:
            assert decision.verdict is gs.Verdict.STABLE and decision.notion == "Lyapunov"
        elif h1 < 0 and h2 < 0 and p * p > 4 * q:
            assert "the axis moves in the orbital frame" in decision.reason
            assert decision.verdict is not gs.Verdict.UNDECIDED or "resonan" in decision.reason
        plus, minus, null = second_variation(scene, state)
        damped = report.verdict(names, damped=True)
        if null == 1 and damped.verdict is not gs.Verdict.UNDECIDED:
            assert damped.growing == minus and (damped.verdict is gs.Verdict.STABLE) == (minus == 0)


@pytest.mark.parametrize(("height", "name"), [("0.70553528", "UNSTABLE"), ("0.70553529", "STABLE")])
def test_the_window_of_a_disc(height, name):
    """C/A = 1.6: held by gyroscopic forces from n3² = 0.49778003553… on."""
    decision = REPORTS["conical"].verdict({"I1": 1, "I3": "1.6", "omega0": 1, "n3": height})
    assert decision.verdict.name == name


def test_the_axis_moves_as_a_body_in_one_direction():
    """The field of the nine coordinates, on the axis, is that of the reduced scene."""
    A, C, w, l = 2, Rational(3, 2), Rational(1, 3), Rational(1, 5)
    scene = gs.assemble(gs.Gyrostat((A, A, C), (0, 0, l)), gs.circular_orbit(w))
    eq = gs.orbital_precession(scene, "conical")
    axis = moving_axis(eq, lambda x: x)
    p, q = gs.derivation.linearize(axis).coefficients
    assert gs.derivation.linearize(eq).coefficients == (p, q, 0)
    P = eq.point[2] + l
    assert axis.at_point(axis.system.space.casimirs[0]).expand() == -P.expand()


def test_other_rotors():
    """A number, none, one that is too strong, and a sphere."""
    def scene(*rotor, moments=(2, 2, 1)):
        return gs.assemble(gs.Gyrostat(moments, rotor), gs.circular_orbit(1))
    assert gs.orbital_precession(scene(0, 0, 1), "conical").point[5] == Rational(1, 4)
    assert gs.orbital_precession(scene(0, 0, 0), "hyperbolic").point[5] == 0
    with pytest.raises(gs.errors.EquilibriumError, match="too strong"):
        gs.orbital_precession(scene(0, 0, 5), "conical")
    with pytest.raises(gs.errors.EquilibriumError, match="no conical precession of a sphere"):
        gs.orbital_precession(scene(0, 0, 1, moments=(1, 1, 1)), "conical")
    with pytest.raises(gs.errors.EquilibriumError, match="no precession: give one of cylindrical, hyper"):
        gs.orbital_precession(scene(0, 0, 1), "elliptic")
    with pytest.raises(gs.errors.ScopeError, match="body of revolution in orbit"):
        gs.orbital_precession(scene(0, 0, 1, moments=(1, 2, 3)), "conical")


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("c", ["axis 1", "(1, 2, 2)", "(1, 1, 1)"])
def test_a_tensor_in_any_axes(kind, c):
    """As in axes of which the third is that of the body; gyroscopic forces stabilise a conical one."""
    turn = TURNS[c]
    l = {"cylindrical": Rational(1, 5), "hyperbolic": Rational(-1, 3), "conical": Rational(-9, 5)}[kind]
    moments = Matrix.diag(1, 1, Rational(8, 5))
    body = gs.Gyrostat((turn.T * moments * turn).tolist(), list(turn.T * Matrix([0, 0, l])))
    one, other = (gs.orbital_precession(gs.assemble(each, gs.circular_orbit(1)), kind)
                  for each in (gs.Gyrostat((1, 1, "8/5"), (0, 0, l)), body))
    sides = [gs.derivation.linearize(eq).coefficients for eq in (one, other)]
    assert not any(nsimplify(x - y) for x, y in zip(*sides))
    first, second = (gs.analyze(eq).verdict({}) for eq in (one, other))
    assert (first.verdict, first.rung) == (second.verdict, second.rung)
    assert kind != "conical" or first.rung.name == "TWIST_NEGATIVE"


@pytest.mark.slow
def test_the_axis_moves_so_under_torques_along_it():
    """λ⁴ + p λ² + q of the reduced scene is that of the nine coordinates, with drag and an asteroid."""
    potential = "t3/3 + n3^2/5 + (n1^2 + n2^2)/4"
    scene = gs.assemble(gs.Gyrostat((1, 1, "8/5"), (0, 0, "1/5")), gs.circular_orbit(1, potential=potential))
    for e in gs.relative_equilibria(scene, {}):
        axis = moving_axis(e.equilibrium, lambda x: x)
        sides = [gs.derivation.linearize(eq).coefficients for eq in (axis, e.equilibrium)]
        assert [float(x) for x in sides[0]] == pytest.approx([float(x) for x in sides[1]][:2], rel=1e-12)
