"""The picture of a well, read back: V by formulas of this file, descents and walks of its own."""
from fractions import Fraction

import numpy as np
import pytest
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import gyrostat as gs
from gyrostat.errors import ArgumentError, ScopeError
from gyrostat.plotting import draw_well
from gyrostat.plotting.filled_well import facing
from gyrostat.plotting.looks import BLUE, INK
from gyrostat.plotting.well_of_tilts import WATER

WATER_LOOKS = (WATER, "#e4edf6")                       # in front, and behind
NEAR = 0.07                                            # of a cell on the sphere
TENSOR = ((3, "1/2", 0), ("1/2", 2, "1/3"), (0, "1/3", 4))
# inertia, rotor, c and Q of U = c·k + k·Qk/2, C1; of a free body abs(M) and the sign of its well
HEAVY = [((1, 2, 3), (0, 0, 1), (1, 1, 1), (0, 0, 0), 2.5),
         ((1, 2, 4), (0, 0, 0), (0, 0, 1), (2, 0, 0), 1),
         ((1, 2, 4), (0, 0.5, 0), (0, 0.25, -1), (-2, 1, 0.5), -0.5),
         (TENSOR, (0, 0.5, 1), (1, 0, 1), (0, 0, 0), 4),
         (((5, "3/5", "-4/5"), ("3/5", 4, "-3/5"), ("-4/5", "-3/5", 6)), (0, 0, 0), (0.125, 0.25, 0.125),
          (0, 0, 0), 6)]                               # an edge of the grid leads through the neck
FREE = [((1, 2, 3), (0.1, 0.2, 0.15), 1, 1), ((3, 1, 2), (0, 0, 0.25), 2, -1)]
SATELLITES = [((60, 70, 35), (0, 0, 0)), ((1, 1.25, 1.6), (0.3, 0.2, 0.1))]


def texts(numbers):
    return [texts(x) if isinstance(x, (tuple, list)) else str(x) for x in numbers]


def unit(x):
    return x / np.linalg.norm(x, axis=-1, keepdims=True)


def heavy(inertia, rotor, c, Q, level):
    tensor = np.array([[float(Fraction(x)) for x in row] for row in inertia]) if isinstance(
        inertia[0], tuple) else np.diag(inertia)
    U = " + ".join(f"({a})*k{n} + ({b})*k{n}^2/2" for n, (a, b) in enumerate(zip(c, Q), 1))
    scene = gs.assemble(gs.Gyrostat(texts(inertia), texts(rotor)), gs.general_potential(U))
    c, Q, l = (np.array(x, float) for x in (c, Q, rotor))

    def V(k):
        return k @ c + k**2 @ Q / 2 + (level - k @ l)**2 / (2 * np.einsum("...i,ij,...j", k, tensor, k))
    return scene, {"C1": str(level)}, V, 1.0


def free(inertia, rotor, M, sign):
    scene = gs.assemble(gs.Gyrostat(texts(inertia), texts(rotor)))
    I, l = np.array(inertia, float), np.array(rotor, float)
    return scene, {"M": M}, lambda k: sign * (M * k - l)**2 @ (1 / I) / 2, float(M)


def known(scene, values, sign=1):
    """The first rotation with a well; of a free body one that is a minimum of sign·h."""
    return next(e for e in gs.relative_equilibria(scene, values) if e.well.barrier_double
                and (e.form.index == 0) == (sign == 1))


def drawn(rotation):
    up, aside = facing(rotation)
    return draw_well(rotation, Figure().add_subplot(projection="3d", elev=up, azim=aside))


class Kept(Poly3DCollection):
    """Polygons that keep their vertices, which Matplotlib holds in other ways from version to version."""

    def __init__(self, faces, **style):
        super().__init__(faces, **style)
        self.kept, self.colour = [np.array(face) for face in faces], style["facecolor"]


@pytest.fixture(autouse=True)
def _keeping(monkeypatch):
    monkeypatch.setattr("mpl_toolkits.mplot3d.art3d.Poly3DCollection", Kept)


def polygons(ax, *colours):
    """The filled polygons of some colours, each of shape (n, 3)."""
    return [face for part in ax.collections if isinstance(part, Kept) and part.colour in colours
            for face in part.kept]


def rim(ax, colour):
    """The vertices of the heavy curves; the outline of the sphere may cut a chord."""
    eye = np.array([np.cos(np.radians(ax.elev)) * np.cos(np.radians(ax.azim)),
                    np.cos(np.radians(ax.elev)) * np.sin(np.radians(ax.azim)), np.sin(np.radians(ax.elev))])
    points = np.concatenate([np.array(x.get_data_3d()).T for x in ax.lines
                             if x.get_color() == colour and x.get_linewidth() == 1.6])
    points = points[np.isfinite(points).all(axis=1)]
    return points[np.abs(points @ eye) > 1e-9 * np.linalg.norm(points[0])]


