"""The sign of D4 at points in a row: by averages in arrays, by the normal form at each point."""
import numpy as np
import pytest

import gyrostat as gs
from gyrostat.charts.signs.stabilized_points import held, leaf, twist_times_pole
from gyrostat.charts.signs.verdict_arrays import grid_for

BODY = gs.Gyrostat((3, 4, 5), (-1, 2, -1))


def rotations():
    """Of a heavy gyrostat, in any direction: h3 is not 0, and any axis may be the one farthest from k."""
    field = gs.general_potential(lambda *k: sum(gs.symbol(f"c{n}") * x for n, x in enumerate(k, 1)))
    return gs.analyze(gs.permanent_rotation(gs.assemble(BODY, field), gs.stereographic()))


def upright():
    """Of an asymmetric body, on whose axis h3 = 0."""
    body = gs.Gyrostat((5, 4, 3), (0, 0, gs.symbol("l")))
    return gs.analyze(gs.upright(gs.assemble(body, gs.general_potential(lambda *k: gs.symbol("m0") * k[2]))))


@pytest.mark.slow
@pytest.mark.parametrize(("report", "ranges", "fixed", "signs"), [
    (rotations, {"u1": (-2, 2), "u2": (-2, 2)}, {"omega": -1, "sigma": -2}, (1, -1)),
    (upright, {"m0": (0, 8), "pi3_0": (-20, 20)}, {"l": 1}, (1,))], ids=["any direction", "upright"])
def test_the_sign_of_d4_is_that_of_the_normal_form(report, ranges, fixed, signs):
    """Where no sign is claimed, another theorem decides than Arnold's."""
    report, rng = report(), np.random.default_rng(8)
    given = {name: rng.uniform(*ends, 150) for name, ends in ranges.items()} | fixed
    grid = grid_for(report, given)
    found = held(report, grid)
    product = twist_times_pole(report, {s: leaf(grid, s) for s in grid.values}, 150)
    for n in [*np.flatnonzero(found)[:40], *np.flatnonzero(found == 0)[:10]]:
        values = {name: float(x[n]) if np.ndim(x) else x for name, x in given.items()}
        if not found[n]:
            assert "D4" not in report.verdict(values).rung.value
            continue
        form = report.normal_form(values)
        assert np.sign(float(form.twists[0])) == found[n]
        slow, fast = sorted(abs(float(x)) for x in form.frequencies)
        assert np.sign(product[n]) == found[n] * np.sign(fast - 2 * slow)
    assert {*found} == {0, *signs}
