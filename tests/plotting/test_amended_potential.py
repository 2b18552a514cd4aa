"""The picture of the amended potential, read back and computed again in doubles."""
from collections import Counter

import numpy as np
import pytest
from matplotlib.figure import Figure
from sympy import Matrix, Rational

import gyrostat as gs
from gyrostat.errors import ArgumentError
from gyrostat.plotting import draw_amended_potential
from gyrostat.plotting.amended_potential import CURVES
from gyrostat.plotting.looks import BLUE, DARK

SHAPES = {"v": "minimum", "D": "saddle", "^": "maximum"}
TENSOR = ((3, Rational(1, 2), 0), (Rational(1, 2), 2, Rational(1, 3)), (0, Rational(1, 3), 4))
# inertia, rotor, c and Q of U = c·k + k·Qk/2, C1
BODIES = [(((1, 0, 0), (0, 2, 0), (0, 0, 3)), (0, 0, 1), (1, 1, 1), (0, 0, 0), 5),
          (((1, 0, 0), (0, 2, 0), (0, 0, 4)), (0, 0, 0), (0, 0, 1), (2, 0, 0), 1),
          (TENSOR, (0, Rational(1, 2), 1), (1, 0, 1), (0, 0, 0), 4)]


@pytest.fixture(scope="module", params=BODIES, ids=["rotor", "quadratic", "tensor"])
def drawn(request):
    """The axes, and U_c in doubles."""
    inertia, rotor, c, Q, level = request.param
    U = gs.general_potential(lambda *k: sum(a * x + b * x**2 / 2 for a, b, x in zip(c, Q, k)))
    tensor = inertia if any(inertia[i][j] for i in range(3) for j in range(i)) else [
        inertia[n][n] for n in range(3)]
    scene = gs.assemble(gs.Gyrostat(tensor, rotor), U)
    ax = draw_amended_potential(scene, {"C1": level}, Figure().add_subplot(projection="3d"))
    I, l, c, Q = (np.array(Matrix(x).evalf().tolist(), float) for x in (inertia, rotor, c, Q))

    def value(k):
        twist = level - k @ l[:, 0]
        return k @ c[:, 0] + k**2 @ Q[:, 0] / 2 + twist**2 / (2 * np.einsum("...i,ij,...j", k, I, k))
    return ax, value


def curves(ax, color, width):
    """Vertices of the lines of one look, in their pieces; without those where the outline cuts a chord."""
    for shown in ax.lines:
        if shown.get_color() == color and shown.get_linewidth() == width and shown.get_marker() == "None":
            k = np.array(shown.get_data_3d()).T
            k = k[np.isfinite(k).all(1)]
            eye = np.array([np.cos(np.radians(ax.elev)) * np.cos(np.radians(ax.azim)),
                            np.cos(np.radians(ax.elev)) * np.sin(np.radians(ax.azim)),
                            np.sin(np.radians(ax.elev))])
            yield k[np.abs(k @ eye) > 1e-9]


def marked(ax):
    """Kind and place of every critical point."""
    return [(SHAPES[shown.get_marker()], np.array(place), shown) for shown in ax.lines
            if shown.get_marker() in SHAPES for place in zip(*shown.get_data_3d())]


def bend(value, k):
    """Gradient, and the eigenvalues of the second differences, along the sphere."""
    plane, h = np.linalg.svd(k[None])[2][1:], 1e-4

    def at(x, y):
        moved = k + h * (x * plane[0] + y * plane[1])
        return value(moved / np.linalg.norm(moved))
    slope = [(at(1, 0) - at(-1, 0)) / (2 * h), (at(0, 1) - at(0, -1)) / (2 * h)]
    mixed = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * h * h)
    form = [[(at(1, 0) - 2 * at(0, 0) + at(-1, 0)) / h**2, mixed],
            [mixed, (at(0, 1) - 2 * at(0, 0) + at(0, -1)) / h**2]]
    return np.array(slope), np.linalg.eigvalsh(np.array(form))


