"""The precession and spin of a body of revolution in U(k3), with its nutation, in balls.

Every constant is enclosed, and so is the state at any time.
"""
from dataclasses import dataclass

import numpy as np
from flint import acb, arb, ctx

from ..._cached import cached_property
from ...algebra.enclosures.precision import own_precision
from ...errors import AccuracyError, ResolutionError
from ..periods import double
from .cayley_klein import momentum, valued
from .integrands import Integrands, integrands
from .level import Level, enclosed
from .nutation import Squares
from .series_integrals import Integrals

MOST_BITS = 4096
# bits by which a constant has to be better known than the results
MARGIN = 20


@dataclass(frozen=True)
class Precession:
    """A body of revolution in U(k3) from a state on, in balls.

    The body turns by the Cayley-Klein parameters a = cos(θ/2) exp(i (φ + ψ)/2) and b = sin(θ/2) exp(i (φ −
    ψ)/2), which are smooth everywhere. With z = k3/abs(k), P = π3 + l, v = M·k/abs(k) and Λ = P/I1 − π3/I3:

    arg a = −Λ t/2 + ∫ (v + P)/(2 I1 (1 + z)) dt,

    arg b = Λ t/2 + ∫ (v − P)/(2 I1 (1 − z)) dt,

    π1 + i π2 = 2 I1 (ā ḃ − b ā˙), without Λ.

    Parameters
    ----------
    integrands : Integrands
    integrals : Integrals
        those of the time and of the two angles, as functions of u
    precision : int
        the bits at which all constants were computed
    pi3, r : arb
        π3, and abs(k)
    axial_rate : arb
        Λ
    t0, angles : arb, two arb
        the integrals at the time 0
    factors : two acb
        the factors of a and b, of modulus 1

    References
    ----------
    Klein & Sommerfeld, Theorie des Kreisels (1897-1910), chapters I and VI; Arnold, Mathematical Methods of
    Classical Mechanics, §30.
    """

    integrands: Integrands
    integrals: Integrals
    precision: int
    pi3: arb
    r: arb
    axial_rate: arb
    t0: arb
    angles: tuple[arb, ...]
    factors: tuple[acb, acb]

    def state(self, t: arb) -> list[arb]:
        """Return (π, k) at a time, to as many bits as it was built for."""
        with own_precision(self.precision):
            n, late, parts = 0, t + self.t0, self.integrands
            time, quarter = self.integrals.means[0], self.integrals.quarter
            if quarter is not None:
                whole = 2 * quarter * time
                n = int((late / whole + 0.5).mid().floor().unique_fmpz())
                late -= n * whole
            u = self._inverse(late)
            (_, *angles), rates = self.integrals.at(u)
            s, c, turn = parts.shape(u)
            first, second = (angle - start for angle, start in zip(angles, self.angles))
            gained = second - first + self.axial_rate * t
            if quarter is not None:
                _, before, after = self.integrals.means
                gained += 2 * n * quarter * (after - before)
            unit = acb(0, 1) * self.factors[1] * self.factors[0].conjugate() * acb(0, gained).exp()
            across = valued(parts.forms.across, Squares(c * c, s * s, s * c, turn))
            p = parts.I1 / rates[0] * unit * acb(*momentum(parts.forms, across, turn, rates[1] + rates[2]))
            k = self.r * unit * acb(*across)
            return [p.real, p.imag, self.pi3, k.real, k.imag, c * c * parts.lower + s * s * parts.upper]

    def _inverse(self, t: arb) -> arb:
        """Return u at a time after u = 0, by Newton's method from the double."""
        if self.integrals.constant[0]:
            return t / self.integrals.means[0]
        u = arb(float(self.integrals.inverse(np.float64(double(t)))))
        for _ in range(ctx.prec.bit_length()):
            values, rates = self.integrals.at(u)
            u = (u - (values[0] - t) / rates[0]).mid()
        return u

    @cached_property
    def gains(self) -> tuple[arb | None, arb, arb]:
        """The period, and what φ and ψ gain in it.

        Without a period it is None, and what they gain in a unit of time, on a separatrix at its end.
        """
        with own_precision(self.precision):
            last = -1 if self.integrands.backward else 1
            time, *means = (mean + last * jump
                            for mean, jump in zip(self.integrals.means, self.integrals.jumps))
            if (quarter := self.integrals.quarter) is None:
                first, second = (mean / time for mean in means)
                return None, first + second, first - second - self.axial_rate
            first, second = (2 * quarter * mean + arb.pi() * sense
                             for mean, sense in zip(means, self.integrands.senses))
            return 2 * quarter * time, first + second, first - second - 2 * quarter * time * self.axial_rate


