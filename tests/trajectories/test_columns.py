"""Columns of a motion: quaternions, Euler's angles, angular velocity, units."""
import numpy as np
import pytest

import gyrostat as gs
from gyrostat.trajectories import motion
from gyrostat.trajectories.columns import columns, euler, quaternions

RANDOM = np.random.default_rng(5)


def rotated(q, x):
    """q x q*, with Hamilton's product written out."""
    def product(a, b):
        return np.array([a[0] * b[0] - a[1:] @ b[1:],
                         *(a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:]))])
    return product(product(q, np.array([0, *x])), q * [1, -1, -1, -1])[1:]


def turn(axis, angle):
    """A rotation, by Rodrigues' formula."""
    n = np.asarray(axis) / np.linalg.norm(axis)
    K = np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def test_a_quaternion_turns_as_its_matrix_does():
    """x_space = q x_body q*, half turns included, where the scalar part is 0."""
    turns = [turn(RANDOM.normal(size=3), angle) for angle in (*RANDOM.uniform(-7, 7, 40), np.pi, 0)] + [
        np.diag([1, -1, -1.0])
    ]
    for q, R in zip(quaternions(np.array(turns)), turns):
        x = RANDOM.normal(size=3)
        np.testing.assert_allclose(rotated(q, x), R @ x, atol=1e-14)           # a few roundings
        assert abs(q @ q - 1) < 1e-15


def test_the_sign_goes_on():
    """After a whole turn the quaternion is the negative of the first one, which has q0 ≥ 0."""
    angles = np.linspace(0, 4 * np.pi, 41)
    found = quaternions(np.array([turn((1, 2, 3), angle) for angle in angles]))
    np.testing.assert_allclose(found[:, 0], np.cos(angles / 2), atol=1e-14)
    assert (np.einsum("ij,ij->i", found[1:], found[:-1]) > 0.98).all()
    assert quaternions(np.empty((0, 3, 3))).shape == (0, 4)


def test_angles_are_those_of_the_turn():
    """R = Rz(φ) Rx(θ) Rz(ψ)."""
    phi, theta, psi = RANDOM.uniform(-3, 3, 20), RANDOM.uniform(0.1, 3, 20), RANDOM.uniform(-3, 3, 20)
    turns = np.array([turn((0, 0, 1), a) @ turn((1, 0, 0), b) @ turn((0, 0, 1), c)
                      for a, b, c in zip(phi, theta, psi)])
    np.testing.assert_allclose(euler(turns), np.stack([phi, theta, psi], axis=1), atol=1e-13)


def test_the_quaternion_moves_with_omega():
    """q̇ = ½ q ω, ω in the body: the columns of one table belong together."""
    top = motion(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()),
                 ("0.3", "-0.2", "1.5", "0.6", 0, "0.8"),
                 {"I1": 1, "I3": "0.6", "l": "0.4", "m0": 1})
    t, h = np.linspace(0, 5, 6), 1e-4
    times = np.sort(np.concatenate([t - h, t, t + h]))
    of = {c.name: c.values for c in columns(top.scene, times, top(times), top.attitude(times))}
    q, omega = (np.stack([of[f"{x}{i}"] for i in r], axis=1)
                for x, r in (("q", range(4)), ("omega", (1, 2, 3))))
    for n in range(1, len(times), 3):
        rate, w = (q[n + 1] - q[n - 1]) / (2 * h), omega[n]
        wanted = np.array([-q[n, 1:] @ w, *(q[n, 0] * w + np.cross(q[n, 1:], w))]) / 2
        np.testing.assert_allclose(rate, wanted, atol=1e-6)                    # h² times the third derivative


def test_units():
    """Those of SI, of every column."""
    box = motion(gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, 0))), (1, 2, 3))
    at = np.zeros(1)
    found = {c.name: c.units for c in columns(box.scene, at, box(at), box.attitude(at))}
    assert found == {"pi1": "kg m2 s-1", "pi2": "kg m2 s-1", "pi3": "kg m2 s-1", "omega1": "s-1",
                     "omega2": "s-1", "omega3": "s-1",
                     "q0": "1", "q1": "1", "q2": "1", "q3": "1", "phi": "rad", "theta": "rad", "psi": "rad"}
    assert [c.name for c in columns(box.scene, np.zeros(1), box(np.zeros(1)), None)][-1] == "omega3"


@pytest.mark.parametrize("given", ["10", "1/3", "sqrt(2)", "0.1"])
def test_the_state_at_the_time_0_is_the_one_given(given):
    """To the last bit, also among other times, and in all digits."""
    scene, numbers = gs.assemble(gs.symmetric_gyrostat(),
                                 gs.uniform_field()), {"I1": 1, "I3": "0.6", "l": "0.4", "m0": 1}
    state = ("0.3", "-0.2", given, "0.6", 0, "0.8")
    top = motion(scene, state, numbers)
    exact = [float(x) for x in top.state]
    assert top(0.0).tolist() == exact and top([[1.0, 0.0]])[0, 1].tolist() == exact
