"""Critical rotations whose first approximations are poor."""
import numpy as np
import pytest

import gyrostat as gs


@pytest.mark.slow
@pytest.mark.parametrize("digits", [3, 7, 10])
def test_wheels_that_nearly_hold_an_attitude(digits):
    """With l·t = −ω0 t·In and l·r = −4 ω0 r·In, in rpm that are rounded, it points as exactly as they say."""
    height = 6378136.6 + 500_000
    rpm = np.sqrt(3.986004418e14 / height**3) / 5e-5 * 30 / np.pi
    speeds = {(1, 0, 0): 0.31 * rpm, (0, 1, 0): 2000, (0, 0, 1): 4 * 0.12 * rpm}
    wheels = [gs.Rotor(axis, "0.05 g m^2", rate=f"{s:.{digits}f} rpm") for axis, s in speeds.items()]
    tensor = "[[14.2, -0.31, 0], [-0.31, 13.6, -0.12], [0, -0.12, 2.05]] kg m^2"
    body = gs.gyrostat_with_rotors(tensor, wheels, lumped=True)
    found = gs.relative_equilibria(gs.assemble(body, gs.circular_orbit(height="500 km")), {})
    least = min(abs(e.attitude.roll) + abs(e.attitude.pitch) + abs(e.attitude.yaw) for e in found)
    assert len(found) == 12 and least < 10.0 ** (1 - digits)
