"""Heavy gyrostats with special and degenerate rotations: counted, found and decided as they must be."""
import random
from collections import Counter
from fractions import Fraction

import heavy
import heavy_exact
import mpmath as mp
import numpy as np
import pytest
from drawn_rotations import KINDS, drawn
from heavy_scenes import by_criteria, floats, scene_of
from slow import sampled

import gyrostat as gs

SCENES = {**dict.fromkeys(KINDS, 200), "general": 3000}


def check(rng, kind):
    """Nothing missing, nothing wrong; what was counted."""
    *data, k = drawn(rng, kind)
    found = gs.relative_equilibria(scene_of(*data[:4]), {"omega": data[4]})
    points = [r for r in found if not r.locus]
    circles = {r.form.circle for r in found if r.locus}
    counted = heavy_exact.count(*data)
    assert counted in (None, (len(points), len(circles))), (kind, data, counted)
    places = [np.array([float(x) for x in r.directions[0]]) for r in points]
    exact, seen = floats(*data), Counter(scenes=1, circles=len(circles))
    wanted = [np.array(k, float), *(heavy.directions(*exact) if not circles and kind != "fold" else ())]
    for direction in wanted:
        if not (circles and on_circle(found, direction)):
            assert min(np.abs(direction - place).max() for place in places) < 1e-6, (kind, data, direction)
    for rotation, place in zip(points, places):
        seen += decided(kind, data, k, rotation, place)
    return seen


def on_circle(found, k):
    for r in found:
        if r.form.circle:
            axis = np.array([float(x) for x in r.form.circle])
            at = np.array([float(x) for x in r.directions[0]])
            if abs((k - at) @ axis) < 1e-9 * np.abs(axis).max():
                return True
    return False


def decided(kind, data, k, rotation, place):
    """The verdict of a rotation: in fractions if it is that of the scene, else at 50 digits."""
    if np.abs(place - np.array(k, float)).max() < 1e-9:
        assert [Fraction(int(x.p), int(x.q)) for x in rotation.directions[0]] == k
        numbers, zero = (*data, k), 0
    else:
        fine = heavy_exact.polished(*data, place)
        if fine is None:
            return Counter(degenerate=1)
        numbers, zero = precise(*data, fine), heavy_exact.TINY
    with mp.workdps(heavy_exact.DIGITS):
        p, q, determinant, trace = heavy_exact.decided(*numbers)
        expected, name = heavy_exact.verdict(p, q, determinant, trace, zero), by_criteria(rotation.decision)
        if expected is not None:
            assert name == expected, (kind, data, place)
            return Counter(decided=1)
        # on a boundary: spectrally unstable, or not to be called what it is not
        if p < -zero or p * p - 4 * q < -zero:
            assert name == "UNSTABLE", (kind, data, place)
        if abs(determinant) > zero:
            assert name == "UNDECIDED", (kind, data, place)
        elif name == "STABLE" and trace >= 0:
            assert all(x > 0 for x in rises(*numbers)), (kind, data, place)
        elif name == "UNSTABLE" and p > 0 and not any(numbers[1]) and numbers[4] == 0:
            assert min(rises(*numbers)) < 0, (kind, data, place)
        return Counter(boundary=1)


def precise(moments, rotor, c, Q, omega, k):
    """In numbers of mpmath."""
    with mp.workdps(heavy_exact.DIGITS):
        def fine(x):
            return mp.mpf(x.numerator) / x.denominator
        return (*([fine(x) for x in vector] for vector in (moments, rotor, c)),
                [[fine(x) for x in row] for row in Q], fine(omega), k)


def rises(moments, rotor, c, Q, omega, k):
    """U_c − U_c(k) on a small circle about k."""
    level = sum((omega * i * x + l) * x for i, x, l in zip(moments, k, rotor))

    def value(x):
        J = sum(i * y * y for i, y in zip(moments, x))
        U = sum(y * z for y, z in zip(c, x)) + sum(
            Q[i][j] * x[i] * x[j] for i in range(3) for j in range(3)) / 2
        return U + (level - sum(l * y for l, y in zip(rotor, x))) ** 2 / (2 * J)

    k = [mp.mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else x for x in k]
    first = [k[1], -k[0], mp.mpf(0)] if k[0] or k[1] else [mp.mpf(1), mp.mpf(0), mp.mpf(0)]
    size = mp.sqrt(sum(x * x for x in first))
    first = [x / size for x in first]
    second = [k[1] * first[2] - k[2] * first[1], k[2] * first[0] - k[0] * first[2],
              k[0] * first[1] - k[1] * first[0]]
    found = []
    for turn in np.linspace(0, 2 * np.pi, 721):
        x = [z + mp.mpf(10) ** -7 * (mp.cos(turn) * u + mp.sin(turn) * v)
             for z, u, v in zip(k, first, second)]
        length = mp.sqrt(sum(y * y for y in x))
        found.append(value([y / length for y in x]) - value(k))
    return found


@pytest.mark.few(2)
@pytest.mark.parametrize("kind", KINDS)
def test_found_and_rightly_decided(kind):
    assert check(random.Random(f"one {kind}"), kind)["decided"] >= 1


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_many(kind, full):
    rng, seen = random.Random(f"many {kind}"), Counter()
    count = sampled(SCENES[kind], full, 7)
    for _ in range(count):
        seen += check(rng, kind)
    print(kind, dict(seen))
    assert seen["decided"] + seen["boundary"] > 2 * count
