"""Continuation along a parameter: of E1, E2 and E3 at a fixed rotor and rate, of permanent rotations.

Pieces of one verdict, and marks where something happens.
"""
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from math import isfinite
from typing import Any

from sympy import Expr

from ...algebra.reals.exact import sign_of_constant
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.stations import between, stations
from ...algebra.text.numbers import exact_number, shown
from ...arguments import checked
from ...errors import ScopeError, ValuesError
from ...mechanics.families.named_families import E3, POLES
from ...mechanics.scenes.coupled import in_one_direction
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System
from ..finders.revolution import branches_at
from .free_branches import RotationContinuation, followed_rotations
from .heavy_branches import HeavyContinuation, followed_heavy
from .piece_and_mark import Mark, Piece, Span
from .revolution_branches import Followed
from .stations_at_rate import critical_of


@dataclass(frozen=True, eq=False)
class Continuation:
    """Branches over a range of one parameter, and what happens on them.

    Parameters
    ----------
    pieces : list of Piece
        each of one verdict
    marks : list of Mark
        every change of stability, every meeting and every end

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> found = gs.continuation(top, "omega", (1, 3), {"I1": 2, "I3": 1, "l": 0, "m0": 1})
    >>> len(found.pieces) > 2
    True
    """

    pieces: list[Piece]
    marks: list[Mark]


@checked
def continuation(scene: System, name: str, ends: tuple[Any, Any],
                 values: Mapping[str, Any]) -> Continuation | RotationContinuation | HeavyContinuation:
    """The branches of E1, E2 and E3, or of permanent rotations, over a range of one parameter, complete.

    Between two stations, which are exact, the tilts are simple roots in a fixed order, none ends, and no
    margin vanishes: the verdicts are those at one fraction between. At a station the branches that come to a
    point are those that a box about it holds, on either side. Of a free gyrostat the stations are the double
    points of the curve of ν.

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
    Continuation; of a free body RotationContinuation, of any other HeavyContinuation

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
    if scene.kind is Kind.FREE:
        return followed_rotations(scene, name, low, high, values)
    if scene.kind is Kind.FIELD and not scene.unspecified:
        return followed_heavy(scene, name, low, high, values)
    critical = critical_of(scene, name, low, high, values)
    found = stations(critical.curve, critical.points,
                     (*critical.lines, *critical.poles[1], *critical.poles[-1]))
    inner = [station.t for station in found if station.t not in (low, high)]
    spans = [_span(scene, values, name, critical.curve, a, b) for a, b in pairwise([low, *inner, high])]
    here = Followed(scene, values, name, critical, {station.t: station for station in found}, spans)
    pieces = [piece for s in POLES for piece in here.pole(s)] + here.tilts() + here.lines() + here.isolated()
    return Continuation(pieces, [mark for station in found for mark in here.marks(station)])


def _span(scene: System, values: Mapping[str, Any], name: str, curve: PlaneCurve, a: Expr,
          b: Expr) -> Span:
    middle = between(a, b)
    found = branches_at(scene, {**values, name: middle})
    tilts = tuple(branch.decision.verdict for branch in reversed(found) if branch.label == E3.label)
    if len(tilts) != len(curve.roots(middle)):
        raise ScopeError(f"at {name} = {middle} there are {len(tilts)} tilts, and "
                         f"{len(curve.roots(middle))} branches were followed: "
                         "write the numbers as fractions")
    return Span(a, b, tilts, {s: x.decision.verdict for s, family in POLES.items()
                              for x in found if x.label == family.label})
