"""The free motion: momentum and attitude against integration, against enclosures, and at a thousand million
periods.
"""
import math
from fractions import Fraction
from itertools import permutations

import mpmath
import numpy as np
import pytest
from draw import moments, nonzero, numbers
from flint import arb, ctx
from free_reference import motion as integrated
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from slow import slow
from sympy import Rational, atan, cos, pi, sin, sqrt
from trajectories.free_motions import REST, SADDLE, distance, free, middles

import gyrostat as gs
from gyrostat.errors import AccuracyError, ScopeError, ValuesError
from gyrostat.mechanics.classical.free_body import polhode_period
from gyrostat.trajectories.free.free_motion import FreeMotion

rotors = st.tuples(numbers, numbers, numbers)


def test_published_free_body():
    """I = (2, 1, 2/3), M = (cos 1.1, 0, sin 1.1): M(32) and the period, every digit printed."""
    printed = (".450201146840795038", ".0783373315292274935", ".889484226882136907")
    motion = free((2, 1, Rational(2, 3)), (cos(Rational(11, 10)), 0, sin(Rational(11, 10))))
    assert distance(motion.state(32.0), printed) < 1e-15
    assert abs(motion.period - 10.7314652348828038) < 4e-15
    with ctx.workprec(160):
        for ours, value in zip(motion.ball_state(arb(32), 100), printed):
            assert ours.rad() < arb("1e-30") and abs(ours - arb(value)) < arb(6) * arb(10) ** -len(value)


def test_published_flips():
    """I = (3, 5, 9), M = (0, 2, .01): M2 vanishes after 29.5277217615964, flips every 59.0554435231929."""
    motion = free((3, 5, 9), (0, 2, Rational(1, 100)))
    assert abs(motion.period / 4 - 29.5277217615964) < 1e-13
    assert abs(motion.period / 2 - 59.0554435231929) < 1e-13
    quarters = motion.state(motion.period / 4 * np.arange(5))
    # slow there: half the digits of the time are enough
    assert np.abs(quarters[:, 1] - [2, 0, -2, 0, 2]).max() < 1e-12


@pytest.mark.few(1)
@pytest.mark.parametrize("M", [
    (Fraction(3, 10), Fraction(-1, 5), Fraction(9, 10)), (Fraction(-1, 2), 0, Fraction(-1, 3)),
    *slow(((Fraction(-9, 10), Fraction(1, 5), Fraction(3, 10)),), ((0, 1, Fraction(-1, 2)),), ((1, -1, 0),))])
@pytest.mark.parametrize("inertia", list(permutations((1, 2, 3))))
def test_every_order_of_the_moments_and_every_sign(inertia, M):
    """M of a free body against integration, either way in time."""
    motion = free(inertia, M)
    for t in (3, -5):
        assert (
            distance(motion.state(float(t)), integrated(inertia, REST, M, t, 20, order=25, bits=128)[0])
            < 2e-15
        )
    assert motion.period == pytest.approx(float(polhode_period(inertia, M)), rel=1e-14)


@pytest.mark.slow
@given(a=moments, b=moments, c=moments, rotor=rotors, M=st.tuples(nonzero, numbers, numbers), t=numbers)
@settings(max_examples=3)
def test_momentum_and_attitude_are_those_of_integration(a, b, c, rotor, M, t):
    """Any body, any rotor: M, and the vector fixed in space along the first body axis of the time 0, after a
    time t.
    """
    assume(max(abs(x) for x in (*rotor, *M)) * abs(t) < 20 * min(a, b, c) and t)
    motion = free((a, b, c), M, rotor)
    reference, seen = integrated((a, b, c), rotor, M, t, 100, [(1, 0, 0)], bits=128)
    start, end = motion.attitude(np.array([0.0, float(t)]))
    assert distance(motion.state(float(t)) + np.array(rotor, float), reference) < 1e-13
    assert np.abs(start[:, 0] - end @ np.array(seen, float)).max() < 1e-13


@pytest.mark.few(3)
@pytest.mark.parametrize(("inertia", "M", "rotor"), [
    ((2, 2, 1), (1, 2, 3), (0, 0, 1)), ((2, 1, 2), (1, 2, 3), (0, -1, 0)), ((1, 2, 2), (1, 2, -3), REST),
    ((2, 2, 2), (1, 2, 3), (3, 0, -1)), ((1, 2, 3), (0, -2, 0), REST),
    ((1, 2, 3), (1, 2, 3), (0, -2, -6)), ((1, 2, 3), (0, 0, 0), (1, -1, 2)), ((1, 2, 3), (0, 0, 0), REST),
    ((1, 1, 2), (sin(1), 0, cos(1)), REST), ((3, 1, 2), (3, 0, 1), REST), (SADDLE[0], SADDLE[2], SADDLE[1]),
    *slow(((1, 2, 3), (1, 0, sqrt(3)), REST), ((2, 2, 1), (1, 2, 3), (1, 0, 0)))])
