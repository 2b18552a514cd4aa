"""Reports, regions and stores that several tests of charts read."""
import shutil
from fractions import Fraction
from pathlib import Path

import pytest
from charts.checked_arrays import axial
from charts.stored_charts import GRID
from sympy import chebyshevt, cos, exp, log, pi, sqrt

import gyrostat as gs
from gyrostat.charts.chart import stability_chart
from gyrostat.charts.signs import compiled_margins, verdict_arrays
from gyrostat.charts.stores import chart_stores

k3, m0, a, b, c = map(gs.symbol, ("k3", "m0", "a", "b", "c"))


@pytest.fixture
def tiny_blocks(monkeypatch):
    """Blocks of seven points."""
    for module in (verdict_arrays, compiled_margins):
        monkeypatch.setattr(module, "NUMPY_BLOCK", 7)
        monkeypatch.setattr(module, "NUMBA_BLOCK", 7)


@pytest.fixture(scope="session")
def reports(scene, general, free):
    """By name; each derived once."""
    uniform, newtonian = (gs.assemble(gs.symmetric_gyrostat(), f)
                          for f in (gs.uniform_field(), gs.newtonian_field(2)))
    six, twenty = axial(a * k3 + b * k3**6), axial(a * chebyshevt(20, k3))
    made = {
        "E1": gs.upright(scene), "E2": gs.hanging(scene), "E3": gs.inclined(scene),
        "at rest": gs.static_tilt(scene),
        "E1 rate": gs.upright(scene, spin="omega3_0"), "E1 uniform": gs.upright(uniform),
        "E3 uniform": gs.inclined(uniform),
        "at rest, uniform": gs.static_tilt(uniform), "E3 uniform, k3": gs.inclined(uniform, eliminate="k3"),
        "E1 Newtonian": gs.upright(newtonian), "E2 Newtonian": gs.hanging(newtonian),
        "E3 Newtonian": gs.inclined(newtonian),
        "E1 degree 6": gs.upright(six), "E3 degree 6": gs.inclined(six), "E3 degree 20": gs.inclined(twenty),
        "at rest, numbers": gs.static_tilt(axial(k3**4 - k3**2)), "E1 pole": gs.upright(axial(a / (c - k3))),
        "E2 pole": gs.hanging(axial(a / (c - k3))), "E3 pole": gs.inclined(axial(1 / (c - k3))),
        "E1 log": gs.upright(axial(log(c - k3))),
        "E1 exp": gs.upright(axial(exp(b * k3))), "E3 exp": gs.inclined(axial(a * exp(50 * k3))),
        "E1 root": gs.upright(axial(sqrt(c - k3))),
        "free 3": gs.principal_rotation(free, 3)}
    return {"general": general} | {name: gs.analyze(eq) for name, eq in made.items()}


@pytest.fixture(scope="session")
def tilted_margin(e3):
    ((condition,),) = e3.sufficient.alternatives
    return condition


@pytest.fixture(scope="session")
def free_body(free):
    return gs.analyze(gs.principal_rotation(free, 3))


@pytest.fixture(scope="session")
def uniform_tilt():
    """At rest in the uniform field: m0 = 0, stable where l ≠ 0."""
    return gs.analyze(gs.static_tilt(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))


@pytest.fixture(scope="session")
def heavy():
    """E1 of the heavy gyrostat: stable for (π3 + l)² > 4 I1 m0, its boundary too."""
    return gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))


