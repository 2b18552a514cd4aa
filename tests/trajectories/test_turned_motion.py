"""Exact motions of bodies of revolution that are not entered in the standard way, against Taylor series and
the standard scene.
"""
import random
from fractions import Fraction as F

import mpmath
import numpy as np
import oracle
import pytest
from sympy import Poly, Rational, cos, exp, sin, sqrt
from turns import OBLIQUE, TURNS, K, rational, scene, turned

import gyrostat as gs
from gyrostat.cli.parser import main
from gyrostat.trajectories import motion

START = tuple(map(rational, (F(3, 10), F(-1, 5), F(3, 2), F(3, 5), F(0), F(4, 5))))
k1, k2, k3 = K


def terms(U):
    """Of a polynomial in k, as the oracle takes it."""
    return [(mpmath.mpf(str(c.evalf(40))), powers) for powers, c in Poly(U, *K).terms()]


def followed(moving, t, digits=20):
    """The state and the attitude by the oracle, from those at the time 0."""
    with mpmath.workdps(40):
        numbers = [[mpmath.mpf(str(x.evalf(40))) for x in v]
                   for v in (moving.scene.body.inertia, moving.scene.body.gyrostatic_momentum)]
        state = [mpmath.mpf(str(x.evalf(40))) for x in moving.state]
        return oracle.taylor_motion(*numbers, state, t, terms(moving.scene.potential.expression), digits)


def fresh(name, degree=3):
    draw = random.Random(f"15 {name}")
    c = [F(draw.randint(-4, 4), 3) for _ in range(degree - 1)] + [F(1)]
    return scene(name, 2, 2 if name in OBLIQUE else 1, F(1, 3), c, (1, -2, F(1, 2)))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["axis 2", "(1, 1, 1)"])
def test_exact_motion_about_another_axis_is_that_of_the_taylor_series(name):
    """Of degree 3 with (abs(k)² − 1) a·k on top.

    The route is exact, and the state is that of Euler and Poisson's equations.
    """
    moving = motion(fresh(name), START)
    assert moving.route == "quadrature" and name in moving.recognised and moving.period
    for t in (-2, 5):
        # a few ulp
        np.testing.assert_allclose(moving(t), [float(x) for x in followed(moving, t)], rtol=0, atol=2e-14)
    np.testing.assert_allclose(moving.axis, [float(x) for x in TURNS[name].row(2)], atol=1e-16)


@pytest.mark.slow
@pytest.mark.parametrize("name", TURNS)
@pytest.mark.parametrize("degree", [1, 2, 4])
def test_exact_motions_about_every_axis(name, degree):
    """State and 25 digits against Taylor series, the attitude, the invariants at late times, and the standard
    motion turned.
    """
    this = fresh(name, degree)
    moving, digits = motion(this, START), motion(this, START, precision=25)
    for t in (-3, 7):
        theirs = followed(moving, t, 30)
        # a few units of the last place
        np.testing.assert_allclose(moving(t), [float(x) for x in theirs], rtol=0, atol=5e-14)
        assert max(abs(x - y) for x, y in zip(digits(t), theirs)) < 1e-23
    times = np.linspace(-50, 1e6, 300)
    assert max(moving.drift(times).values()) < 3e-14
    R = moving.attitude(times)
    np.testing.assert_allclose(R @ R.transpose(0, 2, 1), np.broadcast_to(np.eye(3), R.shape), atol=1e-13)
    np.testing.assert_allclose(R[:, 2], moving(times)[:, 3:], atol=1e-13)
    near, step = np.array([-3.0, 0.0, 7.0]), 1e-4           # R' = R hat(ω), differenced: h²
    x, rate = moving(near), (moving.attitude(near + step) - moving.attitude(near - step)) / (2 * step)
    omega = x[:, :3] / [float(m) for m in this.body.inertia]
    np.testing.assert_allclose(rate,
                               np.stack([np.cross(row, w) for row, w in zip(moving.attitude(near), omega)]),
                               atol=1e-6)
    assert moving.angles(0.0)[0] == pytest.approx(0, abs=1e-15)
    assert (
        moving.limits[0] - 1e-14
        <= (moving(times)[:, 3:] @ moving.axis).min()
        <= (moving(times)[:, 3:] @ moving.axis).max()
    )


