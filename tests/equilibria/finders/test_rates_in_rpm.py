"""Every rotation of a body in a field where rates, or wheels, are in rpm: π in the numbers."""
import random

import heavy
import numpy as np
import pytest
from heavy_scenes import by_criteria, drawn, k1, k2, k3, scene_of
from slow import sampled
from sympy import Matrix, Rational, pi, sqrt

import gyrostat as gs
from gyrostat.errors import ScopeError


def check(rng, quadratic):
    """Nothing missing, nothing wrong, against Newton's method, spectra and signatures; how many there are."""
    inertia, rotor, c, Q, omega = drawn(rng, quadratic)
    if not any(c) and not quadratic:
        return 0
    turns = rng.choice([(1, pi), (pi, 1), (pi, pi)])
    rotor, omega = [Rational(x) * turns[0] for x in rotor], Rational(omega) / 2 * turns[1]
    found = gs.relative_equilibria(scene_of(inertia, rotor, c, Q), {"omega": omega})
    data = np.diag([float(x) for x in inertia]), *(np.array(x, float) for x in (rotor, c, Q)), float(omega)
    places = [np.array([float(x) for x in rotation.directions[0]]) for rotation in found]
    wanted = heavy.directions(*data)
    for k in wanted:
        assert min(np.abs(k - place).max() for place in places) < 1e-6, (data, k, places)
    for rotation, k in zip(found, places):
        assert np.abs(np.cross(data[4]**2 * data[0] @ k + data[4] * data[1] - data[2] - data[3] @ k, k)).max(
            ) < 1e-9 * (1 + data[4]**2), (data, k)
        assert heavy.verdict(*data, k) in (None, by_criteria(rotation.decision)), (data, k)
    return len(found)


@pytest.mark.slow
@pytest.mark.parametrize("quadratic", [False, True])
def test_all_are_found_and_rightly_decided(quadratic, full):
    rng = random.Random(f"rpm {quadratic}")
    assert sum(check(rng, quadratic) for _ in range(sampled(60, full, 4))) >= 6


def test_two_wheels_and_ten_turns_a_minute():
    """U = k2 + k3, l = (1, 0, 1): two rotations, both stable."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (1, 0, 1)), gs.general_potential(k2 + k3))
    found = gs.relative_equilibria(scene, {"omega": "10 rpm"})
    data = np.diag([1.0, 2, 3]), np.array([1.0, 0, 1]), np.array([0, 1.0, 1]), np.zeros((3, 3)), np.pi / 3
    wanted = heavy.directions(*data)
    assert len(found) == len(wanted) == 2 and all(r.rates["omega"] == pi / 3 for r in found)
    for r in found:
        k = np.array(r.directions[0], float)
        assert min(np.abs(k - other).max() for other in wanted) < 1e-9
        assert r.decision.verdict.name == "STABLE"
        # the same as a claimed point: its equations are proved to hold
        assert r.equilibrium.label == "permanent rotation"


def test_a_full_tensor():
    """Turned axes: the same verdicts."""
    R = Matrix([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
    U = (k1 + 2 * k2 - k3).xreplace(dict(zip((k1, k2, k3), R.T * Matrix((k1, k2, k3))))).expand()
    there = gs.assemble(gs.Gyrostat((R * Matrix.diag(1, 2, 3) * R.T).tolist(), tuple(R * Matrix([0, pi, 1]))),
                        gs.general_potential(U))
    here = gs.assemble(gs.Gyrostat((1, 2, 3), (0, pi, 1)), gs.general_potential(k1 + 2 * k2 - k3))
    found, wanted = (gs.relative_equilibria(s, {"omega": Rational(3, 2)}) for s in (there, here))
    assert len(found) == len(wanted) >= 2
    for rotation in wanted:
        k = np.array(R, float) @ np.array(rotation.directions[0], float)
        near = min(found, key=lambda r: np.abs(np.array(r.directions[0], float) - k).max())
        assert np.abs(np.array(near.directions[0], float) - k).max() < 1e-9
        assert near.decision.verdict is rotation.decision.verdict


@pytest.mark.slow
@pytest.mark.parametrize("unit", [pi, sqrt(2)], ids=str)
@pytest.mark.parametrize("U, asked", [(k2**3 + k3, "omega"), (k1 + k2**2 - k3, "C1")])
def test_numbers_with_one_factor(U, asked, unit):
    """l, omega and C1 in a unit of rate, U in its square: the same directions as in other units of time."""
    scenes = [gs.assemble(gs.Gyrostat((1, 2, 3), (x, 0, 2 * x)), gs.general_potential(x**2 * U))
              for x in (unit, 1)]
    found, wanted = (gs.relative_equilibria(s, {asked: 3 * x}) for s, x in zip(scenes, (unit, 1)))
    assert len(found) == len(wanted) >= 2
    for one, other in zip(found, wanted):
        assert np.allclose(*(np.array(r.directions[0], float) for r in (one, other)), rtol=0, atol=1e-12)
        assert abs(float(one.rates["omega"]) - float(unit * other.rates["omega"])) < 1e-12
        assert one.decision.verdict is other.decision.verdict


@pytest.mark.parametrize("U, l, asked", [
    (k2 + k3, (1, 0, 1), {"C1": pi}), (k2**3 + k3, (1, 0, pi), {"omega": 1})])
def test_what_is_refused(U, l, asked):
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), l), gs.general_potential(U))
    with pytest.raises(ScopeError, match="pi is not rational: .* round it to decimals, 3.141592654"):
        gs.relative_equilibria(scene, asked)
