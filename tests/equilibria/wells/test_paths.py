"""Paths down are proved or there are none, and the tree of the wells follows from their ends alone."""
import itertools

import numpy as np
import pytest

import gyrostat as gs
from gyrostat.equilibria.wells import joining
from gyrostat.equilibria.wells import paths as module
from gyrostat.equilibria.wells.landscape import landscape_of
from gyrostat.equilibria.wells.merge_tree import Join, Outcome, joins, outcome
from gyrostat.equilibria.wells.paths import Paths

SATELLITE = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(1))
STABLE = next(e for e in gs.relative_equilibria(SATELLITE, {}) if e.decision.stable)


@pytest.fixture
def paths():
    """Those of the satellite."""
    landscape = landscape_of(STABLE)
    return Paths(landscape, [e.form.index for e in landscape.points])


def test_a_segment_over_a_ridge_is_not_below(paths):
    """Between two minima lies a pass; below the level of a summit the same segment is proved."""
    a, b = paths.minima[:2]
    level = paths.values[a] + 1
    start, end = paths.places[a], paths.places[b]
    assert not paths._below(start, end, level)
    assert paths._below(start, [2 * c for c in start], level)     # an attitude, however long
    assert paths._below(start, end, max(paths.values, key=lambda v: float(v.mid())) + 1)


def test_no_first_step_goes_up(paths):
    """V is concave along the ways down alone; at a minimum no direction is one."""
    saddle = paths.indices.index(1)
    down = paths._downward(saddle)[0]
    assert paths._first(paths.places[saddle], down) and len(paths._downward(saddle)) == 1
    across = np.linalg.svd(np.vstack([paths.near[saddle], down]))[2][2:]
    assert [paths._first(paths.places[saddle], u) for u in across] == [None, None]
    minimum = paths.minima[0]
    assert all(paths._first(paths.places[minimum], u) is None
               for u in np.linalg.svd(paths.near[minimum][None])[2][1:])


def test_a_way_that_is_not_found_is_said(monkeypatch):
    """Then there is a bound from below, the height of the point that is not known, and no kick."""
    monkeypatch.setattr(module, "STEPS", 0)
    e = next(e for e in gs.relative_equilibria(SATELLITE, {}) if e.decision.stable)
    assert e.well.barrier is None and e.well.escape is None and "not proved" in e.well.reason
    assert e.well.bound == pytest.approx(5) and e.well.bound <= 5


def test_the_rows_of_a_quaternion_are_those_of_the_attitude(paths):
    """Of every critical point, whichever component is the largest."""
    for e, q in zip(paths.landscape.points, paths.near):
        w, x, y, z = q / np.linalg.norm(q)
        turn = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                         [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                         [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
        n, r = ([e.doubles.place[f"{v}{m}"] for m in (1, 2, 3)] for v in "nr")
        rows = np.array([np.cross(n, r), n, r])
        np.testing.assert_allclose(turn, rows, atol=1e-12)


def joined(heights, indices, ends, minimum):
    """The outcome of a graph, by the lowest top of all chains of saddles from one minimum to another."""
    minima = [n for n, index in enumerate(indices) if index == 0]
    saddles = [n for n, index in enumerate(indices) if index == 1]
    best = dict.fromkeys(minima, np.inf) | {minimum: heights[minimum]}
    for count in range(1, len(saddles) + 1):
        for chain in itertools.permutations(saddles, count):
            here = {minimum}
            for s in chain:
                here |= set(ends[s]) if here & set(ends[s]) else set()
            top = max(heights[s] for s in chain)
            for m in here:
                best[m] = min(best[m], top)
    other = [best[m] for m in minima if m != minimum]
    touched = [max(heights[n], min(best[m] for m in ends[n])) for n in range(len(indices)) if indices[n]]
    return min(touched), min(other, default=np.inf)


@pytest.mark.parametrize("seed", range(40))
def test_the_tree_is_that_of_all_chains(seed):
    """On random graphs of minima, saddles and summits, with values that coincide."""
    rng = np.random.default_rng(seed)
    low, high, tops = rng.integers(2, 5), rng.integers(1, 5), rng.integers(0, 3)
    indices = [0] * low + [1] * high + [2] * tops
    ends = {n: [int(m) for m in rng.integers(0, low, 2 if indices[n] == 1 else 1)]
            for n in range(low, len(indices))}
    heights = [int(h) for h in rng.integers(0, 3, low)]
    for n in range(low, len(indices)):
        heights.append(max(heights[m] for m in ends[n]) + int(rng.integers(1, 4)))
    levels = [[n for n in range(len(indices)) if heights[n] == h] for h in sorted(set(heights))]
    found = outcome(0, levels, indices, ends.get)
    barrier, escape = joined(heights, indices, ends, 0)
    assert heights[found.passes[0]] == barrier if found.passes else barrier >= escape == np.inf
    assert (heights[found.escape] if found.escape is not None else np.inf) == escape
    assert (found.kind == "well") == (barrier == escape < np.inf)


def test_what_is_degenerate_stops_the_tree_above_the_minimum_alone():
    """Below it nothing is asked of it."""
    levels, indices, ends = [[0], [2], [1], [3]], [0, 0, None, 1], {3: [0, 1]}
    assert outcome(1, levels, indices, ends.get) == Outcome((3,), "well", 3, (0,))
    assert outcome(0, levels, indices, ends.get) == Outcome(stopped=2)


def test_points_of_two_kinds_at_one_value_are_told_to_be_tied():
    """A pass to another well and one that closes round a summit: which comes first must be known."""
    indices, ends = [0, 0, 1, 1], {2: [0, 1], 3: [0, 0]}
    assert outcome(0, [[1], [0], [2, 3]], indices, ends.get).tied
    assert not outcome(0, [[1], [0], [2], [3]], indices, ends.get).tied
    assert outcome(0, [[1], [0], [3], [2]], indices, ends.get) == Outcome((3,), "round", 2, (1,))
    alike = [0, 0, 1, 1], {2: [0, 1], 3: [1, 0]}
    assert not outcome(0, [[1], [0], [2, 3]], alike[0], alike[1].get).tied


def test_a_tie_is_broken_exactly():
    """Points of one class of balls, told apart by their energies; of a maximum the other way round."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), gs.general_potential("k1 + k2 + k3"))
    known = next(e for e in gs.relative_equilibria(scene, {"C1": "5/2"}) if e.form.index == 0).well
    places = sorted(range(len(known.points)), key=lambda n: float(known.heights[n].mid()))
    level = joining.told_apart(known.points, places[::-1], known.value)
    assert level == [[n] for n in places]
    assert joining.told_apart(known.points, places, lambda e: -e.energy) == [[n] for n in places[::-1]]
    assert joining.told_apart([STABLE, STABLE], [0, 1], known.value) == [[0, 1]]


def test_how_wells_join():
    """A saddle from a well to itself joins nothing; three wells over one value become one at once."""
    indices, ends = [0, 0, 0, 1, 1, 1, 2], {3: [0, 0], 4: [1, 0], 5: [2, 1]}
    levels = [[0], [1, 2], [3]]
    assert joins([*levels, [4], [5, 6]], indices, ends.get) == (
        [Join((4,), ((0,), (1,))), Join((5,), ((0, 1), (2,)))], None)
    assert joins([*levels, [4, 5], [6]], indices, ends.get) == ([Join((4, 5), ((0,), (1,), (2,)))], None)
    assert joins([*levels, [4], [5, 6]], [*indices[:5], None, 2], ends.get) == ([Join((4,), ((0,), (1,)))], 5)