def test_attitude_is_a_rotation_about_M(inertia, M, rotor):
    """R Rᵀ = 1, R M = abs(M) e_z, Ṙ = R hat(ω), φ = 0 at the time 0, for every kind of motion and far from
    the start.
    """
    motion = free(inertia, M, rotor)
    step, t = 2.0**-12, np.array([0.0, 0.7, -3.3, 1e3, -1e6])
    R = motion.attitude(t)
    pi = motion.state(t)
    assert np.abs(R @ R.transpose(0, 2, 1) - np.eye(3)).max() < 2e-15 and np.linalg.det(R) == pytest.approx(1)
    l, size = np.array([float(x) for x in rotor]), math.sqrt(sum(float(m) ** 2 for m in M))
    assert np.abs(np.einsum("nij,nj->ni", R, pi + l) - [0, 0, size]).max() < 4e-15 * max(size, 1)
    change = sum(w * motion.attitude(t + n * step) for n, w in ((1, 4 / 3), (-1, -4 / 3), (2, -1 / 6),
                                                                (-2, 1 / 6))) / (2 * step)
    hats = R.transpose(0, 2, 1) @ change
    omega = pi / np.array([float(x) for x in inertia])
    speed = np.abs(omega).max() + 1
    # remainder of the difference
    assert np.abs(hats[:, [2, 0, 1], [1, 2, 0]] - omega).max() < 1e-11 + 50 * (step * speed) ** 4 * speed
    assert abs(R[0, 0, 2]) < 1e-15 and R[0, 1, 2] <= 0


@pytest.mark.parametrize(("inertia", "M", "rotor"), [
    ((1, 2, 3), (1, 2, 2), REST), ((1, 1, 3), (1, 2, 2), (0, 0, 1)),
    *slow(((1, 2, 3), (Fraction(1, 10**6), 2, Fraction(1, 10**6)), REST),
          ((1, 2, 3), (1, 2, 2), (1, 0, -1)))])
def test_nothing_grows_with_the_number_of_periods(inertia, M, rotor):
    """After 10⁹ periods energy and abs(M)² are kept to rounding, M is within 10⁻¹⁴ of its enclosure, R has
    gained the precession.
    """
    motion = free(inertia, M, rotor)
    l, I = np.array(rotor, float), np.array(inertia, float)
    t = motion.period * 1e9 + np.array([0.0, 0.1, 2.3, -7.7])
    pi = motion.state(t)
    assert np.ptp([*((pi + l) ** 2).sum(1), float(sum(m * m for m in M))]) < 1e-14 * sum(m * m for m in M)
    assert np.ptp([*(pi**2 / I).sum(1), *(motion.state(np.zeros(1)) ** 2 / I).sum(1)]) < 2e-14
    for x, y in zip(pi, t):
        assert distance(x, middles(motion.ball_state(arb(y), 60))) < 1e-14
    early, late = motion.attitude(np.array([0.3, motion.period + 0.3]))
    gained, c, s = late @ early.T, math.cos(motion.precession), math.sin(motion.precession)
    assert np.abs(gained - [[c, -s, 0], [s, c, 0], [0, 0, 1]]).max() < 1e-14 * (8 + motion.precession)


def test_attitude_after_a_thousand_million_periods():
    """R gains the angle of one integrated period, 10⁹ times.

    A vector across M, fixed in space, shows it to 40 digits.
    """
    inertia, M, across, n = (1, 2, 3), (1, 2, 2), (0, 1, -1), 10**9
    motion = free(inertia, M)
    with mpmath.workdps(50):
        period = polhode_period(inertia, M, 45)
        v = integrated(inertia, REST, M, Fraction(str(period)), 60, [across], order=40)[1]
        normal = (Fraction(-4, 3), Fraction(1, 3), Fraction(1, 3))         # M/|M| × across
        cosine, sine = (sum(x * y for x, y in zip(v, w)) for w in (across, normal))
        gained = n * mpmath.atan2(*(mpmath.mpf(x.numerator) / x.denominator for x in (-sine, cosine)))
        c, s = float(mpmath.cos(gained)), float(mpmath.sin(gained))
    t = motion.period * n + 0.3
    rest = float(Fraction(t) - n * Fraction(str(period)))
    assert (
        np.abs(
            motion.attitude(t) - np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ motion.attitude(rest)
        ).max()
        < 1e-14
    )