@pytest.mark.slow
def test_every_vertex_is_on_its_level(drawn):
    ax, value = drawn
    heights = []
    for k in curves(ax, BLUE, 0.7):
        if len(k):
            assert np.abs(np.linalg.norm(k, axis=1) - 1).max() < 1e-12
            assert np.ptp(value(k)) < 1e-12 * np.abs(value(k)).max()
            heights.append(value(k).mean())
    levels = np.unique(np.round(heights, 9))
    assert len(levels) == CURVES
    sample = np.random.default_rng(0).normal(size=(20000, 3))
    below = value(sample / np.linalg.norm(sample, axis=1)[:, None])
    parts = [np.mean(below < level) for level in levels]
    assert np.abs(np.array(parts) - (np.arange(CURVES) + 0.5) / CURVES).max() < 0.03


@pytest.mark.slow
def test_no_curve_is_missing(drawn):
    """Where the amended potential passes a level on circles of latitude, its curve is near."""
    ax, value = drawn
    lines = np.concatenate(list(curves(ax, BLUE, 0.7)))
    heights, turn = value(lines), np.linspace(0.001, 2 * np.pi, 3000)
    for height in (-0.91, -0.4, 0.13, 0.55, 0.84):
        size = np.sqrt(1 - height**2)
        k = np.stack([size * np.cos(turn), size * np.sin(turn), np.full(turn.shape, height)], axis=1)
        for level in np.unique(np.round(heights, 9)):
            own = lines[np.abs(heights - level) < 1e-8]
            found = value(k) - level
            for n in np.flatnonzero(found[1:] * found[:-1] < 0):
                assert np.linalg.norm(own - k[n], axis=1).min() < 0.03


@pytest.mark.slow
def test_marks_are_the_critical_points(drawn):
    """No slope, and the signs of the second differences; minima − saddles + maxima = 2."""
    ax, value = drawn
    count = Counter()
    for kind, k, shown in marked(ax):
        slope, signs = bend(value, k)
        assert np.abs(slope).max() < 1e-7
        assert kind == {2: "minimum", 0: "saddle", -2: "maximum"}[int(np.sign(signs).sum())]
        count[kind] += 1
        if kind == "saddle":                                   # unstable: open
            assert shown.get_markerfacecolor() == "white"
        if kind == "minimum":
            assert shown.get_color() == BLUE
    assert count["minimum"] - count["saddle"] + count["maximum"] == 2


@pytest.mark.slow
def test_curves_through_saddles(drawn):
    """From saddle to saddle, on its level; as many as there are ways out."""
    ax, value = drawn
    saddles = np.array([k for kind, k, _ in marked(ax) if kind == "saddle"])
    vertices = np.concatenate([k for k in curves(ax, DARK, 1.8) if len(k)])
    off = np.abs(value(vertices)[:, None] - value(saddles)).min(axis=1)
    assert off.max() < 1e-12 * np.abs(value(saddles)).max()
    for saddle in saddles:
        around = vertices[np.linalg.norm(vertices - saddle, axis=1) < 0.03]
        turn = (around[np.linalg.norm(around - saddle, axis=1) > 0.015] - saddle) @ np.linalg.svd(
            saddle[None])[2][1:].T
        angles = np.unique(np.round(np.degrees(np.arctan2(turn[:, 1], turn[:, 0])) / 8))
        groups = 1 + np.sum(np.diff(np.sort(angles)) > 1.5)
        assert groups >= 4


@pytest.mark.slow
def test_legend_and_heading():
    U = gs.general_potential(lambda *k: sum(k))
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), U)
    ax = draw_amended_potential(scene, {"C1": 5}, Figure().add_subplot(projection="3d"), color="red")
    assert [text.get_text() for text in ax.get_legend().get_texts()] == [
        "level curve", "through a saddle", "minimum, stable", "saddle, unstable", "maximum, stable"]
    assert ax.get_title().replace("\n", " ") == (
        "$U = k_1 + k_2 + k_3$: $l = 1$, $I_1 = 1$, $I_2 = 2$, $I_3 = 3$, $C_{1} = 5$")
    assert any(shown.get_color() == "red" for shown in ax.lines)
    with pytest.raises(ArgumentError, match="the picture is a view of space"):
        draw_amended_potential(scene, {"C1": 5}, Figure().subplots())
