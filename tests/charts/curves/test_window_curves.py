"""Curves in windows, and what decided each point: held against exact verdicts and normal forms."""
from fractions import Fraction as F

import numpy as np
import pytest
from slow import slow

import gyrostat as gs
from gyrostat.charts import stability_chart
from gyrostat.charts.codes import CODE_OF, CURVES, RUNGS
from gyrostat.charts.curves.window_curves import WITHIN
from gyrostat.errors import ScopeError
from gyrostat.stability.decision import Rung

TWISTS = RUNGS[Rung.TWIST_POSITIVE], RUNGS[Rung.TWIST_NEGATIVE]
WINDOW = "the amended potential has a maximum, and gyroscopic forces stabilise it"


def upright():
    """The sleeping asymmetric gyrostat."""
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l"))),
                        gs.general_potential(lambda a, b, c: gs.symbol("m0") * c))
    return gs.analyze(gs.equilibrium(scene, (0, 0, gs.symbol("I3") * gs.symbol("omega"), 0, 0, 1)))


def rotations():
    """Permanent rotations of a heavy gyrostat by their direction."""
    field = gs.general_potential(lambda *k: sum(gs.symbol(f"c{n}") * x for n, x in enumerate(k, 1)))
    scene = gs.assemble(gs.Gyrostat((3, 4, 5), (-1, 2, -1)), field)
    return gs.analyze(gs.permanent_rotation(scene, gs.stereographic()))


CASES = {"upright": (upright, ("omega", -3, 3), ("l", -10, 10), {"I1": 9, "I2": 5, "I3": 7, "m0": 3}),
         "rotations": (rotations, ("u1", -2, 2), ("u2", -2, 2), {"omega": -1, "sigma": -2}),
         "decreasing": (rotations, ("u1", -1, 2), ("omega", 1, -3), {"u2": "1/3", "sigma": -2})}


@pytest.fixture(scope="module")
def charts():
    return {}


def chart_of(charts, name, n):
    """The report and the chart, made once."""
    if (name, n) not in charts:
        made, x, y, fixed = CASES[name]
        report = made()
        charts[name, n] = report, stability_chart(
            report, x=(x[0], np.linspace(*x[1:], n)), y=(y[0], np.linspace(*y[1:], n)), fixed=fixed,
            progress=False)
    return charts[name, n]


def values_of(chart, x, y):
    """The numbers at a point, exact."""
    up, across = chart.verdict.dims
    fixed = {name: c.attrs["exact"] for name, c in chart.coords.items() if c.ndim == 0}
    return fixed | {across: x, up: y}


def vertices(chart, name):
    """The points of a curve, with the step of the grid along the edge on which each lies: (x, y, dx, dy)."""
    up, across = (chart[dim].values for dim in chart.verdict.dims)
    for x, y, code in zip(chart.curve_x.values, chart.curve_y.values, chart.curve.values):
        if code == CURVES[name]:
            row, column = y in up, x in across
            assert row or column
            yield (float(x), float(y), 0 if column else float(abs(across[1] - across[0])),
                   0 if row else float(abs(up[1] - up[0])))


def some(found, most):
    """Some of a list, evenly spaced."""
    return [found[n] for n in sorted({int(n) for n in np.linspace(0, len(found) - 1, most)})]


def margin(form, first, second):
    """(m n)² p² − (m² + n²)² q of the signed frequencies, exact."""
    one, two = (x**2 for x in form.frequencies)
    return ((first * second)**2 * (one + two)**2 - (first**2 + second**2)**2 * one * two).expand()


@pytest.mark.slow
@pytest.mark.parametrize(("name", "n", "most"), [("upright", 21, 2), *slow(
    ("upright", 61, 40), ("rotations", 41, 20), ("decreasing", 45, 20))])
def test_d4_changes_its_sign_at_each_vertex(charts, name, n, most):
    """Exact D4 on both sides, not through a pole: the margin of 1:2 has one sign."""
    report, chart = chart_of(charts, name, n)
    found = list(vertices(chart, "D4_zero"))
    assert len(found) > 3
    for x, y, dx, dy in some(found, most):
        assert (dx == 0) != (dy == 0)
        sides = []
        for side in (-1, 1):
            at = (F(v) + side * F(WITHIN) * F(d) / 2 for v, d in ((x, dx), (y, dy)))
            sides.append(report.normal_form(values_of(chart, *at)))
        one, two = (form.twists[0] for form in sides)
        assert one.is_Rational and two.is_Rational and one * two < 0
        assert margin(sides[0], 1, 2) * margin(sides[1], 1, 2) > 0
        assert report.verdict(values_of(chart, x, y)).rung.value.startswith("D")


