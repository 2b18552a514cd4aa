"""The integers that stand for verdicts, and for what decided them, in arrays and datasets."""
from ..stability.decision import Rung, Verdict

STABLE, UNDECIDED, UNSTABLE, INVALID = 1, 0, -1, -2    # INVALID: there is no equilibrium
CODE_OF = {Verdict.STABLE: STABLE, Verdict.UNDECIDED: UNDECIDED, Verdict.UNSTABLE: UNSTABLE}
# the values of a flag variable, in the order in which a dataset declares them
FLAGS = {"unstable": UNSTABLE, "undecided": UNDECIDED, "stable": STABLE, "no_equilibrium": INVALID}
# what decided a point
RUNGS = {rung: code for code, rung in enumerate(Rung)}
# curves inside windows: frequencies as 1 to 2, as 1 to 3, and no twist
CURVES = {"resonance_1_2": 2, "resonance_1_3": 3, "D4_zero": 4}
# the kinds of boxes, in the order in which shares are told
BOX_KINDS = {"stable": STABLE, "unstable": UNSTABLE, "undecided": UNDECIDED, "no equilibrium": INVALID}
# how much a stable point survives, beside its verdict: what it is, its dimension, its unit in SI
SURVIVED = {"kick": ("impulse below which the motion stays in the well", (1, 1, 0), "N m s"),
            "barrier": ("height of the lowest pass out of the well", (1, 2, 0), "J")}
