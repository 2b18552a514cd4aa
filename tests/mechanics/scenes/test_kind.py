"""What a scene is: five kinds, each with a finder of its relative equilibria or a sentence that refuses."""
import pytest
from sympy import S

import gyrostat as gs
from gyrostat.equilibria.search import FINDERS
from gyrostat.errors import ScopeError
from gyrostat.mechanics import Kind
from gyrostat.mechanics.scenes.system import at_numbers

TOP, GENERAL = gs.symmetric_gyrostat(), gs.Gyrostat()
TWO_FIELDS = gs.coupled_potential(-gs.symbol("k1") - 2 * gs.symbol("e2"))
VEHICLE = gs.underwater_vehicle(weight=(0, 0, gs.symbol("m0")))


@pytest.mark.parametrize("scene, kind", [
    (gs.assemble(TOP), Kind.FREE), (gs.assemble(GENERAL), Kind.FREE),
    (gs.assemble(TOP, gs.axial_potential()), Kind.REVOLUTION),
    (gs.assemble(gs.Gyrostat((1, 2, 3)), gs.axial_potential("k3")), Kind.FIELD),
    (gs.assemble(gs.Gyrostat((1, 1, 3), (1, 0, 0)), gs.axial_potential("k3")), Kind.FIELD),
    (gs.assemble(TOP, gs.general_potential("k3**2")), Kind.FIELD),
    (gs.assemble(TOP, gs.circular_orbit()), Kind.ORBIT), (gs.assemble(TOP, TWO_FIELDS), Kind.COUPLED),
    (VEHICLE, Kind.COUPLED)])
def test_the_kind_of_a_scene(scene, kind):
    """Of what stands in it: a body of revolution is one about axis 3, in a field entered as U(k3)."""
    assert scene.kind is kind
    assert scene.coupled == (kind in (Kind.ORBIT, Kind.COUPLED))


def test_numbers_can_make_a_body_one_of_revolution():
    """I1 = I2 at numbers: the kind is that of the scene at the numbers."""
    scene = gs.assemble(gs.Gyrostat((*map(gs.symbol, ("I1", "I2", "I3")),), (0, 0, 1)),
                        gs.axial_potential("k3"))
    assert scene.kind is Kind.FIELD
    assert at_numbers(scene, dict.fromkeys(map(gs.symbol, ("I1", "I2")), S(2))).kind is Kind.REVOLUTION


@pytest.mark.parametrize("kind", Kind)
def test_every_kind_has_a_finder_or_is_refused(kind):
    """A kind that is added has to say how its relative equilibria are found."""
    if kind is Kind.COUPLED:
        with pytest.raises(ScopeError, match="relative_equilibria is for a body in a field of one direction"):
            gs.relative_equilibria(VEHICLE, {})
    else:
        assert kind in FINDERS
