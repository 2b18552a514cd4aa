"""Bodies of revolution about an axis that is no coordinate axis: pictures are those about the third."""
import random

import numpy as np
import pytest
from drawn_pictures import flat
from satellites import exact, rotation

import gyrostat as gs
from gyrostat import plotting
from gyrostat.errors import ScopeError, ValuesError

ACROSS, ALONG, ROTOR, SLOPE = 2, 1, "1/2", "3/2"


def tilted(seed):
    """The body in axes turned at random, with U = m0 k·c, and c."""
    c = exact(rotation(random.Random(seed))[0])
    tensor = [[(ACROSS if i == j else 0) + (ALONG - ACROSS) * c[i] * c[j] for j in range(3)]
              for i in range(3)]
    body = gs.Gyrostat(tensor, [x / 2 for x in c])
    return gs.assemble(body, gs.general_potential(
        lambda *k: gs.symbol("m0") * sum(x * y for x, y in zip(k, c))))


def upright():
    """The same about axis 3."""
    return gs.assemble(gs.Gyrostat((ACROSS, ACROSS, ALONG), (0, 0, ROTOR)), gs.uniform_field())


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_the_effective_potential(seed):
    """V = (p_φ − p_ψ cos θ)²/(2 A sin²θ) + (p_ψ − l)²/(2 C) + m0 cos θ, whatever the axes."""
    level = {"m0": SLOPE, "p_phi": "1/3", "p_psi": "5/4"}
    ax = plotting.draw_effective_potential(tilted(seed), level, ax=flat())
    theta, V = ax.lines[0].get_data()
    wanted = ((1 / 3 - 1.25 * np.cos(theta)) ** 2 / (2 * ACROSS * np.sin(theta) ** 2) + 0.75**2 / 2
              + 1.5 * np.cos(theta))
    assert len(theta) > 500 and np.allclose(V, wanted, rtol=1e-9)
    assert "$c$ along $(" in ax.get_title() and "m_0 = 3/2" in ax.get_title()
    assert [text.get_text() for text in ax.texts] == ["1"]


@pytest.mark.slow
@pytest.mark.parametrize("draw", [
    lambda scene: plotting.draw_energy_momentum(scene, {"m0": SLOPE, "p_psi": "5/4"}, ax=flat()),
    lambda scene: plotting.draw_bifurcation_diagram(scene, "omega", (-3, 3), {"m0": SLOPE}, flat())])
def test_other_diagrams_are_those_of_the_upright_body(monkeypatch, draw):
    """The same curves and marks, up to the sign of c, which is that of its first entry."""
    monkeypatch.setattr("gyrostat.plotting.energy_momentum.CELLS", 40)
    ours, theirs = draw(tilted(3)), draw(upright())
    assert ours.get_title() != theirs.get_title()

    def heights(ax):
        return sorted(abs(np.concatenate([line.get_ydata() for line in ax.lines])).round(6).tolist())
    if "Bifurcation" in ours.gyrostat_caption.what:
        assert ours.get_ylabel() == r"$k \cdot c$" and theirs.get_ylabel() == "$k_3$"
    assert heights(ours) == pytest.approx(heights(theirs), abs=1e-5)


@pytest.mark.slow
def test_the_plane_of_a_rotor_needs_three_moments():
    """Of a tensor, too, with a name in it or without."""
    scene = gs.assemble(gs.Gyrostat([["a", 1, 0], [1, 3, 0], [0, 0, 4]]))
    with pytest.raises(ScopeError, match="two principal moments of .* are equal"):
        plotting.draw_rotor_set(scene, {"a": 3, "l2": 0, "M": 1}, flat())
    with pytest.raises(ValuesError, match="the tensor needs a"):
        plotting.draw_rotor_set(scene, {"l2": 0, "M": 1}, flat())
    ax = plotting.draw_rotor_set(scene, {"a": 2, "l2": 0, "M": 1}, flat())
    assert {text.get_text() for text in ax.texts} >= {"2", "4"}
