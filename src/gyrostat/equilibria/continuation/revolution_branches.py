"""Branches of E1, E2 and E3 of a body of revolution over a range, at a fixed rotor and rate."""
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
from sympy import Expr, S

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball, fraction_of
from ...algebra.enclosures.floats import Array
from ...algebra.solving.plane_curves import PlaneCurve
from ...algebra.solving.roots import real_roots
from ...algebra.solving.stations import Place, Station, beside, between, critical_points, stations
from ...errors import ScopeError, ValuesError
from ...mechanics.equilibrium.reduction import K3
from ...mechanics.families.named_families import E3, POLES
from ...mechanics.scenes.system import System
from ...notation import symbol
from ...stability.decision import Verdict
from ..finders.rate_level_tilt import exact_point, names_of
from ..finders.revolution import critical_tilt, pole_at, revolution_forms
from .bifurcation_kinds import AT_RATE, defined, kind_of, precessions_leave
from .following import Pieces
from .mark import Mark
from .meeting_equations import insert, relation_at_rate
from .pieces import INFINITE, Piece
from .stations_at_rate import admissible, changes_at_pole, margin_at_rate, margins_vanish, within

# between two stations; of steps in k3 that are longer
NODES, HALVINGS, LONGEST = 96, 12, 0.05


class RevolutionBranches:
    """The Curve of a body of revolution in a U(k3).

    Between two stations the tilts are simple roots in a fixed order, none ends, and no margin vanishes. At a
    station the branches that come to a point are those that a box about it holds, on either side.
    """

    def __init__(self, scene: System, name: str, low: Expr, high: Expr, values: Mapping[str, Any]):
        known = names_of(scene) | {"omega"}
        numbers, free = exact_point(scene, values, known), symbol(name)
        if name not in known or "omega" not in (name, *values):
            raise ValuesError("branches of E3 are computed at a rate about the vertical; given were "
                              f"{', '.join(values)}, and {name} is free: give omega too, or leave it free; "
                              f"the names are "
                              f"{', '.join(sorted(known))}")
        if free in numbers:
            raise ValuesError(f"{name} is the parameter along the axis, and the value {numbers[free]} is "
                              "given for it: leave out one of the two")
        admissible({*scene.body.moments[1:]} | ({free} if free.is_positive else set()), numbers, free, low,
                   high)
        self.scene, self.name, self.values = scene, name, values
        margin, held = margin_at_rate(scene, numbers, free)
        relation = insert(scene, relation_at_rate(scene), K3, numbers, {free, K3}, E3.label)
        self.curve = curve = PlaneCurve(relation, K3, free, (margin, held))
        inside = cache(lambda t: within(t, low, high))
        meet, margins, infinite = (
            [point for point in points if inside(point[0])] for points in (
                critical_points(curve), margins_vanish(curve, margin, held),
                (point for F in curve.components for pole in curve.poles for point in curve.common(F, pole))))
        # (value, k3) where the margin of E3 vanishes, or U is infinite
        self.margins, self.infinite = frozenset(margins), frozenset(infinite)
        # values at which every tilt is E3, and at which the margin of E1 (1) or E2 (−1) is 0 or infinite
        self.lines = [t for line in curve.lines
                      for t in real_roots(curve.ring.expression(line), free) or () if inside(t)]
        self.poles = {s: [t for t in changes_at_pole(scene, numbers, free, s) if inside(t)] for s in POLES}
        self.points = [*meet, *margins, *infinite]

    @cached_property
    def at(self) -> dict[Expr, Station]:
        """The stations, by their values."""
        other = (*self.lines, *self.poles[1], *self.poles[-1])
        return {station.t: station for station in stations(self.curve, self.points, other)}

    @property
    def stations(self) -> list[Expr]:
        """The values of the stations."""
        return list(self.at)

    def placed(self, t: Expr | Fraction) -> dict[str, Any]:
        """Return all numbers, with a value for the free name."""
        return {**self.values, self.name: t}

    def between(self, low: Expr, high: Expr) -> list[Piece]:
        """Return the pieces of the tilts from below, then those of E1 and E2."""
        middle = between(low, high)
        found = revolution_forms(self.scene, self.placed(middle))
        tilts = [form.known().verdict for form in reversed(found) if form.label == E3.label]
        if len(tilts) != (count := len(self.curve.roots(middle))):
            raise ScopeError(f"at {self.name} = {middle} there are {len(tilts)} tilts, and {count} branches "
                             "were followed: write the numbers as fractions")
        ends = np.array([float(low), float(high)])
        return [*(Piece(E3.label, x, verdict, y) for (x, y), verdict in zip(
                    self.traced(low, high, count), tilts)),
                *(Piece(family.label, ends, form.known().verdict, np.full(2, float(s)))
                  for s, family in POLES.items() for form in found if form.label == family.label)]

    def through(self, station: Expr, before: Pieces, after: Pieces) -> Iterator[tuple[int, int]]:
        """Yield the pairs of tilts that come to no point of the station, and E1 and E2 if nothing changes."""
        sides = []
        for which, pieces in (("left", before), ("right", after)):
            held = {n for place in self.at[station].places for n in getattr(place, which)}
            sides.append([n for n, piece in enumerate(pieces) if piece.label == E3.label and n not in held])
        if len(sides[0]) == len(sides[1]):
            yield from zip(*sides)
        for s, family in POLES.items():
            if self.changed(s, station, before, after) is False:
                i, j = ([piece.label for piece in side].index(family.label) for side in (before, after))
                yield i, j

    def changed(self, s: int, t: Expr, *sides: Pieces | None) -> bool | None:
        """Tell whether the verdict of E1 or E2 changes at a value, or is another there.

        None if U is infinite there.
        """
        verdicts: set[Verdict | None] = {
            next((piece.verdict for piece in side if piece.label == POLES[s].label), None)
            for side in sides if side is not None}
        if t in self.poles[s]:
            here = pole_at(self.scene, s, self.placed(t))
            verdicts.add(here.known().verdict if here else None)
        return None if None in verdicts else len(verdicts) > 1

    def traced(self, low: Expr, high: Expr, count: int) -> list[tuple[Array, Array]]:
        """Return the tilts between two stations, each with its ends, in doubles."""
        a, b = float(low), float(high)
        if not count:
            return []
        first, last = (fraction_of(ball(t, 128).mid()) for t in (low, high))
        small = (last - first) / 2**40
        nodes = [Fraction(x) for x in ((a + b) / 2 - (b - a) / 2
                                       * np.cos(np.pi * np.arange(1, NODES) / NODES)).tolist()]
        nodes = [x for x in nodes if first + small < x < last - small]
        at = {x: [float(root.mid()) for root in self.curve.roots(x, count)] for x in nodes}
        for _ in range(HALVINGS):                          # where a branch is steep
            steep = [(x, y) for x, y in pairwise(sorted(at))
                     if np.max(np.abs(np.subtract(at[x], at[y]))) > LONGEST]
            at |= {x: [float(root.mid()) for root in self.curve.roots(x, count)]
                   for x in ((x + y) / 2 for x, y in steep)}
        step = fraction_of(ball(high - low, 64).mid()) / 2**60
        k3 = np.array([self.limits(low, beside(low, step)[1], count, "right"), *(at[x] for x in sorted(at)),
                       self.limits(high, beside(high, step)[0], count, "left")])
        x = np.array([a, *map(float, sorted(at)), b])
        return [(x, k3[:, n]) for n in range(count)]

    def limits(self, t: Expr, near: Fraction, count: int, side: str) -> list[float]:
        """Return where the tilts on one side of a value come to."""
        limits = [float(root.mid()) for root in self.curve.roots(near, count)]
        for place in self.at[t].places if t in self.at else ():
            for n in getattr(place, side):
                limits[n] = float(place.x)
        return limits

    def alone(self, station: Expr) -> Iterator[Piece]:
        """Yield every tilt at one value as a piece, and single ones."""
        if station in self.lines:
            for form in revolution_forms(self.scene, self.placed(station)):
                if form.label == E3.label and form.every:
                    yield Piece(E3.label, np.full(2, float(station)), form.known().verdict,
                                np.array([-1.0, 1.0]))
        for place in self.at[station].places:
            if (place.x**2 != 1 and not place.left and not place.right
                    and (station, place.x) not in self.infinite):
                yield Piece(E3.label, np.array([float(station)]), self.verdict(station, place, []),
                            np.array([float(place.x)]))

    def verdict(self, t: Expr, place: Place, beside_it: list[Verdict]) -> Verdict:
        """Return the verdict of E3 at a place."""
        if (t, place.x) in self.margins:
            return critical_tilt(self.scene, place.x, self.placed(t))
        if beside_it:
            return beside_it[0]
        alone = [form for form in revolution_forms(self.scene, self.placed(t)) if not form.every]
        return min(alone, key=lambda form: abs(float(form.k3 - place.x))).known().verdict

    def marks(self, station: Expr, before: Pieces | None, after: Pieces | None) -> Iterator[Mark]:
        """Yield the marks of E1 and E2, then those of the tilts."""
        for s, family in POLES.items():
            if station in self.poles[s] and (
                    changed := self.changed(s, station, before, after)) is not False:
                kind = INFINITE if changed is None else precessions_leave(family)
                yield Mark(kind, self.name, station, S(s), changes=changed is not None)
        for place in self.at[station].places:
            point, several = (station, place.x), bool(place.left or place.right)
            if point in self.infinite or (place.x**2 == 1 and not defined(self.curve, *point)):
                if several:
                    yield Mark(INFINITE, self.name, *point, changes=False)
                continue
            if (place.x**2 == 1 or point in self.curve.double) and (kind := kind_of(place, AT_RATE)):
                yield Mark(kind, self.name, *point, changes=False)
            beside_it = [side[n].verdict for side, ns in ((before, place.left), (after, place.right))
                         if side is not None for n in ns]
            if place.x**2 != 1 and len({*beside_it, self.verdict(station, place, beside_it)}) > 1:
                yield Mark("fold on a level", self.name, *point, changes=True)
