"""The curves between verdicts: on the exact zeros, complete, and nowhere else."""
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from sympy import Poly, exp, log, sin, sqrt

import gyrostat as gs
from gyrostat.charts.chart import stability_chart
from gyrostat.charts.curves import contours
from gyrostat.charts.curves.contours import boundary, thinned
from gyrostat.notation import symbol


@pytest.fixture(scope="module")
def cases(e1, e3, upright_asymmetric):
    """Charts with curves of the second to the sixth degree, some through points of the grid, or beside them
    by a rounding error.
    """
    newton = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.newtonian_field(2)),
                                    eliminate="k3"))
    whole, tenths = np.linspace(-4, 4, 33), np.linspace(-3, 3, 61)
    one = {"I1": 1, "dU": 1}
    # stable on its boundary
    top = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    return [(e1, ("pi3_0", whole), ("l", whole), one),
            (top, ("pi3_0", whole), ("l", whole), {"I1": 1, "m0": 1}),
            (e1, ("pi3_0", tenths), ("l", tenths[::-1]), one),
            (e1, ("dU", np.linspace(-1, 2, 50)), ("pi3_0", tenths), {"I1": "1/3", "l": "1/7"}),
            (e3, ("k3", np.linspace(-1.2, 1.2, 61)), ("d2U", np.linspace(-6, 2, 53)),
             {"I1": 1, "I3": "1/2", "l": "0.3", "omega": 1}),
            (newton, ("l", np.linspace(-3, 3, 101)), ("omega", np.linspace(-3, 3, 97)),
             {"I1": 2, "I3": 1, "m0": 1, "m1": "1/3"}),
            (upright_asymmetric, ("m0", np.linspace(-4, 8, 25)), ("l", np.geomspace(0.1, 8, 20)),
             {"I1": 2, "I2": "3/2", "I3": 1, "m1": "1/4", "pi3_0": 1})]


def edges(verdict, x, y, points):
    """Each edge of the grid between two verdicts, with the points on the line of the grid that it lies on."""
    for values, others, rows, (along, across) in ((x, y, verdict, points), (y, x, verdict.T, points[::-1])):
        for other, row in zip(others, rows):
            for j in np.nonzero((row[1:] != row[:-1]) & (row[1:] != 0) & (row[:-1] != 0))[0]:
                yield *sorted(values[j:j + 2]), along[across == other]


def drawn(case):
    """The chart, its points without the gaps, and its margins as polynomials in x and y."""
    report, x, y, fixed = case
    chart = stability_chart(report, x=x, y=y, fixed=fixed)
    points = np.array([chart.boundary_x.values, chart.boundary_y.values])
    numbers = {symbol(name): gs.algebra.text.numbers.exact_number(value) for name, value in fixed.items()}
    criteria = [c.margin for k in (report.necessary, report.sufficient) for a in k.alternatives for c in a]
    existing = [e.together().as_numer_denom() for e in report.equilibrium.existence()]
    margins = [m.xreplace(numbers) for m in dict.fromkeys([*criteria,
                                                           *(top * bottom for top, bottom in existing)])]
    return chart, points[:, ~np.isnan(points[0])], [Poly(m, symbol(x[0]), symbol(y[0])) for m in margins]


@pytest.fixture(scope="module")
def charts(cases):
    """What is drawn of a case, computed once."""
    return cache(lambda number: drawn(cases[number]))


def sign_at(margin, a, b):
    """The sign of a polynomial with rational coefficients at two doubles, in Fractions."""
    a, b = Fraction(float(a)), Fraction(float(b))
    value = sum(Fraction(int(c.p), int(c.q)) * a**i * b**j for (i, j), c in margin.terms())
    return (value > 0) - (value < 0)


@pytest.mark.few(3)
@pytest.mark.parametrize("number", range(7))
def test_a_margin_changes_its_sign_within_two_ulp(charts, number):
    """Every point lies on a line of the grid.

    Along it a margin, in exact arithmetic, has a zero within two units of the last place.
    """
    chart, points, margins = charts(number)
    x, y = chart.verdict.dims[::-1]
    assert points.shape[1] > 40
    for a, b in points.T[::7]:
        on_row = b in chart[y].values
        assert on_row or a in chart[x].values
        near = [(a + i * np.spacing(a), b) if on_row else (a, b + i * np.spacing(b)) for i in (-2, 0, 2)]
        if on_row and a in chart[x].values:            # a point of the grid
            near += [(a, b + i * np.spacing(b)) for i in (-2, 2)]
        assert any(len({sign_at(m, *p) for p in near}) > 1 for m in margins), (a, b)


