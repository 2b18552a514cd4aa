"""The kicks that a spinning free gyrostat bears, against saddles and descents of an oracle of its own."""
import math
from fractions import Fraction
from random import Random

import numpy as np
import pytest
from oracles.spin_kicked import least_kick
from sympy import sqrt

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError


def spins(moments, rotor, length=1):
    """The stable rotations about an axis, of least and of greatest energy."""
    found = gs.relative_equilibria(gs.assemble(gs.Gyrostat(moments, rotor)), {"M": length})
    return [e for e in found if e.decision.stable and sum(x != 0 for x in e.momentum) == 1]


@pytest.mark.parametrize("moments", [(1, 2, 3), (2, 3, 4), (5, 3, 6)])
def test_without_a_rotor_they_are_the_formulas_of_the_separatrices(moments):
    """m √(I1 (I3 − I2)/(I2 (I3 − I1))) about the greatest; with that of the least the squares make m²."""
    I1, I2, I3 = sorted(moments)
    kicks = {e.well.kick() for e in spins(moments, (0, 0, 0), "3/2")}
    greatest = 1.5 * math.sqrt(I1 * (I3 - I2) / (I2 * (I3 - I1)))
    assert sorted(kicks) == pytest.approx(sorted([greatest, math.sqrt(2.25 - greatest**2)]), rel=1e-14)


def drawn(seed):
    """Moments, a rotor along one axis, slow enough for a saddle on both sides, the axis and M."""
    chance = Random(seed)
    while True:
        I = [Fraction(chance.randint(8, 24), 8) for _ in range(3)]
        n = chance.choice([I.index(max(I)), I.index(min(I))])
        if len(set(I)) == 3 and 2 * max(I) < sum(I):
            flat = min(abs(1 / x - 1 / I[n]) for x in I if x != I[n])
            l = [flat * I[n] * Fraction(chance.randint(-9, 9), 10) if m == n else Fraction(0)
                 for m in range(3)]
            return I, l, n


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(24))
def test_they_are_those_of_brute_force(seed):
    """In 24 directions the first kick that leads out, to 10⁻⁶, and of all the least; both ways to spin."""
    I, l, n = drawn(seed)
    u = np.random.default_rng(seed).normal(size=(24, 3))
    u /= np.linalg.norm(u, axis=1)[:, None]
    a = {m: abs(1 / float(I[m]) - 1 / float(I[n])) for m in range(3) if m != n}
    steep = max(a, key=a.get)
    for e in (e for e in spins(I, l) if e.momentum[n] and not e.well.reason):
        numbers = [np.array(x, dtype=float) for x in (I, l, e.momentum)]
        sign = -1 if e.form.index else 1
        theirs, ours = least_kick(*numbers, u, sign), np.array([e.well.kick(x) for x in u])
        near = ours < 3.9
        assert np.allclose(ours[near], theirs[near], rtol=1e-6) and np.all(theirs[~near] > 3.8)
        worst = np.zeros((1, 3))
        worst[0, steep], worst[0, n] = math.sqrt(a[steep] - min(a.values())), -math.sqrt(min(a.values()))
        worst[0, n] *= float(e.momentum[n])
        there = least_kick(*numbers, worst / np.linalg.norm(worst), sign)[0]
        assert e.well.kick() == pytest.approx(min(there, 1), rel=1e-6) and e.well.kick() < ours.min() + 1e-12


def test_turned_axes():
    """A full tensor, whose axes are turned, bears the same in turned directions."""
    plain, = (e for e in spins((2, 4, 5), (0, 0, "1/8")) if e.momentum[2] == 1)
    tensor = [[3, 1, 0], [1, 3, 0], [0, 0, 5]]
    turned, = (e for e in spins(tensor, (0, 0, "1/8")) if e.momentum[2] == 1)
    assert turned.well.kick() == pytest.approx(plain.well.kick(), rel=1e-14)
    for a, b, c in ((1, 2, 0), (2, -1, -3), (0, 1, 1)):
        there = turned.well.kick((a - b, -a - b, c * sqrt(2)))
        assert there == pytest.approx(plain.well.kick((a, b, c)), rel=1e-12)


def test_at_the_other_end():
    """A kick against M ends at M = 0, where a rotor makes a small sphere; along M there is no bound."""
    spin, = (e for e in spins((2, 3, 4), (0, 0, "1/4")) if e.momentum[2] == 1)
    assert spin.well.kick((0, 0, -1)) == pytest.approx(1, rel=1e-14) and spin.well.kick((0, 0, 2)) == math.inf
    with pytest.raises(ValuesError, match="direction"):
        spin.well.kick((0, 0, 0))


@pytest.mark.parametrize(("moments", "rotor"), [
    ((1, 2, 3), ("1/10", "1/5", "1/7")), ((1, 2, 3), (0, 0, "7/5")), ((1, 2, 3), ("1/4", 0, 0)),
    ((1, 2, 3), (0, "1/5", 0))])
def test_others_are_refused(moments, rotor):
    """A rotor across the axis; one so fast that there is no saddle; what does not spin about an axis."""
    scene = gs.assemble(gs.Gyrostat(moments, rotor))
    refused = 0
    for e in gs.relative_equilibria(scene, {"M": 1}):
        if e.decision.stable:
            try:
                assert e.well.kick() > 0
            except ScopeError as error:
                assert "momentum sphere" in str(error)
                refused += 1
    assert refused
