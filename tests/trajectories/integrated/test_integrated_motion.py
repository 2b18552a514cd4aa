"""Integrated motions against Taylor series of high precision.

The error that is reported covers the error that is made.
"""
from fractions import Fraction
from math import cos, sin

import draw
import mpmath
import numpy as np
import oracle
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Rational, exp, sqrt
from trajectories.integrations import FIELD, INERTIA, KINDS, ROTOR, STATE, exact, scene

import gyrostat as gs
from gyrostat.errors import AccuracyError, ArgumentError, ValuesError
from gyrostat.trajectories.integrated import integrated_motion as integration
from gyrostat.trajectories.integrated.integrated_motion import Integration

AT_20 = (-.63263141376382492, 1.3279608395136307, -2.30416111460101, -.42019155176267731, .78822852802552266,
         -.44959409185841302)
numbers = st.fractions(min_value=-1, max_value=1, max_denominator=7)


def plain(values):
    return np.array([[float(x) for x in row] if isinstance(row, list) else float(row) for row in values])


@pytest.fixture(scope="module", params=KINDS)
def chaotic(request):
    """An asymmetric gyrostat with its rotor along no axis and its centre of mass on none."""
    return Integration(scene(INERTIA, ROTOR, FIELD), exact(STATE), method=request.param)


@pytest.mark.slow
def test_series_reproduce_the_printed_motion():
    """The oracle has the state of the chaotic gyrostat at t = 20, and of the free body at t = 32, to all 15
    to 18 digits printed.
    """
    printed = ["-.63263141376382492", "1.3279608395136307", "-2.30416111460101", "-.42019155176267731",
               ".78822852802552266",
               "-.44959409185841302"]
    with mpmath.workdps(30):
        for value, text in zip(oracle.taylor_motion(INERTIA, ROTOR, STATE, 20, FIELD, digits=20), printed):
            assert abs(value - mpmath.mpf(text)) <= mpmath.mpf(10) ** -len(text.split(".")[1])
        start, last = [mpmath.cos("1.1"), 0, mpmath.sin("1.1")], mpmath.mpf(2) / 3
        printed = [".450201146840795038", ".0783373315292274935", ".889484226882136907"]
        for value, text in zip(oracle.taylor_motion((2, 1, last), (0, 0, 0), start, 32, digits=20), printed):
            assert abs(value - mpmath.mpf(text)) <= mpmath.mpf(10) ** -len(text.split(".")[1])


@pytest.mark.slow
def test_series_reproduce_the_heavy_top():
    """Simo and Wong's fast top at t = 10, to all digits printed, with the attitude: its third row is k."""
    with mpmath.workdps(30):
        c, s = mpmath.cos("0.05"), mpmath.sin("0.05")
        R = [[1, 0, 0], [0, c, -s], [0, s, c]]
        state, attitude = oracle.taylor_motion((5, 5, 1), (0, 0, 0), (0, 0, 50, 0, s, c), 10,
                                               [(20, (0, 0, 1))], digits=22, attitude=R)
        printed = ["-.153091997209136024", ".143264870866601439", "50",
                   "-.0288715630929733331", ".0458625370775062699", ".998530450480796716"]
        for value, text in zip(state, printed):
            assert abs(value - mpmath.mpf(text)) <= mpmath.mpf(10) ** -len(text.partition(".")[2])
        assert all(abs(a - b) < mpmath.mpf(10) ** -20 for a, b in zip(attitude[2], state[3:]))


@pytest.mark.slow
def test_chaotic_motion_to_eleven_digits(chaotic):
    """At t = 20 the state is right to 10⁻¹¹, and to the error reported."""
    off = np.abs(chaotic.state(20.0) - AT_20).max()
    assert off < 1e-11 and off <= chaotic.error < 1e-10