def test_standard_motion_turned():
    """Axis 1: the same period, gains and limits as entered in the standard way, and the same state with its
    axes in another order.
    """
    field = lambda z: z**3 - z  # noqa: E731
    mine = motion(gs.assemble(gs.Gyrostat((1, 2, 2), (Rational(1, 3), 0, 0)),
                              gs.general_potential(field(k1))), turned("axis 1", START))
    theirs = motion(gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, Rational(1, 3))), gs.axial_potential(field)),
                    START)
    assert (mine.period, mine.precession, mine.spin, mine.limits) == (
        theirs.period,
        theirs.precession,
        theirs.spin,
        theirs.limits,
    )
    times = np.linspace(-5, 1e5, 50)
    assert np.array_equal(mine(times), theirs(times)[:, [2, 0, 1, 5, 3, 4]])
    assert mine.invariants["F1"] == theirs.invariants["F1"]


@pytest.mark.slow
def test_length_of_k_is_that_of_the_state():
    """U = −(k2² + k3²)/2 is U(k1) on the sphere of k, whatever its radius.

    (abs(k)² − 1) k2 is not, but where abs(k) = 1.
    """
    long = (*START[:3], Rational(9, 10), 0, Rational(4, 5))
    moving = motion(gs.assemble(gs.Gyrostat((3, 1, 1), (0, 0, 0)),
                                gs.general_potential(-(k2**2 + k3**2) / 2)), long)
    assert moving.route == "elliptic"
    # a few ulp
    np.testing.assert_allclose(moving(4.0), [float(x) for x in followed(moving, 4)], rtol=0, atol=2e-14)
    other = gs.assemble(gs.Gyrostat((3, 1, 1), (0, 0, 0)),
                        gs.general_potential(k1 + (k1**2 + k2**2 + k3**2 - 1) * k2))
    assert motion(other, START).route == "elliptic" and motion(other, long).route in ("heyoka", "DOP853")


@pytest.mark.slow
def test_special_motions_about_another_axis():
    """At rest, steady, through the pole, from transcendental numbers.

    Each has a model, and φ = 0 at the start.
    """
    top = gs.assemble(gs.Gyrostat((3, 1, 1), (0, 0, 0)), gs.general_potential(k1))
    assert motion(top, (1, 0, 0, 1, 0, 0)).route == "equilibrium"
    assert motion(top, (1, Rational(1, 3), 0, 1, 0, 0)).route == "elliptic"
    sphere = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), gs.general_potential((k1 + k2 + k3) / sqrt(3)))
    moving = motion(sphere, (1, 0, 0, cos(Rational(11, 10)), 0, sin(Rational(11, 10))))
    assert moving.route == "elliptic" and moving.angles(0.0)[0] == pytest.approx(0, abs=1e-15)
    # a few ulp
    np.testing.assert_allclose(moving(3.0), [float(x) for x in followed(moving, 3)], rtol=0, atol=2e-14)


@pytest.mark.slow
@pytest.mark.parametrize(("inertia", "rotor", "U"), [((1, 1, 3), (0, 0, 0), k1), ((2, 2, 2), (1, 0, 0), k2),
                                                     ((2, 2, 2), (0, 0, 0), k1 + k2**2 / 100),
                                                     ((1, 2, 3), (0, 0, 0), k3)])
def test_what_is_not_of_revolution_is_integrated(inertia, rotor, U):
    """As before."""
    moving = motion(gs.assemble(gs.Gyrostat(inertia, rotor), gs.general_potential(U)), START)
    assert moving.route in ("heyoka", "DOP853") and moving.recognised == "" and list(moving.axis) == [0, 0, 1]


def test_the_command_line_says_what_was_recognised(capsys):
    """gyrostat motion --potential k1 with I1 = 3, I2 = I3 = 1."""
    assert main(["motion", "--potential", "k1", "--set", "I1=3", "--set", "I2=1", "--set", "I3=1", "--set",
                 "l1=0", "--set", "l2=0",
                 "--set", "l3=0", "--state", "1,0,1/2,3/5,0,4/5", "--until", "2", "--count", "3"]) == 0
    assert "recognised as a body of revolution about axis 1" in capsys.readouterr().err


def test_transcendental_field_about_an_oblique_axis():
    """U = exp(k·c): a spectral quadrature, whose integrals stay."""
    this = gs.assemble(gs.Gyrostat((1, 1, 1), (1, 2, 2)),
                       gs.general_potential(exp((k1 + 2 * k2 + 2 * k3) / 3)))
    moving = motion(this, START)
    assert moving.route == "quadrature" and max(moving.drift(np.linspace(0, 1e6, 50)).values()) < 3e-14
