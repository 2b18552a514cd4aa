"""Damped verdicts of satellites against a sphere that turns in a viscous fluid inside."""
from fractions import Fraction
from fractions import Fraction as F
from random import Random

import numpy as np
import pytest
from satellites import exact, satellite
from slow import sampled

import gyrostat as gs

SPHERE, FRICTION = 0.1, 0.3                                # of the least moment; of the fluid


def rates(s, inertia, rotor):
    """Of the rates of body and sphere, n and r, at the orbital rate 1, all in body axes."""
    w, sphere, n, r = s.reshape(4, 3)
    J = SPHERE * np.diag(inertia).min()
    torque = FRICTION * J * (sphere - w)
    momentum = (inertia - J * np.eye(3)) @ w + rotor
    turned = np.linalg.solve(inertia - J * np.eye(3),
                             torque + 3 * np.cross(r, inertia @ r) - np.cross(w, momentum))
    return np.concatenate([turned, -torque / J - np.cross(w, sphere), np.cross(n, w), np.cross(r, w - n)])


def spectrum(inertia, rotor, n, r):
    """Of the linearised motion; the field is quadratic, central differences of step 1 are exact."""
    at = np.concatenate([n, n, n, r])
    assert abs(rates(at, inertia, rotor)).max() < 1e-12
    return np.linalg.eigvals(np.stack([
        (rates(at + e, inertia, rotor) - rates(at - e, inertia, rotor)) / 2 for e in np.eye(12)], axis=1))


def floats(numbers):
    return np.array([float(x) for x in numbers])


def check(I, n, r, l, exactly=True):
    """As many modes grow as the library says; whether it says so, exactly: how many."""
    scene = gs.assemble(gs.Gyrostat(exact(I), exact(l)), gs.circular_orbit(1))
    point = [*(a * b for a, b in zip(I, n)), *n, *r]
    decision = gs.analyze(gs.equilibrium(scene, exact(point))).verdict({}, damped=True)
    growing = sum(x.real > 1e-8 for x in spectrum(np.diag(floats(I)), floats(l), floats(n), floats(r)))
    if decision.verdict is gs.Verdict.UNDECIDED:
        return False
    assert (decision.verdict is gs.Verdict.STABLE) == (not growing)
    assert decision.growing == growing or not exactly and decision.growing is None
    return True


@pytest.mark.parametrize("part", [0, *(pytest.param(x, marks=pytest.mark.slow) for x in range(1, 6))])
def test_as_many_modes_grow_as_k_has_negative_squares(part, full):
    """Of random satellites in any attitude."""
    rng = Random(f"sphere {part}")
    count = sampled(100, full, 8 if part == 0 else 15)
    assert sum(check(*satellite(rng)) for _ in range(count)) >= 0.9 * count


def on_a_locus(rng):
    """I_nn = I_rr and I_tn = 0: an axis along n, the moments about n and r equal."""
    across, along, l = (Fraction(rng.randint(5, 25), 10) for _ in range(3))
    axes = rng.sample(range(3), 3)
    I = [across] * 3
    I[axes[0]] = along
    t, n, r = ([Fraction(int(i == axis)) for i in range(3)] for axis in axes)
    if np.cross(floats(n), floats(r)) @ floats(t) < 0:
        r = [-x for x in r]
    return I, n, r, [rng.choice((-1, 1)) * l * x for x in n]


@pytest.mark.parametrize("part", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_where_the_damping_does_not_reach_every_motion(part, full):
    """What is decided there is right: a count of squares would say too many modes."""
    rng = Random(f"locus {part}")
    count = sampled(100, full, 8 if part == 0 else 20)
    decided = sum(check(*on_a_locus(rng), exactly=False) for _ in range(count))
    assert 0 < decided < count


def test_three_squares_and_one_mode():
    """The body (13/10, 2, 2) with l = −2 along n, theory D1."""
    moments = [Fraction(13, 10), Fraction(2), Fraction(2)]
    n, r, l = ([Fraction(x) for x in v] for v in ((0, 1, 0), (0, 0, 1), (0, -2, 0)))
    found = spectrum(np.diag(floats(moments)), floats(l), floats(n), floats(r))
    assert sum(x.real > 1e-8 for x in found) == 1
    check(moments, n, r, l, exactly=False)


def test_a_negative_square_falls_though_damping_does_not_reach_all():
    """An attitude whose I_nn = I_rr, I_tn = 0 and det K < 0, and one whose momentum vanishes.

    There the motions that are not reached have an isotropic part, and it is not said how many grow.
    """
    for I, l, growing in (((F("23/10"), F("23/10"), F("3/5")), (0, -2, 0), 1), ((1, 2, 2), (0, -3, 0), 1),
                          ((F("8/5"), F("1/2"), F("8/5")), (0, 0, F("-8/5")), None)):
        n, r = ((0, 0, 1), (1, 0, 0)) if l[2] else ((0, 1, 0), (0, 0, 1))
        scene = gs.assemble(gs.Gyrostat(exact(I), exact(l)), gs.circular_orbit(1))
        decision = gs.analyze(gs.steady_motion(scene, n, r)).verdict({}, damped=True)
        found = sum(x.real > 1e-8 for x in spectrum(np.diag(floats(I)), floats(l), floats(n), floats(r)))
        assert decision.unstable and found and decision.growing == growing
