"""Kicks that keep k within an angle, against circles on a grid and motions of an oracle of its own."""
from random import Random

import mpmath
import numpy as np
import pytest
from angle_kept import HeavyBody
from flint import arb, arb_series
from sympy import Rational

import gyrostat as gs
from gyrostat.equilibria.wells.disturbances.circles import least
from gyrostat.equilibria.wells.disturbances.within import kick_within, rise_within
from gyrostat.errors import ScopeError, ValuesError

U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
SCENE = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), U)
ANGLES = (1, 10, 30, 75, 120)


def field(c, q):
    return gs.general_potential(lambda *k: sum(a * x + b * x**2 / 2 for a, b, x in zip(c, q, k)))


def drawn(random):
    """(oracle, a rotation with least V in its frame): fractions, with a quadratic field in half of them."""
    def fractions(low, high, d):
        return [Rational(random.randint(low * d, high * d), d) for _ in range(3)]

    while True:
        I, l, c, q = fractions(1, 4, 4), fractions(-1, 1, 4), fractions(-2, 2, 4), fractions(-1, 1, 2)
        if random.random() < 0.5:
            q = [Rational(0)] * 3
        if 2 * max(I) >= sum(I) or len(set(I)) < 3 or not any(c):
            continue
        scene = gs.assemble(gs.Gyrostat(I, l), field(c, q))
        values = {"omega": random.choice(["1/4", "1/2", 1, "3/2"])}
        held = [e for e in gs.relative_equilibria(scene, values) if e.form.index == 0]
        for rotation in held:
            if rise_within(rotation, 1) > 0:
                Q = [[q[i] if i == j else Rational(0) for j in range(3)] for i in range(3)]
                return HeavyBody(I, l, c, Q), rotation


def numbers(rotation):
    k = [mpmath.mpf(str(x.evalf(30))) for x in rotation.directions[0]]
    return k, mpmath.mpf(str(rotation.rates["omega"].evalf(30)))


@pytest.mark.few(2)
@pytest.mark.parametrize("seed", range(20))
def test_the_rise_is_the_greatest_of_the_least_energies_on_smaller_circles(seed):
    """On none of 24 circles up to the angle is the least energy higher, and on one it is as high."""
    oracle, rotation = drawn(Random(seed))
    mpmath.mp.dps = 30
    k, omega = numbers(rotation)
    assert oracle.rotation(np.array(k, float), float(omega))[1] < 1e-12
    degrees = Random(seed).choice(ANGLES)
    for level in (False, True):
        rise = rise_within(rotation, degrees, level)
        highest = max(oracle.least(k, omega, mpmath.mpf(degrees) * n / 24, level) for n in range(1, 25))
        assert rise.rad() < 1e-20
        assert abs(float(rise.mid()) - highest) < 1e-13 * (1 + abs(highest))


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(20))
def test_motions_after_a_weaker_kick_stay_within_the_angle(seed):
    """Of ten motions after a kick of 0.99 of the bound, half on the level, none goes beyond the angle."""
    oracle, rotation = drawn(Random(seed))
    random = np.random.default_rng(seed)
    k = np.array([float(x) for x in rotation.directions[0]])
    pi, _ = oracle.rotation(k, float(rotation.rates["omega"]))
    degrees = Random(seed).choice(ANGLES)
    for n in range(10):
        kick = random.normal(size=3)
        if level := n % 2 == 0:
            kick -= (kick @ k) * k
        kick *= 0.99 * kick_within(rotation, degrees, level) / np.linalg.norm(kick)
        assert oracle.greatest_angle(k, pi + kick, 20) < degrees


def test_scene_1_of_the_notes():
    """I = (1, 2, 3), l = (0, 0, 1), U = k1 + k2 + k3, C1 = 5/2: two rises of an independent computation.

    It searched circles at 40 digits: the rise to 10° is 0.0192151466930092, that to 30° 0.126726378578248,
    and the kick across k that keeps it within 10° is 0.206108123741844.
    """
    rotation = gs.relative_equilibria(SCENE, {"C1": "5/2"})[0]
    assert abs(rise_within(rotation, 10, level=True) - arb("0.0192151466930092")) < 1e-16
    assert abs(rise_within(rotation, "30 deg", level=True) - arb("0.126726378578248")) < 1e-15
    assert abs(kick_within(rotation, 10, level=True) - 0.206108123741844) < 1e-15
    assert kick_within(rotation, 10) < kick_within(rotation, 10, level=True)


def test_an_angle_in_radians_is_the_same():
    """60° is π/3 to 20 digits; a smaller angle has no greater rise."""
    rotation = gs.relative_equilibria(SCENE, {"C1": "5/2"})[0]
    degrees, radians = (rise_within(rotation, angle) for angle in (60, "1.04719755119659774615 rad"))
    assert abs(degrees - radians) < 1e-18
    assert rise_within(rotation, 59) < degrees


def test_a_constant_and_double_minima_are_bounded_from_below():
    """f = 1 is within a ball of 1; sin²φ has two minima, and sin⁴φ flat ones."""
    constant = least(lambda x: arb_series([arb(1) + 0 * x, 0, 0], 3))
    assert constant.contains(1) and constant.rad() < 1e-20

    def sine(x):
        return arb_series([x.sin(), x.cos(), -x.sin() / 2], 3)

    for power, width in ((2, 1e-20), (4, 1e-6)):
        found = least(lambda x, n=power: sine(x) ** n)
        assert found.contains(0) and found.rad() < width


def test_what_is_no_angle_or_has_no_bound_is_refused():
    """Angles outside 0 to 180°, another unit, maxima of V and scenes that are no body in a field."""
    rotations = gs.relative_equilibria(SCENE, {"C1": "5/2"})
    for angle in (0, 180, -10, "4 rad", "10 s"):
        with pytest.raises(ValuesError, match="angle"):
            rise_within(rotations[0], angle)
    highest = next(e for e in rotations if e.form.index == 2)
    for level in (False, True):
        with pytest.raises(ScopeError, match="no kick"):
            kick_within(highest, 10, level)
    satellite = gs.assemble(gs.Gyrostat((1, "5/4", "8/5"), (0, 0, 0)), gs.circular_orbit(1))
    with pytest.raises(ScopeError, match="satellite"):
        rise_within(gs.relative_equilibria(satellite, {})[0], 10)
