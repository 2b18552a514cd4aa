"""Separatrices of the momentum sphere through rotations that are degenerate."""
import numpy as np
import pytest
from matplotlib.figure import Figure
from slow import slow
from sympy import sympify

import gyrostat as gs
from gyrostat.plotting import draw_momentum_sphere
from gyrostat.plotting.energy_levels import floats, level_curve


@pytest.mark.slow
@pytest.mark.parametrize(("inertia", "rotor", "radius"), [
    ((1, 2, 3), (0, 0, "1/2"), 1), *slow(((1, 2, 3), ("1/4", 0, 0), "1/2"),
                                         (("1/2", "4/3", 1), (1, "-1/3", 0), "sqrt(5)"))])
def test_where_rotations_meet_the_separatrix_passes(inertia, rotor, radius):
    """Through two pitchforks and an umbilic that are unstable: on sphere and level, and to the rotation."""
    body = gs.Gyrostat(inertia, rotor)
    points = gs.relative_equilibria(gs.assemble(body), {"M": radius})
    (met,) = [p for p in points if p.form.signs[-1] == 0]
    assert met.decision.verdict is gs.Verdict.UNSTABLE
    I, l, M0 = map(floats, (body.inertia, body.gyrostatic_momentum, met.momentum))
    M = level_curve(body, points, float(sympify(radius)), float(met.energy))
    M = M[np.isfinite(M[:, 0])]
    np.testing.assert_allclose(np.linalg.norm(M, axis=1), float(sympify(radius)), rtol=1e-12)
    np.testing.assert_allclose(((M - l) ** 2 / I).sum(axis=1) / 2, float(met.energy), rtol=1e-9)
    assert np.linalg.norm(M - M0, axis=1).min() < 0.03
    ax = draw_momentum_sphere(gs.assemble(body), radius, {}, [], Figure().add_subplot(projection="3d"))
    assert "separatrix" in [text.get_text() for text in ax.get_legend().get_texts()]
