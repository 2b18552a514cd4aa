"""The picture of Staude's cone, read back and computed again from the equations of motion in doubles."""
import heavy
import numpy as np
import pytest
from matplotlib.figure import Figure
from sympy import Rational

import gyrostat as gs
from gyrostat.errors import ArgumentError
from gyrostat.plotting import draw_staude_cone
from gyrostat.plotting.looks import LINES
from gyrostat.plotting.staude_cone import CHANGE, OPPOSITE, STEP

BODIES = [((1, 2, 3), (1, 1, 1)), ((3, 5, 4), (0, "2/3", "2/3")), ((1, 2, 3), (0, 0, 1)),
          ((2, 2, 3), (1, 2, 1))]


def picture(inertia, c):
    U = gs.general_potential(lambda *k: sum(Rational(x) * y for x, y in zip(c, k)))
    return draw_staude_cone(gs.assemble(gs.Gyrostat(inertia, (0, 0, 0)), U), {},
                            Figure().add_subplot(projection="3d"))


@pytest.fixture(scope="module", params=BODIES, ids=str)
def drawn(request):
    inertia, c = request.param
    return picture(inertia, c), np.diag(np.array(inertia, float)), np.array([float(Rational(x)) for x in c])


def points(ax, color, width=None):
    """Of the lines of a colour, those before and those behind."""
    lines = [line for line in ax.lines if line.get_color() == color and line.get_marker() == "None"
             and line.get_linewidth() == (width or 2.0)]
    found = np.concatenate([np.array(line.get_data_3d()).T for line in lines]) if lines else np.zeros((0, 3))
    return found[np.isfinite(found).all(1)]


def marked(ax):
    """Where the verdict changes."""
    return np.concatenate([np.array(line.get_data_3d()).T for line in ax.lines
                           if line.get_marker() == CHANGE["marker"]])


def rate_squared(inertia, c, k):
    """w of w Ik × k = c × k in the least squares sense, and what is left."""
    lever, torque = np.cross(inertia @ k, k), np.cross(c, k)
    w = lever @ torque / max(lever @ lever, 1e-30)         # 0 on a principal axis
    return w, np.abs(w * lever - torque).max()


@pytest.mark.slow
def test_every_vertex_is_a_rotation_of_that_verdict(drawn):
    """Spectra and signatures; off the ends, where a boundary or an infinite rate is."""
    ax, inertia, c = drawn
    checked, changes = 0, marked(ax)
    for verdict, (color, _) in LINES.items():
        for k in points(ax, color)[::3]:
            assert abs(np.linalg.norm(k) - 1) < 1e-3       # the outline cuts a chord
            w, left = rate_squared(inertia, c, k)
            if left > 1e-9 or not 1e-3 < w < 1e3 or np.linalg.norm(changes - k, axis=1).min() < 1e-9:
                continue
            data = (inertia, np.zeros(3), c, np.zeros((3, 3)), np.sqrt(w))
            growth, form = heavy.growth(*data, k), heavy.squares(*data, k)
            if np.abs(form).min() > 1e-3 * np.abs(form).max() and not 1e-7 < growth < 1e-2:
                assert verdict.upper() == ("UNSTABLE" if growth > 1e-2 else "STABLE"), k
                checked += 1
    assert checked > 25


@pytest.mark.slow
def test_the_opposite_directions_have_no_rate(drawn):
    ax, inertia, c = drawn
    grey = points(ax, OPPOSITE["color"], OPPOSITE["linewidth"])
    assert len(grey) > 100
    off = [k for k in grey if np.abs(np.cross(inertia @ k, k)).max() > 1e-6]
    assert all(rate_squared(inertia, c, k)[0] < 1e-9 for k in off)


@pytest.mark.slow
def test_nothing_of_the_cone_is_missing(drawn):
    """Where the polynomial changes its sign on circles of latitude, a line is near."""
    ax, inertia, c = drawn
    lines = np.concatenate([points(ax, color) for color, _ in LINES.values()]
                           + [points(ax, OPPOSITE["color"], OPPOSITE["linewidth"])])
    turn = np.linspace(0.001, 2 * np.pi, 4000)
    for height in (-0.83, -0.31, 0.17, 0.62):
        k = np.stack([np.sqrt(1 - height**2) * np.cos(turn), np.sqrt(1 - height**2) * np.sin(turn),
                      np.full(turn.shape, height)], axis=1)
        value = np.einsum("ni,ni->n", k, np.cross(c, k @ inertia))
        for n in np.flatnonzero(value[1:] * value[:-1] < 0):
            assert np.linalg.norm(lines - k[n], axis=1).min() < STEP, k[n]


@pytest.mark.slow
def test_legend_heading_and_marks():
    ax = picture((1, 2, 3), (1, 1, 1))
    names = [text.get_text() for text in ax.get_legend().get_texts()]
    assert names == ["stable", "unstable", "no rotation", "stable to unstable", "at rest"]
    assert ax.get_title() == "$U = k_1 + k_2 + k_3$: $I_1 = 1$, $I_2 = 2$, $I_3 = 3$"
    assert len(marked(ax)) == 3
    axis = picture((1, 2, 3), (0, 0, 1))
    assert [text.get_text() for text in axis.get_legend().get_texts()][-1] == "every rate"


def test_a_rotor_that_is_set_to_0():
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, gs.symbol("l"))),
                        gs.general_potential(lambda k1, k2, k3: k3))
    ax = draw_staude_cone(scene, {"I1": 1, "I2": 2, "I3": 3, "l": 0}, Figure().add_subplot(projection="3d"))
    assert "no rotation" in [text.get_text() for text in ax.get_legend().get_texts()]


def test_flat_axes_are_refused():
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), gs.general_potential(lambda *k: sum(k)))
    with pytest.raises(ArgumentError, match="the picture is a view of space"):
        draw_staude_cone(scene, {}, Figure().subplots())
