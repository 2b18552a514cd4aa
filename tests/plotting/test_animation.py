"""Pictures of a motion: the path of the axis, the body turning, its files, and the view of Plotly."""
import numpy as np
import pytest
from matplotlib.animation import FFMpegWriter
from matplotlib.figure import Figure
from PIL import Image
from sympy import diff, lambdify, symbols

import gyrostat as gs
from gyrostat.errors import ArgumentError, MissingExtraError, ValuesError
from gyrostat.plotting import animate_top, draw_nutation, save_animation, view_motion
from gyrostat.plotting.animation import NO_BODY, attitudes
from gyrostat.plotting.energy_levels import floats
from gyrostat.plotting.solids import solid
from gyrostat.trajectories import motion

TIMES = np.linspace(0, 10, 400)


@pytest.fixture(scope="module")
def top():
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    return motion(scene, (0, 0, 3, "0.8", 0, "0.6"), {"I1": 1, "I3": "1/2", "l": 0, "m0": 1})


@pytest.fixture(scope="module")
def box():
    return motion(gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, 0))), ("1/50", 2, 0))


def space():
    return Figure(figsize=(2, 2)).add_subplot(projection="3d", elev=22, azim=40)


def test_the_axis_stays_between_its_limits(top):
    """Its height is k3, which nods between the two circles that are drawn."""
    ax = draw_nutation(top, TIMES, space(), color="red")
    lines = [(line, np.array(line.get_data_3d()).T) for line in ax.lines]
    path = np.concatenate([points for line, points in lines if line.get_color() == "red"
                           and line.get_marker() == "None"])
    path = {tuple(point) for point in path.tolist()}
    assert {tuple(point) for point in top.attitude(TIMES)[..., 2].tolist()} <= path
    heights = [height for _, _, height in path if np.isfinite(height)]
    # reached between two of the times
    assert (min(heights), max(heights)) == pytest.approx(top.limits, abs=1e-3)
    dashed = {round(float(np.nanmedian(points[:, 2])), 12)
              for line, points in lines if line.get_linestyle() == "--"}
    assert dashed == {round(limit, 12) for limit in top.limits}
    assert [text.get_text() for text in ax.texts] == ["$x$", "$y$", "$z$"]


def test_no_limits_are_claimed_for_a_free_body(box):
    """The legend has the path alone."""
    ax = draw_nutation(box, TIMES, space())
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["axis of the body"]


@pytest.mark.parametrize("inertia", [(1, 2, 2.5), (3, 3, 5), (1, 1, 1)])
def test_a_box_has_the_moments_of_its_body(inertia):
    """Edges a, b, c of a homogeneous box have b² + c² : c² + a² : a² + b² as the moments.

    It fits into the sphere.
    """
    scene = gs.assemble(gs.Gyrostat(inertia, (0, 0, 0)))
    corners = np.concatenate([polygon for polygon, _ in solid(scene)])
    a, b, c = np.ptp(corners, axis=0)
    ratios = np.array([b * b + c * c, c * c + a * a, a * a + b * b]) / floats(scene.body.inertia)
    np.testing.assert_allclose(ratios, ratios[0], rtol=1e-12)
    assert np.linalg.norm(corners, axis=1).max() < 1


def test_the_body_turns_by_the_attitude(box, top):
    """Each picture has the faces of the body, turned by R; the path has come as far as the time."""
    for some in (box, top):
        ax = space()
        animation = animate_top(some, TIMES[::40], ax, interval=70)
        body = max((c for c in ax.collections), key=lambda c: len(c.get_facecolor()))
        animation._draw_was_started = True                 # nothing is shown here
        animation._func(5)
        R = some.attitude(TIMES[200])
        expected = np.concatenate([polygon @ R.T for polygon, _ in solid(some.scene)])
        ours = body._faces.reshape(-1, 3) if hasattr(body, "_faces") else body._vec[:3].T
        np.testing.assert_allclose(np.sort(ours.ravel()), np.sort(expected.ravel()), atol=1e-12)
        turns, path, fine, axis_of = attitudes(some, TIMES[::40])
        axis = 2 if some is top else 1
        np.testing.assert_allclose(path[::fine], turns[..., axis], atol=1e-12)
        drawn = np.concatenate([np.array(line.get_data_3d()).T for line in ax.lines[-2:]])
        assert np.nanmin(np.linalg.norm(drawn - path[5 * fine], axis=1)) == 0
        assert not (np.abs(drawn[:, None] - path[5 * fine + 1:]).sum(axis=-1) == 0).any()
        assert animation._interval == 70 and axis_of == axis
        assert f"$t = {TIMES[200]:.0f}$" in [text.get_text() for text in ax.texts]
        assert [text.get_text() for text in ax.get_legend().get_texts()] == [f"path of $e_{{{axis + 1}}}$"]
        assert "I_3 = " in ax.get_title() and r"$\pi(0) = (" in ax.get_title()


