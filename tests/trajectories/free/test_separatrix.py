"""The free motion near the separatrix and on it."""
import math
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx
from free_reference import motion as integrated
from slow import slow
from sympy import sqrt
from trajectories.free_motions import REST, SADDLE, distance, free, middles


@pytest.mark.slow
@pytest.mark.parametrize("d", ["1/100", *slow(("1/10000",), (1e-6,), (1e-7,))])
def test_momentum_near_the_separatrix_is_that_of_integration(d):
    """I = (1, 2, 3), M = (d/2, 2, 2 d), t = 400, ten flips: error below 10⁻¹³.

    The enclosures contain the integrated value.
    """
    d = Fraction(d)
    reference = integrated((1, 2, 3), REST, (d / 2, 2, 2 * d), 400, 800, order=30, bits=192)[0]
    motion = free((1, 2, 3), (d / 2, 2, 2 * d))
    assert motion.name == "free body" and motion.nodes == 0
    assert distance(motion.state(400.0), reference) < 1e-14 < motion.error < 1e-13
    with ctx.workprec(300):
        for ours, theirs in zip(motion.ball_state(arb(400), 60), reference):
            assert abs(ours - arb(theirs.numerator) / theirs.denominator) < arb("1e-17")


@pytest.mark.slow
@pytest.mark.parametrize("gap", ["-1e-10", *slow(("1e-3",), ("1e-30",))])
def test_gyrostat_near_a_separatrix(gap):
    """Next to a homoclinic motion the turn closes, on both sides, and doubles agree with enclosures to 10⁻¹⁴;
    the period is finite.
    """
    inertia, rotor, M = SADDLE
    motion = free(inertia, (M[0] + Fraction(gap), M[1], M[2]), rotor)
    assert motion.name == "free gyrostat" and motion.nodes > 0 and motion.error < 1e-11
    for t in (0.5, 3.0, motion.period * 1e9 + 1.5):
        assert distance(motion.state(t), middles(motion.ball_state(arb(t), 60))) < 1e-14


@pytest.mark.slow
def test_gyrostat_on_a_separatrix():
    """It comes from the permanent rotation and returns to it, in infinite time.

    Then R turns about M at the rate of that rotation.
    """
    inertia, rotor, M = SADDLE
    motion = free(inertia, M, rotor)
    assert motion.period is None and motion.precession is None
    far = motion.state(np.array([-1e9, -40.0, 40.0, 1e9])) + np.array(rotor, float)
    assert np.abs(far - [1, 2, 3]).max() < 1e-15
    for t in (Fraction(1, 2), Fraction(-1, 2)):
        reference, seen = integrated(inertia, rotor, M, t, 80, [(1, 0, 0)])
        assert distance(motion.state(float(t)) + np.array(rotor, float), reference) < 4e-15
        assert (
            np.abs(motion.attitude(0.0)[:, 0] - motion.attitude(float(t)) @ np.array(seen, float)).max()
            < 2e-15
        )
        assert distance(motion.state(float(t)), middles(motion.ball_state(arb(float(t)), 60))) < 2e-15
    for end in (side.length * sign for side, sign in zip(motion.rotation.loops(6), (1, -1))):
        # it turns by 4 · 10⁻⁸ · |M|
        assert np.abs(motion.attitude(end * (1 + 1e-9)) - motion.attitude(end * (1 - 1e-9))).max() < 1e-6
    for t in (30.0, -30.0):
        turned = motion.attitude(t + 0.25) @ motion.attitude(t).T
        assert math.atan2(turned[1, 0], turned[0, 0]) == pytest.approx(
            math.remainder(4 * math.sqrt(14) * 0.25, 2 * math.pi), abs=1e-14
        )


def test_free_body_on_the_separatrix():
    """M2 = √(2 E I2) tanh: exact irrational momenta, both ends, either branch."""
    for signs in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        M = (signs[0], 0, signs[1] * sqrt(3))
        motion = free((1, 2, 3), M)
        rate = 2 * math.sqrt((1 - 1 / 2) * (1 / 2 - 1 / 3))
        t = np.array([-1e6, -2.0, 0.0, 1.0, 1e6])
        branch = signs[0] * signs[1] * np.tanh(rate * t)
        sech = 1 / np.cosh(np.minimum(abs(rate * t), 700))
        expected = np.stack([signs[0] * sech, 2 * branch, signs[1] * math.sqrt(3) * sech], axis=1)
        assert motion.period is None and np.abs(motion.state(t) - expected).max() < 2e-15
    assert distance(motion.state(1.0), middles(motion.ball_state(arb(1), 80))) < 1e-15
    # a mirror
    assert (
        distance(
            free((3, 2, 1), (sqrt(3), 0, 1)).state(1.0)[::-1], free((1, 2, 3), (1, 0, sqrt(3))).state(-1.0)
        )
        < 1e-15
    )
