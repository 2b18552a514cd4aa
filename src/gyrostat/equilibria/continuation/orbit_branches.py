"""Branches of the attitudes in which a satellite rests in a circular orbit, over a range of a name."""
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import lcm
from typing import Any

import numpy as np
from sympy import Expr, Float, Poly, Rational, S, oo

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.rationals import to_sympy
from ...algebra.reals.exact import evaluate
from ...algebra.rings.matrices import cross
from ...algebra.rotations.bounds import LINES, bounded
from ...algebra.rotations.followed_rotations import FollowedRotations, apart
from ...algebra.rotations.meeting_polynomial import MeetingPolynomial
from ...algebra.rotations.quartic_forms import Form, QuarticForm, quartic
from ...algebra.solving.roots import between as beyond
from ...algebra.solving.roots import in_order, inside, roots_of_polynomial
from ...algebra.solving.stations import between
from ...errors import ScopeError, brief
from ...mechanics.classical.quaternion import quaternion_products
from ...mechanics.families.circular_orbit import orbital_rate
from ...mechanics.scenes.system import System, at_numbers, names_of_scene
from ...notation import symbol
from ...stability.decision import Verdict
from ..doubles import nearest
from ..finders.amended_orbit import amended_terms
from ..finders.orbit import orbit_forms
from ..finders.orbit_torques import CURVES, NOT_QUADRATIC
from ..relative_equilibrium import RelativeEquilibrium
from .following import Pieces
from .heavy_changes import SINGULAR
from .mark import Mark
from .pencil_branches import PRECISION, fractions_between
from .pieces import Piece
from .stations_at_rate import admissible, numbers_beside

SOMEWHERE = Fraction(10000019, 3000017)                # a value at which nothing happens
TOGETHER = 0.02                                        # distance of quaternions that meet at a station
NEAR = 2**22                                           # how near branches are followed to a station
DIGITS = 5                                             # of the place of a mark
Span = tuple[list[Fraction], Array, list[RelativeEquilibrium]]


