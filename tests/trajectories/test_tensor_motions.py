"""Motions of bodies whose inertia tensor is full: the same as in principal axes, turned."""
import numpy as np
import pytest
from sympy import Matrix
from turns import of_quaternion

import gyrostat as gs

R = of_quaternion(1, 2, -1, 3)
TIMES = np.array([0.0, 0.5, 3.0, 40.0])
BODIES = [((1, 2, 3), (0, 0, 0)), ((1, 2, 3), ("1/5", "-1/3", "1/2")), ((2, 2, 3), (0, 0, 1)),
          ((3, 2, 2), (0, 0, 0))]


def pair(inertia, rotor):
    """A body in principal axes, and in axes x' = R x."""
    body = gs.Gyrostat(inertia, rotor)
    tensor = R * body.tensor * R.T
    return body, gs.Gyrostat(tensor.tolist(), list(R * Matrix(body.gyrostatic_momentum)))


@pytest.mark.few(1)
@pytest.mark.parametrize(("inertia", "rotor"), BODIES)
def test_a_free_body_in_any_axes(inertia, rotor):
    """π, ω, period and attitude; the attitude up to the turn about M that makes φ = 0."""
    body, other = pair(inertia, rotor)
    state = (1, -2, 3)
    one = gs.trajectories.motion(gs.assemble(body), state)
    two = gs.trajectories.motion(gs.assemble(other), list(R * Matrix(state)))
    turn = np.array(R.tolist(), dtype=float)
    assert two.route == one.route
    np.testing.assert_allclose(two(TIMES), one(TIMES) @ turn.T, atol=1e-12)
    if one.period:
        assert two.period == pytest.approx(one.period, rel=1e-13)
        assert two.precession == pytest.approx(one.precession, rel=1e-11)
    away = two.attitude(TIMES) @ turn @ np.swapaxes(one.attitude(TIMES), -1, -2)
    np.testing.assert_allclose(away, np.broadcast_to(away[0], away.shape), atol=1e-10)   # one turn, about z
    np.testing.assert_allclose(away[0, 2], [0, 0, 1], atol=1e-12)
    assert two.angles(0.0)[0] == pytest.approx(0, abs=1e-12)
    assert max(two.drift(TIMES).values()) < 1e-13


def test_the_axes_of_a_cubic():
    """Moments that are roots of a cubic: the integrals hold, Euler's equations too."""
    scene = gs.assemble(gs.Gyrostat([[4, 1, 0], [1, 3, 1], [0, 1, 5]], (0, 0, 0)))
    motion = gs.trajectories.motion(scene, (1, 2, 0))
    assert max(motion.drift(TIMES).values()) < 1e-13
    h = 1e-4
    slope = (motion(1 + h) - motion(1 - h)) / (2 * h)
    here = dict(zip(scene.space.coordinates, map(float, motion(1.0))))
    field = [float(e.xreplace(here)) for e in scene.vector_field()]
    np.testing.assert_allclose(slope, field, atol=1e-7)


def test_the_table_of_a_motion():
    """ω is I⁻¹ π, in the axes of the tensor."""
    _, body = pair((1, 2, 3), ("1/5", 0, 0))
    table = gs.trajectories.motion(gs.assemble(body), (1, 2, 3)).to_xarray(TIMES)
    tensor = np.array(body.tensor.tolist(), dtype=float)
    omega = np.array([table[f"omega{i}"] for i in (1, 2, 3)])
    np.testing.assert_allclose(tensor @ omega, [table[f"pi{i}"] for i in (1, 2, 3)], atol=1e-13)
    assert table.attrs["inertia"] == str(body.inertia.tolist())


def test_a_field_integrates_a_tensor(monkeypatch):
    """Turned, the same motion."""
    # heyoka compiles longer than this takes
    monkeypatch.setattr("gyrostat.trajectories.integrated.integrated_motion.find_spec", lambda name: None)
    body, other = pair((1, 2, 3), (0, 0, "1/2"))
    k = Matrix([0, 0, 1])
    state = (1, 2, 3, "3/5", 0, "4/5")
    field = gs.general_potential(lambda *x: x[2] + x[0] * x[1])
    one = gs.trajectories.motion(gs.assemble(body, field), state)

    def turned(*x):
        y = R.T * Matrix(x)
        return y[2] + y[0] * y[1]

    start = [*(R * Matrix([1, 2, 3])), *(R * (3 * Matrix([1, 0, 0]) + 4 * k) / 5)]
    two = gs.trajectories.motion(gs.assemble(other, gs.general_potential(turned)), start)
    turn = np.kron(np.eye(2), np.array(R.tolist(), dtype=float))
    np.testing.assert_allclose(two(2.0), turn @ one(2.0), atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("rotor", [28, "9*pi"])
def test_principal_axes_that_are_roots_of_a_cubic(rotor):
    """M turns as Euler's equations say."""
    tensor = ((120, 2, 3), (2, 80, -1), (3, -1, 40))
    body = gs.Gyrostat(tensor, (0, 0, rotor))
    thrown = gs.trajectories.motion(gs.assemble(body), (1, 0, "1/2"))
    step = 1e-3
    before, here, after = thrown(np.array([7 - step, 7, 7 + step]))
    M = here + [0, 0, float(body.gyrostatic_momentum[2])]
    torque = np.cross(M, np.linalg.solve(np.array(tensor), here))
    np.testing.assert_allclose((after - before) / (2 * step), torque, atol=1e-7)
