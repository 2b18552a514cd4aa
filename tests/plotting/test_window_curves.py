"""Curves inside windows as they are drawn."""
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

import gyrostat as gs
from gyrostat.charts import stability_chart
from gyrostat.plotting import draw_chart


@pytest.fixture(scope="module")
def chart():
    """The sleeping asymmetric gyrostat, with internal damping."""
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l"))),
                        gs.general_potential(lambda a, b, c: gs.symbol("m0") * c))
    report = gs.analyze(gs.equilibrium(scene, (0, 0, gs.symbol("I3") * gs.symbol("omega"), 0, 0, 1)))
    return stability_chart(report, x=("omega", np.linspace(-3, 3, 13)), y=("l", np.linspace(-10, 10, 13)),
                           fixed={"I1": 9, "I2": 5, "I3": 7, "m0": 3}, damped=True, progress=False)


@pytest.mark.slow
def test_each_curve_is_drawn_where_it_is(chart):
    """By its own dashes, and named in the legend where it is seen."""
    ax = draw_chart(chart, Figure().subplots())
    lines = {line.get_label(): line for line in ax.lines}
    names = {"resonance 1:2": 2, "resonance 1:3": 3, "$D_4 = 0$": 4}
    assert [*lines] == ["boundary", *names]
    assert len({line.get_linestyle() for line in lines.values()}) == 4
    for name, code in names.items():
        here = chart.curve.values == code
        for data, values in zip(lines[name].get_data(), (chart.curve_x, chart.curve_y)):
            np.testing.assert_array_equal(data[here], values.values[here])
            assert np.isnan(data[~here]).all()
    texts = [text.get_text() for text in ax.get_legend().get_texts()]
    assert texts[-4:] == [*lines] and "destroyed by internal damping" in texts
    part = draw_chart(chart.isel(omega=slice(5, 8), l=slice(5, 8)), Figure().subplots())
    assert not {*names} & {text.get_text() for text in part.get_legend().get_texts()}


@pytest.mark.slow
def test_a_long_legend_is_not_cut_off(chart):
    """What stands above the axes is inside the figure, and not on the axes."""
    figure = Figure((5, 4))
    ax = draw_chart(chart, figure.subplots())
    FigureCanvasAgg(figure).draw()
    for shown in (ax.get_legend(), ax.title):
        box = shown.get_window_extent()
        assert box.x0 >= 0 and box.x1 <= figure.bbox.x1 and box.y1 <= figure.bbox.y1
        assert box.y0 >= ax.get_window_extent().y1 - 1
