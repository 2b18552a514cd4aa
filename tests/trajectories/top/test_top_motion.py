"""A body of revolution in U(k3): the state at any time against Taylor series."""
import draw
import mpmath
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import Rational, cos, sin
from trajectories.tops import BODY, CASES, MANY, MOTIONS, F, about, moving, number, off, theirs

some = settings(max_examples=4)
small = st.fractions(min_value=-2, max_value=2, max_denominator=4)


@pytest.mark.few(3)
@pytest.mark.parametrize("name", CASES)
def test_state_is_that_of_taylor_series(name):
    """The state at a time to 10⁻¹⁴ of its size; at the time 0 it is the state given."""
    inertia, l, U, state, t, route = MOTIONS[name]
    found = moving(inertia, l, U, state)
    assert found.route == route
    assert off(found(float(F(t))), theirs(inertia, l, U, state, t)) < 1e-14
    assert off(found(0.0), [number(x) for x in state]) < 1e-14             # a few roundings
    # relative to terms that may be small
    assert max(found.drift(np.linspace(-20, 20, 40)).values()) < 4e-14


@pytest.mark.slow
@some
@given(I1=draw.moments, I3=draw.moments, l=small, U=st.lists(small, min_size=1, max_size=5).filter(any),
       p=st.tuples(small, small, small),
       tilt=draw.tilts, turn=draw.tilts, t=small)
def test_any_body_anywhere(I1, I3, l, U, p, tilt, turn, t):
    """Moments, rotor, polynomial field and state of any size.

    The state is the oracle's, with time and angles counted as errors.
    """
    state = (*p, tilt[0] * turn[0], tilt[0] * turn[1], tilt[1])
    found, speed = moving((I1, I3), l, U, state), (abs(l) + 3 + sum(map(abs, U))) / min(I1, I3)
    assume(speed * abs(t) < 100)
    assert off(found(float(t)), theirs((I1, I3), l, U, state, t)) < 1e-14 * float(1 + speed * abs(t))


@pytest.mark.few(1)
@pytest.mark.parametrize("name", MANY)
def test_many_digits(name):
    """With precision=30 the state has 28 digits of the oracle's."""
    inertia, l, U, state, _, _ = MOTIONS[name]
    found = moving(inertia, l, U, state, precision=30)(F(1, 4))
    with mpmath.workdps(40):
        for ours, value in zip(found, theirs(inertia, l, U, state, F(1, 4), 29)):
            assert abs(ours - value) < 1e-28


@pytest.mark.parametrize("name", ["at the lower turning point", "from the lower pole, pair",
                                  "from the upper pole", "at rest",
                                  "at a turning point in exp"])
def test_a_start_at_a_turning_point_has_its_digits(name):
    """With precision the state at the time 0 is the one given."""
    inertia, l, U, state, _, _ = MOTIONS[name]
    with mpmath.workdps(40):
        for ours, given in zip(moving(inertia, l, U, state, precision=30)(0), state):
            assert abs(ours - mpmath.mpf(F(given).numerator) / F(given).denominator) < 1e-29


@pytest.mark.few(1)
@pytest.mark.parametrize("name", [
    "degree 1", "degree 4", "at the lower turning point of degree 6", "from the upper pole, pair",
    "swinging", "swinging across k1",
    "over the top from above", "over the top in degree 3", "P = 0, out of the plane",
    "large cancelling momenta", "k of length 5",
    "k of length 5 from its pole", "near the lower pole", "two wells, the upper"])
def test_the_error_is_covered(name):
    """The error reported is no less than the difference to 25 digits, and a few hundred roundings of the
    angles in a period.
    """
    inertia, l, U, state, _, _ = MOTIONS[name]
    found, t = moving(inertia, l, U, state), [F(0), F(3, 8), F(-265, 8), F(10**7)]
    values = moving(inertia, l, U, state, precision=25)(t).astype(float)
    assert (
        np.abs(found([float(x) for x in t]) - values).max()
        <= found.error
        < 1e-13 * max(1, np.abs(values).max()) * (1 + abs(found.spin))
    )


SIMO = (("5", "1"), "0", ("20",), (0, 0, 50, 0, sin(Rational(1, 20)), cos(Rational(1, 20))))


def test_published_heavy_top():
    """Simo & Wong's fast top at t = 10, in doubles to 10⁻¹³, with precision=30 to every digit printed."""
    printed = ["-.153091997209136024", ".143264870866601439", "50", "-.0288715630929733331",
               ".0458625370775062699", ".998530450480796716"]
    assert np.abs(moving(*SIMO)(10.0) - [float(x) for x in printed]).max() < 1e-13
    with mpmath.workdps(40):
        for ours, text in zip(moving(*SIMO, precision=30)(10), printed):
            assert abs(ours - mpmath.mpf(text)) < mpmath.mpf("0.51") * mpmath.mpf(10) ** -len(
                text.partition(".")[2]
            )


@some
@given(turn=draw.tilts, t=small)
def test_turning_the_body_frame(turn, t):
    """The state turned about axis 3 by any angle moves as before, turned."""
    inertia, l, U, state, _, _ = MOTIONS["degree 3"]
    s, c = turn
    p1, p2, p3, k1, k2, k3 = map(F, state)
    turned = moving(inertia, l, U, (c * p1 - s * p2, s * p1 + c * p2, p3, c * k1 - s * k2, s * k1 + c * k2,
                                    k3))(float(t))
    x, R = moving(inertia, l, U, state)(float(t)), about(np.arctan2(float(s), float(c)))
    np.testing.assert_allclose(turned, [*(R @ x[:3]), *(R @ x[3:])], atol=1e-14)


@pytest.mark.slow
@some
@given(l=small, U=st.lists(small, min_size=1, max_size=4).filter(any), p=st.tuples(small, small, small),
       tilt=draw.tilts, t=small)
def test_reversed_and_upside_down(l, U, p, tilt, t):
    """(−π, k, −l) runs backwards; (π1, −π2, −π3, k1, −k2, −k3) in U(−k3) with −l is the mirror image."""
    s, c = tilt
    x = moving(BODY, l, U, (*p, s, 0, c))(float(t))
    back = moving(BODY, -l, U, (-p[0], -p[1], -p[2], s, 0, c))(-float(t))
    np.testing.assert_allclose(back, x * [-1, -1, -1, 1, 1, 1], atol=2e-13)
    mirrored = moving(BODY, -l, [(-1) ** n * u for n, u in enumerate(U, 1)],
                      (p[0], -p[1], -p[2], s, 0, -c))(float(t))
    np.testing.assert_allclose(mirrored, x * [1, -1, -1, 1, -1, -1], atol=2e-13)
