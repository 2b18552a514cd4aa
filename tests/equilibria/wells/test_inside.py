"""Whether a state is in a well, and how the wells of a level join, against floods."""
from fractions import Fraction
from random import Random

import numpy as np
import pytest
from oracles.flooded import parts, sphere

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError

GRID = 180
MOMENTS = (2, 3, 4)
SATELLITE = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(1))
ATTITUDES = [e for e in gs.relative_equilibria(SATELLITE, {}) if e.form.index == 0]
CRAFT = ATTITUDES[0]


def scenes(seed):
    """A body on a level in a field of degree two with several minima, and U_c written out."""
    rng = Random(seed)
    l, c, q = ([Fraction(rng.randint(-6, 6), 4) for _ in range(3)] for _ in range(3))
    level = Fraction(rng.randint(-4, 4), 4)
    U = " + ".join(f"({a})*k{i} + ({3 * b})*k{i}^2" for i, a, b in zip((1, 2, 3), c, q))
    scene = gs.assemble(gs.Gyrostat(MOMENTS, l), gs.general_potential(U))
    found = [e for e in gs.relative_equilibria(scene, {"C1": level}) if e.form.index == 0]
    l, c, q, I = (np.array(x, dtype=float) for x in (l, c, q, MOMENTS))
    return found, lambda k: k @ c + 3 * k**2 @ q + (float(level) - k @ l)**2 / (2 * k**2 @ I), float(level), l


def cell(k):
    """Of a direction on the grid."""
    return int(np.arccos(k[2]) * GRID / np.pi), int(np.arctan2(k[1], k[0]) % (2 * np.pi) * GRID / np.pi)


def held(e):
    """Whether a path is proved, so that there is a barrier."""
    return e.well.barrier_double is not None


@pytest.mark.parametrize("seed", [pytest.param(n, marks=[pytest.mark.slow] * (n > 0)) for n in range(6)])
def test_states_of_a_heavy_gyrostat(seed):
    """At random directions and momenta: inside as the flood says, but for cells at the edge."""
    found, V, level, l = scenes(seed)
    rng, I, values = np.random.default_rng(seed), np.array(MOMENTS), sphere(V, GRID)
    said = []
    for e in filter(held, found):
        k0 = np.array([e.doubles.place[f"k{n}"] for n in (1, 2, 3)])
        height = V(k0) + e.well.barrier_double
        label = parts(values < height - 1e-3 * e.well.barrier_double)
        for share in (0.5, 2):
            k = k0 + share * rng.normal(size=3)
            k /= np.linalg.norm(k)
            a, b = cell(k)
            around = label[max(a - 2, 0):a + 3].take(range(b - 2, b + 3), axis=1, mode="wrap")
            turning = rng.normal(size=3)
            turning -= (turning @ k) * k
            turning *= rng.uniform(0.2, 1.2) * np.sqrt(2 * abs(height - V(k)) / (turning**2 @ (1 / I)))
            energy = V(k) + turning**2 @ (1 / I) / 2
            if len(np.unique(around)) > 1 or abs(energy - height) < 0.01 * e.well.barrier_double:
                continue
            pi = (level - k @ l) / (k**2 @ I) * I * k + turning
            inside = bool(energy < height and around[0, 0] and around[0, 0] == label[cell(k0)])
            answer = e.well.contains([*pi, *k])
            said.append(answer)
            assert answer in (inside, None) and (answer is not None or V(k) > height - 0.05)
    assert None not in said[:1]


@pytest.mark.parametrize("seed", [pytest.param(n, marks=[pytest.mark.slow] * (n > 0)) for n in range(6)])
def test_how_many_wells_there_are_at_each_height(seed):
    """Between two critical values: as many as the flood has parts."""
    found, V, *_ = scenes(seed)
    e = next(filter(held, found))
    tree, values = e.well.tree, sphere(V, GRID)
    k0 = np.array([e.doubles.place[f"k{n}"] for n in (1, 2, 3)])
    heights = sorted(float(x.energy - e.energy) for x in e.well.points)
    assert tree.reason or sum(len(m.wells) - 1 for m in tree.merges) == len(found) - 1
    for low, high in zip(heights, heights[1:]):
        if high - low < 0.05 * (heights[-1] - heights[0]):
            continue
        middle = (low + high) / 2
        there = sum(float(x.energy - e.energy) < middle for x in found)
        joined = sum(len(m.wells) - 1 for m in tree.merges if float(m.height) < middle)
        count = len(np.unique(parts(values - V(k0) < middle))) - 1
        assert count == there - joined