def marks(ax, *shapes):
    return np.array([place for x in ax.lines if x.get_marker() in shapes for place in zip(*x.get_data_3d())])


def slope(V, k, h=1e-6):
    steps = h * np.eye(3)
    full = np.stack([V(unit(k + e)) - V(unit(k - e)) for e in steps], axis=-1) / (2 * h)
    return full - (full * k).sum(axis=-1, keepdims=True) * k


def lowest(V, k, rounds=2500):
    """The ends of descents; every step is short, and halved where V would rise."""
    step = np.full((len(k), 1), 0.02)
    for _ in range(rounds):
        down = slope(V, k)
        new = unit(k - step * down / np.maximum(np.linalg.norm(down, axis=-1, keepdims=True), 1e-12))
        good = (V(new) < V(k))[:, None]
        k, step = np.where(good, new, k), np.where(good, step, step / 2)
    return k


@pytest.mark.slow
@pytest.mark.parametrize("case", [*HEAVY, *FREE], ids=str)
def test_what_is_filled_lies_below_the_pass(case):
    """Vertices at most at the barrier, the rim on it, the pass a critical point on the rim."""
    scene, values, V, size = (heavy if len(case) == 5 else free)(*case)
    rotation = known(scene, values, case[-1] if len(case) == 4 else 1)
    ax, barrier = drawn(rotation), rotation.well.barrier_double
    [start], passes = marks(ax, "v", "^")[:1] / size, marks(ax, "D") / size
    if not len(passes):                                # a summit closes the sphere
        passes = marks(ax, "^") / size
    low = V(start)
    assert np.abs(slope(V, np.array([start, *passes]))).max() < 1e-6 * max(1, barrier)
    np.testing.assert_allclose(V(passes), low + barrier, rtol=1e-9)
    faces = polygons(ax, *WATER_LOOKS)
    vertices = np.concatenate(faces) / size
    assert np.abs(np.linalg.norm(vertices, axis=1) - 1).max() < 1e-9
    assert V(vertices).max() <= low + barrier * (1 + 1e-9)
    edge = rim(ax, BLUE) / size
    np.testing.assert_allclose(V(edge), low + barrier, atol=1e-9 * barrier)
    for place in passes:
        assert np.linalg.norm(edge - place, axis=1).min() < NEAR
    # nothing is missing, nothing is beside it: by descents from points at random
    k = unit(np.random.default_rng(0).normal(size=(400, 3)))
    ends = lowest(V, k)
    own = (V(k) < low + barrier) & (np.linalg.norm(ends - start, axis=1) < 1e-3)
    middles = np.array([face.mean(axis=0) for face in faces]) / size
    apart = np.linalg.norm(middles[None] - k[:, None], axis=2).min(axis=1)
    assert apart[own].max() < NEAR and 20 < own.sum()
    clear = (V(k) > low + 1.1 * barrier) | (~own & (V(k) < low + 0.9 * barrier))
    assert not clear.any() or apart[clear].min() > 0.005


@pytest.mark.slow
@pytest.mark.parametrize(("inertia", "rotor"), SATELLITES)
def test_where_the_vertical_and_the_normal_stay(inertia, rotor):
    """Least V over all turns at most that of the pass, on the rim equal to it; a walk below it stays."""
    scene = gs.assemble(gs.Gyrostat(texts(inertia), texts(rotor)), gs.circular_orbit(1))
    rotation = next(e for e in gs.relative_equilibria(scene, {}) if e.well.barrier_double)
    I, l = np.array(inertia, float), np.array(rotor, float)
    ax, barrier = drawn(rotation), rotation.well.barrier_double

    def V(n, r):
        return 1.5 * r**2 @ I - n**2 @ I / 2 - n @ l

    def least(x, of_n):
        first = unit(np.cross(x, np.array([0.3, 0.5, 0.8])))
        second, turn = np.cross(x, first), np.linspace(0, 2 * np.pi, 1441)[:, None, None]
        y = np.cos(turn) * first + np.sin(turn) * second
        x = np.broadcast_to(x, y.shape)
        return V(*((x, y) if of_n else (y, x))).min(axis=0)

    n, r = marks(ax, "v")[:2]
    low, reached = V(n, r), {}
    for of_n, looks, colour in ((True, ("#f4dfb6", "#f9efda"), INK["undecided"]), (False, WATER_LOOKS, BLUE)):
        reached[of_n] = np.concatenate(polygons(ax, *looks))
        assert least(reached[of_n][::7], of_n).max() < low + barrier * (1 + 1e-4)
        np.testing.assert_allclose(least(rim(ax, colour)[::3], of_n), low + barrier, rtol=1e-4)
    crests = marks(ax, "D")                            # each pass by its n and its r
    for one in crests:
        assert any(abs(V(*pair) - low - barrier) < 1e-9 * barrier for other in crests
                   for pair in ((one, other), (other, one)) if abs(one @ other) < 1e-12)
    rng, far = np.random.default_rng(1), 0.0
    for _ in range(4000):                              # turns of the body at random
        turn = 0.1 * rng.normal(size=3)
        moved = [v + np.cross(turn, v) + np.cross(turn, np.cross(turn, v)) / 2 for v in (n, r)]
        moved[0] = unit(moved[0])
        moved[1] = unit(moved[1] - (moved[1] @ moved[0]) * moved[0])
        if V(*moved) < low + barrier:
            n, r = moved
            far = max(far, *(np.linalg.norm(reached[of_n] - x, axis=1).min()
                             for of_n, x in ((True, n), (False, r))))
    assert 0 < far < NEAR