def test_precession_counts_whole_turns():
    """φ of axis 3, followed along a period, gains the precession.

    For a body of revolution it is abs(M)/I1 times the period.
    """
    for motion in (free((1, 2, 3), (Fraction(3, 10), Fraction(1, 5), Fraction(9, 10))),
                   free((1, 2, 3), (1, 2, 3), (1, 0, -1)),
                   free((2, 2, 3), (1, 2, 2))):
        axis = motion.attitude(np.linspace(0, motion.period, 4001))[:, :, 2]
        phi = np.unwrap(np.arctan2(axis[:, 0], -axis[:, 1]))
        assert motion.precession == pytest.approx(phi[-1] - phi[0], rel=1e-13)
    assert motion.precession == pytest.approx(3 / 2 * motion.period, rel=1e-14)
    assert free((1, 2, 3), (0, 0, 6)).precession == 2                      # a permanent rotation: its rate


def test_nearly_equal_moments_turn_as_slowly_as_they_should():
    """I = (1, 1 + ε, 1 + 2 ε): the momentum takes a time of order 1/ε, in few steps.

    R agrees with a sphere's at once.
    """
    e = Fraction(1, 10**10)
    motion = free((1, 1 + e, 1 + 2 * e), (1, 2, 2))
    assert 1e10 < motion.period < 1e11 and motion.rotation.nodes < 100
    sphere = free((1, 1, 1), (1, 2, 2))
    assert np.abs(motion.attitude(1.0) - sphere.attitude(1.0)).max() < 1e-9


@pytest.mark.parametrize("rotor", [(1, 0, 0), (Fraction(1, 100), Fraction(-1, 7), Fraction(3, 5)),
                                   (0, 0, 40)])
def test_a_turn_in_doubles_lacks_nothing(rotor):
    """What the polynomials in doubles leave of each step is below their rounding, also of the first steps."""
    for M in ((1, 2, 3), (Fraction(1, 1000), 5, 0), (0, Fraction(1, 50), -60)):
        turn = free((1, 2, 3), M, rotor).path.loops(3)[0]
        assert 0 < turn.cut < 2.0**-56


def test_shapes():
    """Times of any shape, also none."""
    motion = free((1, 2, 3), (1, 2, 3), (1, 0, 0))
    t = np.linspace(-3, 40, 12).reshape(3, 4)
    assert motion.state(t).shape == (3, 4, 3) and motion.attitude(t).shape == (3, 4, 3, 3)
    assert motion.state(2.5).shape == (3,) and motion.state(np.zeros((0, 2))).shape == (0, 2, 3)
    assert (motion.state(t)[1, 2] == motion.state(t[1, 2])).all()
    many = np.linspace(0, 10, 20001) ** 2                  # more than a block
    assert (motion.state(many)[[5, 17000]] == motion.state(many[[5, 17000]])).all()


@pytest.mark.slow
def test_free_motion_refuses():
    """A potential, names, undecided motions, motions too close to a separatrix, and what is no state."""
    body = gs.Gyrostat((1, 2, 3), (1, 0, 0))
    # cos 1, by Machin
    hidden = cos(1) + 4 * atan(Rational(1, 5)) - atan(Rational(1, 239)) - pi / 4
    for scene, state, error, why in (
            (gs.assemble(body, gs.uniform_field()), (1, 2, 3), ScopeError, "in no field"),
            (gs.assemble(gs.symmetric_gyrostat()), (1, 2, 3), ValuesError, "I1, I3, l"),
            (gs.assemble(body), (1, 2), ValuesError, "2 components"),
            (gs.assemble(body), (1, 2, "x"), ValuesError, "contains the names"),
            (body, (1, 2, 3), TypeError, "not a System"),
            (gs.assemble(gs.Gyrostat((1, 2, 3), REST)), (hidden, 0, sqrt(3) * cos(1)), ValuesError,
             "undecided")):
        with pytest.raises(error, match=why):
            FreeMotion(scene, state)
    with pytest.raises(AccuracyError, match="separatrix"):
        free((1, 2, 3), (1, 0, sqrt(3) + Rational(1, 10**400))).state(0.0)
    with pytest.raises(AccuracyError, match="separatrix"):
        free(SADDLE[0], (-3 + Rational(1, 10**400), -2, -1), SADDLE[1]).state(0.0)
