"""The bifurcation set of a free gyrostat in a plane of its rotor: curves, and numbers in the regions."""
import re
from fractions import Fraction as F

import counted_rotations as found
import numpy as np
import pytest
from matplotlib.figure import Figure
from sympy import Rational

import gyrostat as gs
from gyrostat.equilibria.curves.rotor_planes import numbers_of_rotations_over
from gyrostat.errors import ScopeError, ValuesError
from gyrostat.plotting import draw_rotor_set
from gyrostat.plotting.looks import BLUE, DARK

SCENE = gs.assemble(gs.Gyrostat((1, 2, 3)))
PLANES = [("l2", "0"), ("l3", "0"), ("l1", "1/10"), ("l3", "3/10")]


@pytest.fixture(scope="module", params=PLANES, ids=" ".join)
def drawn(request):
    held, value = request.param
    free = [name for name in ("l1", "l2", "l3") if name != held]
    return draw_rotor_set(SCENE, {held: value, "M": 1}, Figure().subplots()), free, {held: value}


def rotor_at(free, held, x, y):
    given = {free[0]: F(x), free[1]: F(y), **{name: F(value) for name, value in held.items()}}
    return [given[name] for name in ("l1", "l2", "l3")]


@pytest.mark.slow
def test_the_number_in_a_region_is_that_of_its_rotations(drawn):
    """As Sturm's theorem counts them where the text stands; every number that there is, is shown."""
    ax, free, held = drawn
    numbers = {text.get_text() for text in ax.texts}
    assert {"2", "4"} <= numbers <= {"2", "4", "6"}
    for text in ax.texts:
        rotor = rotor_at(free, held, *map(float, text.get_position()))
        assert (int(text.get_text()), 0) == found.count((F(1), F(2), F(3)), rotor, F(1))


@pytest.mark.slow
def test_rotations_meet_on_the_curves(drawn):
    """Across a line of the plane, where a curve crosses it and nowhere else."""
    ax, free, held = drawn
    at = Rational(7, 53)
    points = gs.bifurcation_points(SCENE, free[1], {**held, free[0]: at, "M": 1})
    assert points
    for kind, color in (("fold", DARK), ("pitchfork", BLUE)):
        exact = sorted(float(p.value) for p in points if p.kind == kind)
        crossed = []
        for line in (line for line in ax.lines if line.get_color() == color):
            x, y = map(np.asarray, line.get_data())
            for n in np.flatnonzero((x[:-1] - float(at)) * (x[1:] - float(at)) < 0):
                crossed.append(np.interp(float(at), *zip(*sorted(zip(x[n:n + 2], y[n:n + 2])))))
        np.testing.assert_allclose(sorted(crossed), exact, atol=1e-3)


def test_counts_in_doubles_are_those_of_sturm():
    """At points of a grid that is on no curve."""
    moments = (F(13, 10), F(2), F(7, 10))
    x, y = (np.linspace(-1.03, 1.07, 7) for _ in range(2))
    rotor = [np.full((7, 7), 0.17), *np.meshgrid(x, y)]
    ours = numbers_of_rotations_over(np.array(moments, float), rotor, 1.0)
    theirs = [[found.count(moments, [F(0.17), F(b), F(a)], F(1))[0] for b in x] for a in y]
    assert ours.tolist() == theirs and {2, 4} <= set(np.unique(ours))


@pytest.mark.slow
def test_axes_and_legend(drawn):
    """What the picture is of; the free components and their dimension; pitchforks where the third is 0."""
    ax, free, held = drawn
    names = [text.get_text() for text in ax.get_legend().get_texts()]
    dimension = r"$[\mathrm{M\,L^{2}\,T^{-1}}]$"
    assert (ax.get_xlabel(), ax.get_ylabel()) == tuple(f"$l_{name[1]}$ {dimension}" for name in free)
    (name, value), = held.items()
    assert ax.get_title() == f"$l_{name[1]} = {value}$, $I_1 = 1$, $I_2 = 2$, $I_3 = 3$, $|M| = 1$"
    assert names == (["fold", "pitchfork"] if "0" in held.values() else ["fold"])
    styles = {(line.get_color(), line.get_linestyle()) for line in ax.lines}
    assert len(styles) == len(names) == len({style for _, style in styles})          # in grey too


@pytest.mark.parametrize(("scene", "values", "error", "words"), [
    (SCENE, {"l1": 0, "l2": 0, "M": 1}, ValuesError, "without a number are l3, and the picture is a plane"),
    (SCENE, {"l1": 0}, ValuesError, "without a number are M, l2, l3"),
    (SCENE, {"l1": 0, "M": 0}, ValuesError, "give a positive number"),
    (gs.assemble(gs.Gyrostat((1, 1, 3))), {"l1": 0, "M": 1}, ScopeError, "two moments are equal"),
    (gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), {}, ScopeError, "assemble the body alone")])
def test_what_is_refused(scene, values, error, words):
    """What was given, why it is impossible, what to do."""
    with pytest.raises(error, match=words):
        draw_rotor_set(scene, values, Figure().subplots())


@pytest.mark.slow
def test_a_tensor_is_drawn_along_its_principal_axes():
    """The same picture as of its moments; what is said of the axes diagonalises the tensor."""
    tensor = np.array([[2, 1, 0], [1, 3, 1], [0, 1, 5]])
    moments = np.linalg.eigvalsh(tensor)
    pictures = [draw_rotor_set(gs.assemble(gs.Gyrostat(inertia)), {"l2": "1/5", "M": 1}, Figure().subplots())
                for inertia in (tensor, moments.tolist())]
    for one, other in zip(*(ax.lines for ax in pictures), strict=True):
        np.testing.assert_allclose(one.get_xydata(), other.get_xydata(), rtol=1e-6, atol=1e-9)
    said = pictures[0].get_title()
    axes = np.array([float(x) for x in re.findall(r"-?\d\.\d\d", said)]).reshape(3, 3)
    np.testing.assert_allclose(axes @ tensor @ axes.T, np.diag(moments), atol=0.1)
    assert np.linalg.det(axes) == pytest.approx(1, abs=0.05)


def test_a_tensor_with_a_rotor_in_its_own_axes_is_refused():
    scene = gs.assemble(gs.Gyrostat([[2, 1, 0], [1, 3, 1], [0, 1, 5]], (0, 0, gs.symbol("l"))))
    with pytest.raises(ScopeError, match="leave it out of the body"):
        draw_rotor_set(scene, {"M": 1}, Figure().subplots())
