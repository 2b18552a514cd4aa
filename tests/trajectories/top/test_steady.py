"""Motions at constant k3: vertical rotations, inclined equilibria, steady precessions."""
import numpy as np
import pytest
from trajectories.tops import BODY, F, about, moving, off, theirs

UNIT = {"E1": ("0", "0", "3/2", "0", "0", "1"), "E2": ("0", "0", "-3/2", "0", "0", "-1"),
        "E2 of length 2": ("0", "0", "1", "0", "0", "-2")}
TIMES = np.array([0.0, 0.3, -7.0, 1e6, -1e12])


@pytest.mark.parametrize("U", [("1",), ("-2", "1/3", "1"), "exp"])
@pytest.mark.parametrize("state", UNIT.values(), ids=UNIT)
def test_vertical_rotations_stay(state, U):
    """E1 and E2, stable or not: the state does not move, the body turns about the vertical with ω3."""
    found, value = moving(BODY, "2/5", U, state), [float(F(x)) for x in state]
    assert found.route == "equilibrium" and found.period is None and found.limits == (value[5], value[5])
    assert (found(TIMES) == value).all()
    s, rate = np.sign(value[5]), value[2] / 0.6
    for R, t in zip(found.attitude(TIMES[:4]), TIMES):
        c, d = np.cos(s * rate * t), np.sin(s * rate * t)
        np.testing.assert_allclose(R, np.array([[c, -d, 0], [d, c, 0], [0, 0, 1]]) @ np.diag([1, s, s]),
                                   atol=1e-9 if t > 1e3 else 1e-14)
    rates = found.frequencies
    assert rates.keys() == {"precession", "spin"}
    assert rates["precession"] + s * rates["spin"] == pytest.approx(s * rate, rel=1e-15)


def inclined(w, l, k):
    """E3 with ω = w k: the slope of U there, and the state."""
    I1, I3 = map(F, BODY)
    slope = w * l - w * w * k[2] * (I1 - I3)
    return slope, (I1 * w * k[0], I1 * w * k[1], I3 * w * k[2], *k)


@pytest.mark.parametrize("w", [F(2), F(-1, 3)])
@pytest.mark.parametrize("bend", [F(0), F(3), F(-3)])
@pytest.mark.parametrize("k", [(F(3, 5), F(0), F(4, 5)), (F(-2, 7), F(3, 7), F(-6, 7))])
def test_inclined_equilibria_stay(w, bend, k):
    """E3: the state stays, the body turns uniformly about the vertical by w."""
    slope, state = inclined(w, F(3), k)
    found = moving(BODY, F(3), (slope - 2 * bend * k[2], bend), state)
    assert found.route == "equilibrium" and found.period is None
    np.testing.assert_allclose(found(TIMES), np.tile(np.array(state, float), (5, 1)), rtol=0, atol=2e-15)
    assert found.precession_rate == pytest.approx(float(w), rel=1e-15) and abs(found.spin_rate) < 1e-15
    c, s = np.cos(float(w) * 0.3), np.sin(float(w) * 0.3)
    np.testing.assert_allclose(found.attitude(0.3),
                               np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ found.attitude(0.0), atol=1e-15)


@pytest.mark.few(1)
@pytest.mark.parametrize(("W", "pi3", "k"), [(F(2), F(1), (F(3, 5), F(0), F(4, 5))),
                                             (F(-1), F(5, 2), (F(0), F(12, 13), F(-5, 13))),
                                            (F(1, 2), F(-3), (F(9, 5), F(0), F(12, 5)))])
def test_steady_precession_is_uniform(W, pi3, k):
    """Where I1 k3 W² − P W + U′ = 0, p = I1 W (k1, k2).

    k3 stays, φ gains W and ψ gains π3/I3 − W k3 in a unit of time.
    """
    r = {1: 1, 3: 3}[int(sum(x * x for x in k) ** F(1, 2))]
    l, W1 = F(2, 5), W / r                                  # p = I1 W1 k: the vertical is k/|k|
    slope = (pi3 + l) * W1 - k[2] * W1 * W1
    state = (W1 * k[0], W1 * k[1], pi3, *k)
    found = moving(BODY, l, (slope - k[2], F(1, 2)), state)
    spin = float(pi3) / 0.6 - float(W * k[2] / r)
    assert found.route == "steady precession"
    assert found.precession_rate == pytest.approx(float(W), rel=1e-15)
    assert found.period is found.precession is found.spin is None
    assert found.spin_rate == pytest.approx(spin, rel=1e-14) and found.limits == (float(k[2]), float(k[2]))
    for t in (0.7, -1.3):
        np.testing.assert_allclose(found.attitude(t),
                                   about(float(W) * t) @ found.attitude(0.0) @ about(spin * t), atol=1e-14)
        assert off(found(t), theirs(BODY, l, (slope - k[2], F(1, 2)), state, F(str(t)))) < 1e-14
    np.testing.assert_allclose(found.attitude(0.0)[2], np.array(k, float) / r, atol=1e-15)
