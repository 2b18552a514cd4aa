"""The motion of any scene: arguments, shapes, integrals, precision, datasets."""
from fractions import Fraction as F

import mpmath
import numpy as np
import pytest
from sympy import Rational, cos, pi, sin, sqrt
from trajectories.heavy_top import NUMBERS, STATE, TOP

import gyrostat as gs
from gyrostat.errors import ValuesError
from gyrostat.mechanics.classical.attitude import ANGLES, rotation
from gyrostat.trajectories import motion


@pytest.fixture(scope="module")
def top():
    return motion(TOP, STATE, NUMBERS)


@pytest.fixture(scope="module")
def precise():
    return motion(TOP, STATE, NUMBERS, precision=30)


def test_numbers_of_every_kind(top):
    """Strings, fractions, decimals of Python, SymPy numbers: the same motion.

    A float is the dyadic number it is.
    """
    state = (F(3, 10), Rational(-1, 5), 1.5, F(3, 5), 0, Rational(4, 5))
    same = motion(TOP, np.array(state, dtype=object),
                  {"I1": 1.0, "I3": F(3, 5), "l": Rational(2, 5), "m0": 1.5})
    assert (same([0.0, 2.0]) == top([0.0, 2.0])).all() and same.state == top.state
    assert (
        motion(TOP, (0.3, -0.2, 1.5, 0.6, 0.0, 0.8), NUMBERS).state[0]
        == Rational(*(0.3).as_integer_ratio())
        != Rational(3, 10)
    )
    np.testing.assert_allclose(motion(TOP, (0.3, -0.2, 1.5, 0.6, 0.0, 0.8), NUMBERS)(3.0), top(3.0),
                               atol=1e-15)
    assert motion(TOP, (0, 0, 1, sin(pi / 5), 0, cos(pi / 5)), NUMBERS)(0.0) == pytest.approx(
        [0, 0, 1, np.sin(np.pi / 5), 0, np.cos(np.pi / 5)], abs=1e-15)
    assert top.scene.body.inertia == (1, 1, Rational(3, 5))
    assert top.scene.body.gyrostatic_momentum == (0, 0, Rational(2, 5))


def test_times_of_any_shape(top):
    """A number, an empty array, a table: the state along a last axis, the attitude along the last two."""
    t = np.array([[0.5, -1.0, 2.0], [1e6, 0.0, 3.5]])
    table, R, angles = top(t), top.attitude(t), top.angles(t)
    assert table.shape == (2, 3, 6) and R.shape == (2, 3, 3, 3) and angles.shape == (2, 3, 3)
    for place in np.ndindex(t.shape):
        assert top(float(t[place])).shape == (6,)
        assert top.attitude(t[place]).shape == (3, 3)
        assert top.angles(t[place]).shape == (3,)
        np.testing.assert_allclose(top(t[place]), table[place], rtol=0, atol=1e-15)
        np.testing.assert_allclose(top.attitude(t[place]), R[place], rtol=0, atol=1e-15)
    assert top([]).shape == (0, 6)
    assert top.attitude([]).shape == (0, 3, 3)
    assert top(np.empty((2, 0))).shape == (2, 0, 6)
    assert top([1, 2]).shape == (2, 6) and top(1).shape == (6,) and table.dtype == float
    long = np.linspace(-50, 50, 10001)
    np.testing.assert_allclose(top(long)[[1, 4095, 4096, 4097, 9999]],
                               top(long[[1, 4095, 4096, 4097, 9999]]), rtol=0, atol=1e-15)


