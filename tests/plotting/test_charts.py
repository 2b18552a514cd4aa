"""Pictures of charts: what is where, in which look, with which names."""
import sys

import numpy as np
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from gyrostat.charts.chart import stability_chart
from gyrostat.charts.codes import FLAGS
from gyrostat.errors import MissingExtraError, ValuesError
from gyrostat.plotting import caption, charts, draw_chart
from gyrostat.plotting.looks import LOOKS

NAMES = {code: name for name, code in FLAGS.items()}


@pytest.fixture(scope="module")
def wedge(upright_asymmetric):
    """A chart with undecided regions."""
    return stability_chart(upright_asymmetric, x=("m0", np.linspace(-4, 8, 25)),
                           y=("l", np.linspace(0, 8, 17)),
                           fixed={"I1": 2, "I2": "3/2", "I3": 1, "m1": "1/4", "pi3_0": 1})


@pytest.fixture(scope="module")
def tilted(e3):
    """A chart with points at which there is no equilibrium."""
    return stability_chart(e3, x=("k3", np.linspace(-1.5, 1.5, 41)), y=("d2U", np.linspace(-6, 2, 33)),
                           fixed={"I1": 1, "I3": "1/2", "l": "0.3", "omega": 1})


def drawn(ds, **kwargs):
    ax = Figure(figsize=(6, 5)).subplots()
    return draw_chart(ds, ax, **kwargs)