class OrbitBranches:
    """The Curve of a satellite in its orbit, cut where two attitudes may meet, complex ones too.

    Between two such values the attitudes are as many as at one fraction, and K is regular at each of them.
    """

    def __init__(self, scene: System, name: str, low: Expr, high: Expr, values: Mapping[str, Any]):
        """Take a range, or −∞ to ∞ for all values that are admissible."""
        numbers = numbers_beside(scene, name, values, {s.name for s in names_of_scene(scene)}, "attitudes")
        self.scene, self.name, self.values, self.free = scene, name, values, symbol(name)
        self.placed, positive = at_numbers(scene, dict(numbers)), (*scene.body.positive, orbital_rate(scene))
        if low != -oo:
            admissible(positive, numbers, self.free, low, high)
        elif self.free in positive:
            low = S.Zero
        elif any(self.free in x.free_symbols for x in positive):
            raise ScopeError(f"the tensor is not that of a body for every {name}: give a range, "
                             "continuation(scene, name, ends, values).marks")
        self._range = low, high
        self._spans: dict[tuple[Expr, Expr], Span] = {}

    @cached_property
    def _terms(self) -> dict[tuple[tuple[int, ...], int], Expr]:
        """The coefficients of V, or of V/ω0², by exponents of n and r and of the free name."""
        rate = orbital_rate(self.placed)
        found: dict[tuple[tuple[int, ...], int], Expr] = {}
        for e, c in amended_terms(self.placed).items():
            c = evaluate(c if rate.free_symbols else c / rate**2, {})
            if not c.is_polynomial(self.free):
                raise ScopeError(f"the potential is not polynomial in {self.name}, and the values at which "
                                 "attitudes meet are those of a polynomial: choose another name")
            found |= {(e, k): number for (k,), number in Poly(c, self.free).terms()}
        return found

    @cached_property
    def scale(self) -> Expr:
        """The number, as 1/ω0, that makes the coefficients rational which are linear in the free name."""
        irrational = (c for (_, k), c in self._terms.items() if k == 1 and not isinstance(c, Rational))
        return next(irrational, S.One)

    @cached_property
    def forms(self) -> list[Form]:
        """The forms F_k of V N² = Σ sᵏ F_k over a positive number, with s as the free name times `scale`."""
        powers: dict[int, dict[tuple[int, ...], Rational]] = {}
        for (e, k), c in self._terms.items():
            if not isinstance(number := evaluate(c / self.scale**k, {}), Rational):
                raise ScopeError(f"{brief(number)} is not rational, and the values of {self.name} at which "
                                 "attitudes meet are found at rational numbers: round them to decimals")
            powers.setdefault(k, {})[e] = number
        bottom = lcm(*(x.q for terms in powers.values() for x in terms.values()))
        found = [quartic({e: int(x * bottom) for e, x in powers.get(k, {}).items()})
                 for k in range(min(powers), max(powers) + 1)]
        if None in found:
            raise ScopeError(NOT_QUADRATIC)
        return [form for form in found if form is not None]

    @cached_property
    def meetings(self) -> list[Expr]:
        """Every real value at which two attitudes may meet, in order."""
        (p, q), degree = SOMEWHERE.as_integer_ratio(), len(self.forms) - 1
        whole = {e: sum(p**k * q ** (degree - k) * form[e] for k, form in enumerate(self.forms))
                 for e in self.forms[0]}
        bound = next((b for lines in LINES if (b := bounded(QuarticForm(whole), lines)) is not None), None)
        if bound is None:
            raise ScopeError(CURVES)
        roots = roots_of_polynomial(MeetingPolynomial(self.forms, bound).bare)
        return in_order([evaluate(root / self.scale, {}) for root in roots])

    @cached_property
    def stations(self) -> list[Expr]:
        """The values inside the range at which two attitudes may meet."""
        return inside(self.meetings, *self._range)

    @cached_property
    def ends(self) -> tuple[Expr, Expr]:
        """The ends of the range; if it is infinite, numbers beyond the stations."""
        low, high = self._range
        first, last = (self.stations[0], self.stations[-1]) if self.stations else (S.One, S.One)
        return beyond(low, first) if low == -oo else low, beyond(last, high) if high == oo else high

    def alone(self, station: Expr) -> tuple[()]:
        """Return no isolated attitudes: those at one value alone are not looked for."""
        return ()

    def between(self, low: Expr, high: Expr) -> list[Piece]:
        """Return every attitude between two stations as a piece."""
        places, q, found = self._span(low, high)
        parameter = np.array([float(low), *map(float, places[1:-1]), float(high)])
        _, n, r = _frame(q)
        return [Piece(one.label, parameter, _verdict(one), n=n[:, i], r=r[:, i])
                for i, one in enumerate(found)]

    def through(self, station: Expr, before: Pieces, after: Pieces) -> Iterator[tuple[int, int]]:
        """Yield which pieces go on as which: those of which it is proved that they do."""
        (low, left), (high, right) = self._beside(station)
        first, last = (ball(to_sympy(x) * self.scale, PRECISION) for x in (low, high))
        for i, q in enumerate(left):
            if self._followed.goes_on(q, first.union(last)):
                yield i, int(np.argmin(apart(q[None], right)))

    def marks(self, station: Expr, before: Pieces | None, after: Pieces | None) -> Iterator[Mark]:
        """Yield what happens to those that do not go on, group by group."""
        assert before is not None and after is not None    # no station is an end of the range
        pairs = [*self.through(station, before, after)]
        (_, left), (_, right) = self._beside(station)
        ends = [i for i in range(len(left)) if i not in {i for i, _ in pairs}]
        begins = [j for j in range(len(right)) if j not in {j for _, j in pairs}]
        points = np.concatenate([left[ends], right[begins]])
        one, other = (span[2] for span in self._around(station))
        index = [*(one[i].form.index for i in ends), *(other[j].form.index for j in begins)]
        for group in _groups(points):
            few, changes = sum(n < len(ends) for n in group), None
            if (few, len(group)) == (1, 2):                # it goes on, and nothing is said if K stays
                i, j = group
                changes = before[ends[i]].verdict is not after[begins[j - len(ends)]].verdict
                if index[i] == index[j]:
                    continue
            _, n, r = _frame(points[group]).mean(axis=1)
            yield Mark(_kind(few, len(group) - few), self.name, station, n=_rounded(n), r=_rounded(r),
                       numbers=(len(before), len(after)), changes=changes)

    def _around(self, station: Expr) -> tuple[Span, Span]:
        places = [self.ends[0], *self.stations, self.ends[1]]
        n = places.index(station)
        return self._span(places[n - 1], places[n]), self._span(places[n], places[n + 1])

    def _beside(self, station: Expr) -> list[tuple[Fraction, Array]]:
        """Return a value before a station and one after it, each with the attitudes there."""
        before, after = self._around(station)
        return [(before[0][-1], before[1][-1]), (after[0][0], after[1][0])]

    def _span(self, low: Expr, high: Expr) -> Span:
        """Return values between two stations, the attitudes there as quaternions, and those at one of them.

        The attitudes are exact at one fraction, and from there on they are followed in doubles.
        """
        if (low, high) not in self._spans:
            t = between(low, high)
            numbers = {**self.values, self.name: to_sympy(t)}
            found = [RelativeEquilibrium(form) for form in orbit_forms(self.scene, numbers)]
            start = np.array([_quaternion(*map(nearest, one.directions)) for one in found])
            places = fractions_between(low, high, near=NEAR)
            down, up = [x for x in places if x < t], [x for x in places if x > t]
            scale = float(self.scale)
            before, after = (self._followed.along(start, [scale * float(x) for x in (t, *side)])
                             for side in (down[::-1], up))
            self._spans[low, high] = [*down, t, *up], np.concatenate([before[::-1], after[1:]]), found
        return self._spans[low, high]

    @cached_property
    def _followed(self) -> FollowedRotations:
        return FollowedRotations(self.forms)


