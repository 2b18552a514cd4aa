"""What decides between the two criteria where there are two directions, or a coupling β."""
from collections.abc import Mapping

from sympy import Expr, Symbol

from ..mechanics.equilibria import Equilibrium
from .decision import Finding, settled

HELD = ("gyroscopic forces hold it, the second variation has both signs: no theorem decides with three "
        "degrees of freedom")
COUPLED = "the point lies between the two criteria, which are what there is of a field with a coupling β"
DEGENERATE = "the second variation is degenerate: terms of higher degree decide"


def decide_in_frame(eq: Equilibrium, numbers: Mapping[Symbol, Expr], degenerate: bool) -> Finding:
    """Undecided, with what is known of it."""
    if degenerate:
        return settled(None, DEGENERATE)
    return settled(None, HELD if len(eq.point) == 9 else COUPLED)