def test_files(box, tmp_path, monkeypatch):
    """A GIF with one picture for each time; MP4 only with ffmpeg; nothing else."""
    animation = animate_top(box, TIMES[:90:30], space())
    save_animation(animation, tmp_path / "box.gif", fps=5)
    with Image.open(tmp_path / "box.gif") as image:
        assert image.n_frames == 3 and image.info["duration"] == 200
    monkeypatch.setattr(FFMpegWriter, "isAvailable", classmethod(lambda cls: False))
    with pytest.raises(MissingExtraError,
                       match="box.mp4 needs the program ffmpeg.*install it, or write a .gif"):
        save_animation(animation, tmp_path / "box.mp4")
    with pytest.raises(ValuesError,
                       match="box.png is to be a .png file: animations are written as .gif, or as .mp4"):
        save_animation(animation, tmp_path / "box.png")


@pytest.mark.slow
def test_the_view_of_plotly(box):
    """A frame and a step of the slider for each time, the faces of the body as triangles, turned by R."""
    pytest.importorskip("plotly")
    figure = view_motion(box, TIMES[:90:30])
    assert len(figure.frames) == len(figure.layout.sliders[0].steps) == 3
    sphere, body, path = figure.data
    np.testing.assert_allclose(np.array(sphere.x) ** 2 + np.array(sphere.y) ** 2 + np.array(sphere.z) ** 2,
                               1, atol=2e-4)
    assert len(body.i) == len(body.facecolor) == 12 and max(body.k) < len(body.x) == 8
    R, last = box.attitude(TIMES[60]), figure.frames[-1]
    corners = np.stack([last.data[0].x, last.data[0].y, last.data[0].z], axis=1)
    triangles = corners[np.stack([body.i, body.j, body.k], axis=1)]
    for triangle, color in zip(triangles, body.facecolor):
        faces = [polygon @ R.T for polygon, other in solid(box.scene) if other == color]
        assert any((np.abs(corner - face).max(axis=1) < 1e-4).any() for face in faces for corner in triangle)
        assert any(all((np.abs(corner - face).max(axis=1) < 1e-4).any() for corner in triangle)
                   for face in faces)
    points = np.stack([path.x, path.y, path.z], axis=1)
    for n, frame in enumerate(figure.frames):
        middle = (frame.data[1].line.cmin + frame.data[1].line.cmax) / 2
        so_far = points[np.asarray(path.line.color) < middle]
        np.testing.assert_allclose(so_far[-1], box.attitude(TIMES[30 * n])[:, 1], atol=1e-4)


@pytest.mark.slow
def test_the_view_of_plotly_is_small(top):
    """Two hundred frames are less than a megabyte."""
    pytest.importorskip("plotly")
    assert len(view_motion(top, np.linspace(0, 20, 200)).to_json()) < 1e6


@pytest.mark.parametrize("draw", [draw_nutation, animate_top, view_motion])
def test_a_scene_is_no_motion(draw, box):
    """The message says what was given."""
    if draw is view_motion:
        pytest.importorskip("plotly")
    with pytest.raises(ArgumentError, match="the motion is a System, not a Motion"):
        draw(box.scene, TIMES)


def vertices(ax, color):
    """Points of the curves of a colour, as they are in the axes."""
    lines = [np.array(line.get_data_3d()).T for line in ax.lines if line.get_color() == color
             and line.get_marker() == "None"]
    points = np.concatenate(lines)
    return points[np.isfinite(points[:, 0])]


@pytest.mark.slow
@pytest.mark.parametrize("U, values, state", [
    (lambda z: z, {"I1": 1, "I3": "1/2", "l": 0}, (0, 0, 3, "0.8", 0, "0.6")),
    (lambda z: z**5 - 2 * z**3, {"I1": 2, "I3": 1, "l": "-1/2"}, ("1/3", "1/5", 2, "0.6", 0, "-0.8")),
    (lambda z: 1 / (z + 2), {"I1": 1, "I3": 3, "l": 1}, ("1/3", 0, "-1/2", 0, 1, 0)),
    (lambda z: z, {"I1": 1, "I3": "1/2", "l": 0}, (0, 0, 3, "1.6", 0, "1.2")),
    (lambda z: z, {"I1": 1, "I3": 1, "l": 0}, (0, 0, 3, 0, 0, 1))])
