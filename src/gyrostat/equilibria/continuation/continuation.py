"""Continues every relative equilibrium of a scene along a name over a range, and says what happens there."""
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
from .orbit_branches import OrbitBranches
from .pieces import Continuation
from .revolution_branches import RevolutionBranches

CURVES: dict[Kind, type[FreeBranches | HeavyBranches | OrbitBranches | RevolutionBranches]] = {
    Kind.FREE: FreeBranches, Kind.REVOLUTION: RevolutionBranches, Kind.FIELD: HeavyBranches,
    Kind.ORBIT: OrbitBranches}


@checked
def continuation(scene: System, name: str, ends: tuple[Any, Any], values: Mapping[str, Any]) -> Continuation:
    """Return all relative equilibria over a range of one parameter, as branches.

    The list is complete. The branches are followed from one station to the next, exact values at which some
    may meet, appear or vanish, or their stability change: between two of them the verdicts are those at one
    fraction. Excepted are values at which a gyroscopically stabilised rotation is in resonance, or D4 = 0.

    For a satellite in a circular orbit these are the attitudes in which it rests, in a potential as
    relative_equilibria takes it, polynomial in the parameter and with rational numbers. Each mark says in
    `numbers` how many attitudes there are before and after it. The stations are the roots of a polynomial
    that is interpolated modulo primes; one more prime confirms its coefficients. An attitude at which K has
    two negative squares is UNDECIDED on its piece, because gyroscopic forces may stabilise it on a part. One
    that exists at a single value is not looked for, and the ends of the range have no marks.

    Parameters
    ----------
    scene : System
        a body of revolution in a U rational in k3, any body without a field, or in a U of degree 1 or 2, or
        a satellite in a circular orbit
    name : str
        of the parameter
    ends : pair of numbers
        of its range
    values : mapping of name to number
        the moments, l, the parameters of U and omega, for a free gyrostat M, for a satellite omega0, without
        the one that is free

    Returns
    -------
    Continuation

    Raises
    ------
    ScopeError
        U is unspecified, of too high a degree, of a body of revolution not rational in k3, or everything is
        E3; the attitudes of a satellite lie on curves, or a number is not rational
    ValuesError
        numbers are missing, unknown or not admissible, or the range is empty

    Examples
    --------
    >>> import gyrostat as gs
    >>> field = gs.axial_potential(lambda k3: k3**4 - k3**2 / 2)
    >>> scene = gs.assemble(gs.symmetric_gyrostat(), field)
    >>> numbers = {"I1": 2, "I3": 1, "l": 0}
    >>> found = gs.continuation(scene, "omega", ("1/2", 2), numbers)
    >>> for mark in found.marks:
    ...     print(mark.kind, mark.value, mark.k3, mark.changes)
    fold on a level sqrt(2)/2 0 True
    pitchfork at fixed rate 1 0 False
    >>> [piece.verdict.name for piece in found.pieces
    ...  if piece.label == "E3" and abs(piece.k3).max() < 0.1]
    ['UNSTABLE', 'STABLE', 'STABLE']
    >>> free = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("l"))))
    >>> found = gs.continuation(free, "l", (0, 1), {"M": 1})
    >>> [(mark.kind, mark.value) for mark in found.marks]
    [('pitchfork', 1/2)]
    >>> len(found.pieces)
    10
    >>> body = gs.Gyrostat((1, "5/4", "8/5"), (0, gs.symbol("l"), 0))
    >>> satellite = gs.assemble(body, gs.circular_orbit(1))
    >>> found = gs.continuation(satellite, "l", ("1/2", 2), {})
    >>> sorted({(mark.value, mark.numbers) for mark in found.marks})
    [(1, (16, 12)), (7/5, (12, 8))]
    """
    if scene.kind not in CURVES:
        in_one_direction(scene.potential, "continuation")
    low, high = (exact_number(end, name) for end in ends)
    if not all(isfinite(float(end)) for end in (low, high)):
        raise ValuesError(f"the range of {name} is {shown(low)} to {shown(high)}: branches are drawn in "
                          "doubles, below 1.8e308; give the numbers in other units")
    if sign_of_constant(high - low) != 1:
        raise ValuesError(f"the range of {name} is {low} to {high}: give two numbers, the lower one "
                          "first")
    if scene.unspecified:
        names_of(scene)                                    # to refuse an unspecified U
    return follow(CURVES[scene.kind](scene, name, low, high, values), low, high)
