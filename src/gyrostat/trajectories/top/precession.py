"""The precession and spin of a body of revolution in U(k3), with its nutation.

Every constant, and the state at any time, in balls.
"""
from functools import cached_property
from math import prod

import numpy as np
from flint import acb, arb, ctx

from ...algebra.precision import own_precision
from ...errors import AccuracyError, ResolutionError
from ..elliptic import quarter_period
from ..periods import double
from .cayley_klein import momentum, structure
from .level import Level, enclosed
from .nutation import Nutation, nutation
from .profiles import Profile
from .quadrature import FEWEST, Integrals, over_a_period, to_infinity
from .turning_points import roots_of

MOST_BITS = 4096
# bits by which a constant is better known than the results
MARGIN = 20


class Precession:
    """A body of revolution in U(k3) from a state on, in balls.

    The body turns by the Cayley-Klein parameters a = cos(θ/2) exp(i (φ + ψ)/2), b = sin(θ/2) exp(i (φ −
    ψ)/2), which are smooth everywhere. With z = k3/abs(k), P = π3 + l, v = M·k/abs(k), Λ = P/I1 − π3/I3:

    arg a = −Λ t/2 + ∫ (v + P)/(2 I1 (1 + z)) dt,  arg b = Λ t/2 + ∫ (v − P)/(2 I1 (1 − z)) dt,  π1 + i π2 = 2
        I1 (ā ḃ − b ā˙) without Λ.

    Each integrand has poles where z = ∓1, with the residues of an angle: a is (c √(1 + z1) + i s √(1 +
    z2))/√2 times a unit factor whose angle has none, and b likewise; s, c are those of the nutation.

    Parameters
    ----------
    level : Level
    bits : int
        of the results; 53 for doubles

    References
    ----------
    Klein & Sommerfeld, Theorie des Kreisels (1897-1910), chapters I and VI; Arnold, Mathematical Methods of
    Classical Mechanics, §30.
    """

    def __init__(self, level: Level, bits: int = 53):
        self.level, self.bits = level, bits
        precision = bits + 128
        while True:
            try:
                with own_precision(precision):
                    self._prepare()
                self.precision = precision
                return
            except ResolutionError:                        # more bits are no more nodes
                raise
            except AccuracyError:
                if (precision := 2 * precision) > MOST_BITS:
                    raise

    def _prepare(self) -> None:
        """Every constant, at the precision of the moment."""
        level = self.level
        numbers = [enclosed(x) for x in level.numbers]
        self.profile = Profile(level)
        self.I1, self.pi3, self.r = numbers[0], numbers[5], enclosed(level.square_radius).sqrt()
        v, P = enclosed(level.level) / self.r, enclosed(level.axial)
        self.momenta = [arb(0) if sign == 0 else v + side * P for side, sign in zip((1, -1), level.poles)]
        self.drift = P / self.I1 - self.pi3 / numbers[1]
        self.path = None if level.direction == 0 and level.turn == 0 else nutation(roots_of(level))
        self.backward = self.path is not None and self.path.kind == "passage" and level.direction < 0
        self._measure(numbers[8])
        self.integrals = self._steady() if self.path is None else self._integrate(self.path)
        self.u0 = self._start(numbers[8])
        (self.t0, *self.angles), rates = self.integrals.at(self.u0)
        self._place(acb(numbers[3], numbers[4]), acb(numbers[6], numbers[7]), rates)
        self._check()

    def _check(self) -> None:
        """That every constant is known: a length relatively, an angle by the radian, a time by the period.

        Raises
        ------
        AccuracyError
            it is not, at this precision
        """
        of_one = [*self.angles, *(x for factor in self.factors for x in (factor.real, factor.imag))]
        relative = [x for gap in self.gaps for x in gap if x != 0] + [self.I1, self.r, *self.momenta]
        time = self.integrals.means[0] * (1 if self.integrals.quarter is None else self.integrals.quarter)
        pairs = [(x, abs(x)) for x in relative if x != 0] + [(x, arb(1)) for x in of_one]
        pairs += [(self.t0, abs(time) + abs(self.t0)),
                  (self.drift, abs(self.drift) + abs(self.pi3 / self.I1))]
        if not all(x.is_finite() and x.rad() <= size * arb(2) ** -(self.bits + MARGIN) for x, size in pairs):
            raise AccuracyError(f"the constants of the motion are not known to {self.bits + MARGIN} bits")

    def _measure(self, height: arb) -> None:
        """√(1 ± z) at the lower and the upper end, exactly 0 where an end is a pole."""
        level, ends = (
            self.level,
            (height, height) if self.path is None else (self.path.roots.lower, self.path.roots.upper),
        )
        self.lower, self.upper = ends
        self.gaps = []
        for sign, side in zip(level.poles, (1, -1)):
            poles = [sign == 0 and (1 + side * x / self.r).contains(0) for x in ends]
            self.gaps.append([arb(0) if pole else (1 + side * x / self.r).sqrt()
                              for x, pole in zip(ends, poles)])

    def _steady(self) -> Integrals:
        """k3 at rest: u is the time."""
        rates = [m / (2 * self.I1 * gap[0] ** 2) if m != 0 else arb(0)
                 for m, gap in zip(self.momenta, self.gaps)]
        return Integrals((arb(1), *rates), (arb(0),) * 3, [[arb(0)]] * 3, None, 1)

    def _integrate(self, path: Nutation) -> Integrals:
        """dt/du and the smooth parts of the two angles."""
        if (quarter := path.quarter) is not None:
            nodes = FEWEST
            if path.complement < 0.999:                    # the terms fall like the nome to the power j
                nodes = max(nodes, int(0.28 * self.bits
                                       * float(quarter / quarter_period(1 - path.complement))) + 6)
            return over_a_period(lambda u: self._rates(path, *path.shape(u)), quarter, nodes, self.bits + 7)
        low, high = ((arb(0), arb(1), arb(0)), (arb(1), arb(0), arb(0)))
        first, last = {(False, True): (high, high), (True, False): (low, low),
                       (True, True): (low, high)}[path.roots.double]
        limits = self._rates(path, *first), self._rates(path, *last)
        return to_infinity(lambda u: self._rates(path, *path.shape(u)), limits, self.bits + 7)

    def _rates(self, path: Nutation, s: arb, c: arb, turn: arb) -> list[arb]:
        """dt/du, and d(angle)/du without the angle of c √(1 ± z1) ± i s √(1 ± z2)."""
        time = self.I1 * path.scale / self._factor(path, s, c).sqrt() * (-1 if self.backward else 1)
        rates = [time]
        for level, (low, high), sense in zip(self.momenta, self.gaps, self.senses):
            square = c * low * c * low + s * high * s * high
            rates.append((time * level / (2 * self.I1) - sense * turn * low * high) / square
                         if low * high != 0 else arb(0))
        return rates

    def _factor(self, path: Nutation, s: arb, c: arb) -> arb:
        """g/abs(q)."""
        z = c * c * self.lower + s * s * self.upper
        if path.roots.leading is not None:
            return prod((abs(z - x) ** m for x, m in path.rest), start=abs(path.roots.leading))
        if turned := (c == 0 or s == 0):
            z = self.lower if s == 0 else self.upper
        value = self.profile(z, 2) / 2 if turned else self.profile(z)
        return abs(value) / path.quartic(z, turned)

    @cached_property
    def senses(self) -> list[int]:
        """In which sense c √(1 ± z1) ± i s √(1 ± z2) turns: as its angle does near the pole."""
        return [(sign or 1) * (-1 if self.backward else 1) for sign in self.level.poles]

    def _start(self, height: arb) -> arb:
        """u at the time 0."""
        if self.path is None:
            return arb(0)
        width = self.upper - self.lower
        if self.level.direction == 0:
            s, c = (arb(0), arb(1)) if self.level.turn > 0 else (arb(1), arb(0))
        else:
            s, c = ((height - self.lower) / width).sqrt(), ((self.upper - height) / width).sqrt()
        return self.path.start(s if self.level.direction >= 0 or self.backward else -s, c)

    def _place(self, p: acb, w: acb, rates: list[arb]) -> None:
        """The constant factors of a and b: from k1 + i k2, at a pole from π1 + i π2, and so that φ = 0."""
        s, c, turn = self.shape(self.u0)
        if self.level.direction == 0 and self.path is not None:
            s, c = (arb(0), arb(1)) if self.level.turn > 0 else (arb(1), arb(0))
        (a, b), slopes = self.structure(s, c, turn, rates)
        relative = acb(1)
        if w != 0:
            relative = w / (2 * acb(0, 1) * b * a.conjugate())
        elif p != 0:
            relative = p / momentum(self.I1, a, b, *slopes)
        relative /= abs(relative)
        if a == 0 or b == 0:
            first = (a if b == 0 else relative * b).conjugate()
        else:
            square = (relative * a * b).conjugate() / abs(a * b)
            # its root, up to a positive factor
            first = 1 + square if square.real > 0 else acb(0, 1) * (1 - square)
        first /= abs(first)
        self.factors = first, relative * first

    def shape(self, u: arb) -> tuple[arb, arb, arb]:
        """s, c and the rate of their angle."""
        return (arb(0), arb(1), arb(0)) if self.path is None else self.path.shape(u)

    def structure(self, s: arb, c: arb, turn: arb, rates: list[arb]) -> tuple[list[acb], list[acb]]:
        """a and b without their unit factors, and their derivatives in time."""
        return structure(self.gaps, self.senses, s, c, turn, rates, acb(0, 1), arb(2).rsqrt())

    def state(self, t: arb) -> list[arb]:
        """(π, k) at a time, to as many bits as it was built for."""
        with own_precision(self.precision):
            n, late = 0, t + self.t0
            time, quarter = self.integrals.means[0], self.integrals.quarter
            if quarter is not None:
                whole = 2 * quarter * time
                n = int((late / whole + 0.5).mid().floor().unique_fmpz())
                late -= n * whole
            u = self._inverse(late)
            (_, *angles), rates = self.integrals.at(u)
            s, c, turn = self.shape(u)
            values, slopes = self.structure(s, c, turn, rates)
            units = []
            for sign, factor, angle, start, mean in zip((-1, 1), self.factors, angles, self.angles,
                                                        self.integrals.means[1:]):
                gained = (
                    angle
                    - start
                    + sign * self.drift * t / 2
                    + (0 if quarter is None else 2 * n * quarter * mean)
                )
                units.append(factor * acb(0, gained).exp())
            (a, b), slopes = (x * e for x, e in zip(values, units)), [x * e for x, e in zip(slopes, units)]
            p, k = momentum(self.I1, a, b, *slopes), 2 * acb(0, 1) * self.r * b * a.conjugate()
            return [p.real, p.imag, self.pi3, k.real, k.imag, c * c * self.lower + s * s * self.upper]

    def _inverse(self, t: arb) -> arb:
        """u at a time after u = 0, by Newton's method from the double."""
        if self.integrals.constant[0]:
            return t / self.integrals.means[0]
        u = arb(float(self.integrals.inverse(np.array([double(t)]))[0]))
        for _ in range(ctx.prec.bit_length()):
            values, rates = self.integrals.at(u)
            u = (u - (values[0] - t) / rates[0]).mid()
        return u

    @cached_property
    def gains(self) -> tuple[arb | None, arb, arb]:
        """Period, and what φ and ψ gain in it.

        Without a period None and their rates, on a separatrix those at its end.
        """
        with own_precision(self.precision):
            last = -1 if self.backward else 1
            time, *means = (mean + last * jump
                            for mean, jump in zip(self.integrals.means, self.integrals.jumps))
            if (quarter := self.integrals.quarter) is None:
                first, second = (mean / time for mean in means)
                return None, first + second, first - second - self.drift
            first, second = (2 * quarter * mean + arb.pi() * sense for mean, sense in zip(means, self.senses))
            return 2 * quarter * time, first + second, first - second - 2 * quarter * time * self.drift
