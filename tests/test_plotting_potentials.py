"""The effective potential drawn: turning points, equilibria, heights."""
from fractions import Fraction

import numpy as np
import oracle
import pytest
from matplotlib.figure import Figure

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError
from gyrostat.plotting import draw_effective_potential
from gyrostat.plotting.looks import BLUE, DARK
from gyrostat.plotting.potentials import well

TOP = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
QUARTIC = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: 6 * k3**4 - 5 * k3**2))
CASES = [(TOP, {"I1": 1, "I3": "1/2", "l": 0, "m0": 1, "p_phi": 2, "p_psi": 3}, 10, [0, 1]),
         (TOP, {"I1": 2, "I3": 1, "l": "1/2", "m0": -1, "p_phi": 1, "p_psi": "-1/3"}, 3, [0, -1]),
         (QUARTIC, {"I1": 1, "I3": "1/2", "l": 0, "p_phi": "1/5", "p_psi": "1/10"}, "-0.3", [0, 0, -5, 0, 6])]


@pytest.mark.parametrize("scene, values, energy, U", CASES)
def test_turning_points_are_roots_of_g(scene, values, energy, U):
    """g = 2 I1 (e − U)(1 − z²) − (v − P z)² vanishes there, nowhere else between; V is the energy there and g ≥ 0 is V ≤ energy."""
    I1, I3, l, v, P = (float(Fraction(values[name])) for name in ("I1", "I3", "l", "p_phi", "p_psi"))
    g = np.polynomial.Polynomial(oracle.reduced_motion(I1, float(Fraction(energy)) - (P - l) ** 2 / (2 * I3), v, P, U))
    found = well(scene, values, energy)
    turning = np.array([float(k3) for k3 in found.turning])
    roots = g.roots()
    expected = np.sort(roots.real[(np.abs(roots.imag) < 1e-9) & (np.abs(roots.real) < 1)])
    np.testing.assert_allclose(turning, expected, rtol=1e-9)           # simple roots in doubles
    inside = g(np.cos(found.theta))
    clear = np.abs(inside) > 1e-9
    np.testing.assert_array_equal((inside > 0)[clear], (found.height < float(Fraction(energy)))[clear])


@pytest.mark.parametrize("scene, values, energy, U", CASES)
def test_equilibria_are_the_minima_and_maxima(scene, values, energy, U):
    """Between two angles where the differences of V change sign lies an equilibrium, stable at a minimum, at the height of V."""
    found = well(scene, values)
    turns = np.flatnonzero(np.diff(np.sign(np.diff(found.height))))
    minima = np.diff(found.height)[turns] < 0
    inner = sorted((t, h, branch) for t, h, branch in found.equilibria)
    assert len(inner) == len(turns) and found.turning == []
    for (theta, height, branch), n, minimum in zip(inner, turns, minima):
        assert found.theta[n] <= theta <= found.theta[n + 2]
        assert height == pytest.approx(found.height[n + 1], abs=1e-3)  # a step of the angles away, where the slope vanishes
        assert (branch.decision.verdict is gs.Verdict.STABLE) == minimum


def test_poles_are_on_their_level():
    """Where p_phi = p_psi E1 is on the level, at the height U(1) + π3²/(2 I3); below the critical spin it is open."""
    values = {"I1": 1, "I3": "1/2", "l": "1/4", "m0": 1, "p_phi": 1, "p_psi": 1}
    (theta, height, branch), *_ = well(TOP, values).equilibria
    assert (theta, height, branch.label) == (0.0, 1 + 0.75**2, "E1")
    ax = draw_effective_potential(TOP, values, ax=Figure().subplots())
    markers = {line.get_markerfacecolor(): line.get_xydata().tolist() for line in ax.lines if line.get_marker() == "o"}
    assert markers["white"] == [[0.0, height]] and len(markers[BLUE]) == 1


def test_the_picture():
    """The curve takes the arguments; a heavy line joins two turning points; axes and legend are named."""
    scene, values, energy, _ = CASES[2]
    ax = draw_effective_potential(scene, values, energy, Figure().subplots(), linewidth=3)
    curve = ax.lines[0]
    assert curve.get_linewidth() == 3 and curve.get_color() == DARK and (ax.get_xlabel(), ax.get_ylabel()) == (r"$\theta$", "$V$")
    np.testing.assert_array_equal(curve.get_xydata().T, [well(scene, values).theta, well(scene, values).height])
    turns = sorted(np.arccos([float(k3) for k3 in well(scene, values, energy).turning]))
    bars = [line.get_xdata() for line in ax.lines if line.get_linewidth() == 2.2 and line.get_linestyle() == "-"]
    np.testing.assert_array_equal(bars, [turns[:2], turns[2:]])
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["$V$", "motion at the energy", "stable", "unstable"]


def test_what_cannot_be_drawn_is_refused():
    """Another body, U unspecified, a name that is missing."""
    with pytest.raises(ScopeError, match="given U\\(k3\\)"):
        draw_effective_potential(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential()), {})
    with pytest.raises(ValuesError, match="the picture needs p_psi: give a number"):
        draw_effective_potential(TOP, {"I1": 1, "I3": 1, "l": 0, "m0": 1, "p_phi": 1})
