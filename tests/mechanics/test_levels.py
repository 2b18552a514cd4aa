"""The amended potential: its critical points and their kinds are those of the rotations on the level."""
import numpy as np
import pytest
from sympy import Matrix, lambdify

import gyrostat as gs
from gyrostat.errors import ScopeError

k = [gs.symbol(f"k{n}") for n in (1, 2, 3)]


def test_its_critical_points_are_the_rotations():
    """By differences along the sphere."""
    body = gs.Gyrostat((1, 2, 4), ("1/2", "1/5", "1/3"))
    scene = gs.assemble(body, gs.general_potential(k[0] + 2 * k[1] + k[2]))
    U = gs.mechanics.amended_potential(scene).xreplace({gs.symbol("C1"): 3})
    slope = lambdify(k, list(Matrix([U]).jacobian(k)))
    found = gs.relative_equilibria(scene, {"C1": 3})
    assert len(found) % 2 == 0
    counted, value = [], lambdify(k, U)
    for rotation in found:
        place = np.array([float(x) for x in rotation.k])
        assert np.abs(np.cross(slope(*place), place)).max() < 1e-9
        across = np.linalg.svd(place[None])[2][1:]
        form = np.zeros((2, 2))
        for i in range(2):
            for j in range(2):
                corners = [(s, t, place + 1e-3 * (s * across[i] + t * across[j]))
                           for s in (1, -1) for t in (1, -1)]
                form[i, j] = sum(s * t * value(*(x / np.linalg.norm(x))) for s, t, x in corners)
        signs = np.sort(np.sign(np.linalg.eigvalsh(form)))
        counted.append(signs.prod())
        words = {2: "minimum", 0: "saddle", -2: "maximum"}[int(signs.sum())]
        assert words in rotation.decision.reason
    assert sum(counted) == 2


def test_without_a_field():
    with pytest.raises(ScopeError, match="has no field"):
        gs.mechanics.amended_potential(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))))
