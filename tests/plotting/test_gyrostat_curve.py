"""The picture of the permanent rotations of a gyrostat, read back and computed again in doubles."""
import heavy
import numpy as np
import pytest
from matplotlib.figure import Figure
from sympy import Rational

import gyrostat as gs
from gyrostat.plotting import draw_staude_cone
from gyrostat.plotting.globe import towards
from gyrostat.plotting.looks import LINES
from gyrostat.plotting.staude_cone import CHANGE, FOLD, OPPOSITE, REST, STEP

GENERAL = (1, 2, "13/5"), (1, 0, 3), (1, "1/2", 0)


def picture(inertia, c, rotor):
    U = gs.general_potential(lambda *k: sum(Rational(x) * y for x, y in zip(c, k)))
    return draw_staude_cone(gs.assemble(gs.Gyrostat(inertia, rotor), U), {},
                            Figure().add_subplot(projection="3d"))


@pytest.fixture(scope="module")
def drawn():
    inertia, c, rotor = (np.array([float(Rational(x)) for x in v]) for v in GENERAL)
    return picture(*GENERAL), np.diag(inertia), c, rotor


def points(ax, color):
    """Of the arcs of a colour, those before and those behind."""
    lines = [np.array(line.get_data_3d()).T for line in ax.lines
             if line.get_color() == color and line.get_marker() == "None" and line.get_linewidth() == 2.0]
    found = np.concatenate(lines) if lines else np.zeros((0, 3))
    return found[np.isfinite(found).all(1)]


def marked(ax, style):
    return np.concatenate([np.array(line.get_data_3d()).T for line in ax.lines
                           if line.get_marker() == style["marker"]])


def rate(inertia, c, rotor, k):
    """omega of omega² Ik × k + omega l × k = c × k, from omega² and omega as two unknowns; what is left."""
    sides = np.stack([np.cross(inertia @ k, k), np.cross(rotor, k)], axis=1)
    (square, omega), *_ = np.linalg.lstsq(sides, np.cross(c, k), rcond=None)
    left = np.abs(omega**2 * sides[:, 0] + omega * sides[:, 1] - np.cross(c, k)).max()
    return omega, left / (1 + omega**2), np.linalg.svd(sides)[1][-1]


@pytest.mark.slow
def test_every_vertex_is_a_rotation_of_that_verdict(drawn):
    ax, inertia, c, rotor = drawn
    checked, changes = 0, marked(ax, CHANGE)
    for verdict, (color, _) in LINES.items():
        for k in points(ax, color)[::3]:
            assert abs(np.linalg.norm(k) - 1) < 1e-9
            omega, left, least = rate(inertia, c, rotor, k)
            if abs(k @ towards(ax)) < 1e-9 or least < 1e-3 or abs(omega) > 1e3:
                continue                                   # the outline cuts a chord
            assert left < 1e-9, k
            found = heavy.verdict(inertia, rotor, c, np.zeros((3, 3)), omega, k)
            if found and np.linalg.norm(changes - k, axis=1).min() > 1e-9:
                assert ("STABLE" if found == "UNDECIDED" else found) == verdict.upper(), k      # by D4
                checked += 1
    assert checked > 60


@pytest.mark.slow
def test_nothing_of_the_curve_is_missing(drawn):
    """Where the polynomial changes its sign on circles of latitude, a line is near."""
    ax, inertia, c, rotor = drawn
    lines = np.concatenate([points(ax, color) for color, _ in LINES.values()])
    turn, seen = np.linspace(0.001, 2 * np.pi, 4000), 0
    for height in (-0.83, -0.31, 0.17, 0.62, 0.9):
        k = np.stack([np.sqrt(1 - height**2) * np.cos(turn), np.sqrt(1 - height**2) * np.sin(turn),
                      np.full(turn.shape, height)], axis=1)
        a, b, d = (np.sum(k * np.cross(x, y), axis=1) for x, y in
                   ((k @ inertia, c), (k @ inertia, rotor), (c, rotor)))
        value = a**2 - b * d
        for n in np.flatnonzero(value[1:] * value[:-1] < 0):
            assert np.linalg.norm(lines - k[n], axis=1).min() < STEP, k[n]
            seen += 1
    assert seen > 8


@pytest.mark.slow
def test_marks_and_legend(drawn):
    ax, inertia, c, rotor = drawn
    names = [text.get_text() for text in ax.get_legend().get_texts()]
    assert names == ["stable", "unstable", "stable to unstable", "unstable, other reason", "fold", "at rest"]
    assert not [line for line in ax.lines if line.get_linewidth() == OPPOSITE["linewidth"]
                and line.get_color() == OPPOSITE["color"]]
    rest = marked(ax, REST)
    assert np.abs(np.sort(np.abs(rest @ c)) - np.linalg.norm(c)).max() < 1e-12 and len(rest) == 2
    for k in marked(ax, FOLD):                             # of one rate there, two on one side
        omega, left, _ = rate(inertia, c, rotor, k)
        assert left < 1e-9
        near = [sum(np.abs(x - k).max() < 0.05 for x in heavy.directions(
            inertia, rotor, c, np.zeros((3, 3)), omega + side)) for side in (-1e-4, 1e-4)]
        assert sorted(near) == [0, 2]
