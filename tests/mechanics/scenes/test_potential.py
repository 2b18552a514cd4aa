"""A potential: its jet, and the body it acts on."""
import pytest
import sympy
from sympy import cos

import gyrostat as gs
from gyrostat.errors import PotentialError, ScopeError

k1, k3, m0, m1 = map(gs.symbol, ("k1", "k3", "m0", "m1"))


def test_jets_are_derivatives():
    """dU, d2U, … of a given U; mixed ones of a general U."""
    potential = gs.axial_potential(cos(k3) * m0)
    assert [potential.value(gs.symbol(n)) for n in ("dU", "d2U", "d4U")] == [
        -m0 * sympy.sin(k3),
        -m0 * cos(k3),
        m0 * cos(k3),
    ]
    general = gs.general_potential(lambda a, b, c: a**2 * b * c**3)
    assert general.value(gs.symbol("d3U_123")) == 6 * k1 * k3**2
    assert [d.name for d in general.following(gs.symbol("dU_2"))] == ["d2U_12", "d2U_22", "d2U_23"]


def test_the_body_enters_its_own_potential():
    """The I1, I3 of a field are those of the body it acts on.

    The field of an axisymmetric body refuses any other.
    """
    scene = gs.assemble(gs.Gyrostat((2, 2, 5), (0, 0, 1)), gs.newtonian_field(2))
    assert sympy.expand(scene.potential.expression - m0 * k3 - m1 * 3 * k3**2 / 2) == 0
    with pytest.raises(ScopeError, match="I1 = I2"):
        gs.assemble(gs.Gyrostat(), gs.newtonian_field(2))


def test_errors_are_builtins():
    """PotentialError is a ValueError, ScopeError a NotImplementedError."""
    assert issubclass(PotentialError, ValueError) and issubclass(ScopeError, NotImplementedError)