@pytest.fixture(scope="session")
def regions(e1, e2, e3, at_rest, asymmetric, free):
    """Reports, and for each a region with several kinds of verdict."""
    def of(family, potential):
        return gs.analyze(family(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(potential))))

    third = Fraction(1, 3)
    tilted = {"I1": 1, "I3": "1/2", "omega": (-2, 2), "k3": (-1, 1)}
    return {
        "E1": (e1, {"I1": (-third, 1), "l": (-2, 2), "pi3_0": 1, "dU": (-1, 1)}),
        "E2": (e2, {"I1": 1, "l": (-2, 2), "pi3_0": (-2, 2), "dU": (-1, 1)}),
        "E3": (e3, {"I1": 1, "I3": (third, 2), "l": 1, "omega": (-2, 2), "k3": (-1.25, 1.25), "d2U": -2}),
        "E3 at rest": (at_rest, {"I1": 1, "l": (-2, 2), "k3": (-1, 1), "d2U": (-2, 2)}),
        "uniform field": (of(gs.inclined, m0 * k3), {**tilted, "m0": (-1, 1)}),
        "tilt eliminated": (gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(),
                                                               gs.axial_potential(m0 * k3 + a * k3**2)),
                                                   "k3")),
                            {"I1": 1, "I3": (0, 2), "l": 1, "omega": (-2, 2), "m0": 1, "a": 1}),
        "quartic": (of(gs.inclined, k3**4 - k3**2 + k3 / 3), tilted),
        "pole": (of(gs.inclined, 1 / (k3 - third)), tilted),
        "steep exponential": (of(gs.inclined, exp(50 * k3)), tilted),
        "exponential": (of(gs.inclined, -exp(a * k3)), {**tilted, "a": (-5, 1)}),
        "logarithm": (of(gs.inclined, log(k3 + third) + cos(3 * k3)), tilted),
        "logarithm at E1": (of(gs.upright, log(a + k3 - 2)),
                            {"I1": 1, "l": 1, "pi3_0": (-2, 2), "a": (0, 3)}),
        "irrational numbers": (of(gs.inclined, a * k3**2),
                               {"I1": sqrt(2), "I3": pi, "omega": (-2, 2), "k3": (-1, sqrt(3) / 2),
                                "a": (-2, 2)}),
        "general body": (gs.analyze(gs.upright(asymmetric)),
                         {"I1": 1, "I2": 2, "I3": "5/2", "m0": 1, "m1": (-1, 1), "l": (-4, 4),
                          "pi3_0": (-4, 4)}),
        "free body": (gs.analyze(gs.principal_rotation(free, 3)),
                      {"I1": 1, "I2": 2, "I3": (1, 3), "l": 1, "omega3_0": (-2, 2)}),
        "a margin that is a square": (e1, {"I1": 1, "dU": 0, "l": (-2, 2), "pi3_0": (-1, 1)}),
        "minus a square": (of(gs.upright, a**2 * k3 + (k3 - 1) ** 2),
                           {"I1": (1, 2), "l": 0, "pi3_0": 0, "a": (-1, 1)}),
        "nothing but a spin": (of(gs.upright, k3), {"I1": 1, "l": 1, "pi3_0": (-4, 4)}),
    }


@pytest.fixture
def ten_blocks(monkeypatch):
    """Blocks of seven rows: ten of them."""
    monkeypatch.setattr(chart_stores, "POINTS", 7 * 90)


@pytest.fixture
def written(monkeypatch):
    """The numbers of the blocks that are computed in this process."""
    numbers, write = [], chart_stores.write_block
    monkeypatch.setattr(chart_stores, "write_block", lambda marks, chart, arrays, n: numbers.append(n)
                        or write(marks, chart, arrays, n))
    return numbers


@pytest.fixture(scope="session")
def memory(e1):
    """The chart in memory."""
    return stability_chart(e1, **GRID)


@pytest.fixture(scope="session")
def finished(e1, tmp_path_factory):
    """A store of ten blocks, written once."""
    path = tmp_path_factory.mktemp("finished") / "chart.zarr"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(chart_stores, "POINTS", 7 * 90)
        stability_chart(e1, **GRID, store=path)
    return path


@pytest.fixture
def store(ten_blocks, finished, tmp_path):
    """A copy of it, to be damaged."""
    return Path(shutil.copytree(finished, tmp_path / "chart.zarr"))
