"""What decides between the two criteria where there are two directions, or a coupling β."""
from collections.abc import Callable, Mapping
from dataclasses import replace

from sympy import Expr, Symbol

from ..algebra.exact import evaluate
from ..mechanics.equilibria import Equilibrium
from ..mechanics.orbital_precession import moving_axis
from ..mechanics.parallel import parallel
from .decision import Decision, undecided

HELD = ("gyroscopic forces hold it, the second variation has both signs: no theorem decides with three "
        "degrees of freedom")
COUPLED = "the point lies between the two criteria, which are what there is of a field with a coupling β"
DEGENERATE = "the second variation is degenerate: terms of higher degree decide"
AXIS = "the axis moves in the orbital frame as k of a spherical gyrostat in one field does: "


def open_between(eq: Equilibrium) -> bool:
    """Whether nothing decides between the two criteria of its report, whatever the numbers."""
    return eq.system.coupled and not eq.system.linear_integrals and not parallel(eq)


def decide_in_frame(eq: Equilibrium, numbers: Mapping[Symbol, Expr], degenerate: bool,
                    point_decided: Callable[[Equilibrium], Decision]) -> Decision:
    """Of a symmetric satellite what its axis does; of any other undecided, with what is known of it.

    The last argument says what is proved of a body in one direction, as a point. Its C1 is minus the momentum
    along the axis of the satellite.
    """
    if axis := moving_axis(eq, lambda x: evaluate(x, numbers)):
        found = point_decided(axis)
        return replace(found, reason=f"{AXIS}{found.reason}", margins=(),
                       level=found.level and eq.system.linear_integrals)
    if degenerate:
        return undecided(DEGENERATE)
    return undecided(HELD if len(eq.point) == 9 else COUPLED)
