"""What is above and beside a picture: U and numbers, legends of what is seen, names that lie over nothing."""
import matplotlib.style
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.proj3d import proj_transform
from slow import slow
from sympy import Rational, exp

import gyrostat as gs
from gyrostat.charts import stability_chart
from gyrostat.plotting import (
    draw_bifurcation_diagram,
    draw_chart,
    draw_effective_potential,
    draw_energy_momentum,
    draw_momentum_sphere,
    headings,
)
from gyrostat.plotting.globe import stage

BODY = {"I1": 1, "I3": "1/2", "l": 0}


def space(elevation=22, azimuth=40):
    return Figure(figsize=(4, 4)).add_subplot(projection="3d", elev=elevation, azim=azimuth)


def in_a_field(U):
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U))


def names(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def drawn(figure):
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return canvas.get_renderer()


@pytest.mark.slow
@pytest.mark.parametrize("width", [3.4, 7])
def test_a_title_is_as_wide_as_its_axes(width):
    """U of many terms and its numbers are broken into lines; each is read back whole; none is cut off."""
    m = gs.symbol("m0")
    scene = in_a_field(lambda k: m * k + k**2 / 2 + sum(k**n / (n + 3) for n in range(3, 9)))
    with matplotlib.style.context("gyrostat.plotting.paper"):
        ax = draw_effective_potential(scene, {**BODY, "m0": "-1/3", "p_phi": "1/7", "p_psi": "1/9"},
                                      ax=Figure(figsize=(width, 3)).subplots())
        box = ax.title.get_window_extent(drawn(ax.figure))
    assert ax.get_title().count("\n") >= (2 if width < 4 else 0)
    assert box.x0 >= 0 and box.x1 <= ax.figure.bbox.width and box.y1 <= ax.figure.bbox.height
    text = ax.get_title().replace("\n", " ")
    for part in ("m_0 k_3", r"\frac{k_3^{8}}{11}", "$m_0 = -1/3$", r"$p_{\phi} = 1/7$", "$l = 0$"):
        assert part in text, part


@pytest.mark.slow
def test_a_field_of_too_many_terms_is_cut_and_says_so():
    """Not without a sign of it."""
    long = headings.field(" + ".join(f"a_{{{n}}} k_3^{{{n}}}" for n in range(60)))
    text = headings.lines(long, ["$l = 0$"])
    assert text.endswith("$+\\;\\ldots$: $l = 0$") and text.count("\n") == 2
    assert headings.field(r"\notaword{k_3}") == []                    # Matplotlib cannot set it


def test_numbers_of_body_and_field():
    """Those of the scene and those given, each once; what is exact and short as it is."""
    a = gs.symbol("a")
    scene = gs.assemble(gs.Gyrostat((2, 2, a), (0, 0, "1/3")), gs.axial_potential(lambda k: exp(-k) * a))
    above, shown = headings.of_scene(scene, {"a": "0.123456789"})
    assert above == ["$U = a e^{- k_3}$"]
    assert shown == ["$I_3 = a$", "$l = 1/3$", "$I_1 = 2$", "$a = 0.1235$"]
    free, numbers = headings.of_scene(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 1, 0))), {})
    assert free == [] and numbers == ["$l_2 = 1$", "$I_1 = 1$", "$I_2 = 2$", "$I_3 = 3$"]


def test_in_orbit_the_other_energy_is_written_as_it_was_given():
    """Without that of the gravity gradient, whose numbers have many digits; ω0 stands beside the moments."""
    body = gs.Gyrostat((3, 4, 2), (0, 0, 0))
    drag = gs.circular_orbit(height="500 km", potential="f*(x*t1 + y*t2)")
    above, shown = headings.of_scene(gs.assemble(body, drag), {"f": "3 mN"})
    assert above[0] == "in orbit" and above[1].replace(r"\left", "").replace(r"\right", "") == (
        "$U = f (t_{1} x + t_{2} y)$")
    assert r"$\omega_0 = 0.001107$" in shown and "$f = 3/1000$" in shown
    assert headings.of_scene(gs.assemble(body, gs.circular_orbit(1)), {})[0] == ["in orbit"]


def test_a_long_formula_in_parentheses_is_drawn():
    """Its lines have no parentheses that Matplotlib does not know."""
    long = headings.field(r"\left(" + " + ".join(f"a_{{{n}}} k_3^{{{n}}}" for n in range(30)) + r"\right)")
    figure = Figure()
    figure.text(0, 0, headings.lines(long, ["$l = 0$"]))
    drawn(figure)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [0, 3, *slow(*((n,) for n in (1, 2, 4, 5, 6, 7)))])
def test_names_of_axes_do_not_lie_over_the_outline(seed):
    """From wherever the sphere is seen, each is well inside or outside of the circle."""
    rng = np.random.default_rng(seed)
    for elevation, azimuth in zip(rng.uniform(-90, 90, 12), rng.uniform(0, 360, 12)):
        ax = space(elevation, azimuth)
        eye = stage(ax, 2.0, "abc")
        ax.figure.canvas.draw()

        def seen(point, ax=ax):
            return np.array(proj_transform(*point, ax.get_proj())[:2])

        radius = np.linalg.norm(seen(2.0 * np.cross(eye, [1.0, 0, 0]) / np.linalg.norm(
            np.cross(eye, [1.0, 0, 0]))) - seen((0, 0, 0)))
        for text in ax.texts:
            away = np.linalg.norm(seen(text.get_position_3d()) - seen((0, 0, 0))) / radius
            assert not 0.82 < away < 1.2, (elevation, azimuth, text.get_text())


