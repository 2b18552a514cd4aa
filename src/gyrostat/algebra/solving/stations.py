"""Finds where the branches of a plane curve F(x, t) = 0 meet, begin and end as t grows.

At each such place it says which of the branches on either side come to the same point: those in a box that no
branch leaves through its lower or upper side.
"""
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import arb
from sympy import Expr, S

from ..enclosures.balls import ball, ends, fraction_of
from .plane_curves import Box, PlaneCurve
from .roots import in_order

BITS = 96                                              # of the roots at first


@dataclass(frozen=True)
class Place:
    """A point of a curve, and the branches that come to it, counted from below: range(left), range(right)."""

    x: Expr
    box: Box
    left: range
    right: range


@dataclass(frozen=True)
class Station:
    """A value of t at which branches meet, begin or end, or another value that is asked for.

    Parameters
    ----------
    t : Expr
        exact
    before, after : Fraction
        values beside it; nothing else happens between them
    places : tuple of Place
        from below
    """

    t: Expr
    before: Fraction
    after: Fraction
    places: tuple[Place, ...]


def stations(curve: PlaneCurve, points: Iterable[tuple[Expr, Expr]],
             other: Iterable[Expr] = ()) -> list[Station]:
    """Return the points of a curve, and other values of t, in order of t.

    Each point comes with the branches that come to it from either side.

    Parameters
    ----------
    curve : PlaneCurve
    points : iterable of (t, x)
        exact and canonical; every multiple root −1 < x < 1, and every root ±1, is among them
    other : iterable of Expr
        values of t without a point

    Examples
    --------
    >>> from sympy import Symbol
    >>> x, t = Symbol("x"), Symbol("t")
    >>> curve = PlaneCurve(x * (x**2 - t), x, t)
    >>> for s in stations(curve, critical_points(curve)):
    ...     print(s.t, [(p.x, len(p.left), len(p.right)) for p in s.places])
    0 [(0, 1, 3)]
    1 [(-1, 1, 0), (1, 1, 0)]
    """
    at: dict[Expr, list[Expr]] = {t: [] for t in other}
    for t, x in dict.fromkeys(points):
        at.setdefault(t, []).append(x)
    order = in_order(list(at))
    edges = [between(a, b) for a, b in zip(order, order[1:])]
    found = []
    for n, t in enumerate(order):
        beside_it = [*edges[max(0, n - 1):n + 1], *([S.Zero] if t != 0 else [])]
        reach = min([distance(t, edge) for edge in beside_it], default=Fraction(1))
        found.append(_station(curve, t, in_order(at[t]), reach))
    return found


def critical_points(curve: PlaneCurve) -> list[tuple[Expr, Expr]]:
    """Return (t, x) of every multiple root −1 < x < 1 and of every root ±1.

    Between them branches are simple, in a fixed order, and do not end.
    """
    return [*curve.double, *((t, S(s)) for s in (1, -1) for t in curve.at_edge(s))]


def _station(curve: PlaneCurve, t: Expr, places: Sequence[Expr], reach: Fraction) -> Station:
    boxes = []
    for x in places:
        others = [y for y in (*places, S.One, S.NegativeOne) if y != x]
        boxes.append(curve.box(t, x, min(distance(x, y) for y in others) / 2, reach))
    before, after = beside(t, reach / 2)
    if boxes:
        before, after = max(box.before for box in boxes), min(box.after for box in boxes)
    left, right = (curve.roots(side, precision=BITS) for side in (before, after))
    return Station(t, before, after, tuple(
        Place(x, box, _inside(curve, before, left, box), _inside(curve, after, right, box))
        for x, box in zip(places, boxes)))


def _inside(curve: PlaneCurve, t: Fraction, roots: Sequence[arb], box: Box) -> range:
    """Return which roots at t lie in a box; none lies on its sides, so that enough digits tell."""
    precision = BITS
    while True:
        spans = [ends(root) for root in roots]
        inside = [n for n, (low, high) in enumerate(spans) if box.low < low and high < box.high]
        if len(inside) == sum(high > box.low and low < box.high for low, high in spans):
            return range(inside[0], inside[-1] + 1) if inside else range(0)
        precision *= 2
        roots = curve.roots(t, len(roots), precision)


def distance(a: Expr, b: Expr | Fraction) -> Fraction:
    """Return a lower bound, more than half, of the distance of two numbers that differ."""
    precision = 64
    while True:
        gap = abs(ball(a - S(b), precision))
        if gap.is_finite() and gap.abs_lower() > gap.rad() * 4:
            return fraction_of(gap.abs_lower()) * Fraction(3, 4)
        precision *= 2


def beside(t: Expr, step: Fraction) -> tuple[Fraction, Fraction]:
    """Return two fractions on either side of a number, within a step."""
    n = max(4, step.denominator.bit_length() - step.numerator.bit_length() + 3)
    precision = 64 + n
    while (enclosure := ball(t, precision)).rad() > arb(2) ** -n:
        precision *= 2
    middle = Fraction(round(fraction_of(enclosure.mid()) * 2**n), 2**n)
    return middle - Fraction(3, 2**n), middle + Fraction(3, 2**n)


def between(a: Expr, b: Expr) -> Fraction:
    """Return a short fraction well between two numbers, a < b."""
    precision = 64
    while not (high := ball(b, precision)) > (low := ball(a, precision)):
        precision *= 2
    start, end = ends(low)[1], ends(high)[0]
    n = 0
    while True:
        middle = Fraction(round((start + end) / 2 * 2**n), 2**n)
        if min(middle - start, end - middle) > (end - start) / 4:
            return middle
        n += 1