@pytest.mark.few(1)
@pytest.mark.parametrize("number", range(7))
def test_no_edge_between_two_verdicts_is_left_out(charts, number):
    """Each edge of the grid from stable to unstable, or to no equilibrium, has a point on it."""
    chart, points, _ = charts(number)
    y, x = (chart[name].values for name in chart.verdict.dims)
    assert all(((low <= here) & (here <= high)).any()
               for low, high, here in edges(chart.verdict.values, x, y, points))


def test_points_whose_sign_doubles_get_wrong():
    """Where the grid passes the curve by less than a rounding error, the edges between different verdicts
    still have their points.
    """
    x, y = symbol("a"), symbol("b")
    xs = np.linspace(1, 2, 41)
    ys = np.array([float(Fraction(a)**7) for a in xs])
    exact = np.array([[Fraction(a)**7 - Fraction(b) for a in xs] for b in ys])
    assert ((exact > 0) & ((xs**2)**3 * xs - ys[:, None] < 0)).any()
    verdict = np.where(exact > 0, 1, -1)
    points = np.array(boundary([x**7 - y], {}, (x, xs), (y, ys), verdict))
    assert all(((low <= here) & (here <= high)).any() for low, high, here in edges(verdict, xs, ys, points))
    assert np.isnan(points).sum() == 0


@pytest.mark.few(1)
@pytest.mark.parametrize("number", range(7))
def test_no_point_lies_within_one_verdict(charts, number):
    """Around each point two verdicts occur at least, whatever the margins do."""
    chart, points, _ = charts(number)
    verdict, (y, x) = chart.verdict.values, (chart[name].values for name in chart.verdict.dims)
    verdict, y = (verdict[::-1], y[::-1]) if y[0] > y[-1] else (verdict, y)
    gaps = np.isnan(chart.boundary_x.values)
    assert not gaps[[0, -1]].any() and not (gaps[1:] & gaps[:-1]).any()
    for a, b in points.T:
        i, j = np.searchsorted(y, b), np.searchsorted(x, a)
        assert len(np.unique(verdict[max(i - 1, 0):i + 2, max(j - 1, 0):j + 2])) > 1, (a, b)


def test_pieces_are_curves(charts, cases):
    """Two straight lines, in order along them, one gap between; a chart without a curve has no point."""
    chart, _, _ = charts(0)
    gaps = np.nonzero(np.isnan(chart.boundary_x.values))[0]
    assert len(gaps) == 1 and np.isnan(chart.boundary_y.values[gaps]).all()
    for piece in (slice(0, gaps[0]), slice(gaps[0] + 1, None)):
        total = chart.boundary_x.values[piece] + chart.boundary_y.values[piece]
        steps = np.diff(chart.boundary_x.values[piece])
        assert (abs(total) == 2).all() and ((steps >= 0).all() or (steps <= 0).all())
    assert cases[0][0]
    assert (
        stability_chart(cases[0][0], x=cases[0][1], y=cases[0][2], fixed={"I1": 1, "dU": -1}).vertex.size == 0
    )


def test_a_zero_at_zero(monkeypatch):
    """A curve through 0 between two points of the grid is at 0 exactly, not at a tiny number, and found at
    once.
    """
    asked, sign_of = [], contours.sign_of

    def counted(*given):
        sign = sign_of(*given)
        return lambda *at: asked.append(at) or sign(*at)

    monkeypatch.setattr(contours, "sign_of", counted)
    x, y = symbol("a"), symbol("b")
    grid = np.linspace(-1.1, 0.9, 4)
    here, there = boundary([x**3 + x], {}, (x, grid), (y, grid),
                           np.where(grid > 0, 1, -1) * np.ones((4, 1), dtype=int))
    assert here.tolist() == [0.0] * 4 and sorted(there) == grid.tolist() and len(asked) <= 2


