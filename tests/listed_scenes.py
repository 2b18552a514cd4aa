"""The lists of relative equilibria, of every kind of scene, and of what else a list may be asked of."""
from functools import cache

from scene_kinds import CASES

import gyrostat as gs

TOP = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
TURNED = gs.assemble(gs.Gyrostat((1, 2, 2), ("1/4", 0, 0)), gs.general_potential("3*k1"))
FLAT = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential("k3^2/4"))
PULLED = "k1^2/2 + k2^2 + 3*k3^2/2 {}(k1 + 2*k2 - k3)^2 + k1 + 2*k2 - k3"
CURVED = "(k1^2 + 2*k2^2 + 3*k3^2 - 7/4)^2"
# what a list is asked of, beside the kinds of scenes: precessions, where every tilt rests, circles and curves
# of one rate, along which C1 changes
MORE = {
    **{f"a circle of one rate, {name}": (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)),
                                                     gs.general_potential(PULLED.format(sign))), {"omega": 1})
       for name, sign in (("least", "+"), ("a saddle", "-"))},
    "a curve": (gs.assemble(gs.Gyrostat((1, 2, 3), (1, 2, 0)), gs.general_potential(CURVED)),
                        {"omega": 0}),
    "precessions": (TOP, {"I1": 2, "I3": 1, "l": 0, "m0": 3, "k3": "1/2", "pi3_0": 6}),
    "precessions on a level": (TOP, {"I1": 2, "I3": 1, "l": 1, "m0": 3, "pi3_0": 5, "C1": 3}),
    "precessions about axis 1": (TURNED, {"k1": "1/3", "pi1_0": 6}),
    "every tilt": (FLAT, {"I1": 1, "I3": 3, "l": 0, "omega": "1/2"}),
    "every rate": (gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential("0*k3")),
                   {"I1": 2, "I3": 1, "l": 1, "pi3_0": -1, "C1": 0})}
LISTS = {name: (case.equilibrium.system, case.asks_for_all) for name, case in CASES.items()
         if case.level is not None} | MORE


@cache
def listed(name):
    """All of a list."""
    return gs.relative_equilibria(*LISTS[name])

