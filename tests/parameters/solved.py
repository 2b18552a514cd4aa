"""Reports in named fields, and whether an equilibrium is there and stable."""
from functools import cache

import gyrostat as gs
from gyrostat.errors import ValuesError
from gyrostat.stability.decision import Verdict

BODY, k3 = gs.symmetric_gyrostat(), gs.symbol("k3")
POSITIVE = ("I1", "I3", "mass1", "mass3", "p0", "r")
FIELDS = {"U1": gs.uniform_field(), "U2": gs.newtonian_field(2), "U3": gs.newtonian_field(3),
          "fluid": gs.ideal_fluid(),
          "square": gs.axial_potential(lambda z: gs.symbol("a") ** 2 * z),
          "bowl": gs.axial_potential(lambda z: gs.symbol("a") ** 2 * z - (z - 1) ** 2),
          "quartic": gs.axial_potential(lambda z: (gs.symbol("b") * gs.symbol("a") ** 2
                                                   - gs.symbol("a") ** 4) * z
                                        + gs.symbol("c") * (z - 1) ** 2),
          "product": gs.axial_potential(lambda z: gs.symbol("a") * gs.symbol("b") ** 2 * gs.symbol("c") * z),
          "exp": gs.axial_potential(lambda z: gs.symbol("a") * z**2 - gs.symbol("b") * z**5)}


@cache
def reports(field):
    scene = gs.assemble(BODY, FIELDS[field])
    return {"E1": gs.analyze(gs.upright(scene)), "E2": gs.analyze(gs.hanging(scene, spin="omega3_0")),
            "E3": gs.analyze(gs.inclined(scene))}


def truth(report, values):
    """Whether the equilibrium exists there and is stable."""
    try:
        verdict = report.verdict(values).verdict
    except ValuesError:
        return False
    assert verdict is not Verdict.UNDECIDED
    return verdict is Verdict.STABLE
