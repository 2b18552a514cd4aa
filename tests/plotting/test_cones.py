"""The cones of a free body of revolution touch along ω, and their angles are those of M, ω and e3."""
from itertools import combinations

import numpy as np
import pytest
from draw import moments, nonzero
from hypothesis import given, settings
from matplotlib.figure import Figure

from gyrostat.errors import ScopeError
from gyrostat.plotting import draw_cones
from gyrostat.plotting.cones import Cone, cones

CASES = [((2, 1), 1, 2), ((1, 2), 1, 1), ((5, 1), 1, 3), ((1, "1.9"), 1, "0.4"), ((2, 1), 1, -2)]


def angle(a, b):
    return np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)


@pytest.mark.parametrize("inertia, transverse, axial", CASES)
def test_the_cones_touch_along_omega(inertia, transverse, axial):
    """ω is on both cones, in the plane of their axes; M, ω, e3 have the angles of I ω and ω in the body."""
    space, body, vectors = cones(inertia, transverse, axial)
    omega = np.array([float(transverse), 0, float(axial)])
    M = np.array([float(inertia[0]), 0, float(inertia[1])]) * omega
    e3 = np.array([0, 0, 1.0])
    expected = {("M", "omega"): angle(M, omega), ("M", "e3"): angle(M, e3), ("omega", "e3"): angle(omega, e3)}
    for (a, b), value in expected.items():
        assert angle(vectors[a], vectors[b]) == pytest.approx(value, abs=1e-12)
    assert space.angle == pytest.approx(expected["M", "omega"], abs=1e-12)
    assert body.angle == pytest.approx(expected["omega", "e3"], abs=1e-12)
    assert abs(np.linalg.det([vectors["M"], vectors["omega"], vectors["e3"]])) < 1e-15


def test_rim_and_outline_are_on_the_cone():
    """Every generator has the half-angle; at the outline the surface is seen edge on."""
    cone, eye = Cone(np.array([0, 0.6, 0.8]), 0.4), np.array([0.9, 0.1, np.sqrt(0.18)])
    for points in (cone.rim(), cone.outline(eye)):
        np.testing.assert_allclose(points @ cone.axis, np.cos(0.4), rtol=1e-14)
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), 1, rtol=1e-14)
    normals = np.cross(cone.outline(eye), np.cross(cone.outline(eye), cone.axis))
    assert len(normals) == 2
    np.testing.assert_allclose(normals @ eye, 0, atol=1e-15)
    # seen from within its own angle
    assert len(cone.outline(cone.axis * 0.99 + 0.01 * np.array([1.0, 0, 0]))) == 0


def test_the_picture():
    """Two surfaces that take the arguments, three arrows with their names."""
    ax = draw_cones((2, 1), 1, 2, Figure().add_subplot(projection="3d"), alpha=0.2)
    surfaces = [c for c in ax.collections if c.get_alpha() == 0.2]
    assert len(surfaces) == 2 and [text.get_text() for text in ax.texts] == ["$M$", r"$\omega$", "$e_{3}$"]
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["space cone", "body cone"]


@pytest.mark.parametrize("inertia, transverse, axial", [((2, 1), 0, 1), ((2, 2), 1, 1), ((2, 1), 1, 0)])
def test_no_cone_where_omega_lies_along_m(inertia, transverse, axial):
    """What was given, why there is no cone, what to do."""
    with pytest.raises(ScopeError,
                       match="ω lies along M, there is no space cone; give two different moments, and two "
                             "rates"):
        draw_cones(inertia, transverse, axial)


@pytest.mark.slow
@given(moments, moments, nonzero, nonzero)
@settings(max_examples=6)
def test_what_is_drawn_lies_on_the_cones_and_on_the_vectors(I1, I3, transverse, axial):
    """Rims and wedges on the two cones about M and e3, arrows and names along M, ω, e3, the cones touch along
    ω.
    """
    if I1 == I3:
        return
    ax = draw_cones((I1, I3), abs(transverse), axial, Figure().add_subplot(projection="3d"))
    w = np.array([float(abs(transverse)), 0, float(axial)])
    M = np.array([float(I1), 1, float(I3)]) * w
    texts = {text.get_text(): np.array(text.get_position_3d()) for text in ax.texts}
    directions = {name: place / np.linalg.norm(place) for name, place in texts.items()}
    vectors = {"$M$": M, r"$\omega$": w, "$e_{3}$": np.array([0, 0, 1.0])}
    for a, b in combinations(vectors, 2):
        assert angle(directions[a], directions[b]) == pytest.approx(angle(vectors[a], vectors[b]), abs=1e-9)
    rims = [np.array(line.get_data_3d()).T for line in ax.lines if len(line.get_data_3d()[0]) > 50]
    for rim, axis, half in zip(rims, ("$M$", "$e_{3}$"), (angle(M, w), angle(w, np.array([0, 0, 1.0])))):
        np.testing.assert_allclose(rim @ directions[axis], np.cos(half), atol=1e-9)
        # within a step of the rim
        assert np.linalg.norm(rim - directions[r"$\omega$"], axis=1).min() < 0.06
        assert np.linalg.norm(rim[0] - rim[-1]) < 1e-9
