"""Wells in the frame of a rotation: numbers of another program, floods, and motions after any kick."""
import math
from random import Random

import numpy as np
import pytest
from angle_kept import HeavyBody
from heavy_scenes import drawn, scene_of
from oracles import heavy
from oracles.flooded import cell_of, shape, sphere
from scipy.ndimage import binary_dilation
from sympy import CRootOf

import gyrostat as gs
from gyrostat.equilibria.wells.frame import index_at_rate
from gyrostat.errors import ScopeError, ValuesError

HEAVY = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), gs.general_potential("k1 + k2 + k3"))


# computed by Newton's method at 40 digits and by paths, in another program
@pytest.mark.parametrize(("values", "barrier", "kick"), [
    ({"C1": "5/2"}, 3.03252457133102, 2.46273204849046),
    ({"omega": "1/2"}, 3.01851780762505, 2.45703797594789)])
def test_numbers_that_another_program_has_found(values, barrier, kick):
    """Of a rotation whose rate is of degree 18, and of one whose rate is a fraction but C1 is none."""
    well = next(e for e in gs.relative_equilibria(HEAVY, values) if e.form.index == 0).well
    assert well.frame.barrier_double == pytest.approx(barrier, rel=3e-15)
    assert well.kick() == pytest.approx(kick, rel=3e-15) and well.frame.kind == "summit"
    assert "omega" not in values or float(well.frame.barrier.evalf(20)) == well.frame.barrier_double
    assert well.frame.escape == math.inf
    each = [well.kick([int(n == m) for m in range(3)]) for n in range(3)]
    assert each == pytest.approx([math.sqrt(2 * barrier * I) for I in (1, 2, 3)], rel=1e-14)
    assert all(e.rates["omega"] == well.rotation.rates["omega"] for e in well.frame.points)
    assert "up to the pass at k = (" in str(well.frame) and f"less than {kick:.6}"[:-1] in str(well.frame)
    with pytest.raises(ValuesError, match="direction"):
        well.kick((0, 0, 0))


def minima(seed, quadratic=True):
    """Rotations of random scenes with a well in their frame: (oracle, k, rate, well)."""
    chance = Random(seed)
    while True:
        I, l, c, Q, number = drawn(chance, quadratic and chance.random() < 0.5)
        scene = scene_of(I, l, c, Q)
        asked = chance.choice(["omega", "C1"])
        for e in gs.relative_equilibria(scene, {asked: number / 4}):
            if e.form.index == 0 and e.well.frame.found.passes and e.well.frame.barrier_double > 0.05:
                k = np.array([e.doubles.place[f"k{n}"] for n in (1, 2, 3)])
                yield HeavyBody(I, l, c, Q), k, e.doubles.rates["omega"], e.well.frame


@pytest.mark.slow
@pytest.mark.few(2)
@pytest.mark.parametrize("seed", range(12))
def test_it_is_that_of_a_flood(seed):
    """Below its barrier it is a disc; above, it has a hole, or a neighbour, or is all."""
    for (body, k, rate, frame), _ in zip(minima(seed), range(3)):
        def V(x, body=body, rate=rate):
            return body.turning(x, rate)

        low, rise = float(V(k)), frame.barrier_double
        values = sphere(lambda x, V=V, k=k, low=low: np.where(x @ k > 1 - 1e-3, low - 100, V(x)))
        inside, rest = shape(values, low + 0.97 * rise)
        assert rest == 1
        heights = [float(h.mid()) for h in frame.heights]
        if any(rise < h < 1.06 * rise for h in heights):
            continue
        before, (inside, rest) = inside.sum(), shape(values, low + 1.03 * rise)
        assert rest == 0 if frame.kind == "summit" else rest > 1 or inside.sum() > before
        ends = [np.array([o.doubles.place[f"k{n}"] for n in (1, 2, 3)]) for o in frame.beyond]
        if frame.kind == "well":
            assert all(inside[cell_of(x)] for x in ends)


