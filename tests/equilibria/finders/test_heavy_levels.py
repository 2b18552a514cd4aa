"""Every permanent rotation of a heavy gyrostat at given C1, against Newton's method, Morse's count."""
import random

import heavy
import numpy as np
import pytest
from heavy_scenes import by_criteria, drawn, floats, k1, k2, k3, scene_of
from slow import sampled
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.errors import ScopeError


def check(rng, quadratic):
    """Nothing missing, nothing wrong, #min − #saddle + #max = 2; how many there are."""
    inertia, rotor, c, Q, level = drawn(rng, quadratic)
    if not any(c) and not quadratic:
        return 0
    found = gs.relative_equilibria(scene_of(inertia, rotor, c, Q), {"C1": level})
    data = floats(inertia, rotor, c, Q, level)
    places = [np.array([float(x) for x in r.directions[0]]) for r in found]
    for k, omega in heavy.on_level(*data):
        near = min(range(len(found)), key=lambda n: np.abs(k - places[n]).max())
        assert np.abs(k - places[near]).max() < 1e-6, (data, k)
        assert abs(omega - float(found[near].rates["omega"])) < 1e-6 * (1 + abs(omega))
    count = 0
    for r, k in zip(found, places):
        omega = float(r.rates["omega"])
        growth, form = heavy.growth(*data[:4], omega, k), heavy.squares(*data[:4], omega, k)
        least = np.abs(form).min() / np.abs(form).max()
        if least > 1e-6 and (growth > 1e-4 or growth < 1e-7):
            expected = "UNSTABLE" if growth > 1e-4 else "STABLE" if form[0] > 0 else "UNDECIDED"
            assert by_criteria(r.decision) == expected, (data, k)
        count += 1 if np.sum(form < 0) % 2 == 0 else -1
    assert count == 2, data
    return len(found)


@pytest.mark.slow
@pytest.mark.parametrize("quadratic", [False, True])
def test_all_are_found_and_rightly_decided(quadratic):
    rng = random.Random(f"levels {quadratic}")
    assert sum(check(rng, quadratic) for _ in range(2 if quadratic else 6)) >= 4


@pytest.mark.slow
def test_many(full):
    rng = random.Random("many levels")
    count = sampled(2000, full, 8)
    assert sum(check(rng, n % 2) for n in range(count)) > 2 * count


def test_at_rest():
    """C1 = 0 and l = 0: omega = 0, k along c or against it."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(k1 + 2 * k2 + 2 * k3))
    found = gs.relative_equilibria(scene, {"C1": 0})
    third = Rational(1, 3)
    assert [(r.directions[0], r.rates["omega"]) for r in found] == [((third, 2 * third, 2 * third), 0),
                                               ((-third, -2 * third, -2 * third), 0)]
    assert [r.decision.verdict.name for r in found] == ["UNSTABLE", "STABLE"]


def test_what_is_refused():
    body = gs.Gyrostat((1, 2, 3), (0, 0, 0))
    linear = gs.assemble(body, gs.general_potential(k1 + 2 * k2 + k3))
    with pytest.raises(ScopeError, match="if the numbers are rational"):
        gs.relative_equilibria(linear, {"C1": sqrt(2) + 1})


@pytest.mark.slow
def test_in_a_plane_of_symmetry_and_off_it():
    """c and l in the plane of axes 1 and 3: Newton's method finds the same number, Morse counts 2."""
    rotor, c = (Rational(-1), 0, Rational(5, 6)), (Rational(-5, 3), 0, Rational(-7, 2))
    U = c[0] * k1 + c[2] * k3
    scene = gs.assemble(gs.Gyrostat((Rational(5, 2), 1, 2), rotor), gs.general_potential(U))
    found = gs.relative_equilibria(scene, {"C1": 6})
    data = np.diag([2.5, 1, 2]), np.array(rotor, float), np.array(c, float), np.zeros((3, 3)), 6.0
    wanted = heavy.on_level(*data)
    rates = sorted(float(r.rates["omega"]) for r in found)
    assert np.allclose(rates, sorted(omega for _, omega in wanted), atol=1e-7)
    kinds = [r.decision.reason for r in found]
    assert sum(-1 if "saddle" in why else 1 for why in kinds) == 2


@pytest.mark.slow
@pytest.mark.parametrize(("U", "slope", "least"), [
    ("k1 + 2*k2", lambda k: np.array([1.0, 2, 0]), 2),
    ("k1^3 + k3", lambda k: np.array([3 * k[0]**2, 0, 1]), 6)], ids=["linear", "cubic"])
def test_what_is_found_rests_on_the_level(U, slope, least):
    """M × ω + k × ∇U = 0, and M·k = C1, M = I ω + l: a rotor off the axes, fields of degree 1 and 3."""
    inertia, rotor = np.diag([1.0, 2, 3]), np.array([0.5, 0, 1])
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), ("1/2", 0, 1)), gs.general_potential(U))
    found = gs.relative_equilibria(scene, {"C1": 3})
    assert len(found) >= least
    for rotation in found:
        k, omega = np.array([float(x) for x in rotation.directions[0]]), float(rotation.rates["omega"])
        M = omega * inertia @ k + rotor
        np.testing.assert_allclose(np.cross(M, omega * k) + np.cross(k, slope(k)), 0, atol=1e-10)
        assert M @ k == pytest.approx(3, abs=1e-10) and k @ k == pytest.approx(1, abs=1e-12)