def _verdict(one: RelativeEquilibrium) -> Verdict:
    """Return the verdict that holds on a whole piece.

    The index stays, and 0 or an odd one decides. With 2 gyroscopic forces may stabilise it on a part.
    """
    return Verdict.UNDECIDED if one.form.index == 2 else one.decision.verdict


def _quaternion(n: Sequence[float], r: Sequence[float]) -> Array:
    products = np.array(quaternion_products([cross(n, r), n, r]))
    q = products[np.argmax(np.diag(products))]
    return q / np.linalg.norm(q)


def _frame(q: Array) -> Array:
    """Return t, n and r in body axes, shape (3, …, 3), for quaternions of length 1, shape (…, 4)."""
    a, b, c, d = np.moveaxis(q, -1, 0)
    rows = ((a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
            (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
            (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d))
    return np.array([np.stack(row, axis=-1) for row in rows])


def _groups(points: Array) -> list[list[int]]:
    """Return which of some points meet: those at small distances."""
    near, groups = apart(points, points) < TOGETHER, list[list[int]]()
    for n in range(len(points)):
        touched = [group for group in groups if near[n, group].any()]
        groups = [group for group in groups if group not in touched] + [sorted(sum(touched, [n]))]
    return groups


def _kind(before: int, after: int) -> str:
    few, many = sorted((before, after))
    if few == many:
        return SINGULAR if few == 1 else "crossing"
    return "fold" if few == 0 else "pitchfork"


def _rounded(vector: Array) -> tuple[Expr, ...]:
    return tuple(Float(round(x, DIGITS) + 0.0, DIGITS) for x in (vector / np.linalg.norm(vector)).tolist())
