"""The amended potential: its critical points and their kinds are those of the rotations on the level."""
import numpy as np
import pytest
from sympy import Matrix, Rational, lambdify

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError

k = [gs.symbol(f"k{n}") for n in (1, 2, 3)]


@pytest.mark.slow
def test_its_critical_points_are_the_rotations():
    """By differences along the sphere."""
    body = gs.Gyrostat((1, 2, 4), ("1/2", "1/5", "1/3"))
    scene = gs.assemble(body, gs.general_potential(k[0] + 2 * k[1] + k[2]))
    amended = gs.amended_potential(scene)
    U = amended.expression.xreplace({gs.symbol("C1"): 3})
    slope = lambdify(k, list(Matrix([U]).jacobian(k)))
    found = amended.critical_points({"C1": 3})
    assert len(found) % 2 == 0
    counted, value = [], lambdify(k, U)
    for point in found:
        rotation = point.rotation
        place = np.array([float(x) for x in rotation.directions[0]])
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
        assert words in rotation.decision.reason and words == point.kind
        assert abs(float(point.value) - value(*place)) < 1e-12
    assert sum(counted) == 2


def test_a_degenerate_point():
    """c = (0, 0, 1): upright, a pitchfork of E1 where (I3 − I1) omega² = 1 at I = (2, 4, 3), omega = 1."""
    U = gs.general_potential(lambda k1, k2, k3: k3)
    body = gs.Gyrostat((2, 4, 3), (0, 0, 0))
    points = gs.amended_potential(gs.assemble(body, U)).critical_points({"C1": 3})
    (upright,) = [p for p in points if p.rotation.directions[0] == (0, 0, 1)]
    assert upright.kind == "degenerate" and upright.value == 1 + Rational(3, 2)
    assert str(upright).startswith("degenerate point of U_c = 5/2 at k = (0, 0, 1), ω = 1: ")


def test_as_text_and_latex():
    moments = tuple(map(gs.symbol, ("I1", "I2", "I3")))
    scene = gs.assemble(gs.Gyrostat(moments, (0, 0, 0)), gs.uniform_field())
    assert str(gs.amended_potential(scene)) == "U_c = m₀ k₃ + C₁²/(2 (I₁ k₁² + I₂ k₂² + I₃ k₃²))"
    assert r"U_{c} = m_0 k_3 + \frac{C_{1}^{2}}{2 \left(I_1" in gs.to_latex(gs.amended_potential(scene))


def test_what_is_refused():
    body = gs.Gyrostat((1, 2, 3), (0, 0, 0))
    with pytest.raises(ScopeError, match="has no field"):
        gs.amended_potential(gs.assemble(body))
    with pytest.raises(ValuesError, match="depends on the level of C1 = M·k: give C1"):
        gs.amended_potential(gs.assemble(body, gs.general_potential(k[0]))).critical_points({})
    for inertia, U in (((2, 2, 3), k[2]), ((2, 3, 3), k[0]), ((2, 2, 2), k[0] + k[1])):
        scene = gs.assemble(gs.Gyrostat(inertia, (0, 0, 0)), gs.general_potential(U))
        with pytest.raises(ScopeError, match="so that the critical points are on circles"):
            gs.amended_potential(scene).critical_points({"C1": 1})
