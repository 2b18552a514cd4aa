"""Wheels in rpm at a height in km: their momentum over ω0 is rounded, and that is said."""
import math

import numpy as np
import pytest

import gyrostat as gs

SHEET = {"inertia": "[[62.1, 1.3, -0.8], [1.3, 71.4, 0.6], [-0.8, 0.6, 38.2]] kg m^2", "lumped": True,
         "rotors": ["axis=0,1,0 inertia=0.02 kg m^2 speed=3000 rpm",
                    "axis=0,0,1 inertia=0.02 kg m^2 speed=-500 rpm"], "orbit": "height=500 km"}


@pytest.fixture(scope="module")
def found():
    """What decide answers to the sheet."""
    return gs.questions.decide(SHEET)


def test_each_attitude_satisfies_the_equations_of_the_sheet(found):
    """t·Ir = 0, t·(ω0 In + l) = 0, r·(4 ω0 In + l) = 0 with l = (0, 2π, −π/3), within the rounding."""
    inertia = np.array([[62.1, 1.3, -0.8], [1.3, 71.4, 0.6], [-0.8, 0.6, 38.2]])
    rate = math.sqrt(398600.4418 / (6378.1366 + 500)**3)
    over = np.array([0, 0.02 * 100 * math.pi, -0.02 * 500 * math.pi / 30]) / rate
    assert len(found["equilibria"]) == 8
    for each in found["equilibria"]:
        n, r = (np.array([float(each["place"][f"{x}{i}"]["decimal"]) for i in (1, 2, 3)]) for x in "nr")
        t = np.cross(n, r)
        left = t @ inertia @ r, t @ (inertia @ n + over), r @ (4 * inertia @ n + over)
        assert np.abs(left).max() < 1e-7                  # 12 digits of some 6000, and the decimals printed


def test_that_they_are_rounded_is_said_once(found):
    """And nothing of it where no number is rounded."""
    assert "rounded to 12 digits" in found["note"]
    exact = gs.questions.decide(SHEET | {"rotors": ["axis=0,1,0 inertia=0.02 kg m^2 speed=30 rad/s"],
                                         "inertia": "62, 71, 38 kg m^2"})
    assert "rounded" not in exact.get("note", "")