def test_precise_times_of_any_shape(precise, top):
    """With precision the results are mpmath numbers of as many digits, in arrays of objects.

    Times are exact numbers.
    """
    found = precise([["1/2", F(-1)], [2, sqrt(3)]])
    assert found.shape == (2, 2, 6) and found.dtype == object and isinstance(found[0, 0, 0], mpmath.mpf)
    np.testing.assert_allclose(found.astype(float), top([[0.5, -1.0], [2.0, 3**0.5]]), rtol=0, atol=2e-15)
    assert precise("1/2").shape == (6,)
    assert precise([]).shape == (0, 6)
    assert isinstance(precise.period, mpmath.mpf)
    with mpmath.workdps(30):
        assert precise(0)[0] == mpmath.mpf(3) / 10 and abs(precise(0)[5] - mpmath.mpf(4) / 5) < 1e-30
    assert isinstance(top.period, float) and float(precise.period) == top.period
    for ours, double in ((precise.precession, top.precession), (precise.spin, top.spin)):
        assert isinstance(ours, mpmath.mpf) and float(ours) == double
    with mpmath.workdps(30):
        assert abs(precise.spin_rate * precise.period - precise.spin) < 1e-28 * abs(precise.spin)
    assert precise.attitude(1.0).dtype == float and precise.frequencies == top.frequencies
    np.testing.assert_allclose(precise.attitude(1.0), top.attitude(1.0), rtol=0, atol=1e-15)


def test_a_precise_period_is_a_time(precise):
    """A period later k3 is what it was: mpmath numbers are taken as times."""
    assert abs(precise(precise.period)[5] - precise(0)[5]) < 1e-28


def test_a_motion_goes_on_from_where_it_is(precise):
    """The motion from the state at t1, after t2, is that after t1 + t2, to 25 digits; and back again."""
    with mpmath.workdps(40):
        here = [Rational(str(x)) for x in precise(F(7, 4))]
        later = motion(TOP, here, NUMBERS, precision=30)
        assert max(abs(a - b) for a, b in zip(later(F(5, 2)), precise(F(17, 4)))) < 1e-26
        assert max(abs(a - b) for a, b in zip(later(F(-7, 4)), precise(0))) < 1e-26


def test_integrals_and_what_is_lost_of_them(top):
    """Energy, Casimirs and π3 at the start.

    The drift is the largest deviation relative to the largest term.
    """
    assert top.energy == pytest.approx((0.09 + 0.04) / 2 + 2.25 / 1.2 + 1.5 * 0.8, rel=1e-15)
    assert top.casimirs == (pytest.approx(0.18 + 1.9 * 0.8, rel=1e-15), 1.0) and len(top.integrals) == 1
    assert top.integrals[0] in (1.5, 1.9)
    assert list(top.invariants) == ["energy", "C1", "C2", "F1"] and top.invariants["C2"] == 1
    drift = top.drift(np.linspace(-1e9, 1e9, 50))
    assert list(drift) == ["energy", "C1", "C2", "F1"]
    assert 0 < max(drift.values()) < 3e-15
    assert drift["F1"] == 0
    assert set(top.drift([]).values()) == {0.0} and all(isinstance(x, float) for x in drift.values())


def test_drift_shows_a_wrong_state(monkeypatch, top):
    """A state that is off by 10⁻³ in k3 has lost 10⁻³ m0 of the energy relative to its largest term, and so
    on.
    """
    wrong = motion(TOP, STATE, NUMBERS)
    right = wrong(np.array([1.0]))
    monkeypatch.setattr(wrong._route, "state", lambda t: right + np.array([0, 0, 0, 0, 0, 1e-3]))
    lost = wrong.drift([1.0])                              # at the time 0 the state is the one given
    assert lost["energy"] == pytest.approx(1.5e-3 / 1.875, rel=1e-9)
    assert lost["C1"] == pytest.approx(1.9e-3 / 1.2, rel=1e-9)
    assert lost["C2"] == pytest.approx(((right[0, 5] + 1e-3)**2 - right[0, 5]**2) / 0.64, rel=1e-9)


