"""Motions of vehicles, against the equations of their velocities."""
from random import Random

import numpy as np
import pytest
from kirchhoff import Vehicle, random_vehicle
from scipy.integrate import solve_ivp

import gyrostat as gs

HULL = Vehicle(np.diag([2, 2, 3]), np.array([[0, -1, 0], [1, 0, 0], [0, 0, 0]]), np.diag([3, 3, 1]),
               np.array([0, 0, 2]), np.array([0, 0, 1]))


def by_velocities(vehicle, z, times):
    """π, p and γ, by integrating Ω, v and γ."""
    J, D, M, weight, rotor = (np.array(part, dtype=float) for part in vehicle)
    T = np.block([[J, D], [D.T, M]])

    def field(_, y):
        pi, p = np.split(T @ y[:6], 2)
        omega, v, down = np.split(y, 3)
        torque = np.cross(pi + rotor, omega) + np.cross(p, v) - np.cross(down, weight)
        return [*np.linalg.solve(T, [*torque, *np.cross(p, omega)]), *np.cross(down, omega)]

    found = solve_ivp(field, (0, times[-1]), [float(x) for x in z], "DOP853", times, rtol=1e-13, atol=1e-14)
    return np.hstack([found.y[:6].T @ T, found.y[6:].T])


def scene_of(vehicle, weight):
    """The scene of a vehicle."""
    J, D, M, pull, rotor = ([[*map(str, row)] for row in part] if np.ndim(part) == 2 else [*map(str, part)]
                            for part in vehicle)
    return gs.underwater_vehicle(J, M, D, weight=pull if weight else None, gyrostatic_momentum=rotor)


@pytest.mark.slow
@pytest.mark.parametrize("weight", [True, False])
@pytest.mark.parametrize("vehicle", [HULL, random_vehicle(Random("motion"))], ids=["round", "general"])
def test_motion(vehicle, weight):
    """With the coupling, with weight or without; p has any length."""
    if not weight:
        vehicle = vehicle._replace(weight=[0, 0, 0])
    z, times = [0.3, -0.2, 0.5, 0.4, -0.3, 0.6, 0.6, 0, 0.8], np.linspace(0, 4, 9)
    expected = by_velocities(vehicle, z, times)
    state = [*expected[0], *(("3/5", 0, "4/5") if weight else ())][:9 if weight else 6]
    motion = gs.trajectories.motion(scene_of(vehicle, weight), state)
    assert np.abs(motion(times) - expected[:, :len(state)]).max() < 1e-8
    assert "|k|" not in motion.note and "has to be" not in motion.note


@pytest.mark.slow
def test_a_vertical_that_is_no_unit_vector():
    """It is said, as of the directions of an orbit that are not at right angles."""
    motion = gs.trajectories.motion(scene_of(HULL, True), (0, 0, 0, 1, 0, 0, 0, 0, 2))
    assert motion.note == "gamma1**2 + gamma2**2 + gamma3**2 = 4.00000000000, and has to be 1"
    orbit = gs.assemble(gs.Gyrostat((2, 3, 4), (0, 0, 0)), gs.circular_orbit(1))
    assert gs.trajectories.motion(orbit, (0, 0, 0, 1, 0, 0, 0, "3/5", "4/5")).note == ""
    tilted = gs.trajectories.motion(orbit, (0, 0, 0, 1, 0, 0, "3/5", 0, "4/5"))
    assert tilted.note.endswith("has to be 0")
