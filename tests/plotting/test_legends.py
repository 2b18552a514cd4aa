"""Legends and the names beside marks: how much of a figure they take, and what they lie over."""
import matplotlib.style
import numpy as np
import pytest
from drawn_pictures import BODY, FIELDS, GENERAL, flat, of_revolution, of_three_moments, without_a_field
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

import gyrostat as gs
from gyrostat import plotting

MOST = 0.25


def measured(pictures):
    """The part of its figure that each legend takes, in a column of a paper, with the large letters that are
    Matplotlib's default.
    """
    with matplotlib.rc_context({"figure.figsize": (3.8, 3.8), "figure.constrained_layout.use": True}):
        for ax in pictures:
            canvas = FigureCanvasAgg(ax.figure)
            canvas.draw()
            if legend := ax.get_legend():
                box = legend.get_window_extent(canvas.get_renderer())
                yield box.width * box.height / (ax.figure.bbox.width * ax.figure.bbox.height)


@pytest.mark.slow
@pytest.mark.parametrize("field", FIELDS)
def test_a_legend_in_a_field_takes_less_than_a_quarter(field):
    """Of a body of revolution, in fields of degree 1 to 4, those with the most kinds of marks included."""
    parts = list(measured(of_revolution(FIELDS[field])))
    assert len(parts) >= 6 and max(parts) < MOST, parts


@pytest.mark.slow
@pytest.mark.parametrize("degree", GENERAL)
def test_a_legend_of_three_moments_takes_less_than_a_quarter(degree):
    """On the sphere of directions and along a rate."""
    parts = list(measured(of_three_moments(degree)))
    assert len(parts) >= 2 and max(parts) < MOST, parts


@pytest.mark.slow
def test_a_legend_without_a_field_takes_less_than_a_quarter():
    """Of free bodies and of satellites."""
    parts = list(measured(without_a_field()))
    assert len(parts) == 8 and max(parts) < MOST, parts


@pytest.mark.slow
@pytest.mark.parametrize("field", ["3, more marks", "4, more marks"])
def test_names_beside_marks_lie_over_nothing(field):
    """No vertex of a curve and no mark is under a name, and no name is over another or over the frame."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(FIELDS[field]))
    with matplotlib.style.context("gyrostat.plotting.paper"):
        ax = plotting.draw_bifurcation_diagram(scene, "omega", (-5, 5), BODY, flat())
        FigureCanvasAgg(ax.figure).draw()
    frame = ax.get_window_extent()
    names = [text for text in ax.texts if text.get_text() not in ("E1", "E2", "E3")]
    boxes = [text.get_window_extent() for text in names]
    assert len(names) >= 4
    assert not any(a.overlaps(b) for n, a in enumerate(boxes) for b in boxes[:n])
    for name, box in zip(names, boxes):
        assert frame.x0 < box.x0 and box.x1 < frame.x1 and frame.y0 < box.y0 and box.y1 < frame.y1
        for line in ax.lines:
            x, y = ax.transData.transform(line.get_xydata()).T
            assert not ((box.x0 < x) & (x < box.x1) & (box.y0 < y) & (y < box.y1)).any(), name.get_text()
        place, mark = ax.transData.transform(name.xy), np.array([[box.x0, box.y0], [box.x1, box.y1]])
        assert np.linalg.norm(np.clip(place, *mark) - place) < 15 * ax.figure.dpi / 72


@pytest.mark.slow
def test_a_name_without_room_stands_in_the_legend():
    """Of a picture that is too small for names beside its marks."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(FIELDS["4, more marks"]))
    small = plotting.draw_bifurcation_diagram(scene, "omega", (-5, 5), BODY, Figure((1.2, 1.2)).subplots())
    assert "fold at fixed rate" in [text.get_text() for text in small.get_legend().get_texts()]
    assert not any(text.get_text() == "fold at fixed rate" for text in small.texts)


def test_curves_that_are_not_finite_are_in_nobodys_way():
    """A piece without a finite point, of a picture that was there before, leaves room for names."""
    ax = Figure().subplots()
    ax.add_collection(LineCollection([[(np.nan, np.nan)] * 2, [(0, 0), (1, 1)]]))
    upright = gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()))
    plotting.draw_eigenvalues(upright, "pi3_0", np.linspace(3, 1, 9), {"I1": 1, "I3": 1, "l": 0, "m0": 1}, ax)
    assert ["2" in text.get_text() for text in ax.texts if "pi_3" in text.get_text()] == [True]
