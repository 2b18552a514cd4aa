"""The momentum sphere of a body whose tensor is given in any axes."""
import numpy as np
import pytest

import gyrostat as gs
from gyrostat.plotting.energy_levels import energies_between, level_curve


def rotations(body, radius):
    return gs.relative_equilibria(gs.assemble(body), {"M": radius})


@pytest.mark.slow
def test_polhodes_of_a_tensor_lie_on_sphere_and_level_in_its_axes():
    """As many pieces as in principal axes, which are irrational; the energy is that of its own tensor."""
    tensor = np.array([[62.1, 1.3, -0.8], [1.3, 58, 0.2], [-0.8, 0.2, 30]])
    moments, axes = np.linalg.eigh(tensor)
    rotor = np.array([0.0, 0.0, 10.0])
    bodies = gs.Gyrostat(tensor, rotor), gs.Gyrostat(moments, axes.T @ rotor)
    points, turned = (rotations(body, 200) for body in bodies)
    for energy in energies_between(bodies[0], points, 1):
        M = level_curve(bodies[0], points, 200.0, energy)
        pi = M[np.isfinite(M[:, 0])] - rotor
        np.testing.assert_allclose(np.linalg.norm(pi + rotor, axis=1), 200, rtol=1e-12)
        np.testing.assert_allclose((pi * np.linalg.solve(tensor, pi.T).T).sum(axis=1) / 2, energy, rtol=1e-12)
        pieces = [np.isnan(level_curve(body, found, 200.0, energy)[:, 0]).sum()
                  for body, found in zip(bodies, (points, turned))]
        assert pieces[0] == pieces[1]
