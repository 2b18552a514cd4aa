"""Codes of verdicts in arrays and datasets."""
from ..stability.report import Verdict

STABLE, UNDECIDED, UNSTABLE, INVALID = 1, 0, -1, -2    # INVALID: there is no equilibrium
CODE_OF = {Verdict.STABLE: STABLE, Verdict.UNDECIDED: UNDECIDED, Verdict.UNSTABLE: UNSTABLE}
# the values of a flag variable, in the order in which a dataset declares them
FLAGS = {"unstable": UNSTABLE, "undecided": UNDECIDED, "stable": STABLE, "no_equilibrium": INVALID}
# the kinds of boxes, in the order in which shares are told
BOX_KINDS = {"stable": STABLE, "unstable": UNSTABLE, "undecided": UNDECIDED, "no equilibrium": INVALID}
