"""The integrands along a nutation: dt/du, and the smooth parts of the two angles, in balls."""
from dataclasses import dataclass
from math import prod

from flint import acb, arb

from ..._cached import cached_property
from ..elliptic import quarter_period
from .cayley_klein import Forms, forms
from .level import Level, enclosed
from .nutation import Nutation, nutation
from .profiles import Profile
from .quadrature import FEWEST, over_a_period, to_infinity
from .series_integrals import Integrals
from .turning_points import roots_of

# s, c and the rate of their angle at either end
LOW, HIGH = (arb(0), arb(1), arb(0)), (arb(1), arb(0), arb(0))


@dataclass(frozen=True)
class Integrands:
    """The rates in u of the time and of the two angles of the Cayley-Klein parameters a and b.

    Those of the angles have poles at z = ∓1, with the residues of an angle: a is (c √(1 + z1) + i s √(1 +
    z2))/√2 times a unit factor whose angle has none, and b likewise; s, c are those of the nutation.

    Parameters
    ----------
    level : Level
    profile : Profile
    I1 : arb
    momenta : tuple of arb
        v + P and v − P, exactly 0 if the axis may pass the pole
    path : Nutation or None
        None if k3 is at rest: then u is the time
    lower, upper : arb
        the ends between which k3 moves
    gaps : tuple of (arb, arb)
        √(1 ± z) at the lower and the upper end, exactly 0 if an end is a pole
    """

    level: Level
    profile: Profile
    I1: arb
    momenta: tuple[arb, ...]
    path: Nutation | None
    lower: arb
    upper: arb
    gaps: tuple[tuple[arb, ...], ...]

    @cached_property
    def backward(self) -> bool:
        """Whether u runs against the time."""
        return self.path is not None and self.path.kind == "passage" and self.level.direction < 0

    @cached_property
    def senses(self) -> list[int]:
        """The senses in which c √(1 ± z1) ± i s √(1 ± z2) turn: as their angles do near the pole."""
        return [(sign or 1) * (-1 if self.backward else 1) for sign in self.level.poles]

    def integrals(self, bits: int) -> Integrals:
        """Return the integrals of the time, and of the smooth parts of the two angles."""
        path = self.path
        if path is None:
            rates = [m / (2 * self.I1 * gap[0] ** 2) if m != 0 else arb(0)
                     for m, gap in zip(self.momenta, self.gaps)]
            return Integrals((arb(1), *rates), (arb(0),) * 3, [[arb(0)]] * 3, None, 1)
        if (quarter := path.quarter) is not None:
            nodes = FEWEST
            if path.complement < 0.999:                    # the terms fall like the nome to the power j
                fall = float(quarter / quarter_period(1 - path.complement))
                nodes = max(nodes, int(0.28 * bits * fall) + 6)
            return over_a_period(lambda u: self.rates(path, *path.shape(u)), quarter, nodes, bits + 7)
        first, last = {(False, True): (HIGH, HIGH), (True, False): (LOW, LOW),
                       (True, True): (LOW, HIGH)}[path.roots.double]
        limits = self.rates(path, *first), self.rates(path, *last)
        return to_infinity(lambda u: self.rates(path, *path.shape(u)), limits, bits + 7)

    def rates(self, path: Nutation, s: arb, c: arb, turn: arb) -> list[arb]:
        """Return dt/du, and d(angle)/du without the angle of c √(1 ± z1) ± i s √(1 ± z2)."""
        time = self.I1 * path.scale / self._factor(path, s, c).sqrt() * (-1 if self.backward else 1)
        rates = [time]
        for level, (low, high), sense in zip(self.momenta, self.gaps, self.senses):
            square = c * low * c * low + s * high * s * high
            rates.append((time * level / (2 * self.I1) - sense * turn * low * high) / square
                         if low * high != 0 else arb(0))
        return rates

    def _factor(self, path: Nutation, s: arb, c: arb) -> arb:
        """Return g/abs(q)."""
        z = c * c * self.lower + s * s * self.upper
        if path.roots.leading is not None:
            return prod((abs(z - x) ** m for x, m in path.rest), start=abs(path.roots.leading))
        if at_end := (c == 0 or s == 0):
            z = self.lower if s == 0 else self.upper
        value = self.profile(z, 2) / 2 if at_end else self.profile(z)
        return abs(value) / path.quartic(z, at_end)

    @cached_property
    def ends(self) -> tuple[arb, ...]:
        """The s and c at the end at which a motion starts that starts at one."""
        return LOW[:2] if self.level.turn > 0 else HIGH[:2]

    def start(self, height: arb) -> arb:
        """Return u at the time 0."""
        if self.path is None:
            return arb(0)
        width = self.upper - self.lower
        if self.level.direction == 0:
            s, c = self.ends
        else:
            s, c = ((height - self.lower) / width).sqrt(), ((self.upper - height) / width).sqrt()
        return self.path.start(s if self.level.direction >= 0 or self.backward else -s, c)

    def shape(self, u: arb) -> tuple[arb, arb, arb]:
        """Return s, c and the rate of their angle."""
        return LOW if self.path is None else self.path.shape(u)

    @cached_property
    def forms(self) -> Forms:
        """The products of a and b without their unit factors.

        They have the precision at which they are first asked.
        """
        return forms(self.gaps, self.senses)

    def structure(self, s: arb, c: arb) -> list[acb]:
        """Return √2 a and √2 b without their unit factors."""
        return [acb(c * low, s * (sense * high)) for (low, high), sense in zip(self.gaps, self.senses)]


def integrands(level: Level) -> Integrands:
    """Return the integrands of a level, at the precision of the moment."""
    height, r = enclosed(level.height), enclosed(level.square_radius).sqrt()
    v, P = enclosed(level.level) / r, enclosed(level.axial)
    momenta = tuple(arb(0) if sign == 0 else v + side * P for side, sign in zip((1, -1), level.poles))
    path = None if level.direction == 0 and level.turn == 0 else nutation(roots_of(level))
    lower, upper = (height, height) if path is None else (path.roots.lower, path.roots.upper)
    gaps = []
    for sign, side in zip(level.poles, (1, -1)):
        poles = [sign == 0 and (1 + side * x / r).contains(0) for x in (lower, upper)]
        gaps.append(tuple(arb(0) if pole else (1 + side * x / r).sqrt()
                          for x, pole in zip((lower, upper), poles)))
    return Integrands(level, Profile(level), enclosed(level.inertia), momenta, path, lower, upper,
                      tuple(gaps))