@pytest.mark.slow
@pytest.mark.few(2)
@pytest.mark.parametrize("seed", range(20))
def test_after_any_weaker_kick_k_stays_over_it(seed):
    """Ten motions after kicks of 0.99 of the bound, of every direction, do not leave the flooded part."""
    body, k, rate, frame = next(minima(100 + seed))
    random = np.random.default_rng(seed)
    pi, off = body.rotation(k, rate)
    assert off < 1e-12
    V0, bound = body.turning(k, rate), frame.kick()
    values = sphere(lambda x: np.where(x @ k > 1 - 1e-3, V0 - 100, body.turning(x, rate)))
    inside, _ = shape(values, V0 + frame.barrier_double)
    inside = binary_dilation(np.hstack([inside] * 3), np.ones((3, 3)))[:, 360:720]
    for _ in range(10):
        kick = random.normal(size=3)
        path = body.followed(k, pi + 0.99 * bound * kick / np.linalg.norm(kick), 15)
        assert body.turning(path, rate).max() < V0 + frame.barrier_double
        assert all(inside[cell_of(x)] for x in path)


@pytest.mark.slow
@pytest.mark.few(3)
@pytest.mark.parametrize("seed", range(30))
def test_rotations_of_an_algebraic_rate(seed):
    """At the rates of a level all are found, with the index of V, as by Newton's method from 300 starts."""
    chance = Random(seed)
    I, l, c, Q, level = drawn(chance, chance.random() < 0.6)
    scene = scene_of(I, l, c, Q)
    e = chance.choice(gs.relative_equilibria(scene, {"C1": level}))
    assert e.rates["omega"].atoms(CRootOf)
    terms = {tuple((i == n) + (j == n) for n in range(3)): float(Q[i][j]) * (1 if i != j else 0.5)
             for i in range(3) for j in range(i, 3)}
    terms |= {tuple(int(i == n) for n in range(3)): float(x) for i, x in enumerate(c)}
    slope = heavy.at_rate(np.diag([float(x) for x in I]), np.array(l, float), terms, e.doubles.rates["omega"])
    theirs = heavy.critical(slope)
    found = gs.relative_equilibria(scene, {"omega": e.rates["omega"]})
    assert len(found) == len(theirs)
    for other in found:
        k = np.array([other.doubles.place[f"k{n}"] for n in (1, 2, 3)])
        near = min(theirs, key=lambda x, k=k: abs(x - k).max())
        assert abs(near - k).max() < 1e-9
        assert (-1)**index_at_rate(other) == heavy.index(slope, near)


def test_what_has_none_says_why():
    """No minimum in the frame; a cubic field at a rate that is no fraction; a plane askew; a satellite."""
    scene = gs.assemble(gs.Gyrostat((2, 1, "3/2"), (1, 0, 0)), gs.general_potential("k1"))
    spun = next(e for e in gs.relative_equilibria(scene, {"C1": "3/2"}) if e.place["k3"] == 1)
    assert spun.form.index == 0 and spun.well.frame.barrier is None
    with pytest.raises(ScopeError, match="no strict minimum"):
        spun.well.kick()
    cubic = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), gs.general_potential("k1^3 + k2 + k3"))
    held = next(e for e in gs.relative_equilibria(cubic, {"omega": "1/2"}) if e.form.index == 0)
    assert held.well.barrier is None and held.well.kick() > 0
    held = next(e for e in gs.relative_equilibria(cubic, {"C1": "5/2"}) if e.form.index == 0)
    with pytest.raises(ScopeError, match="rational"):
        held.well.kick()
    oblique = gs.assemble(gs.Gyrostat([[3, 1, 0], [1, 3, 0], [0, 0, 5]], ("1/5", "1/5", "1/3")),
                          gs.general_potential("k1 + k2 + k3/2"))
    held = next(e for e in gs.relative_equilibria(oblique, {"C1": "1/2"}) if e.form.index == 0)
    assert held.well.barrier_double > 0 and "plane of" in str(held.well.frame)
    craft = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(1))
    assert "permanent rotation" in gs.relative_equilibria(craft, {})[0].well.frame.reason