def test_functions_to_the_precision_of_doubles():
    """exp(x) = y: as good as exp itself; and nothing comes of points where a logarithm is not real."""
    x, y = symbol("a"), symbol("b")
    xs, ys = np.linspace(-1, 2, 40), np.linspace(0.1, 5, 37)
    verdict = np.where(np.exp(xs) > ys[:, None], 1, -1)
    here, there = boundary([exp(x) - y], {}, (x, xs), (y, ys), verdict)
    # two roundings of exp and of its argument
    assert len(here) > 40 and np.allclose(np.exp(here), there, rtol=4e-16, atol=0)
    with np.errstate(all="ignore"):
        here, there = boundary([log(x) + y], {}, (x, xs), (y, ys - 2),
                               np.where(np.log(xs) > 2 - ys[:, None], 1, -1))
    assert len(here) > 20 and (here > 0).all() and np.allclose(np.log(here), -there, atol=1e-15)


def test_a_margin_without_a_sign_in_between():
    """sin(1/x): where there is no sign, the sign stops; the search ends."""
    x, y = symbol("a"), symbol("b")
    xs = np.array([-0.7, 0.7])
    with np.errstate(all="ignore"):
        verdict = np.where(np.sin(1 / xs) < 0, 1, -1) * np.ones((2, 1), dtype=int)
        here, there = boundary([-exp(x) * sin(1 / x)], {}, (x, xs), (y, xs), verdict)
    assert len(here) == 2 and (abs(here) <= 0.7).all() and set(there) <= set(xs)


def test_only_the_margin_that_decides_has_a_curve():
    """At E3 a zero of the margin beyond abs(k3) = 1 on the edge that abs(k3) = 1 crosses is no boundary."""
    report = gs.analyze(
        gs.inclined(
            gs.assemble(
                gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: gs.symbol("b") * k3 - k3**5 / 5)
            )
        )
    )
    chart = stability_chart(report, x=("k3", np.linspace(-1.25, 2.75, 9)),
                            y=("I1", np.linspace(0.0625, 4, 8)), fixed={"b": 2, "omega": 2})
    at = chart.boundary_x.values[~np.isnan(chart.boundary_x.values)]
    assert len(at) and (abs(at) <= 1).all()


def test_where_an_equilibrium_ends_at_0():
    """E3 whose l is eliminated needs ω ≠ 0: the boundary is at 0, not where ω² underflows."""
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(),
                                                gs.axial_potential(lambda k3: gs.symbol("a") * k3 + k3**3))))
    chart = stability_chart(report, x=("a", np.linspace(1, 2, 5)), y=("omega", np.linspace(-1, 1, 9)),
                            fixed={"I1": 1, "k3": "1/2"})
    at = chart.boundary_y.values[~np.isnan(chart.boundary_y.values)]
    assert len(at) and 0 in at and (abs(at[at != 0]) > 1e-3).all()


def test_a_curve_ends_where_its_margin_does():
    """Beside points at which a root is not real, no point is made between lines of the grid."""
    x, y = symbol("a"), symbol("b")
    xs = np.linspace(-1, 1, 36)
    with np.errstate(all="ignore"):
        value = xs - xs[:, None] + np.sqrt(xs + xs[:, None])
    here, there = boundary([x - y + sqrt(x + y)], {}, (x, xs), (y, xs),
                           np.where(np.isnan(value), -2, np.where(value > 0, 1, -1)))
    assert len(here) > 9 and (np.isin(here, xs) | np.isin(there, xs)).all()
    # a few roundings of numbers up to 1
    assert np.allclose(here - there + np.sqrt(here + there), 0, atol=1e-14)


@pytest.mark.parametrize("n", [1, 2, 1999, 2000, 2001, 31623])
def test_thinned(n):
    """All places up to 2000, else 2000 that include both ends and lie as evenly as they can."""
    places = thinned(n)
    steps = np.diff(places)
    assert places[0] == 0 and places[-1] == n - 1 and len(places) == min(n, 2000)
    assert n <= 2000 or steps.max() - steps.min() <= 1


def test_the_curve_of_a_large_chart(e1, monkeypatch):
    """Where the grid is finer than what curves are followed on, the points are as exact, on lines of the
    grid.
    """
    monkeypatch.setattr("gyrostat.charts.curves.contours.FINEST", 9)
    xs = np.linspace(-4, 4, 129)
    chart = stability_chart(e1, x=("pi3_0", xs), y=("l", xs / 2), fixed={"I1": 1, "dU": "1/4"})
    points = np.array([chart.boundary_x.values, chart.boundary_y.values])
    points = points[:, ~np.isnan(points[0])]
    assert 20 < points.shape[1] < 60 and (abs(points.sum(axis=0)) == 1).all()
