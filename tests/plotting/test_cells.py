"""The image of a chart: each pixel has the colour of its cell."""
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from gyrostat.charts.chart import stability_chart
from gyrostat.charts.codes import FLAGS
from gyrostat.plotting import draw_chart
from gyrostat.plotting.looks import LOOKS

COLOURS = {code: to_rgb(LOOKS[name][0]) for name, code in FLAGS.items()}


def squares(low, high, n):
    """Values that lie closer together at the beginning."""
    part = np.linspace(0, 1, n)
    return low + (high - low) * (part + part**2) / 2


def drawn(e1, xs, ys):
    """A chart and its picture without the boundary."""
    chart = stability_chart(e1, x=("pi3_0", xs), y=("l", ys), fixed={"I1": 1, "dU": 1})
    ax = Figure(figsize=(6, 5)).subplots()
    return chart, draw_chart(chart.drop_vars(["boundary_x", "boundary_y"]), ax)


@pytest.mark.few(1)
@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize("spacing", [np.linspace, squares])
def test_every_pixel_has_the_colour_of_its_cell(e1, spacing, turned):
    """The cell is found by distance: its value is the nearest to the centre of the pixel.

    Beside the outermost cells there is nothing, also where axes are turned or show more than the chart.
    """
    xs, ys = spacing(-4, 4, 31), spacing(-2, 2, 23)
    chart, ax = drawn(e1, xs, ys)
    ax.set(xlim=(5, -3) if turned else (-3, 5), ylim=(-1.7, 1.9))
    ax.set_axis_off()
    canvas = FigureCanvasAgg(ax.figure)
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())[::-1, :, :3] / 255
    left, below, right, above = ax.bbox.extents.round().astype(int)
    for row in range(below, above, 7):
        x, y = ax.transData.inverted().transform([(n + 0.5, row + 0.5) for n in range(left, right)]).T
        codes = chart.verdict.values[np.argmin(abs(ys - y[0])), np.argmin(abs(xs[:, None] - x), axis=0)]
        last = 1.5 * xs[-1] - 0.5 * xs[-2]
        colours = [COLOURS[code] if at < last else (1, 1, 1) for at, code in zip(x, codes)]
        assert np.allclose(pixels[row, left:right], colours, atol=0.01)


def test_the_cursor_is_told_the_verdict_of_its_cell(e1):
    """At the points of the chart, and nothing beside its cells."""
    xs, ys = squares(-4, 4, 33), np.linspace(-2, 2, 9)
    chart, ax = drawn(e1, xs, ys)
    (image,) = ax.images
    for n, y in enumerate(ys):
        pixels = ax.transData.transform([(x, y) for x in xs])
        said = [image.get_cursor_data(SimpleNamespace(x=x, y=y)) for x, y in pixels]
        assert said == chart.verdict.values[n].tolist()
    assert image.get_cursor_data(SimpleNamespace(x=0, y=0)) is None