def precession(level: Level, bits: int = 53) -> Precession:
    """Return the precession of a level to so many bits; 53 for doubles.

    Raises
    ------
    AccuracyError
        4096 bits of its constants do not tell the turning points apart
    ResolutionError
        the integrals do not converge, and more bits do not help: they give no more nodes
    """
    # near a separatrix more bits are lost: then the precision is doubled
    precision = bits + 128
    while True:
        try:
            with own_precision(precision):
                return _at_precision(level, bits, precision)
        except ResolutionError:
            raise
        except AccuracyError:
            if (precision := 2 * precision) > MOST_BITS:
                raise


def _at_precision(level: Level, bits: int, precision: int) -> Precession:
    """Return every constant, at the precision of the moment, if it is enough.

    Raises
    ------
    AccuracyError
        the precision is not enough
    """
    I1, I3, _, p1, p2, pi3, k1, k2, k3 = (enclosed(x) for x in level.numbers)
    parts = integrands(level)
    integrals = parts.integrals(bits)
    u = parts.start(k3)
    (t0, *angles), rates = integrals.at(u)
    factors = _unit_factors(parts, u, rates, acb(p1, p2), acb(k1, k2))
    found = Precession(parts, integrals, precision, pi3, enclosed(level.square_radius).sqrt(),
                       enclosed(level.axial) / I1 - pi3 / I3, t0, tuple(angles), factors)
    _check(found, bits + MARGIN)
    return found


def _unit_factors(parts: Integrands, u: arb, rates: list[arb], p: acb, w: acb) -> tuple[acb, acb]:
    """Return the unit factors of a and b: from k1 + i k2, at a pole from π1 + i π2, so that φ = 0."""
    s, c, turn = parts.shape(u)
    if parts.level.direction == 0 and parts.path is not None:
        s, c = parts.ends
    a, b = parts.structure(s, c)
    across, relative = valued(parts.forms.across, Squares(c * c, s * s, s * c, turn)), acb(1)
    if w != 0:
        relative = w / (acb(0, 1) * acb(*across))
    elif p != 0:
        relative = p * rates[0] / (acb(0, 1) * acb(*momentum(parts.forms, across, turn, rates[1] + rates[2])))
    relative /= abs(relative)
    if a == 0 or b == 0:
        first = (a if b == 0 else relative * b).conjugate()
    else:
        square = (relative * a * b).conjugate() / abs(a * b)
        # its root, up to a positive factor
        first = 1 + square if square.real > 0 else acb(0, 1) * (1 - square)
    first /= abs(first)
    return first, relative * first


def _check(found: Precession, bits: int) -> None:
    """Check that every constant is known: lengths relatively, angles by the radian, times by the period."""
    parts, integrals = found.integrands, found.integrals
    of_one = [*found.angles, *(x for factor in found.factors for x in (factor.real, factor.imag))]
    relative = [x for gap in parts.gaps for x in gap if x != 0] + [parts.I1, found.r, *parts.momenta]
    time = integrals.means[0] * (1 if integrals.quarter is None else integrals.quarter)
    pairs = [(x, abs(x)) for x in relative if x != 0] + [(x, arb(1)) for x in of_one]
    pairs += [(found.t0, abs(time) + abs(found.t0)),
              (found.axial_rate, abs(found.axial_rate) + abs(found.pi3 / parts.I1))]
    if not all(x.is_finite() and x.rad() <= size * arb(2) ** -bits for x, size in pairs):
        raise AccuracyError(f"the constants of the motion are not known to {bits} bits")
