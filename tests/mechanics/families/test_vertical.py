"""Upright and hanging rotation: the points, and the scenes that have them."""
import pytest

import gyrostat as gs
from gyrostat.errors import EquilibriumError, ScopeError

I3 = gs.symbol("I3")


def test_upright_and_hanging(scene):
    """(0, 0, π3, 0, 0, ±1), also in the body rate ω3 = π3/I3."""
    assert gs.upright(scene).point == (0, 0, gs.symbol("pi3_0"), 0, 0, 1)
    assert gs.hanging(scene, spin="omega3_0").point == (0, 0, I3 * gs.symbol("omega3_0"), 0, 0, -1)


def test_vertical_equilibria_need_their_scene(scene, free):
    """No field, no vertical; l off the axis, no vertical rotation; an unknown spin parameter."""
    with pytest.raises(ScopeError, match="principal_rotation"):
        gs.upright(free)
    with pytest.raises(EquilibriumError, match="E1 is not an equilibrium: dpi1/dt = l2"):
        gs.upright(gs.assemble(gs.Gyrostat(), gs.axial_potential()))
    with pytest.raises(EquilibriumError, match="spin = 'omega'"):
        gs.upright(scene, spin="omega")