@pytest.mark.slow
def test_attitude_follows_the_body(chaotic):
    """R is the oracle's, from the Euler angle φ = 0 on: a rotation with k in its third row."""
    theta, psi = np.arccos(0.8), np.pi / 2
    start = [[cos(psi), -sin(psi), 0], [cos(theta) * sin(psi), cos(theta) * cos(psi), -sin(theta)],
             [0.6, 0, 0.8]]
    np.testing.assert_allclose(chaotic.attitude(0.0), start, atol=1e-15)                # arccos and cos
    _, R = oracle.taylor_motion(INERTIA, ROTOR, STATE, 3, FIELD, digits=16, attitude=start)
    np.testing.assert_allclose(chaotic.attitude(3.0), plain(R), atol=1e-12)
    t = np.linspace(-5, 20, 7)
    np.testing.assert_allclose(chaotic.attitude(t)[:, 2], chaotic.state(t)[:, 3:], atol=1e-11)
    np.testing.assert_allclose(chaotic.attitude(t) @ chaotic.attitude(t).transpose(0, 2, 1), [np.eye(3)] * 7,
                               atol=1e-15)
    assert (np.linalg.det(chaotic.attitude(t)) > 0).all()


def test_times_in_any_order_and_shape(chaotic):
    """Times of any shape, order and sign, asked again, later or earlier: the same motion.

    None is asked of none.
    """
    t = np.array([[3.0, -1.0, 0.0], [-2.0, 3.0, 1.5]])
    found = chaotic.state(t)
    assert found.shape == (2, 3, 6)
    assert (found[0, 2] == [0.5, 0.3, 1.2, 0.6, 0, 0.8]).all()
    assert (found[0, 0] == found[1, 1]).all()
    for place in np.ndindex(t.shape):
        np.testing.assert_allclose(chaotic.state(t[place]), found[place], atol=1e-12)   # other steps
    assert chaotic.state(np.empty((0, 2))).shape == (0, 2, 6) and chaotic.attitude([]).shape == (0, 3, 3)
    back = oracle.taylor_motion(INERTIA, ROTOR, STATE, -2, FIELD, digits=16)
    np.testing.assert_allclose(found[1, 0], plain(back), atol=1e-12)


def test_nothing_is_integrated_twice(chaotic):
    """The same times again cost no step, later ones only those from the last time on."""
    chaotic.state([1.0, 10.0])
    steps = chaotic.nodes
    chaotic.attitude([10.0, 1.0])
    assert chaotic.nodes == steps
    chaotic.state(10.5)
    assert steps < chaotic.nodes < steps + 40


@pytest.mark.slow
@settings(max_examples=3)
@given(inertia=st.tuples(*[draw.moments] * 3), rotor=st.tuples(*[numbers] * 3),
       momentum=st.tuples(*[numbers] * 3), tilt=draw.tilts,
       terms=st.lists(st.tuples(numbers, st.tuples(*[st.integers(0, 2)] * 3).filter(any)), min_size=1,
                      max_size=3))
