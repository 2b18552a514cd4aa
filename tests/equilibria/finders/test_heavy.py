"""Every permanent rotation of a heavy gyrostat, against Newton's method, spectra and signatures."""
import random
from dataclasses import replace
from fractions import Fraction

import heavy
import mpmath
import numpy as np
import pytest
from heavy_scenes import DIRECTION, by_criteria, drawn, floats, k1, k2, k3, scene_of
from slow import sampled
from sympy import Matrix, Rational, sqrt

import gyrostat as gs
from gyrostat.equilibria.finders.heavy_form import HeavyForm, unreached
from gyrostat.equilibria.finders.level_rates import LevelZeros
from gyrostat.errors import ValuesError
from gyrostat.stability.criteria.amended_form import amended_form


def check(rng, quadratic):
    """Nothing missing, nothing wrong, but within rounding of a boundary; how many were decided."""
    inertia, rotor, c, Q, omega = drawn(rng, quadratic)
    if not any(c) and not quadratic:
        return 0
    found = gs.relative_equilibria(scene_of(inertia, rotor, c, Q), {"omega": omega})
    data = floats(inertia, rotor, c, Q, omega)
    wanted = heavy.directions(*data)
    places = [np.array([float(x) for x in rotation.directions[0]]) for rotation in found]
    assert len(found) % 2 == 0 or min(abs(float(r.form.invariants(None).form[-1])) for r in found) < 1e-6
    for k in wanted:
        assert min(np.abs(k - place).max() for place in places) < 1e-6, (data, k, places)
    for rotation, k in zip(found, places):
        growth, form = heavy.growth(*data, k), heavy.squares(*data, k)
        least = np.abs(form).min() / np.abs(form).max()
        if least > 1e-6 and (growth > 1e-4 or growth < 1e-7):
            expected = "UNSTABLE" if growth > 1e-4 else "STABLE" if form[0] > 0 else "UNDECIDED"
            assert by_criteria(rotation.decision) == expected, (data, k)
            assert rotation.damped.growing == np.sum(form < 0), (data, k)
    return len(found)


@pytest.mark.slow
@pytest.mark.parametrize("quadratic", [False, True])
def test_all_are_found_and_rightly_decided(quadratic):
    rng = random.Random(f"heavy {quadratic}")
    assert sum(check(rng, quadratic) for _ in range(3)) >= 6


@pytest.mark.slow
def test_many(full):
    rng = random.Random("many heavy")
    count = sampled(3000, full, 35)
    assert sum(check(rng, n % 2) for n in range(count)) > 2 * count


@pytest.mark.slow
def test_closed_forms_are_those_of_the_matrices():
    """p, q of the linearised field, the determinant of K on a basis of the plane across k; exactly."""
    rng = random.Random("closed forms")
    for _ in range(10):
        inertia, rotor, _, Q, omega = drawn(rng, True)
        a, b = (Fraction(rng.randint(-5, 5), rng.randint(1, 4)) for _ in range(2))
        k = [2 * a / (1 + a * a + b * b), 2 * b / (1 + a * a + b * b), 1 - 2 / (1 + a * a + b * b)]
        sigma, slopes = Fraction(rng.randint(-9, 9), 2), [sum(x * y for x, y in zip(row, k)) for row in Q]
        c = [omega**2 * m * x + omega * l + sigma * x - y for m, l, x, y in zip(inertia, rotor, k, slopes)]
        scene = scene_of(inertia, rotor, c, Q)
        eq = gs.equilibrium(scene, (*(omega * m * x for m, x in zip(inertia, k)), *k))
        gradient = [x + y for x, y in zip(c, slopes)]
        rows = [[inertia[i] if i == j else 0 for j in range(3)] for i in range(3)]
        form = amended_form(rows, rotor, gradient, Q, k, omega)
        assert gs.derivation.linearize(eq).coefficients == (form.p, form.q)
        form = gs.derivation.second_variation(eq).matrix
        minors = [form[:n, :n].det() for n in range(1, 5)]
        found = amended_form(rows, rotor, gradient, Q, k, omega)
        assert all(m > 0 for m in minors) == (found.trace > 0 and found.determinant > 0)
        assert (minors[3] > 0) == (found.determinant > 0)


def digits(x):
    with mpmath.workdps(50):
        return mpmath.mpf(str(x.evalf(50)))


