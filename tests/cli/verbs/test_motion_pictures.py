"""gyrostat motion: pictures and animations."""
import sys

import commands
import numpy as np
import pytest
from cli.two_motions import FREE, TOP, the_box, the_top
from matplotlib.animation import FFMpegWriter
from PIL import Image

from gyrostat.plotting.looks import BLUE


def run(capsys, *arguments):
    return commands.run(capsys, *arguments, verb="motion")


@pytest.fixture
def drawn(monkeypatch):
    """Figures that are not written."""
    figures = []
    monkeypatch.setattr("gyrostat.cli.verbs.motion.save_picture", lambda figure, path: figures.append(figure))
    return figures


def path_of(ax, width):
    lines = [np.array(line.get_data_3d()).T for line in ax.lines
             if (line.get_color(), line.get_linewidth()) == (BLUE, width)]
    return {tuple(point) for line in lines for point in line.round(12).tolist() if np.isfinite(point).all()}


@pytest.mark.slow
def test_a_picture_in_a_field(capsys, tmp_path, heavy, drawn):
    """The path of e3, and π and k over the time."""
    assert run(capsys, *TOP, "--until", "9", "--count", "50", "--output", str(tmp_path / "top.png"))[0] == 0
    top, times = the_top(heavy), np.array([9 * n / 49 for n in range(50)])
    sphere, momenta, directions = drawn[0].axes
    assert {tuple(point) for point in top.attitude(times)[..., 2].round(12).tolist()} <= path_of(sphere, 1.4)
    for ax, names, columns in ((momenta, "pi", slice(0, 3)), (directions, "k", slice(3, 6))):
        np.testing.assert_array_equal([line.get_ydata() for line in ax.lines], top(times)[:, columns].T)
        np.testing.assert_array_equal(ax.lines[0].get_xdata(), times)
        assert [text.get_text().strip("$\\") for text in ax.get_legend().get_texts()] == [
            f"{names}_{i}" for i in (1, 2, 3)
        ]
        assert (
            len({line.get_linestyle() for line in ax.lines}) == 3
            or len({str(line._dash_pattern) for line in ax.lines}) == 3
        )
    assert directions.get_xlabel() == r"$t$ $[\mathrm{T}]$"


@pytest.mark.slow
def test_a_picture_of_a_free_body(capsys, tmp_path, drawn):
    """The momentum sphere with the path of M = π + l."""
    assert run(capsys, *FREE, "--until", "-9", "--count", "50", "--output", str(tmp_path / "box.pdf"))[0] == 0
    sphere, momenta = drawn[0].axes
    times = np.array([-9 * n / 49 for n in range(50)])
    M = the_box()(times) + [0, 0, 0.25]
    assert {tuple(point) for point in M.round(12).tolist()} <= path_of(sphere, 2.4)
    assert sphere.get_legend().get_texts()[0].get_text() == "polhode" and len(momenta.lines) == 3
    polhode = np.array(sorted(path_of(sphere, 0.9)))
    energies = (polhode - [0, 0, 0.25])**2 @ (0.5 / np.array([1, 2, 2.5]))
    # a chord, where the curve passes behind the sphere
    np.testing.assert_allclose(energies, the_box().energy, rtol=1e-4)


@pytest.mark.slow
def test_a_picture_file(capsys, tmp_path):
    """There is something on both sides of it."""
    assert run(capsys, *FREE, "--until", "9", "--count", "30", "--output", str(tmp_path / "box.png"))[0] == 0
    with Image.open(tmp_path / "box.png") as image:
        left, right = (np.asarray(image.convert("L").crop(box)) for box in (
            (0, 0, image.width // 2, image.height), (image.width // 2, 0, *image.size)))
        assert image.width > 1000
        assert left.min() < 80
        assert right.min() < 80
        assert left.std() > 10
        assert right.std() > 10


@pytest.mark.slow
def test_an_animation(capsys, tmp_path, monkeypatch):
    """A picture for each time, of a body that turns; on a terminal a bar."""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr("gyrostat.charts.progress.QUIET", 0.0)
    monkeypatch.setattr("gyrostat.charts.progress.PAUSE", 0.0)
    status, out, err = run(capsys, *FREE, "--until", "3", "--count", "3", "--output",
                           str(tmp_path / "box.gif"))
    assert status == 0 and out == "" and "animation    [" in err and "] 3/3" in err and "\rroute" in err
    with Image.open(tmp_path / "box.gif") as film:
        frames = []
        for n in range(film.n_frames):
            film.seek(n)
            frames.append(np.asarray(film.convert("L"), dtype=int))
    assert len(frames) == 3 and all(np.abs(a - b).max() > 80 for a, b in zip(frames, frames[1:]))


def test_no_film_without_its_program(capsys, tmp_path, monkeypatch):
    """It is said before anything is drawn."""
    monkeypatch.setattr(FFMpegWriter, "isAvailable", lambda: False)
    monkeypatch.setattr("gyrostat.plotting.animate_top", None)
    status, _, err = run(capsys, *FREE, "--until", "3", "--output", str(tmp_path / "box.mp4"))
    assert status == 2 and "needs the program ffmpeg" in err and list(tmp_path.iterdir()) == []