def test_error_covers_the_error(inertia, rotor, momentum, tilt, terms):
    """Of any body in a polynomial U(k) the state at two times is the oracle's to the error reported."""
    state = (*momentum, tilt[0], Fraction(0), tilt[1])
    built = scene(inertia, rotor, [*terms, (1, (0, 0, 1))])
    moving = Integration(built, exact(state), method="DOP853")
    found, earlier = moving.state([1.0, -2.0]), moving.error
    for t, x in zip((1, -2), found):
        theirs = plain(oracle.taylor_motion(inertia, rotor, state, t, [*terms, (1, (0, 0, 1))], digits=16))
        assert np.abs(x - theirs).max() <= earlier < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_transcendental_field(kind):
    """U = exp(1 + k3), a body of revolution with irrational numbers: the state is the oracle's."""
    built = gs.assemble(gs.Gyrostat((1, 1, sqrt(2)), (0, 0, Rational(3, 4))),
                        gs.axial_potential(lambda z: exp(1) * exp(z)))
    moving = Integration(built, exact((Fraction(1, 2), 0, 1, Fraction(3, 5), 0, Fraction(4, 5))), method=kind)
    with mpmath.workdps(20):
        theirs = oracle.taylor_motion((1, 1, mpmath.sqrt(2)), (0, 0, "0.75"), ("0.5", 0, 1, "0.6", 0, "0.8"),
                                      4,
                                      lambda z: (z + oracle.constant(mpmath.mpf(1))).exp(), 16)
    assert np.abs(moving.state(4.0) - plain(theirs)).max() <= moving.error < 1e-10


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_free_gyrostat(kind):
    """On so(3)* the momentum is the oracle's.

    The space axis z has the direction of M, which R takes to itself.
    """
    state = (Fraction(1, 2), Fraction(-1, 3), Fraction(3, 4))
    moving = Integration(scene(INERTIA, ROTOR), exact(state), method=kind)
    t = np.array([2.0, -1.0])
    found = moving.state(t)
    for time, x in zip((2, -1), found):
        assert (
            np.abs(x - plain(oracle.taylor_motion(INERTIA, ROTOR, state, time, digits=16))).max()
            <= moving.error
            < 1e-10
        )
    M = found + [0.3, -0.2, 0.5]
    np.testing.assert_allclose(np.einsum("tij,tj->ti", moving.attitude(t), M),
                               [[0, 0, np.linalg.norm(M[0])]] * 2, atol=1e-11)
    R = moving.attitude(0.0)
    assert abs(R[0, 2]) < 1e-16 and R[1, 2] < 0                                         # φ = 0
    _, theirs = oracle.taylor_motion(INERTIA, ROTOR, state, 2, digits=16, attitude=R.tolist())
    np.testing.assert_allclose(moving.attitude(2.0), plain(theirs), atol=1e-11)


@pytest.mark.parametrize("s", [1, -1])
def test_attitude_of_the_vertical_body(s):
    """Where sin θ = 0 both φ and ψ are 0 at the start; about the vertical the body then turns at its rate."""
    moving = Integration(gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, 0)), gs.axial_potential(lambda z: z)),
                         exact((0, 0, 2, 0, 0, s)),
                         method="DOP853")
    np.testing.assert_array_equal(moving.attitude(0.0), np.diag([1, s, s]))
    c, d = cos(0.7), sin(0.7)
    np.testing.assert_allclose(moving.attitude(0.7), [[c, -d, 0], [s * d, s * c, 0], [0, 0, s]], atol=1e-12)


def test_a_tolerance_that_is_not_met_is_an_error(chaotic):
    """The time and the error are named; the limit without a tolerance is 10⁻³."""
    strict = Integration(chaotic.scene, exact(STATE), 1e-15, chaotic.name)
    with pytest.raises(AccuracyError,
                       match=r"at t = (20\.0|-3\.0) the error is about .*, more than the tolerance 1e-15"):
        strict.state([20.0, -3.0])
    assert strict.state(0.0)[0] == 0.5
    if chaotic.name == "heyoka":
        with pytest.raises(AccuracyError, match="more than the tolerance 0.001"):
            chaotic.state(2000.0)


def test_what_breaks_an_integral_counts_as_an_error(chaotic, monkeypatch):
    """Both runs wrong alike: energy and Casimirs show it."""
    moving = Integration(chaotic.scene, exact(STATE), method=chaotic.name)
    monkeypatch.setattr(moving, "_followed", lambda run, times: np.tile(run.start * 1.0001, (len(times), 1)))
    moving.state([1.0])
    assert 1e-4 < moving.error < 1e-4 * np.linalg.norm(plain(exact(STATE)))


def test_methods_and_times_are_checked(chaotic, monkeypatch):
    """heyoka is the method where it is installed; another name, or a time that is none, is refused."""
    monkeypatch.setattr(integration, "find_spec", lambda name: None)
    assert Integration(chaotic.scene, exact(STATE)).name == "DOP853"
    with pytest.raises(ArgumentError, match="'RK4' is not known: use heyoka or DOP853"):
        Integration(chaotic.scene, exact(STATE), method="RK4")
    with pytest.raises(ValuesError, match="nan is not a finite time"):
        chaotic.state([0.0, np.nan])