def tops():
    """U, U at z, I1, P, C1 and the sign of the slope of the list: two wells, and one at a pole."""
    quartic = gs.axial_potential("k3^4 - k3^2/2"), lambda z: z**4 - z**2 / 2
    return [(*quartic, 2, 0.5, 0.1, 0), (*quartic, 2, 0.5, 0.1, 1)]


@pytest.mark.slow
@pytest.mark.parametrize(("field", "U", "I1", "P", "C1", "which"), tops(), ids=["lower", "upper"])
def test_the_tilts_of_a_top(field, U, I1, P, C1, which):
    """Filled between V and the height of the pass, from one end of the reach to the other."""
    scene = gs.assemble(gs.Gyrostat((I1, I1, 1), (0, 0, 0)), field)
    found = [e for e in gs.relative_equilibria(scene, {"C1": str(C1), "pi3_0": str(P)})
             if e.well.barrier_double]
    rotation = found[which]
    ax = draw_well(rotation, Figure().subplots())

    def V(z):
        return U(z) + (C1 - P * z)**2 / (2 * I1 * (1 - z**2))

    start, crest = (np.array(next(x.get_data() for x in ax.lines if x.get_marker() == shape)).ravel()
                    for shape in "vD")
    z, height = ax.lines[1].get_data()
    np.testing.assert_allclose(height, V(z) - V(start[0]), rtol=1e-9, atol=1e-12)
    assert crest[1] == pytest.approx(V(crest[0]) - V(start[0]), rel=1e-12)
    assert abs(V(crest[0] + 1e-5) - V(crest[0] - 1e-5)) < 1e-12 > abs(V(start[0] + 1e-5) - V(start[0] - 1e-5))
    filled = np.concatenate([path.vertices for path in ax.collections[0].get_paths()])
    low, high = filled[:, 0].min(), filled[:, 0].max()
    for end in (low, high):
        assert V(end) - V(start[0]) == pytest.approx(crest[1], rel=1e-9)
    inside = np.linspace(low, high, 300)[1:-1]
    assert (V(inside) - V(start[0]) < crest[1]).all() and low < start[0] < high
    assert filled[:, 1].max() == pytest.approx(crest[1]) and filled[:, 1].min() > -1e-12


def test_without_a_pass():
    """A sleeping top: the curve alone, and the title says so."""
    top = gs.assemble(gs.Gyrostat((1, 1, "8/5"), (0, 0, 0)), gs.axial_potential("k3"))
    ax = draw_well(gs.relative_equilibria(top, {"omega": 2})[0], Figure().subplots())
    assert "no pass at any energy" in ax.get_title() and not ax.collections
    assert np.isfinite(ax.get_ylim()).all()


def test_what_cannot_be_drawn():
    """An unstable one, and axes of the wrong kind."""
    body = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    rotations = gs.relative_equilibria(body, {"M": 1})
    with pytest.raises(ScopeError, match="there is no well to draw: it is not stable"):
        draw_well(rotations[2])
    with pytest.raises(ArgumentError, match="the picture is a view of space"):
        draw_well(rotations[0], Figure().subplots())
    top = gs.assemble(gs.Gyrostat((1, 1, "8/5"), (0, 0, 0)), gs.axial_potential("k3"))
    with pytest.raises(ArgumentError, match="give flat axes"):
        draw_well(gs.relative_equilibria(top, {"omega": 2})[0], Figure().add_subplot(projection="3d"))
