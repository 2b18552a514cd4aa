"""Continuation along a name: every relative equilibrium of a scene over a range, and what happens there."""
from collections.abc import Mapping
from math import isfinite
from typing import Any

from ...algebra.reals.exact import sign_of_constant
from ...algebra.text.numbers import exact_number, shown
from ...arguments import checked
from ...errors import ValuesError
from ...mechanics.scenes.coupled import in_one_direction
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System
from ..finders.rate_level_tilt import names_of
from .following import follow
from .free_branches import FreeBranches
from .heavy_branches import HeavyBranches
from .pieces import Continuation
from .revolution_branches import RevolutionBranches

CURVES: dict[Kind, type[FreeBranches | HeavyBranches | RevolutionBranches]] = {
    Kind.FREE: FreeBranches, Kind.REVOLUTION: RevolutionBranches, Kind.FIELD: HeavyBranches}


@checked
def continuation(scene: System, name: str, ends: tuple[Any, Any], values: Mapping[str, Any]) -> Continuation:
    """The branches of E1, E2 and E3, or of permanent rotations, over a range of one parameter, complete.

    They are followed from one station to the next, exact values at which some may meet, appear or vanish, or
    their stability change: between two of them the verdicts are those at one fraction, but for values at
    which a resonance of a rotation that gyroscopic forces hold, or D4 = 0, is.

    Parameters
    ----------
    scene : System
        a body of revolution in a U rational in k3, or any body without a field, or in a U of degree 1 or 2
    name : str
        of the parameter
    ends : pair of numbers
        of its range
    values : mapping of name to number
        the moments, l, the parameters of U and omega, of a free gyrostat M, without the one that is free

    Returns
    -------
    Continuation

    Raises
    ------
    ScopeError
        U is unspecified, of too high a degree, of a body of revolution not rational in k3, or
        everything is E3
    ValuesError
        numbers are missing, unknown or not admissible, or the range is empty

    Examples
    --------
    >>> import gyrostat as gs
    >>> scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: k3**4 - k3**2 / 2))
    >>> found = gs.continuation(scene, "omega", ("1/2", 2), {"I1": 2, "I3": 1, "l": 0})
    >>> [(mark.kind, mark.value, mark.k3, mark.changes) for mark in found.marks]
    [('fold on a level', sqrt(2)/2, 0, True), ('pitchfork at fixed rate', 1, 0, False)]
    >>> [piece.verdict.name for piece in found.pieces if piece.label == "E3" and abs(piece.k3).max() < 0.1]
    ['UNSTABLE', 'STABLE', 'STABLE']
    >>> free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l"))))
    >>> found = gs.continuation(free, "l", (0, 1), {"M": 1})
    >>> [(mark.kind, mark.value) for mark in found.marks], len(found.pieces)
    ([('pitchfork', 1/2)], 10)
    """
    in_one_direction(scene.potential, "continuation")
    low, high = (exact_number(end, name) for end in ends)
    if not all(isfinite(float(end)) for end in (low, high)):
        raise ValuesError(f"the range of {name} is {shown(low)} to {shown(high)}: branches are drawn in "
                          "doubles, below 1.8e308; give the numbers in other units")
    if sign_of_constant(high - low) != 1:
        raise ValuesError(f"the range of {name} is {low} to {high}: give two numbers, the lower one "
                          "first")
    if scene.unspecified:
        names_of(scene)                                    # refuses it
    return follow(CURVES[scene.kind](scene, name, low, high, values), low, high)
