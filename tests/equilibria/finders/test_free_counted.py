"""Every permanent rotation of a free gyrostat, against counting, Newton's method and spectra."""
import random
from fractions import Fraction as F

import counted_rotations as found
import mpmath as mp
import numpy as np
import pytest
from slow import sampled
from sympy import Rational

import gyrostat as gs

SLOW = pytest.mark.slow


def drawn(rnd):
    """Distinct moments, a rotor and a length, of three digits; the rotor of any size beside M."""
    moments = [F(n, 100) for n in rnd.sample(range(50, 400), 3)]
    rotor = [F(rnd.choice([-1, 1]) * rnd.randint(1, 100), 100) for _ in range(3)]
    return moments, rotor, F(rnd.randint(10, 300), 100)


def exact(vector):
    return [Rational(x.numerator, x.denominator) for x in vector]


def rotations(moments, rotor, size):
    scene = gs.assemble(gs.Gyrostat(exact(moments), exact(rotor)))
    return gs.relative_equilibria(scene, {"M": size})


def is_held(moments, rotor, size, rotation):
    """Whether it is on the sphere, ω ∥ M, and its spectrum says what was decided; True where it is silent."""
    with mp.workdps(50):
        M = [mp.mpf(str(m.evalf(55))) for m in rotation.momentum]
        rate = mp.matrix([(m - mp.mpf(l.numerator) / l.denominator) * i.denominator / i.numerator
                          for m, l, i in zip(M, rotor, moments)])
        assert abs(mp.norm(M) - mp.mpf(size.numerator) / size.denominator) < mp.mpf(10)**-45
        assert mp.norm(found.hat(M) * rate) < mp.mpf(10)**-45
        grows = found.growth(moments, rotor, M)
    return (rotation.decision.verdict is gs.Verdict.UNSTABLE) == (grows > mp.mpf(10)**-15)


@pytest.mark.slow
@pytest.mark.parametrize("cases", [10, pytest.param(10_000, marks=SLOW)])
def test_random_gyrostats(cases, full):
    """As many as Sturm's theorem counts, where Newton's method finds them, each decided as its spectrum says.
    """
    rnd, numbers = random.Random(f"all {cases}"), set()
    for _ in range(sampled(cases, full, 80)):
        moments, rotor, size = drawn(rnd)
        ours = rotations(moments, rotor, size)
        assert (len(ours), 0) == found.count(moments, rotor, size)
        assert all(is_held(moments, rotor, size, rotation) for rotation in ours)
        M = np.array([[float(m) for m in rotation.momentum] for rotation in ours])
        for other in found.newton(moments, rotor, size, rnd):
            assert np.abs(M - other).max(axis=1).min() < 1e-6
        numbers.add(len(ours))
    assert numbers == {2, 4, 6}


def degenerate(rnd, kind):
    moments, rotor, size = drawn(rnd)
    if kind == "on an axis or in a plane":
        for n in rnd.sample(range(3), rnd.randint(1, 3)):
            rotor[n] = F(0)
    if kind == "two equal moments":
        first, second = rnd.sample(range(3), 2)
        moments[first] = moments[second]
        for n in rnd.choice([(), (first,), (first, second), range(3)]):
            rotor[n] = F(0)
    return moments, rotor, size


@pytest.mark.slow
@pytest.mark.parametrize("cases", [6, pytest.param(500, marks=SLOW)])
@pytest.mark.parametrize("kind", ["on an axis or in a plane", "two equal moments"])
def test_degenerate_gyrostats(kind, cases, full):
    """Points and circles as counted; points as their spectra say, circles drift."""
    rnd = random.Random(f"{kind} {cases}")
    for _ in range(sampled(cases, full, 60)):
        moments, rotor, size = degenerate(rnd, kind)
        ours = rotations(moments, rotor, size)
        circles = [rotation for rotation in ours if rotation.locus]
        assert (len(ours) - len(circles), len(circles)) == found.count(moments, rotor, size)
        assert all(is_held(moments, rotor, size, rotation) for rotation in ours if not rotation.locus)
        assert all(rotation.decision.stable and rotation.decision.modulo for rotation in circles)
        assert all(rotation.itself.unstable for rotation in circles)
        assert all(is_held(moments, rotor, size, rotation) for rotation in circles)


@pytest.mark.parametrize("cases", [3, pytest.param(500, marks=SLOW)])
def test_three_equal_moments_and_no_momentum(cases):
    """M ∥ l, both stable; M = 0 is one point."""
    rnd = random.Random(f"equal {cases}")
    for _ in range(cases):
        moments, rotor, size = drawn(rnd)
        (rest,) = rotations(moments, rotor, F(0))
        assert rest.momentum == (0, 0, 0) and rest.decision.verdict is gs.Verdict.STABLE
        moments = [moments[0]] * 3
        ours = rotations(moments, rotor, size)
        assert len(ours) == 2 and {rotation.decision.verdict.name for rotation in ours} == {"STABLE"}
        l = np.array([float(x) for x in rotor])
        for rotation, side in zip(ours, (1, -1)):
            M = np.array([float(m) for m in rotation.momentum])
            np.testing.assert_allclose(M, side * float(size) * l / np.linalg.norm(l), rtol=1e-12)
