"""An equilibrium that is named is found again in the list of its level, whatever the scene."""
import pytest
from sympy import Integer

import gyrostat as gs
from gyrostat.equilibria.in_its_list import in_its_list
from gyrostat.errors import ScopeError

U = gs.general_potential("k1 + 2*k2^2 + k3")
LISTS = {
    "free": ((1, 2, 3), (0, 0, "1/4"), None, {"M": 1}),
    "at a rate": ((1, 2, 3), (0, 0, 1), gs.general_potential("k1^2 + k3"), {"omega": 2}),
    "at rest": ((1, 2, 3), (0, "1/3", 1), U, {"omega": 0}),
    "in orbit": ((60, 70, 35), (0, 5, 0), gs.circular_orbit(1), {}),
    "top": ((2, 2, 1), (0, 0, "1/2"), gs.axial_potential("k3^3 - k3"), {"omega": 1})}


@pytest.mark.few(3)
@pytest.mark.parametrize("case", LISTS)
def test_each_of_a_list_is_found_again(case):
    """By its point alone; with the same label and place."""
    inertia, rotor, field, asked = LISTS[case]
    scene = gs.assemble(gs.Gyrostat(inertia, rotor), *([] if field is None else [field]))
    listed = gs.relative_equilibria(scene, asked)
    assert len(listed) > 1
    for e in listed:
        again = in_its_list(e.equilibrium, {})
        assert again.label == e.label
        places = [[x for name, x in sorted(one.doubles.place.items())] for one in (e, again)]
        assert places[1] == pytest.approx(places[0], abs=1e-12)


def test_names_without_a_number():
    """They are named; a number for each finds it."""
    top = gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()))
    with pytest.raises(ScopeError, match="E1 has names without a number: give I3, l, m0, pi3_0"):
        in_its_list(top, {"I1": Integer(1)})
    numbers = {name: Integer(n) for name, n in (("I1", 1), ("I3", 2), ("l", 0), ("m0", 1), ("pi3_0", 3))}
    assert in_its_list(top, numbers).label == "E1"