@pytest.mark.slow
def test_frequencies_and_growth_rates():
    """Against the eigenvalues of the six equations at 50 digits, two of which are 0."""
    rng, kinds = random.Random("frequencies"), set()
    for _ in range(12):
        inertia, rotor, _, Q, omega = drawn(rng, True)
        k, sigma = (Fraction(2, 3), Fraction(1, 3), Fraction(-2, 3)), Fraction(rng.randint(-60, 20))
        slopes = [sum(x * y for x, y in zip(row, k)) for row in Q]
        c = [omega**2 * m * x + omega * l + sigma * x - y for m, l, x, y in zip(inertia, rotor, k, slopes)]
        found = gs.relative_equilibria(scene_of(inertia, rotor, c, Q), dict(zip(("k1", "k2", "k3"), k)))
        (rotation,) = [r for r in found if r.rates["omega"] == omega]
        whole = heavy.eigenvalues(np.diag(inertia), rotor, [x + y for x, y in zip(c, slopes)], Q,
                                  omega, k)
        moving = [x for x in whole if abs(x) > 1e-9]
        wanted = sorted(x.imag for x in moving if x.imag > 0 and abs(x.real) < 1e-30)
        assert len(moving) == 4 and len(wanted) == len(rotation.frequencies)
        assert all(abs(digits(x) - y) < 1e-30 for x, y in zip(rotation.frequencies, wanted))
        growth = max(x.real for x in moving)
        assert (rotation.growth_rate is None) == (growth < 1e-30)
        assert growth < 1e-30 or abs(digits(rotation.growth_rate) - growth) < 1e-30
        kinds.add((len(wanted), growth > 1e-30))
    assert kinds == {(2, False), (1, True), (0, True)}


@pytest.mark.parametrize("inertia, k, rotor, slopes, p, q", [
    ((3, 5, 4), (2, 1, 2), (0, 0, 0), (0, "2/3", "2/3"), "2/3", "2/135"),
    ((4, 6, 3), (-2, 1, 2), (0, 0, 0), ("-2/3", 1, 0), "209/324", "1/81"),
    ((3, 4, 5), (1, 2, -2), (-1, 2, -1), ("4/3", "-2/3", -1), "479/540", "52/405"),
])
def test_in_a_direction(inertia, k, rotor, slopes, p, q):
    """Derived by hand; gyroscopic: the amended potential is greatest there."""
    U = sum(Rational(x) * y for x, y in zip(slopes, DIRECTION))
    scene = gs.assemble(gs.Gyrostat(inertia, rotor), gs.general_potential(U))
    found = gs.relative_equilibria(scene, {f"k{n}": Rational(x, 3) for n, x in enumerate(k, 1)})
    (rotation,) = [r for r in found if r.rates["omega"] == -1]
    assert rotation.form.invariants(None).spectrum == (1, Rational(p), Rational(q))
    assert rotation.decision.notion == "Lyapunov (Arnold-Moser)" and "maximum" in rotation.decision.reason
    assert rotation.damped.growing == 2
    assert gs.analyze(rotation.equilibrium).verdict({}).reason == rotation.decision.reason


def test_staude():
    """I = (1, 2, 3), c = (1, 1, 1)/√3: the numbers of a published example, in a direction off every plane."""
    U = (k1 + k2 + k3) / sqrt(3)
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(U))
    found = gs.relative_equilibria(scene, {"k1": -1 / sqrt(19), "k2": -3 / sqrt(19), "k3": 3 / sqrt(19)})
    assert [f"{float(r.rates['omega']):.9f}" for r in found] == ["-1.295276413", "1.295276413"]
    form, (_, *spectrum) = found[1].form.invariants(None)
    assert [f"{float(x):.11f}" for x in spectrum] == ["2.28113905939", "0.68680961663"]
    assert [f"{float(x):.11f}" for x in form] == ["3.35164274701", "1.70209339775"]
    assert not gs.relative_equilibria(scene, {"k1": 1 / sqrt(19), "k2": 3 / sqrt(19), "k3": -3 / sqrt(19)})