def test_states_of_a_satellite():
    """Kicked about an axis: inside up to the energy of the pass; at rest elsewhere it is in another well."""
    still = [0, 70, 0, 0, 1, 0, 0, 0, 1]
    assert CRAFT.doubles.place["n2"] == CRAFT.doubles.place["r3"] == 1 and CRAFT.well.contains(still) is True
    for e in ATTITUDES:
        inside = [other.well.contains([float(x) for x in e.point]) for other in ATTITUDES]
        assert sorted(inside) == [False, False, False, True]
        for axis, moment in enumerate((60, 70, 35)):
            for share, kept in (("0.999", True), ("1.001", False)):
                x = [Fraction(str(c)) for c in e.point]
                x[axis] += Fraction(share) * Fraction(np.sqrt(10 * moment))
                assert e.well.contains(x) is kept
    rest, yawed = (36, 56), ("3/5", "4/5", 0, 0, 0, 1)                     # (70 - 60) 9/25/2 = 9/5 above
    assert CRAFT.well.contains([*rest, "14.9", *yawed]) is True            # and 14.9²/35/2
    assert CRAFT.well.contains([*rest, "15", *yawed]) is False
    assert CRAFT.well.contains([36.0, 56.0, 0, 0.6, 0.8, 1e-9, 0, 0, 1]) is True
    assert CRAFT.well.contains([0, 42, 28, 0, "3/5", "4/5", 0, "-4/5", "3/5"]) is False


def test_states_of_a_free_gyrostat():
    """On its momentum sphere, about a minimum and about a maximum of the energy."""
    I, l = np.array([1, 2, 3]), np.array([0.1, 0.2, 1 / 7])
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), ("1/10", "1/5", "1/7")))
    values = sphere(lambda M: (M - l)**2 @ (1 / I) / 2, GRID)
    rng = np.random.default_rng(5)
    for e in filter(held, [x for x in gs.relative_equilibria(scene, {"M": 1}) if x.decision.stable]):
        turn = 1 if e.form.index == 0 else -1
        M0 = np.array([float(x) for x in e.momentum])
        height = turn * float(e.energy) + e.well.barrier_double
        label = parts(turn * values < height - 1e-3)
        for _ in range(30):
            M = rng.normal(size=3)
            M /= np.linalg.norm(M)
            if abs(turn * ((M - l)**2 @ (1 / I) / 2) - height) > 0.02:
                inside = bool(label[cell(M)] and label[cell(M)] == label[cell(M0)])
                assert e.well.contains(M - l) is inside
        if len(e.well.tree.merges) == 1:
            assert float(e.well.tree.merges[0].height) == pytest.approx(e.well.escape_double)


def test_what_is_no_state_of_the_level():
    """Another C1, another abs(M), no unit vector, too few numbers: said with what it is here."""
    found, _, _, _ = scenes(0)
    e = next(filter(held, found))
    x = [float(c) for c in e.point]
    assert e.well.contains(x) is True
    for wrong, said in (([x[0] + 1, *x[1:]], "C1 = M·k"), ([*x[:3], 2, 0, 0], "k·k = 4"),
                        (x[:5], "5 numbers")):
        with pytest.raises(ValuesError, match=said):
            e.well.contains(wrong)
    with pytest.raises(ValuesError, match="n·r = 1"):
        CRAFT.well.contains([0, 70, 0, 0, 1, 0, 0, 1, 0])
    free = gs.relative_equilibria(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))), {"M": 1})
    with pytest.raises(ValuesError, match="M·M = 4"):
        next(e for e in free if e.decision.stable).well.contains((2, 0, 0))
    top = gs.assemble(gs.Gyrostat((1, 1, "8/5"), (0, 0, 0)), gs.axial_potential("k3"))
    sleeping = gs.relative_equilibria(top, {"omega": 2})[0].well
    assert sleeping.tree.merges == () and "tilt alone" in sleeping.tree.reason
    with pytest.raises(ScopeError, match="tilt alone"):
        sleeping.contains([0, 0, 3, 0, 0, 1])


def test_a_state_of_doubles_is_the_next_one_of_its_level():
    """Off it along k by 1e-7, at 1e-9 below the pass and above it: the answer is that of the level."""
    found, V, level, l = scenes(0)
    e, I = next(filter(held, found)), np.array(MOMENTS)
    k = np.array([e.doubles.place[f"k{n}"] for n in (1, 2, 3)])
    across = np.cross(k, (1, 2, 3))
    across *= np.sqrt(2 * e.well.barrier_double / (across**2 @ (1 / I)))
    for share, inside in ((1 - 1e-9, True), (1 + 1e-9, False)):
        for off in (-1e-7, 0, 1e-7):
            pi = (level - k @ l) / (k**2 @ I) * I * k + share * across + off * k
            assert e.well.contains([*pi, *(k * (1 + off / 10))]) is inside
