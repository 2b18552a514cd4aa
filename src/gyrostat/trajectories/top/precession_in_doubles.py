"""A precession in doubles: its constants, each rounded once, and states and attitudes from them.

Times are numbers or rows of numbers: the same arithmetic, to the last bit.
"""
from typing import Any, NamedTuple

import numpy as np
from flint import acb, arb

from ..._cached import cached_property
from ...algebra.enclosures.double_double import Twofold
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import own_precision
from ..circle import circle
from ..periods import double, pair, reduced, turns
from .cayley_klein import Forms, momentum, product, rotation, valued
from .nutation import Squares
from .precession import Precession
from .series_integrals import Curve, Place

REST = Squares(1.0, 0.0, 0.0, 0.0)                         # if k3 does not move


class Moment(NamedTuple):
    """The place of a nutation at times.

    It has its periods and u since it was at u = 0; without a period the time from 0 on less the linear part
    of u.
    """

    t: Any
    n: Any
    u: Any
    rest: Any
    place: Place
    squares: Squares


class Doubles:
    """The constants of a precession and the state and attitude of its body, in doubles.

    Parameters
    ----------
    exact : Precession
    """

    def __init__(self, exact: Precession):
        self.exact, self.parts, self.integrals = exact, exact.integrands, exact.integrals
        parts, whole = exact.integrands, exact.integrals.quarter
        self.I1, self.r, self.pi3, self.start = map(double, (parts.I1, exact.r, exact.pi3, exact.t0))
        self.lower, self.upper = double(parts.lower), double(parts.upper)
        self.forms = Forms(*((double(x), double(y), double(w)) for x, y, w in parts.forms))
        with own_precision(exact.precision):
            self.period = None if whole is None else pair(2 * whole * self.integrals.means[0])

    @cached_property
    def turning(self) -> Curve:
        """The smooth part of φ, in radians."""
        return self.integrals.curve([0, 1, 1])

    @cached_property
    def precession(self) -> "Angle":
        """The angle φ."""
        return Angle(self.exact, 1)

    @cached_property
    def spin(self) -> "Angle":
        """The angle −ψ."""
        return Angle(self.exact, -1)

    def moment(self, t: Any) -> Moment:
        """Return the place of the nutation at times, numbers or a row."""
        if self.period is None:
            n, u = None, self.integrals.inverse(t + self.start)
        else:
            n, r = reduced(t, self.period)
            r = r + self.start
            more = np.rint(r / self.period.high)
            n, u = n + more, self.integrals.inverse(r - more * self.period.high)
        half = self.integrals.half(u)
        place = self.integrals.place(u)
        rest = self.start - self.integrals.time.bounded(place) if self.period is None else None
        path = self.parts.path
        return Moment(t, n, u, rest, place, REST if path is None else path.squares(u, half))

    def height(self, squares: Squares) -> Any:
        """Return k3."""
        return squares.cosine * self.lower + squares.sine * self.upper

    def state(self, x: Array, t: Any) -> None:
        """Enter (π, k) at times, numbers or a row, into an array that has it along the last axis."""
        moment = self.moment(t)
        squares, place = moment.squares, moment.place
        unit, across = self.spin.unit(moment), valued(self.forms.across, squares)
        speed = self.I1 / (self.integrals.time.mean if self.integrals.constant[0]
                           else self.integrals.time.rate(place))
        p = momentum(self.forms, across, squares.turn, self.turning.rate(place))
        k1, k2 = product(across, unit)
        p1, p2 = product(p, unit)
        x[..., 0], x[..., 1], x[..., 2] = 0 - speed * p2, speed * p1, self.pi3         # times √−1, no −0
        x[..., 3], x[..., 4], x[..., 5] = 0 - self.r * k2, self.r * k1, self.height(squares)

    def attitude(self, R: Array, t: Any) -> None:
        """Enter R from body to space into an array that has it along the last two axes."""
        moment = self.moment(t)
        values = [valued(form, moment.squares) for form in self.forms]
        rotation(R, values, self.precession.unit(moment), self.spin.unit(moment),
                 self.height(moment.squares) / self.r)


class Angle:
    """The angle φ or −ψ in turns, without the parts that the products of the Cayley-Klein parameters have.

    Parameters
    ----------
    exact : Precession
    side : int
        1 for φ = arg b + arg a, −1 for −ψ = arg b − arg a
    """

    def __init__(self, exact: Precession, side: int):
        integrals, (first, second) = exact.integrals, exact.factors
        with own_precision(exact.precision):
            turn = 2 * arb.pi()
            self.curve = integrals.curve([0, side, 1], turn)
            time, mean = integrals.means[0], integrals.means[2] + side * integrals.means[1]
            jump, step = integrals.jumps[0], integrals.jumps[2] + side * integrals.jumps[1]
            factor = second * (first if side > 0 else first.conjugate())
            start = _argument(factor) - exact.angles[1] - side * exact.angles[0]
            self.start = double(start / turn)
            self.whole, self.ends = None, []
            if integrals.quarter is not None:              # turns in a period
                self.whole = pair(2 * integrals.quarter * mean / turn)
            else:                                          # in a unit of time, before and after
                self.ends = [pair((mean + end * step) / (time + end * jump) / turn) for end in (-1, 1)]
            # Λ t turns a and b against each other: it is in ψ alone
            self.axial: Twofold | None = pair(exact.axial_rate / turn) if side < 0 else None

    def unit(self, moment: Moment) -> tuple[Any, Any]:
        """Return cosine and sine of the angle."""
        if self.whole is not None:
            cycles = turns(moment.n, self.whole) + self.curve.mean * moment.u
        else:
            before, after = (turns(moment.t, rate) + rate.high * moment.rest for rate in self.ends)
            cycles = np.where(moment.u > 0, after, before)
        if self.axial is not None:
            cycles = cycles + turns(moment.t, self.axial)
        return circle(cycles + self.start + self.curve.bounded(moment.place))


def _argument(z: acb) -> arb:
    """Return an angle of a number, from the half plane in which atan2 is continuous."""
    if z.real < 0:
        return arb.pi() + arb.atan2(-z.imag, -z.real)
    return arb.atan2(z.imag, z.real)