def pixels_of(ax):
    """What is seen, row by row from below."""
    canvas = FigureCanvasAgg(ax.figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[::-1, :, :3] / 255


def legend(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def widening(low, high, n):
    part = np.linspace(0, 1, n)
    return low + (high - low) * (part + part**2) / 2


@pytest.mark.slow
@pytest.mark.parametrize(("spacing", "turned"), [
    (np.linspace, (1, 1)), (np.linspace, (-1, 1)), (np.linspace, (1, -1)), (widening, (1, 1)),
    (widening, (-1, -1))])
def test_every_verdict_has_its_look_in_its_place(e3, turned, spacing):
    """Evenly spaced or not, axes in either direction.

    The colour at a point of the chart is that of its verdict.
    """
    xs, ys = spacing(-1.5, 1.5, 21)[::turned[0]], spacing(-6, 2, 17)[::turned[1]]
    chart = stability_chart(e3, x=("k3", xs), y=("d2U", ys),
                            fixed={"I1": 1, "I3": "1/2", "l": "0.3", "omega": 1})
    ax = drawn(chart)
    assert ax.get_xlim()[0] < ax.get_xlim()[1] and ax.get_ylim()[0] < ax.get_ylim()[1]
    pixels = pixels_of(ax)
    for x, y in ((-0.9, -1), (0.05, -5), (0.05, 1), (0.93, -1.1)):
        point = chart.verdict.sel(k3=x, d2U=y, method="nearest")
        colour = LOOKS[NAMES[int(point)]][0]
        column, row = ax.transData.transform((point.k3.item(), point.d2U.item())).round().astype(int)
        assert np.allclose(pixels[row, column], to_rgb(colour), atol=0.01), (x, y)
    assert NAMES[int(chart.verdict.sel(k3=-1.4, d2U=0, method="nearest"))] == "no_equilibrium"
    assert "no equilibrium" in legend(ax)


@pytest.mark.slow
def test_names_and_legend(wedge, tilted):
    """Axes as in the notation; the legend has what occurs and no more, above the axes.

    The boundary is a black line.
    """
    ax = drawn(wedge)
    assert (ax.get_xlabel(), ax.get_ylabel()) == (r"$m_0$ $[\mathrm{M\,L^{2}\,T^{-2}}]$",
                                                  r"$l$ $[\mathrm{M\,L^{2}\,T^{-1}}]$")
    assert legend(ax) == ["stable", "unstable", "boundary", "resonance 1:2", "resonance 1:3"]
    assert ax.get_title().startswith("E, $U = m_0 k_3 + ")
    assert ax.get_title().endswith(": $\\pi_3^0 = 1$, $I_1 = 2$, $I_2 = 3/2$, $I_3 = 1$, $m_1 = 1/4$")
    ax.figure.canvas.draw()
    assert ax.get_legend().get_window_extent().y0 >= ax.get_window_extent().y1 - 1
    assert ax.get_legend().get_window_extent().y1 <= ax.title.get_window_extent().y0 + 1
    line, *_ = ax.lines
    assert line.get_color() == "black"
    np.testing.assert_array_equal(line.get_xdata(), wedge.boundary_x)
    np.testing.assert_array_equal(line.get_ydata(), wedge.boundary_y)
    ax = drawn(tilted)
    assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_title()) == (
        "$k_3$", r"$U''(k_3)$ $[\mathrm{M\,L^{2}\,T^{-2}}]$",
        "E3: $\\omega = 1$, $l = 0.3$, $I_1 = 1$, $I_3 = 1/2$, $U'(k_3)$ determined at each point")
    assert legend(ax) == ["stable modulo the spin", "unstable", "no equilibrium", "boundary"]
    ax = drawn(tilted.isel(k3=slice(18, 22), d2U=slice(28, 32)).drop_vars(["boundary_x", "boundary_y"]))
    assert legend(ax) == ["stable modulo the spin"] and not ax.lines


@pytest.mark.few(1)
@pytest.mark.parametrize("scale", [1e-12, 1.0, 1e12])
def test_spacing_is_seen_at_every_scale(e1, scale):
    """Cells of values that are not evenly spaced are where their values are, however small these are."""
    xs = widening(-4, 4, 33) * scale
    ax = drawn(stability_chart(e1, x=("pi3_0", xs), y=("l", np.linspace(-2, 2, 9) * scale),
                               fixed={"I1": 1, "dU": scale**2}))
    corners = ax.images[0].edges[0]
    assert ((corners[:-1] < xs) & (xs < corners[1:])).all()


@pytest.mark.slow
def test_the_legend_has_no_boundary_that_is_not_seen(e1):
    """Of a part of a chart in which there is none."""
    chart = stability_chart(e1, x=("pi3_0", np.linspace(-4, 4, 41)), y=("l", np.linspace(-2, 2, 9)),
                            fixed={"I1": 1, "dU": 1})
    assert legend(drawn(chart.isel(pi3_0=slice(None, 3), l=slice(None, 3)))) == ["stable"]


@pytest.mark.slow
def test_undecided_is_hatched(wedge):
    """By a hatch, not by colour alone."""
    chart = wedge.copy(deep=True)
    chart.verdict[2:6, 2:6] = 0
    hatched = [c for c in drawn(chart).collections if "////" in (getattr(c, "hatches", None) or [])]
    assert len(hatched) == 1 and len(hatched[0].get_paths()[0].vertices) > 4
    assert "undecided" in legend(drawn(chart))


@pytest.mark.slow
def test_a_transposed_chart_has_the_same_boundary(wedge):
    """The line follows the axes, whichever is horizontal."""
    ax = drawn(wedge.transpose())
    assert (ax.get_xlabel(), ax.get_ylabel()) == (r"$l$ $[\mathrm{M\,L^{2}\,T^{-1}}]$",
                                                  r"$m_0$ $[\mathrm{M\,L^{2}\,T^{-2}}]$")
    np.testing.assert_array_equal(ax.lines[0].get_xdata(), wedge.boundary_y)


@pytest.mark.slow
def test_axes_are_made_only_where_none_are_given(wedge, monkeypatch):
    """No figure besides the one that is given; a new one of pyplot where none is."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    before = plt.get_fignums()
    given = Figure().subplots()
    assert draw_chart(wedge, ax=given) is given and plt.get_fignums() == before
    new = draw_chart(wedge)
    assert plt.get_fignums() != before and new.figure.number not in before
    plt.close(new.figure)


@pytest.mark.slow
def test_arguments_go_to_the_image(wedge):
    """Whatever an image takes, before what is chosen here."""
    (image,) = drawn(wedge, alpha=0.5, zorder=-3, cmap="viridis").images
    assert image.get_alpha() == 0.5 and image.get_zorder() == -3 and image.get_cmap().name == "viridis"


def test_other_numbers_of_axes_are_refused(e1):
    """Three axes or one: the message says how to choose."""
    chart = stability_chart(e1, x=("pi3_0", [0, 1]), y=("l", [0, 1]), axes={"dU": [1, 2]}, fixed={"I1": 1})
    with pytest.raises(ValuesError,
                       match=r"has the axes dU, l, pi3_0, two are drawn: choose values of the others with "
                             r"ds.sel\(dU="):
        draw_chart(chart)
    with pytest.raises(ValuesError, match="has the axes pi3_0"):
        draw_chart(chart.isel(dU=0, l=0))
    ax = drawn(chart.sel(dU=1))
    assert not ax.lines and ax.get_xlabel().startswith(r"$\pi_3^0$ ")
    assert "U'(1) = 1" in ax.get_title() and "U'(1) = 1" in caption(ax)


@pytest.mark.slow
def test_from_a_file_and_from_a_store(e1, tmp_path):
    """The same picture from memory, netCDF and Zarr."""
    grid = {"x": ("pi3_0", np.linspace(-4, 4, 50)), "y": ("l", np.linspace(2, -2, 40)),
            "fixed": {"I1": "1/3", "dU": 1}}
    memory = stability_chart(e1, **grid)
    memory.to_netcdf(tmp_path / "chart.nc", engine="netcdf4")
    stored = stability_chart(e1, **grid, store=tmp_path / "chart.zarr")
    pictures = []
    with xr.open_dataset(tmp_path / "chart.nc") as file:
        for chart in (memory, file, stored, xr.open_zarr(tmp_path / "chart.zarr", consolidated=False)):
            ax = drawn(chart)
            FigureCanvasAgg(ax.figure).draw()
            pictures.append(np.asarray(ax.figure.canvas.buffer_rgba()).tobytes())
    assert len(set(pictures)) == 1


def test_a_large_chart_is_thinned(e1, monkeypatch):
    """Of more values than are drawn, every second, third, …"""
    monkeypatch.setattr(charts, "SHOWN", 20)
    chart = stability_chart(e1, x=("pi3_0", np.linspace(-4, 4, 50)), y=("l", np.linspace(-2, 2, 20)),
                            fixed={"I1": 1, "dU": 1}).chunk()
    (image,) = drawn(chart).images
    assert image.get_array().shape == (20, 17)
    np.testing.assert_array_equal(image.get_array(), chart.verdict[:, ::3])


@pytest.mark.slow
def test_one_value_is_a_strip(e1):
    """An axis of one value, and a chart of one point, are drawn."""
    for xs, ys in (([1.0], [0.0, 1.0, 2.0]), ([1.0], [0.5])):
        ax = drawn(stability_chart(e1, x=("pi3_0", xs), y=("l", ys), fixed={"I1": 1, "dU": 1}))
        assert ax.get_xlim() == (0.5, 1.5) and ax.get_legend()


@pytest.mark.slow
def test_a_missing_extra_is_named(wedge, monkeypatch):
    """The message has the pip command."""
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(MissingExtraError,
                       match=r'matplotlib cannot be imported.*pip install "gyrostat\[plot\]"'):
        draw_chart(wedge)