def test_limits_frequencies_and_error(top):
    """k3 stays between the limits and reaches them; 2π/T and the mean rates; an error of a few roundings."""
    low, high = top.limits
    z = top(np.linspace(0, top.period, 20001))[:, 5]
    assert low <= z.min() + 1e-15 < low + 1e-7 and high >= z.max() - 1e-15 > high - 1e-7
    assert top.frequencies == {"nutation": pytest.approx(2 * np.pi / top.period),
                               "precession": pytest.approx(top.precession / top.period),
                               "spin": pytest.approx(top.spin / top.period)}
    assert top.precession_rate == top.frequencies["precession"] and top.spin_rate == top.frequencies["spin"]
    assert 1e-16 < top.error < 1e-13 and 10 < top.nodes < 100


def test_angles_at_a_pole():
    """At and next to a pole the angles are those of the attitude, R(φ, θ, ψ) = R."""
    for z in (1, -1):
        found = motion(TOP, (1, "1/2", 1, 0, 0, z), NUMBERS)
        for t in (0.0, 1e-9, 0.3, found.period):
            R = np.array(rotation("zxz").subs(dict(zip(ANGLES, map(float, found.angles(t))))), dtype=float)
            np.testing.assert_allclose(R, found.attitude(t), rtol=0, atol=1e-14)
        np.testing.assert_allclose(found.attitude(0.0), np.diag([1, z, z]), rtol=0, atol=1e-15)
    swinging = motion(TOP, (0, 1, "-2/5", 0, 0, -1), NUMBERS)
    R = np.array(rotation("zxz").subs(dict(zip(ANGLES, map(float, swinging.angles(0.0))))), dtype=float)
    np.testing.assert_allclose(R, swinging.attitude(0.0), rtol=0, atol=1e-14)


def test_dataset(top):
    """One variable for each coordinate over the times, what is known of the motion as attributes."""
    pytest.importorskip("xarray")
    t = np.linspace(0, 5, 7)
    found = top.to_xarray(t)
    state, turned = ["pi1", "pi2", "pi3", "k1", "k2",
                     "k3"], "omega1 omega2 omega3 q0 q1 q2 q3 phi theta psi".split()
    assert list(found.data_vars) == state + turned and found["k3"].dims == ("time",)
    np.testing.assert_array_equal(found["time"], t)
    np.testing.assert_array_equal(found[state].to_array().values.T, top(t))
    assert found["k3"].attrs["latex"] and found["pi1"].attrs["long_name"]
    for name, value in (("route", "elliptic"), ("period", top.period), ("precession", top.precession),
                        ("spin", top.spin),
                        ("energy", top.energy), ("error", top.error), ("nodes", top.nodes),
                        ("potential", "3*k3/2"),
                        ("gyrostatic_momentum", "(0, 0, 2/5)"), ("state", "(3/10, -1/5, 3/2, 3/5, 0, 4/5)")):
        assert found.attrs[name] == value
    assert "period" not in motion(TOP, (0, 0, 1, 0, 0, 1), NUMBERS).to_xarray(t).attrs
    free = motion(gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, 0))), (1, 2, 3)).to_xarray(t)
    assert list(free.data_vars) == [*state[:3], *turned]
    assert free.attrs["potential"] == "none"
    assert "spin" not in free.attrs
    precise = motion(TOP, STATE, NUMBERS, precision=20).to_xarray(t)
    assert precise["k3"].dtype == float and precise.attrs["period"] == top.period
    with pytest.raises(ValuesError, match=r"shape \(1, 2\) is not that of a row: give a row"):
        top.to_xarray([[0.0, 1.0]])


def test_times_that_are_refused(top, precise):
    """Neither nan nor infinity, nor more periods than can be counted, nor a time that is no number."""
    for bad in (np.nan, np.inf, -np.inf, [0.0, np.nan]):
        for verb in (top, top.attitude, top.angles, top.drift, top.to_xarray):
            with pytest.raises(ValuesError, match="finite"):
                verb(bad)
    for verb in (top, top.attitude):
        with pytest.raises(ValuesError, match="t = 1e\\+17 is not within"):
            verb(1e17)
    for bad in (np.nan, np.inf, "x"):
        with pytest.raises(ValuesError, match="t = "):
            precise(bad)
