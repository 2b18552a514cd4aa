"""Marks and their numbers: those that nearly coincide are all seen, and no number lies on another one."""
import numpy as np
import pytest
from drawn_pictures import space
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.proj3d import proj_transform

import gyrostat as gs
from gyrostat import plotting
from gyrostat.plotting.nested import nest


def marks(ax):
    """The place in pixels, the size in points and the height of each mark."""
    found = []
    for line in ax.lines:
        if line.get_marker() in ("o", "D", "s"):
            data = np.array(line.get_data_3d() if ax.name == "3d" else line.get_data())
            flat = data if ax.name != "3d" else np.array(proj_transform(*data, ax.get_proj())[:2])
            found += [(place, line.get_markersize(), line.get_zorder())
                      for place in ax.transData.transform(flat.T)]
    return found


@pytest.mark.parametrize("three", [False, True])
def test_marks_that_nearly_coincide_are_around_each_other(three):
    """Of three within a point each is larger than the one above it; the others stay; none is moved."""
    ax = Figure().add_subplot(**({"projection": "3d"} if three else {}))
    ax.set(xlim=(0, 1), ylim=(0, 1), **({"zlim": (0, 1)} if three else {}))
    places = np.array([[0.5, 0.5, 0.5], [0.8, 0.2, 0.5], [0.502, 0.5, 0.5], [0.5, 0.503, 0.5]])[
        :, :3 if three else 2]
    ax.plot(*places[:2].T, marker="o", linestyle="none", markersize=6)
    ax.plot(*places[2:3].T, marker="s", linestyle="none", markersize=6, zorder=4)
    ax.plot(*places[3:].T, marker="D", linestyle="none", markersize=6, zorder=5)
    ax.plot(*places[3:].T, marker=".", linestyle="none", markersize=3)
    ax.plot(*places[:2].T, marker="o", markersize=6)       # along a line they are no marks of their own
    before = sorted(tuple(place.round(6)) for place, *_ in marks(ax))
    nest(ax)
    after = marks(ax)
    assert sorted(tuple(place.round(6)) for place, *_ in after) == before
    heap = sorted((size, -height) for place, size, height in after
                  if np.linalg.norm(place - after[-1][0]) < 20 and (size, height) != (6, 2))
    sizes = sorted(size for _, size, _ in after)
    assert sizes.count(6) == 4 and sizes[-2:] == [11, 16]
    assert heap == sorted(heap, key=lambda mark: mark[1])  # what is larger is below


@pytest.mark.slow
def test_rotations_that_are_about_to_meet_are_all_seen():
    """Three of them near a pitchfork, a saddle between two minima: each has a size of its own."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "-4999/10000")))
    ax = plotting.draw_momentum_sphere(scene, 1, ax=space())
    found = [(place, size) for place, size, _ in marks(ax)]
    near = [sorted(size for other, size in found if np.linalg.norm(place - other) < 4)
            for place, _ in found]
    assert max(map(len, near)) == 3 and all(len(set(sizes)) == len(sizes) for sizes in near)


@pytest.mark.few(1)
@pytest.mark.parametrize(("inertia", "rotor", "other"), [
    ((1, "5/4", "8/5"), (0, 0, 0), 0), ((2, 2, 3), (0, 1, 0), 0),
    ((1, "5/4", "8/5"), ("3/10", "1/5", "1/10"), 0),
    pytest.param((1, "5/4", "8/5"), (0, 0, 0), "t1/10 + r2/7", marks=pytest.mark.slow)])
def test_numbers_lie_on_no_mark_and_on_no_number(inertia, rotor, other):
    """Of all attitudes, in a picture of the width of a column."""
    orbit = gs.circular_orbit(1, potential=other)
    ax = Figure(figsize=(3.4, 3.4)).add_subplot(projection="3d", elev=22, azim=40)
    plotting.draw_attitudes(gs.assemble(gs.Gyrostat(inertia, rotor), orbit), ax=ax)
    canvas = FigureCanvasAgg(ax.figure)
    canvas.draw()
    boxes = []
    for text in ax.texts:
        if text.get_text().isdigit():
            extent = text.get_window_extent(canvas.get_renderer())      # its size; it is drawn at its place
            middle = ax.transData.transform(proj_transform(*text.get_position_3d(), ax.get_proj())[:2])
            boxes.append((middle, np.array([extent.width, 0.7 * extent.height]) / 2))   # digits have no tails
    assert len(boxes) >= 8
    for n, (middle, half) in enumerate(boxes):
        assert not any((abs(place - middle) < half).all() for place, *_ in marks(ax)), n
        assert not any((abs(there - middle) < half + wide).all() for there, wide in boxes[:n]), n


@pytest.mark.slow
@pytest.mark.parametrize("size", [(3.4, 3), (6.4, 4.8)])
def test_a_tall_title_is_on_the_figure(size):
    """Of a tensor, on a figure without a layout: savefig cuts off what is beyond its edge."""
    tensor = [["62.13", "1.31", "-0.83"], ["1.31", "58.07", "0.29"], ["-0.83", "0.29", "30.01"]]
    for three in (True, False):
        ax = Figure(figsize=size).add_subplot(projection="3d" if three else None)
        if three:
            body = gs.Gyrostat(tensor, ("1/7", "2/13", "3/11"))
            plotting.draw_momentum_sphere(gs.assemble(body), 11, ax=ax)
        else:
            plotting.draw_rotor_set(gs.assemble(gs.Gyrostat(tensor)), {"l1": "1/17", "M": "22/7"}, ax)
        canvas = FigureCanvasAgg(ax.figure)
        canvas.draw()
        for part in (ax.title, ax.get_legend(), *(() if three else (ax.xaxis.label, ax.yaxis.label))):
            box = part.get_window_extent(canvas.get_renderer())
            assert box.x0 >= 0 and box.y0 >= 0 and (box.max <= ax.figure.bbox.max).all(), part
