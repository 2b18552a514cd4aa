"""The well of every equilibrium of every kind of list: a barrier, or a reason; the numbers agree."""
import json
import math
from functools import cache

import pytest
from listed_scenes import LISTS

import gyrostat as gs
from gyrostat.errors import ScopeError
from gyrostat.mechanics.scenes.kind import Kind
from gyrostat.printing.results.well import well_blocks, well_data

UNIFORM = gs.general_potential("k1 + 2*k3")
TENSOR = [[3, 1, 0], [1, 3, 0], [0, 0, 5]]
FEW_AXES = gs.gyrostat_with_rotors((60, 70, 35), [gs.Rotor((0, 1, 0), 1, momentum=2)], lumped=True)
# kinds of bodies, of numbers and of torques that the lists of the kinds of scenes have not
OTHERS = {
    "a tensor": (gs.assemble(gs.Gyrostat(TENSOR, ("1/5", 0, "1/3")), UNIFORM), {"C1": 1}),
    "a tensor, free": (gs.assemble(gs.Gyrostat(TENSOR, ("1/5", 0, "1/3"))), {"M": "3/2"}),
    "a tensor in orbit": (gs.assemble(gs.Gyrostat([[3, "1/4", 0], ["1/4", "5/2", 0], [0, 0, 2]],
                                                  ("1/8", 0, 0)), gs.circular_orbit(1)), {}),
    "a rotor that is one of the list": (gs.assemble(FEW_AXES, gs.circular_orbit(1)), {}),
    "a torque of the orbit": (gs.assemble(gs.Gyrostat((60, 70, 35), (0, 1, 0)),
                                          gs.circular_orbit(1, potential="n1/3")), {}),
    "of revolution in orbit": (gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 0)), gs.circular_orbit(1)), {}),
    "a sphere in orbit": (gs.assemble(gs.Gyrostat((2, 2, 2), (0, 1, 0)), gs.circular_orbit(1)), {}),
    "of revolution, free": (gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, "1/3"))), {"M": 1}),
    "at rest, free": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/3"))), {"M": 0}),
    "an irrational M": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/3"))), {"M": "sqrt(2)"}),
    "a degenerate one, free": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/2"))), {"M": "3/4"}),
    "C1 of many digits": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), UNIFORM), {"C1": "1.23456789012"}),
    "C1 = 0": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)), UNIFORM), {"C1": 0}),
    "a rate": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), UNIFORM), {"omega": 2}),
    "of degree two": (gs.assemble(gs.Gyrostat((1, 2, "5/2"), ("1/5", 0, "1/3")),
                                  gs.general_potential("k1/2 + k2^2 - k3^2/3")), {"C1": "1/2"}),
    "of degree three": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), gs.general_potential("k1^3 + k2")),
                        {"C1": 1}),
    "about axis 2": (gs.assemble(gs.Gyrostat((2, 1, 2), (0, "1/2", 0)), gs.general_potential("k2")),
                     {"C1": "1", "pi2_0": 2}),
    "a sphere in a field": (gs.assemble(gs.Gyrostat((2, 2, 2), (0, 0, 1)), UNIFORM), {"C1": 1}),
    "at a tilt": (gs.assemble(gs.Gyrostat((1, 1, "8/5"), (0, 0, 0)), gs.axial_potential("k3")),
                  {"k3": "1/2"})}
# of these at least one has a barrier
BARRIERS = {"a tensor", "a tensor, free", "a tensor in orbit", "a rotor that is one of the list",
            "a torque of the orbit", "an irrational M", "C1 of many digits", "C1 = 0",
            "of degree two", "a sphere in a field", "free", "in a field"}


@cache
def listed(name):
    return gs.relative_equilibria(*(OTHERS | LISTS)[name])


@pytest.mark.slow
@pytest.mark.parametrize("name", OTHERS | LISTS)
def test_a_barrier_or_a_reason(name):
    """Never an error; an unstable one has none; the exact number, the double and the text agree."""
    wells = [e.well for e in listed(name)]
    for well in wells:
        verdict, barrier = well.rotation.decision.verdict.name, well.barrier_double
        kind = well.rotation.scene.kind
        data, said = json.loads(json.dumps(well_data(well))), " ".join(str(well_blocks(well, False)).split())
        if barrier is None:
            assert well.barrier is None and well.reason and well.reason in said
            assert ("is stable" in well.reason, "not stable" in well.reason) == {
                "STABLE": (False, False), "UNSTABLE": (False, True), "UNDECIDED": (True, False)}[verdict]
            with pytest.raises(ScopeError):
                well.kick(level=True)
            assert data["barrier"] is None and data["kick"] is None and data["reason"] == well.reason
            continue
        assert verdict == "STABLE" and barrier > 0
        if math.isinf(barrier):
            assert data["held_at_every_energy"]
            continue
        assert float(well.barrier.evalf(20)) == pytest.approx(barrier, rel=1e-15)
        assert data["barrier"] == barrier and f"{barrier:.6g}" in said and well.kind in kinds_of_passes(well)
        if kind is not Kind.FREE:
            assert 0 < well.kick(level=kind is not Kind.ORBIT) == data["kick"]
    assert (name in BARRIERS) <= any(w.barrier_double for w in wells)


def kinds_of_passes(well):
    """Which there are: an inflection is one of a line alone."""
    return {"well", "summit", "round" if well.line is None else "shelf"}
