"""Rotations of a free body about its principal axes."""
import pytest

import gyrostat as gs
from gyrostat.errors import EquilibriumError, ScopeError

I3 = gs.symbol("I3")


def test_principal_rotations(free):
    """About the axis that carries l; about any axis where l = 0; about no other."""
    assert gs.principal_rotation(free, 3).point == (0, 0, I3 * gs.symbol("omega3_0"))
    plain = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0)))
    assert [sum(bool(x) for x in gs.principal_rotation(plain, axis).point) for axis in (1, 2, 3)] == [1, 1, 1]
    with pytest.raises(EquilibriumError, match="dpi2/dt = l"):
        gs.principal_rotation(free, 1)
    with pytest.raises(EquilibriumError, match="axis = 4"):
        gs.principal_rotation(free, 4)
    with pytest.raises(ScopeError, match="has a field"):
        gs.principal_rotation(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), 3)
