"""Every permanent rotation in a field of degree 3 or more, against Newton's method, counts, spectra."""
import random
from fractions import Fraction
from itertools import product

import heavy
import numpy as np
import pytest
from heavy_scenes import by_criteria, k1, k2, k3
from slow import sampled
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.algebra.enclosures.balls import ball
from gyrostat.errors import ScopeError

DIRECTION = (k1, k2, k3)


def drawn(rng, degree):
    """A body, a rotor and U as a polynomial, in fractions."""
    def number():
        return Fraction(rng.randint(-12, 12), rng.randint(1, 6))
    inertia = [Fraction(rng.randint(4, 30), 10) for _ in range(3)]
    terms = {e: number() / 3 for e in product(range(degree + 1), repeat=3) if 0 < sum(e) <= degree}
    return inertia, [number() / 5 for _ in range(3)], terms, number()


def double(x):
    return float(ball(x, 64).mid())


def check(rng, degree, asked):
    """Nothing missing, nothing wrong, minima − saddles + maxima = 2; how many there are."""
    inertia, rotor, terms, number = drawn(rng, degree)
    U = sum(c * k1**a * k2**b * k3**n for (a, b, n), c in terms.items())
    scene = gs.assemble(gs.Gyrostat(tuple(inertia), tuple(rotor)), gs.general_potential(U))
    found = gs.relative_equilibria(scene, {asked: number})
    floats = {e: float(c) for e, c in terms.items()}
    data = np.diag(np.array(inertia, float)), np.array(rotor, float), floats, float(number)
    slope = (heavy.at_rate if asked == "omega" else heavy.amended)(*data)
    places = [np.array([double(x) for x in r.directions[0]]) for r in found]
    for k in heavy.critical(slope):
        assert min(np.abs(k - place).max() for place in places) < 1e-6, (data, k)
    assert sum(heavy.index(slope, k) for k in places) == 2, data
    for r, k in zip(found, places):
        omega = double(r.rates["omega"])
        assert asked == "omega" or np.abs(omega * k @ data[0] @ k + data[1] @ k - data[3]) < 1e-9
        (g,), (Q,) = heavy.jet(floats, np.array([k]))
        whole = data[0], data[1], g - Q @ k, Q, omega, k
        growth, form = heavy.growth(*whole), heavy.squares(*whole)
        if np.abs(form).min() > 1e-6 * np.abs(form).max() and (growth > 1e-4 or growth < 1e-7):
            expected = "UNSTABLE" if growth > 1e-4 else "STABLE" if form[0] > 0 else "UNDECIDED"
            assert by_criteria(r.decision) == expected, (data, k)
    return len(found)


@pytest.mark.slow
@pytest.mark.parametrize("degree, asked, scenes", [(3, "omega", 2)])
def test_all_are_found_and_rightly_decided(degree, asked, scenes):
    rng = random.Random(f"degree {degree} {asked}")
    assert sum(check(rng, degree, asked) for _ in range(scenes)) >= 2 * scenes


@pytest.mark.slow
@pytest.mark.parametrize("degree, asked, scenes", [(3, "omega", 400), (4, "omega", 60), (3, "C1", 10)])
def test_many(full, degree, asked, scenes):
    rng = random.Random(f"many {degree} {asked}")
    count = sampled(scenes, full, scenes // 40 + 1)
    assert sum(check(rng, degree, asked) for _ in range(count)) > 2 * count


def test_the_number_of_critical_points():
    """Of k1ᵈ + k2ᵈ + k3ᵈ on the sphere all 2 (d² − d + 1) are real: faces, edges and corners of a cube."""
    for degree, count in ((3, 14), (4, 26)):
        U = gs.general_potential(k1**degree + k2**degree + k3**degree)
        found = gs.relative_equilibria(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), U), {"omega": 0})
        squares = {tuple(x**2 for x in r.directions[0]) for r in found}
        assert len(found) == count == len({r.directions[0] for r in found})
        assert squares == {tuple(Rational(n in on, len(on)) for n in range(3)) for on in (
            (0,), (1,), (2,), (0, 1), (0, 2), (1, 2), (0, 1, 2))}


def test_several_rotations_of_one_rate_on_a_level():
    """b = c − omega l vanishes across a principal axis at omega = 1; or along a circle of rotations."""
    third = Rational(1, 3)
    U = -third * k1 + 2 * third * k2 + k3
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (1, 1, 1)), gs.general_potential(U))
    (r,) = [r for r in gs.relative_equilibria(scene, {"C1": 11 * third}) if r.rates["omega"] == 1]
    assert r.directions[0] == (2 * third, third, 2 * third)


@pytest.mark.slow
@pytest.mark.parametrize("inertia, rotor, c, Q, level, count", [
    ((2, 2, 1), (1, 2, 1), (3, 1, 2), (0, 0, 0), 3, 4),    # two equal moments
    ((2, 2, 1), (1, 2, 1), (2, 4, 2), (0, 0, 0), 3, 8),    # a circle at omega = 2, two of it on the level
    pytest.param((1, 2, 3), (0, 0, 1), (0, 0, 3), (-4, -3, 2), 3, 10, marks=pytest.mark.slow),
])
def test_equal_moments_and_circles(inertia, rotor, c, Q, level, count):
    U = sum(x * y + z * x**2 / 2 for x, y, z in zip(DIRECTION, c, Q))
    scene = gs.assemble(gs.Gyrostat(inertia, rotor), gs.general_potential(U))
    found = gs.relative_equilibria(scene, {"C1": level})
    data = (*(np.array(x, float) for x in (np.diag(inertia), rotor, c, np.diag(Q))), float(level))
    wanted = heavy.on_level(*data)
    assert len(found) == len(wanted) == count
    for k, omega in wanted:
        assert any(np.abs(k - [double(x) for x in r.directions[0]]).max() < 1e-7
                   and abs(omega - double(r.rates["omega"])) < 1e-7 for r in found)


def test_what_is_refused():
    body = gs.Gyrostat((1, 2, 3), (0, 0, 0))
    turned = gs.assemble(body, gs.general_potential(k3**3 + k1 * (k1**2 + k2**2 + k3**2)))
    with pytest.raises(ScopeError, match="1 . sqrt.2. is not rational: .* 2.414213562, or give a direction"):
        gs.relative_equilibria(turned, {"omega": sqrt(2) + 1})
    cosine = gs.assemble(body, gs.general_potential(k1 * (1 + k2) / (2 + k3)))
    with pytest.raises(ScopeError, match="is not a polynomial in k: all rotations at a rate omega"):
        gs.relative_equilibria(cosine, {"omega": 1})