@pytest.mark.slow
@pytest.mark.parametrize(("name", "n", "most"), [("upright", 21, 2), *slow(
    ("upright", 61, 30), ("rotations", 41, 12), ("decreasing", 45, 12))])
@pytest.mark.parametrize(("curve", "pair"), [("resonance_1_2", (1, 2)), ("resonance_1_3", (1, 3))])
def test_frequencies_are_in_resonance_at_each_vertex(charts, name, n, most, curve, pair):
    """The exact margin changes its sign within some ulp, inside a window."""
    report, chart = chart_of(charts, name, n)
    found = list(vertices(chart, curve))
    assert len(found) > 3
    for x, y, dx, dy in some(found, most):
        signs = set()
        for side in (-4, 4):
            at = [v + side * np.spacing(v) * bool(d) for v, d in ((x, dx), (y, dy))]
            values = values_of(chart, *map(float, at))
            decision = report.verdict(values)
            assert WINDOW in decision.reason
            try:
                signs.add(float(margin(report.normal_form(values), *pair).evalf(60)) > 0)
            except ScopeError:                             # on the resonance itself
                signs |= {True, False}
        assert signs == {True, False}


@pytest.mark.parametrize(("name", "n"), slow(("upright", 21), ("rotations", 41), ("decreasing", 45)))
def test_no_crossing_is_left_out(charts, name, n):
    """Neighbours held by D4 of other signs have a vertex of D4 = 0 or of 1:2, its pole, between them."""
    _, chart = chart_of(charts, name, n)
    up, across = (chart[dim].values for dim in chart.verdict.dims)
    places = {name: {(x, y) for x, y, _, _ in vertices(chart, name)} for name in CURVES}
    drawn = places["D4_zero"] | places["resonance_1_2"]
    rung, left = chart.rung.values, 0
    for axis in (0, 1):
        signs = np.where(rung == TWISTS[0], 1, np.where(rung == TWISTS[1], -1, 0))
        for i, j in np.argwhere(np.take(signs, range(n - 1), axis) * np.take(signs, range(1, n), axis) < 0):
            low, high = (sorted((v[k], v[k + 1])) if on else (v[k], v[k])
                         for v, k, on in ((across, j, axis == 1), (up, i, axis == 0)))
            left += not any(low[0] <= x <= low[1] and high[0] <= y <= high[1] for x, y in drawn)
    assert left <= 2                                       # beside where the two curves meet


@pytest.mark.slow
@pytest.mark.parametrize(("name", "n", "most"), [("upright", 21, 12), *slow(
    ("upright", 61, 200), ("rotations", 41, 200), ("decreasing", 45, 200))])
def test_each_rung_is_what_decided(charts, name, n, most):
    """As Report.verdict says it; the verdict too."""
    report, chart = chart_of(charts, name, n)
    up, across = (chart[dim].values for dim in chart.verdict.dims)
    rng = np.random.default_rng(3)
    rungs = chart.rung.values
    occurring = np.unique(rungs)
    assert {RUNGS[Rung.SPECTRUM], *TWISTS} <= {*occurring.tolist()}
    for code in occurring:
        places = np.argwhere(rungs == code)
        for i, j in places[rng.permutation(len(places))[:most // len(occurring)]]:
            decision = report.verdict(values_of(chart, float(across[j]), float(up[i])))
            assert CODE_OF[decision.verdict] == chart.verdict.values[i, j]
            assert RUNGS[decision.rung] == code


@pytest.mark.slow
def test_a_store_is_the_chart_in_memory(charts, tmp_path):
    """The rungs block by block, and the curves."""
    report, chart = chart_of(charts, "upright", 21)
    x, y = ((name, chart[name].values) for name in reversed(chart.verdict.dims))
    for _ in range(2):                                     # written, then continued
        stored = stability_chart(report, x=x, y=y, fixed=CASES["upright"][3], store=tmp_path / "a.zarr",
                                 progress=False)
        assert stored.load().equals(chart)


@pytest.mark.parametrize(("tilted", "x", "fixed"), [
    (False, ("pi3_0", [1.0, 2.0, 3.0]), {"I1": 1, "dU": 1}),
    (True, ("k3", [0.0, 0.5, 0.75]), {"I1": 1, "I3": "1/2", "omega": 1, "d2U": 0})])
def test_a_body_of_revolution_has_no_windows(e1, e3, tilted, x, fixed):
    """Its spin is divided out, and every point decided without a normal form."""
    chart = stability_chart(e3 if tilted else e1, x=x, y=("l", [0.0, 0.5]), fixed=fixed)
    assert "boundary_x" in chart and not {"rung", "curve_x", "curve_y", "curve"} & {*chart.variables}
