"""Librations of satellites in the frame of their orbit, against integration in inertial axes."""
from random import Random

import numpy as np
import pytest
from inertial import followed
from slow import sampled

import gyrostat as gs


def librating(rng):
    """A gyrostat near an equilibrium that is stable by its energy: moments, rotor, rate, π, n and r."""
    least, middle, greatest = sorted(rng.uniform(1, 3) for _ in range(3))
    if greatest > 0.95 * (least + middle) or middle - least < 0.1 or greatest - middle < 0.1:
        return librating(rng)
    moments, rate = np.array([middle, greatest, least]), rng.uniform(0.2, 2)
    rotor = np.array([0, rng.uniform(0, 1) * rate, 0])
    turn = np.array([[0, 0, 1.0], [1, 0, 0], [0, 1, 0]]) @ small(rng)   # rows r, t, n in body axes
    n, r = turn[2], turn[0]
    omega = rate * n + np.array([rng.uniform(-1, 1) for _ in range(3)]) * 1e-2 * rate
    return moments, rotor, rate, omega, turn, moments * omega, n, r


def small(rng):
    """A rotation by some degrees."""
    a = np.array([rng.uniform(-1, 1) for _ in range(3)]) * 0.05
    hat = np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])
    return np.linalg.solve(np.eye(3) - hat, np.eye(3) + hat)


@pytest.mark.slow
def test_librations(full):
    """To 10⁻¹⁰ over twenty orbits."""
    rng = Random("librations")
    for _ in range(sampled(50, full, 2)):
        moments, rotor, rate, omega, turn, pi, n, r = librating(rng)
        scene = gs.assemble(gs.Gyrostat(tuple(moments), tuple(rotor)), gs.circular_orbit(float(rate)))
        motion = gs.trajectories.motion(scene, (*pi, *n, *r))
        times = np.linspace(0, 40 * np.pi / rate, 41)
        found, (w, normal, vertical) = motion(times), followed(moments, rotor, rate, omega, turn, times)
        assert np.abs(found[:, 3:6] - normal).max() < 1e-10
        assert np.abs(found[:, 6:] - vertical).max() < 1e-10
        assert np.abs(found[:, :3] / moments - w).max() < 1e-10 * max(1, rate)
        assert max(motion.drift(times).values()) < 1e-11
        frame = motion.attitude(times)
        assert np.abs(frame[:, 2] - normal).max() < 1e-10 and np.abs(frame[:, 0] - vertical).max() < 1e-10


@pytest.mark.slow
def test_a_free_wheel():
    """Its axial momentum stays, and gravity acts on it: without that the motion is another."""
    rng = Random("a free wheel")
    moments, _, rate, omega, turn, _, n, r = librating(rng)
    wheel = gs.Rotor((1, 0, 0), axial=0.3, momentum=0.2)
    body = gs.gyrostat_with_rotors(tuple(moments), [wheel], lumped=True)
    left, wheels = np.array([float(x) for x in body.moments]), np.array([0.3, 0, 0])
    scene = gs.assemble(body, gs.circular_orbit(float(rate)))
    motion, times = gs.trajectories.motion(scene, (*(left * omega), *n, *r)), np.linspace(0, 10 / rate, 21)
    w, normal, vertical = followed(left, (0.2, 0, 0), rate, omega, turn, times, wheels)
    found = motion(times)
    assert np.abs(found[:, 3:6] - normal).max() < 1e-10 and np.abs(found[:, 6:] - vertical).max() < 1e-10
    _, other, _ = followed(left, (0.2, 0, 0), rate, omega, turn, times)
    assert np.abs(found[:, 3:6] - other).max() > 1e-3


def test_a_table_and_notes():
    """Columns of both directions; what is no frame is said."""
    scene = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(1))
    table = gs.trajectories.motion(scene, (0, 70, 0, 0, 1, 0, 0, 0, 1)).to_xarray([0.0, 1.0])
    assert {"n1", "r3", "omega2", "q0"} <= set(table) and "the frame" in table.q1.attrs["long_name"]
    note = gs.trajectories.motion(scene, (0, 70, 0, 0, 1, 0, 0, "1/2", 1)).attributes["note"]
    assert note.startswith("n1*r1 + n2*r2 + n3*r3 = 0.5") and "has to be 0" in note


def test_exact_digits_are_refused():
    """It is integrated."""
    scene = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(1))
    with pytest.raises(gs.errors.ScopeError, match="integrated"):
        gs.trajectories.motion(scene, (0, 70, 0, 0, 1, 0, 0, 0, 1), precision=30)


@pytest.mark.slow
def test_a_satellite_is_not_searched_for_an_axis_of_revolution(monkeypatch):
    """In two directions no body is one of revolution in U(k3): its numbers are not simplified to know it."""
    def refused(*_, **__):
        raise AssertionError("the square of k was simplified")
    monkeypatch.setattr("gyrostat.trajectories.turned_motion.trigsimp", refused)
    monkeypatch.setattr("gyrostat.trajectories.turned_motion.lowest", refused)
    scene = gs.assemble(gs.Gyrostat((60, 70, 35), (1, 2, 3)), gs.circular_orbit(1))
    assert gs.trajectories.motion(scene, gs.release(scene, ("5 deg", "3 deg", "1/10"))).recognised == ""