@pytest.mark.few(1)
@pytest.mark.parametrize("inertia", [(1, 2, 3), (1, 2, "21/10"), (5, 2, 1)])
def test_polhodes_are_evenly_spaced(inertia):
    """Those drawn cross the great circles from the saddle to the other axes at equal angles."""
    body = gs.assemble(gs.Gyrostat(inertia, (0, 0, 0)))
    ax = draw_momentum_sphere(body, 1, ax=space(), color="green")
    points = np.concatenate([np.array(line.get_data_3d()).T for line in ax.lines
                             if line.get_color() == "green"])
    order = np.argsort([float(Rational(moment)) for moment in inertia])
    for across, along in ((order[0], order[2]), (order[2], order[0])):
        at = np.flatnonzero(points[:-1, across] * points[1:, across] <= 0)
        where = (points[at] + points[at + 1]) / 2
        angles = np.degrees(np.arctan2(abs(where[:, order[1]]), abs(where[:, along])))
        # a chord is not where the curve is
        assert set((angles / 15).round(1).tolist()) == {1.0, 2.0, 3.0, 4.0, 5.0}


def test_a_power_of_ten_is_not_under_the_legend():
    """What the ticks have in common stands between legend and axes."""
    values = {**BODY, "p_phi": "1/1000", "p_psi": "1/1000"}
    scene = in_a_field(lambda k: k / 10**6)
    ax = draw_effective_potential(scene, values, ax=Figure(figsize=(5, 4)).subplots())
    renderer = drawn(ax.figure)
    power = ax.yaxis.get_offset_text()
    assert power.get_text()
    assert not power.get_window_extent(renderer).overlaps(ax.get_legend().get_window_extent(renderer))


@pytest.mark.slow
def test_a_legend_of_uneven_columns_fits_above_its_axes():
    """Four names in three columns would be wider than a column of a paper, and push the axes together."""
    tilted = gs.analyze(gs.inclined(in_a_field(lambda k: k - k**2), eliminate="k3"))
    chart = stability_chart(tilted, x=("l", np.linspace(-3, 3, 40)), y=("omega", np.linspace(-2, 2, 41)),
                            fixed={"I1": 2, "I3": 1})
    with matplotlib.style.context("gyrostat.plotting.paper"):
        ax = draw_chart(chart, Figure().subplots())
        renderer = drawn(ax.figure)
        assert len(names(ax)) == 4
        assert ax.get_legend().get_window_extent(renderer).x1 <= ax.figure.bbox.x1
        assert ax.get_window_extent().width > 0.75 * ax.figure.bbox.width


@pytest.mark.slow
def test_the_legend_has_nothing_that_is_outside_of_the_window():
    """Curves, points and marks beyond the ends of the axes are not named."""
    scene, values = in_a_field(lambda k: 6 * k**4 - 5 * k**2 + k / 2), {**BODY, "p_psi": "1/2"}
    whole = names(draw_energy_momentum(scene, values, ax=Figure().subplots()))
    assert {"unstable", "2 bands"} <= set(whole)
    part = names(draw_energy_momentum(scene, values, (2.5, 3.5, 3.0, 9.0), Figure().subplots()))
    assert part == ["stable (curves: modulo the spin)", "1 band of $k_3$"]


def test_e3_in_l_and_omega_says_what_is_determined():
    """Of a chart of E3 the name that differs from point to point; no frame looks like a boundary."""
    scene = in_a_field(lambda k: k**3 / 3 - k)
    tilted = gs.analyze(gs.inclined(scene))
    k3, omega = np.linspace(-1, 1, 300), np.linspace(-1.5, 1.5, 300)
    chart = stability_chart(tilted, x=("k3", k3), y=("omega", omega), fixed={"I1": 2, "I3": 1})
    ax = draw_chart(chart, Figure().subplots())
    assert ax.get_title().replace("\n", " ").endswith("$l$ determined at each point")
    assert "no equilibrium" not in names(ax) and (chart.verdict == -2).any()
    assert np.nanmax(np.abs(chart.boundary_x)) == 1
    (line,) = ax.lines
    x, y = line.get_data()
    frame = (np.abs(x[1:]) > 1 - 1e-9) & (np.abs(x[:-1]) > 1 - 1e-9) & (np.diff(y) != 0)
    assert not frame.any() and np.isfinite(x).sum() > 300
    inside = np.abs(chart.boundary_x.values) < 0.99                    # nothing else is left out
    np.testing.assert_array_equal(x[inside], chart.boundary_x.values[inside])


@pytest.mark.slow
def test_the_style_of_a_paper_is_found_by_its_name():
    """Serif letters and mathematics that go with them, at the width of a column."""
    with matplotlib.style.context("gyrostat.plotting.paper"):
        ax = draw_bifurcation_diagram(in_a_field(lambda k: -k), "omega", (0, 3), {"I1": 2, "I3": 1, "l": 0},
                                      Figure().subplots())
        assert matplotlib.rcParams["mathtext.fontset"] == "stix"
        assert ax.figure.get_size_inches()[0] == pytest.approx(3.4)
        assert ax.xaxis.label.get_fontname() == "STIXGeneral"
    assert Rational(ax.title.get_fontsize()) == 9
