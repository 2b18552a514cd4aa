"""Wheels in rpm at a height in km: the attitudes of a data sheet."""
import math

import numpy as np
import pytest

from gyrostat.questions.answers.answers import answers_at
from gyrostat.questions.scene_texts import Asked

TENSOR = "[[62.1, 1.3, -0.8], [1.3, 71.4, 0.6], [-0.8, 0.6, 38.2]] kg m^2"
WHEELS = ("axis=0,1,0 inertia=0.02 kg m^2 speed=3000 rpm", "axis=0,0,1 inertia=0.02 kg m^2 speed=-500 rpm")


@pytest.mark.slow
def test_each_attitude_satisfies_the_equations_of_the_sheet():
    """t·Ir = 0, t·(ω0 In + l) = 0, r·(4 ω0 In + l) = 0 with l = (0, 2π, −π/3)"""
    inertia = np.array([[62.1, 1.3, -0.8], [1.3, 71.4, 0.6], [-0.8, 0.6, 38.2]])
    rate = math.sqrt(398600.4418 / (6378.1366 + 500)**3)
    over = np.array([0, 0.02 * 100 * math.pi, -0.02 * 500 * math.pi / 30]) / rate
    found = answers_at(Asked(inertia=TENSOR, rotors=WHEELS, orbit="height=500 km").of_body(()), None, {})
    assert len(found) == 8
    for each in found:
        n, r = (np.array([each.found.doubles.place[f"{x}{i}"] for i in (1, 2, 3)]) for x in "nr")
        t = np.cross(n, r)
        left = t @ inertia @ r, t @ (inertia @ n + over), r @ (4 * inertia @ n + over)
        assert np.abs(left).max() < 1e-7                  # of doubles, times some 6000
