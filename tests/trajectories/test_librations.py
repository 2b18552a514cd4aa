"""Roll, pitch and yaw of a satellite: against matrices made here, and against its frequencies."""
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gyrostat as gs
from gyrostat.trajectories import motion, roll_pitch_yaw

AXES = [(1, 2, 3), (3, 1, 2), (1, -2, -3), (-2, 1, 3), (2, 3, 1), (-1, 3, 2)]
ROLL, PITCH, YAW = np.eye(3)


def turn(axis, angle):
    """By Rodrigues' formula."""
    across = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * across + (1 - np.cos(angle)) * across @ across


def placed(pointing):
    """Rows: the axes t, n, r of an untilted body in its own axes; t = n × r."""
    n, r = (np.sign(axis) * np.eye(3)[abs(axis) - 1] for axis in pointing[1:])
    return np.array([np.cross(n, r), n, r])


@given(angles=st.tuples(st.floats(-3.1, 3.1), st.floats(-1.57, 1.57), st.floats(-3.1, 3.1)),
       pointing=st.sampled_from(AXES))
@settings(max_examples=40)
def test_angles_of_a_matrix(angles, pointing):
    """First yaw about r, then pitch about the turned axis of pitch, then roll about that of roll."""
    body = np.eye(3)                                       # columns: the body's roll, pitch, yaw in t, n, r
    for axis, angle in ((2, angles[2]), (1, angles[1]), (0, angles[0])):
        body = turn(body[:, axis], angle) @ body           # about its own axis, where that is now
    turns = body @ placed(pointing)                        # from the body to t, n, r
    found = roll_pitch_yaw(turns[[2, 0, 1]], pointing)     # an attitude has r, t, n
    assert np.allclose(found, angles, atol=1e-9)


@pytest.mark.few(1)
@pytest.mark.parametrize("pointing", AXES)
def test_what_is_let_go_has_those_angles(pointing):
    """At rest in the frame: π = ω0 In."""
    scene = gs.assemble(gs.Gyrostat((60, 70, 50), (0, 0, 0)), gs.circular_orbit("1/3"))
    state = gs.release(scene, ("20 deg", "-1/10", "0.3"), pointing)
    moving = motion(scene, state)
    assert np.allclose(roll_pitch_yaw(moving.attitude(0.0), pointing), (np.pi / 9, -0.1, 0.3), atol=1e-14)
    n = np.array([float(x) for x in state[3:6]])
    assert np.allclose([float(x) for x in state[:3]], np.array([60, 70, 50]) * n / 3)


@pytest.mark.slow
def test_pitch_swings_at_its_frequency():
    """√(3 (I_roll − I_yaw)/I_pitch) ω0, theory A3; a small swing in pitch stays in pitch."""
    scene = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(2))
    moving = motion(scene, gs.release(scene, (0, "1/10000", 0)))
    times = np.linspace(0, 6, 200)
    roll, pitch, yaw = roll_pitch_yaw(moving.attitude(times)).T
    assert abs(pitch - 1e-4 * np.cos(np.sqrt(75 / 70) * 2 * times)).max() < 1e-11
    assert abs(roll).max() < 1e-14 and abs(yaw).max() < 1e-14


@pytest.mark.parametrize(("angles", "wrong"), [
    ((0, 0), "2 angles"), ((0, 0, "x y"), "cannot read"), ((0, 0, "k3"), "names k3")])
def test_impossible_angles(angles, wrong):
    """Refused, with their name."""
    scene = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(2))
    with pytest.raises(gs.errors.GyrostatError, match=wrong):
        motion(scene, gs.release(scene, angles))


def test_only_in_orbit():
    """Of a body in a fixed field there is no roll."""
    scene = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)))
    with pytest.raises(gs.errors.ScopeError, match="circular_orbit"):
        gs.release(scene, (0, 0, 0))
