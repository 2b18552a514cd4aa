"""What holds a motion after a motor has changed a rotor: closed forms, floods and motions of oracles."""
import math
from random import Random

import numpy as np
import pytest
from angle_kept import HeavyBody
from heavy_scenes import drawn, scene_of
from oracles.flooded import cell_of, shape, sphere
from scipy.ndimage import binary_dilation

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError


def test_a_wheel_along_pitch():
    """B of moments (60, 70, 35) is min((10 + l)²/20 or 2 l from 10 on, 75/2); ½ l²/70 has to be less."""
    craft = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(1))
    upright = next(e for e in gs.relative_equilibria(craft, {}) if e.decision.stable)
    most, least = math.sqrt(75 * 70), -10 * math.sqrt(7) / (1 + math.sqrt(7))
    for spin in (most, least):
        near = upright.well.spun_up((0, 0.9999 * spin, 0))
        assert near.directions == upright.directions and near.scene.body.gyrostatic_momentum[1] != 0
        assert upright.well.spun_up((0, 1.0001 * spin, 0)) is None
    with pytest.raises(ValuesError, match="three"):
        upright.well.spun_up((1, 2))


@pytest.mark.slow
@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(12))
def test_a_heavy_body_stays_in_the_flooded_part(seed):
    """The motion with the new rotor, at the same k and M, runs in the flooded part round what is returned."""
    chance, held = Random(seed), 0
    while held < 3:
        I, l, c, Q, level = drawn(chance, False)
        change = [x / 4 for x in drawn(chance, False)[1]]
        e = next(e for e in gs.relative_equilibria(scene_of(I, l, c, Q), {"C1": level}) if not e.form.index)
        if (found := e.well.spun_up(change)) is None:
            continue
        held += 1
        body = HeavyBody(I, [a + b for a, b in zip(l, change)], c, Q)
        k, there = (np.array([x.doubles.place[f"k{n}"] for n in (1, 2, 3)]) for x in (e, found))
        pi = body.I * k * e.doubles.rates["omega"] - np.array(change, dtype=float)

        def V(x, body=body, level=float(level)):
            return x @ body.c + (level - x @ body.l)**2 / (2 * x**2 @ body.I)

        top = V(there) + found.well.barrier_double
        values = sphere(lambda x, V=V, there=there: np.where(x @ there > 1 - 1e-3, V(there) - 100, V(x)))
        inside, _ = shape(values, top)
        inside = binary_dilation(np.hstack([inside] * 3), np.ones((3, 3)))[:, 360:720]
        path = body.followed(k, pi, 15)
        assert V(path).max() < top and all(inside[cell_of(x)] for x in path)


def test_free_bodies_and_tops():
    """A free spin keeps its axis while it is the least energy; of a top only the tilt is known."""
    free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/4")))
    spin = next(e for e in gs.relative_equilibria(free, {"M": 1}) if e.momentum == (0, 0, 1))
    for change in ("1/10", 1):                             # with l = 5/4 the trace at the pass is 0
        assert spin.well.spun_up((0, 0, change)).momentum == (0, 0, 1)
    top = gs.assemble(gs.Gyrostat((1, 1, "8/5"), (0, 0, 0)), gs.axial_potential("k3"))
    with pytest.raises(ScopeError, match="tilt"):
        gs.relative_equilibria(top, {"omega": "3/2"})[0].well.spun_up((0, 0, 1))
