"""Motions that come to rest in infinite time, both ways."""
import numpy as np
import pytest
from slow import slow
from sympy import Rational, exp, solve, sqrt, symbols
from trajectories.tops import BODY, SEPARATRICES, TILTED, F, about, moving, off, theirs

import gyrostat as gs
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.errors import AccuracyError
from gyrostat.trajectories import motion


def levelled(heights, poles, across, P, height, degree):
    """Coefficients of the polynomial U, of z first, for which g has double roots at given k3 inside and
    abs(p)² = 0 at given poles.
    """
    z, a = symbols("z"), symbols(f"a1:{degree + 1}")
    U = sum(c * z ** (n + 1) for n, c in enumerate(a))
    v = across[0] * sqrt(1 - height**2) + P * height
    kinetic = across[0] ** 2 + across[1] ** 2 + 2 * (U.subs(z, height) - U)
    g = kinetic * (1 - z**2) - (v - P * z) ** 2
    conditions = [e.subs(z, Rational(x)) for x in heights for e in (g, g.diff(z))] + [
        kinetic.subs(z, x) for x in poles
    ]
    found = solve(conditions, a, dict=True)[0]
    return [found.get(c, c) for c in a]


LEAVING = ["sleeping top", "hanging", "pendulum between its poles", "hanging in exp"]


@pytest.mark.few(1)
@pytest.mark.parametrize("name", [
    *LEAVING, *slow(*((name,) for name in SEPARATRICES if name not in LEAVING))])
def test_asymptotic_motions(name):
    """Both ways in time k3 comes to rest, as the exact energy wants it, and never returns.

    On the way the state is the oracle's.
    """
    U, state, (before, after) = SEPARATRICES[name]
    state = [exact_number(x) for x in state]
    found = moving(BODY, "2/5", U, state)
    assert found.route == "separatrix" and found.period is None
    for t in (F(3, 4), F(-1, 2)):
        assert off(found(float(t)), theirs(BODY, "2/5", U, state, t)) < 1e-14
    times = np.array([*np.linspace(1, 60, 30), 1e6, 1e12])
    for side, end in ((-1, before), (1, after)):
        values = found(side * times)
        gap = np.abs(values[:, 5] - end)
        assert (np.diff(gap[gap.argmax():]) <= 4e-16).all() and gap[-3:].max() < 1e-14
        assert np.abs(values[-2:, [0, 1, 3, 4]]).max() < 1e-10
    assert max(found.drift(np.concatenate([-times, times])).values()) < 2e-14
    exact = moving(BODY, "2/5", U, state, precision=30)([F(5, 4), F(-1, 2), 50, -50])
    assert np.abs(found([1.25, -0.5, 50.0, -50.0]) - exact.astype(float)).max() < 1e-14
    assert max(abs(x) for x in exact[2, :2]) > 1e-60        # not there yet


ONE, ONE_OF_THREE, TWO, POLE = ((F(1, 5),), (), 2), ((F(1, 5),), (), 3), ((F(1, 5), F(19, 20)), (), 4), (
    (F(1, 5),), (1,), 3)


@pytest.mark.few(1)
@pytest.mark.parametrize(("heights", "poles", "degree", "back"), [
    (*ONE, 1), (*TWO, -1), (*POLE, 1),
    *slow((*ONE, -1), (*ONE_OF_THREE, 1), (*ONE_OF_THREE, -1), (*TWO, 1), (*POLE, -1))])
def test_asymptotic_to_inclined_precession(heights, poles, degree, back):
    """From k3 = 4/5 to double roots of g inside.

    What is left is a steady precession with the rates said, the rest as before.
    """
    height, P = F(4, 5), F(1, 2)
    p1 = P * (1 - height) / F(3, 5) if poles else F(1, 4)
    across = (p1, back * F(1, 2))
    l, U = F(2, 5), levelled(heights, poles, across, P, height, degree)
    U = [F(str(c.subs(dict.fromkeys(c.free_symbols, 1)))) for c in U]
    state = (*across, P - l, *map(F, TILTED))
    found = moving(BODY, l, U, state)
    assert found.route == "separatrix" and found.period is None
    both = len(heights) + len(poles) == 2
    for t in (F(3, 4), F(-1)):
        assert off(found(float(t)), theirs(BODY, l, U, state, t)) < 2e-14
    ends = found(np.array([-300.0, 300.0]))[:, 5]
    towards = sorted([float(heights[0]), 1.0 if poles else float(heights[-1])])
    assert np.abs(ends - (towards[::back] if both else towards)).max() < 1e-13
    if not poles:
        t = 1000.0
        rate = found.precession_rate * 0.8, found.spin_rate * 0.8
        np.testing.assert_allclose(found.attitude(t + 0.8),
                                   about(rate[0]) @ found.attitude(t) @ about(rate[1]), atol=1e-12)
        z = found(t)[5]
        slope = sum(n * float(c) * z ** (n - 1) for n, c in enumerate(U, 1))
        assert abs(z * found.precession_rate**2 - float(P) * found.precession_rate + slope) < 1e-12
    assert max(found.drift(np.array([1e-3, -70.0, 1e3, 1e6, -1e12])).values()) < 3e-14


@pytest.mark.slow
def test_an_unreachable_accuracy_is_an_error():
    """In a plane, U = k3 − exp k3 at its highest energy.

    A double root of g inside is not told from two, and refused.
    """
    scene = gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, 0)), gs.axial_potential(lambda z: z - exp(z)))
    with pytest.raises(AccuracyError):
        motion(scene, (0, -sqrt(2 * exp(Rational(4, 5)) - Rational(18, 5)), 0, F(3, 5), 0, F(4, 5)))
