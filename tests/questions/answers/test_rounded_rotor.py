"""Wheels in rpm at a height in km: their momentum over ω0 is rounded, and that is said."""
import math
from functools import cache

import numpy as np

from gyrostat.questions.answers.answer_list import note_once
from gyrostat.questions.answers.answers import answers_at
from gyrostat.questions.scene_texts import Asked

TENSOR = "[[62.1, 1.3, -0.8], [1.3, 71.4, 0.6], [-0.8, 0.6, 38.2]] kg m^2"
WHEELS = ("axis=0,1,0 inertia=0.02 kg m^2 speed=3000 rpm", "axis=0,0,1 inertia=0.02 kg m^2 speed=-500 rpm")


@cache
def answers(inertia, *wheels):
    """What decide answers to a data sheet, 500 km above the Earth."""
    return answers_at(Asked(inertia=inertia, rotors=wheels, orbit="height=500 km").of_body(()), None, {})


def test_each_attitude_satisfies_the_equations_of_the_sheet():
    """t·Ir = 0, t·(ω0 In + l) = 0, r·(4 ω0 In + l) = 0 with l = (0, 2π, −π/3), within the rounding."""
    inertia = np.array([[62.1, 1.3, -0.8], [1.3, 71.4, 0.6], [-0.8, 0.6, 38.2]])
    rate = math.sqrt(398600.4418 / (6378.1366 + 500)**3)
    over = np.array([0, 0.02 * 100 * math.pi, -0.02 * 500 * math.pi / 30]) / rate
    found = answers(TENSOR, *WHEELS)
    assert len(found) == 8
    for each in found:
        n, r = (np.array([each.found.doubles.place[f"{x}{i}"] for i in (1, 2, 3)]) for x in "nr")
        t = np.cross(n, r)
        left = t @ inertia @ r, t @ (inertia @ n + over), r @ (4 * inertia @ n + over)
        assert np.abs(left).max() < 1e-7                  # 12 digits of some 6000


def test_that_they_are_rounded_is_said_once():
    """And nothing of it where no number is rounded."""
    assert "rounded to 12 digits" in note_once(answers(TENSOR, *WHEELS))[0]
    exact = answers("62, 71, 38 kg m^2", "axis=0,1,0 inertia=0.02 kg m^2 speed=30 rad/s")
    assert "rounded" not in note_once(exact)[0] and "rounded" not in exact[0].decision.note
