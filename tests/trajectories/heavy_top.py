"""A heavy top with a rotor, its numbers and a state."""
import gyrostat as gs

TOP = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
NUMBERS = {"I1": 1, "I3": "3/5", "l": "2/5", "m0": "3/2"}
STATE = ("3/10", "-1/5", "3/2", "3/5", 0, "4/5")