@pytest.mark.slow
@pytest.mark.parametrize("cases", [1, pytest.param(8, marks=pytest.mark.slow)])
@pytest.mark.parametrize("quadratic", [False, True])
def test_in_any_axes(quadratic, cases):
    """A full tensor: the same rotations, turned, with the same verdicts."""
    rng = random.Random(f"axes {quadratic} {cases}")
    R = Matrix([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
    for _ in range(cases):
        inertia, rotor, c, Q, omega = drawn(rng, quadratic)
        scene = scene_of(inertia, rotor, c, Q)
        turned = scene.potential.expression.xreplace(dict(zip(DIRECTION, R.T * Matrix(DIRECTION)))).expand()
        tensor, moved = R * Matrix.diag(*inertia) * R.T, R * Matrix(rotor)
        there = gs.assemble(gs.Gyrostat(tensor.tolist(), tuple(moved)), gs.general_potential(turned))
        found, wanted = (gs.relative_equilibria(s, {"omega": omega}) for s in (there, scene))
        assert len(found) == len(wanted)
        for rotation in wanted:
            place = np.array((R * Matrix(rotation.directions[0])).evalf(20).tolist(), float).ravel()
            (same,) = [r for r in found if np.abs(np.array(r.directions[0], float) - place).max() < 1e-9]
            for one, other in ((same.decision, rotation.decision), (same.damped, rotation.damped)):
                assert replace(one, note="") == replace(other, note="") and bool(one.note) is bool(other.note)


def test_principal_axes_carry_every_rate_that_is_an_eigenvalue():
    """c = 0 in a quadratic field: k is an eigenvector, six of them, and a circle where two values meet."""
    U = k1**2 / 2 + k2**2 + 3 * k3**2 / 2
    scene = gs.assemble(gs.Gyrostat((1, 2, 4), (0, 0, 0)), gs.general_potential(U))
    found = gs.relative_equilibria(scene, {"omega": 2})
    assert sorted(r.directions[0] for r in found) == sorted(
        tuple(s * (n == m) for m in range(3)) for n in range(3) for s in (1, -1))
    (circle, *_) = [r for r in gs.relative_equilibria(scene, {"omega": 1}) if r.locus]
    assert circle.locus == "the circle about axis 3" and circle.directions[0][2] == 0


def test_what_is_refused():
    body = gs.Gyrostat((1, 2, 3), (0, 0, 0))
    cubic = gs.assemble(body, gs.general_potential(k1**3 + k2))
    with pytest.raises(ValuesError, match="every rate omega"):
        gs.relative_equilibria(cubic, {"k1": 0, "k2": 1, "k3": 0})
    assert gs.relative_equilibria(cubic, {"k1": 0, "k2": "3/5", "k3": "-4/5"}) == []
    linear = gs.assemble(body, gs.general_potential(k1 + k2))
    with pytest.raises(ValuesError, match=r"\|k\|² − 1 = 1"):
        gs.relative_equilibria(linear, {"k1": 1, "k2": 1, "k3": 0})
    with pytest.raises(ValuesError, match="give omega, the rate"):
        gs.relative_equilibria(linear, {"k1": 1})


def test_two_frequencies_that_are_equal():
    """The sleeping top at its critical spin, (I3 omega)² = 4 I1 m0: p² = 4q exactly, no ball tells."""
    scene = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 0)), gs.general_potential(k3))
    critical, beyond = (HeavyForm(scene, (0, 0, 1), sqrt(8) + x) for x in (0, Rational(1, 10**50)))
    assert critical.signs == beyond.signs == (-1, 1)
    assert critical.spectral_signs == (1, 0) and beyond.spectral_signs == (1, 1)


def test_balls_decide_without_expressions(monkeypatch):
    """A rotation that gyroscopic forces stabilise, in a field of degree 18: no component is written out."""
    def refuse(*_):
        raise AssertionError("a number in the field is written out")

    U = k1 / 10 + k2 / 5 + 3 * k3 / 10
    moments, rotor = ([Rational(n, 100) for n in several] for several in ((107, 121, 141), (28, 52, 85)))
    scene = gs.assemble(gs.Gyrostat(moments, rotor), gs.general_potential(U))
    monkeypatch.setattr(LevelZeros, "expression", refuse)
    found = gs.relative_equilibria(scene, {"C1": 1})
    assert sum(r.decision.notion == "Lyapunov (Arnold-Moser)" for r in found) == 1
    assert sum(r.damped.verdict.name == "STABLE" for r in found) == 1


def test_what_damping_does_not_reach_in_expressions():
    """M × k, and D²U − k·∇U across k: in fractions, and in numbers that are sums of roots."""
    data = ([[2, 1, 0], [1, 3, 1], [0, 1, 4]], [1, -2, 3], [3, 1, 2], [[1, 2, 0], [2, 0, 1], [0, 1, 5]],
            [Fraction(2, 3), Fraction(1, 3), Fraction(2, 3)], 2)
    unit = 1 + sqrt(2)
    inertia, rotor, gradient, curved, k, omega = data
    scaled = ([[unit * x for x in row] for row in inertia], [unit * x for x in rotor],
              [unit * x for x in gradient], [[unit * x for x in row] for row in curved], k, omega)
    wanted = unreached(*data)
    assert any(wanted) and all((x - unit * Rational(y.numerator, y.denominator)).expand() == 0
                               for x, y in zip(unreached(*scaled), wanted))