def test_the_path_is_that_of_the_vertical_seen_from_the_body(U, values, state):
    """Its height is k3/abs(k) of Euler and Poisson's equations, by Runge-Kutta.

    It nods between the circles drawn, also where abs(k) = 2.
    """
    z = symbols("z")
    slope = lambdify(z, diff(U(z), z))
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U))
    moved = motion(scene, state, values)
    I1, I3, l = (float(gs.algebra.text.numbers.exact_number(values[n])) for n in ("I1", "I3", "l"))
    I, rotor = np.array([I1, I1, I3]), np.array([0, 0, l])

    def rate(x):
        w = x[:3] / I
        return np.concatenate([np.cross(x[:3] + rotor, w) + np.cross(x[3:], [0, 0, slope(x[5])]),
                               np.cross(x[3:], w)])

    x = np.array([float(gs.algebra.text.numbers.exact_number(s)) for s in state])
    h, heights = TIMES[1] / 8, []
    for _ in range(len(TIMES)):
        heights.append(x[5] / np.linalg.norm(x[3:]))
        for _ in range(8):
            a = rate(x)
            b = rate(x + h / 2 * a)
            c = rate(x + h / 2 * b)
            x = x + h / 6 * (a + 2 * b + 2 * c + rate(x + h * c))
    ax = draw_nutation(moved, TIMES, space(), color="red")
    path = vertices(ax, "red")
    np.testing.assert_allclose(np.linalg.norm(path, axis=1), 1, rtol=1e-9)
    for height in heights:
        assert np.abs(path[:, 2] - height).min() < 1e-7                # the error of the Runge-Kutta method
    assert path[:, 2].min() == pytest.approx(min(heights), abs=1e-3)
    assert path[:, 2].max() == pytest.approx(max(heights), abs=1e-3)
    circles = {round(float(np.nanmedian(np.array(line.get_data_3d())[2])), 9)
               for line in ax.lines if line.get_linestyle() == "--"}
    names = [text.get_text() for text in ax.get_legend().get_texts()]
    assert ("limits of $k_{3}$" in names or "limits of $k_3$" in names) == bool(circles)
    for circle in circles:
        # a limit is reached between two of the times
        assert min(abs(circle - min(heights)), abs(circle - max(heights))) < 2e-3


def test_times_too_far_apart_are_refused_and_paths_of_animations_refined(top):
    """A chord across the sphere is not the path; the animation follows it between its pictures."""
    with pytest.raises(ValuesError, match="the axis moves by up to .*give about"):
        draw_nutation(top, np.linspace(0, 2000, 100), space())
    _, path, fine, _ = attitudes(top, np.linspace(0, 200, 10))
    assert np.linalg.norm(np.diff(path, axis=0), axis=1).max() < 0.2 and fine > 8


@pytest.mark.slow
def test_no_box_is_drawn_for_moments_that_no_body_has():
    """I = (1, 1, 3): bars along the axes, and a sentence; a plate, I3 = I1 + I2, is a box."""
    impossible = motion(gs.assemble(gs.Gyrostat((1, "1.1", 3), (0, 0, 0))), ("1/50", 2, 0))
    ax = space()
    animate_top(impossible, TIMES[:90:30], ax)._draw_was_started = True
    assert [text.get_text() for text in ax.texts if text.get_text() == NO_BODY] == [NO_BODY]
    corners = np.concatenate([polygon for polygon, _ in solid(impossible.scene)])
    assert np.ptp(corners, axis=0) == pytest.approx([1.8] * 3)
    plate = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    assert np.ptp(np.concatenate([polygon for polygon, _ in solid(plate)]), axis=0)[2] < 0.2
    thousand = gs.assemble(gs.Gyrostat((1000, 2000, 3000), (0, 0, 0)))
    for (polygon, _), (other, _) in zip(solid(plate), solid(thousand), strict=True):     # whatever the unit
        np.testing.assert_allclose(polygon, other, rtol=1e-12)


def test_the_surface_of_a_top_is_closed():
    """Every side of a face is a side of another one, or a point on the axis."""
    sides = []
    for polygon, _ in solid(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())):
        ends = [tuple(corner) for corner in (polygon.round(9) + 0.0).tolist()]
        sides += [frozenset(side) for side in zip(ends, ends[1:] + ends[:1])]
    assert {sides.count(side) for side in sides if len(side) == 2} == {2}
