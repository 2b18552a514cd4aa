"""Followed: the branches of E1, E2 and E3 over a range, station by station, as pieces and marks."""
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
from sympy import Expr, S

from ...algebra.enclosures.balls import ball, fraction_of
from ...algebra.enclosures.floats import Array
from ...algebra.solving.stations import Place, Station, beside
from ...mechanics.families.named_families import E3, POLES
from ...mechanics.scenes.system import System
from ...stability.decision import Verdict
from ..finders.revolution import critical_tilt, pole_at, revolution_forms
from .bifurcation_kinds import AT_RATE, defined, kind_of, precessions_leave
from .piece_and_mark import INFINITE, Mark, Piece, Span
from .stations_at_rate import Critical

# between two stations; of steps in k3 that are longer
NODES, HALVINGS, LONGEST = 96, 12, 0.05


@dataclass(frozen=True)
class Followed:
    """What a continuation is made of."""

    scene: System
    values: Mapping[str, Any]
    parameter: str
    critical: Critical
    stations: dict[Expr, Station]
    spans: list[Span]

    def at(self, t: Expr) -> dict[str, Any]:
        return {**self.values, self.parameter: t}

    def pole(self, s: int) -> list[Piece]:
        """E1 or E2, cut where its verdict changes or U is infinite."""
        found: list[Piece] = []
        for n, span in enumerate(self.spans):
            ends = np.array([float(span.low), float(span.high)]), np.full(2, float(s))
            if n and s in self.spans[n - 1].poles and self.changed(s, span.low) is False:
                found[-1].extend(*ends)
            elif s in span.poles:
                found.append(Piece(POLES[s].label, *ends, span.poles[s]))
        return found

    def changed(self, s: int, t: Expr) -> bool | None:
        """Whether the verdict of E1 or E2 changes at a value, or is another there.

        None where U is infinite.
        """
        verdicts = {span.poles.get(s) for span in self.spans if t in (span.low, span.high)}
        if t in self.critical.poles[s]:
            here = pole_at(self.scene, s, self.at(t))
            verdicts.add(here.known().verdict if here else None)
        return None if None in verdicts else len(verdicts) > 1

    def tilts(self) -> list[Piece]:
        """E3, each piece from one point where something happens to the next."""
        found: list[Piece] = []
        # those that pass the station before without a change, from below
        going: list[Piece] = []
        for span in self.spans:
            pieces = [Piece(E3.label, x, y, verdict)
                      for (x, y), verdict in zip(self.traced(span), span.tilts)]
            passing = self.passing(span, span.low)
            if len(going) == len(passing):
                for n, piece in zip(passing, going):
                    if piece.verdict is pieces[n].verdict:
                        piece.extend(pieces[n].parameter, pieces[n].k3)
                        pieces[n] = piece
            found += [piece for piece in pieces if all(piece is not other for other in going)]
            going = [pieces[n] for n in self.passing(span, span.high)]
        return found

    def passing(self, span: Span, t: Expr) -> list[int]:
        """Which tilts of a span do not come to a point of the station at one of its ends."""
        station = self.stations.get(t)
        held = (
            {n for place in station.places for n in (place.right if t is span.low else place.left)}
            if station
            else set()
        )
        return [n for n in range(len(span.tilts)) if n not in held]

    def traced(self, span: Span) -> list[tuple[Array, Array]]:
        """The tilts of a span, each with its ends."""
        a, b, count = float(span.low), float(span.high), len(span.tilts)
        if not count:
            return []
        first, last = (fraction_of(ball(t, 128).mid()) for t in (span.low, span.high))
        small = (last - first) / 2**40
        nodes = [Fraction(x) for x in ((a + b) / 2 - (b - a) / 2
                                       * np.cos(np.pi * np.arange(1, NODES) / NODES)).tolist()]
        nodes = [x for x in nodes if first + small < x < last - small]
        at = {x: [float(root.mid()) for root in self.critical.curve.roots(x, count)] for x in nodes}
        for _ in range(HALVINGS):                          # where a branch is steep
            steep = [(x, y) for x, y in pairwise(sorted(at))
                     if np.max(np.abs(np.subtract(at[x], at[y]))) > LONGEST]
            at |= {x: [float(root.mid()) for root in self.critical.curve.roots(x, count)]
                   for x in ((x + y) / 2 for x, y in steep)}
        k3 = np.array([self.limits(span, span.low), *(at[x] for x in sorted(at)),
                       self.limits(span, span.high)])
        x = np.array([a, *map(float, sorted(at)), b])
        return [(x, k3[:, n]) for n in range(count)]

    def limits(self, span: Span, t: Expr) -> list[float]:
        """Where the tilts of a span come to at one of its ends."""
        station, count = self.stations.get(t), len(span.tilts)
        near = beside(t, (fraction_of(ball(span.high - span.low, 64).mid()))
                      / 2**60)[0 if t is span.high else 1]
        limits = [float(root.mid()) for root in self.critical.curve.roots(near, count)]
        for place in station.places if station else ():
            for n in place.right if t is span.low else place.left:
                limits[n] = float(place.x)
        return limits

    def lines(self) -> list[Piece]:
        """Every tilt at one value."""
        found = []
        for t in self.critical.lines:
            for form in revolution_forms(self.scene, self.at(t)):
                if form.label == E3.label and form.every:
                    found.append(Piece(E3.label, np.full(2, float(t)), np.array([-1.0, 1.0]),
                                       form.known().verdict))
        return found

    def isolated(self) -> list[Piece]:
        """Tilts at one value, without others beside them."""
        return [Piece(E3.label, np.array([float(station.t)]), np.array([float(place.x)]),
                      self.verdict(station, place))
                for station in self.stations.values() for place in station.places
                if place.x**2 != 1 and not place.left and not place.right
                and (station.t, place.x) not in self.critical.infinite]

    def verdict(self, station: Station, place: Place) -> Verdict:
        """Of E3 at a place."""
        if (station.t, place.x) in self.critical.margins:
            return critical_tilt(self.scene, place.x, self.at(station.t))
        if sides := self.sides(station, place):
            return sides[0]
        alone = [form for form in revolution_forms(self.scene, self.at(station.t))
                 if not form.every]
        return min(alone, key=lambda form: abs(float(form.k3 - place.x))).known().verdict

    def sides(self, station: Station, place: Place) -> list[Verdict]:
        """Verdicts of the branches that come to a place."""
        return [span.tilts[n] for span in self.spans for n in (
            place.right if station.t == span.low else place.left if station.t == span.high else ())]

    def marks(self, station: Station) -> Iterator[Mark]:
        """What happens at a station."""
        for s, family in POLES.items():
            if station.t in self.critical.poles[s] and (changed := self.changed(s, station.t)) is not False:
                yield Mark(INFINITE if changed is None else precessions_leave(family), station.t, S(s),
                           changed is not None)
        for place in station.places:
            point, several = (station.t, place.x), bool(place.left or place.right)
            if point in self.critical.infinite or (place.x**2 == 1
                                                   and not defined(self.critical.curve, *point)):
                if several:
                    yield Mark(INFINITE, *point, False)
                continue
            if (place.x**2 == 1 or point in self.critical.curve.double) and (kind := kind_of(place, AT_RATE)):
                yield Mark(kind, *point, False)
            if place.x**2 != 1 and len({*self.sides(station, place), self.verdict(station, place)}) > 1:
                yield Mark("fold on a level", *point, True)
