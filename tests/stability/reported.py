"""Verdicts by their signs."""
from gyrostat.stability.decision import Verdict

# 0: on the boundary, the next derivative of U not given
SIGNS = {1: Verdict.STABLE, -1: Verdict.UNSTABLE, 0: Verdict.UNDECIDED}
