"""The motion of a body of revolution in U(k3) in doubles.

k3 by elliptic functions, the two angles by series, at any time.
"""
from functools import cached_property
from typing import Any

import numpy as np
from flint import arb

from ...algebra.floats import Array
from ...algebra.precision import own_precision
from ..periods import double, pair, reduced, turns
from .cayley_klein import momentum, rotation, structure
from .level import Level, enclosed, known
from .precession import precession

BLOCK = 4096                                               # times that a cache holds


class AxialMotion:
    """A body of revolution in U(k3) from a state on, a route of gyrostat.trajectories.motion.

    Parameters
    ----------
    level : Level
    bits : int
        of the states in balls; 53 for doubles
    """

    enclosed, recognised, axis = True, "", (0.0, 0.0, 1.0)

    def __init__(self, level: Level, bits: int = 53):
        self.exact = precession(level, bits)

    def _parameters(self, t: Array) -> tuple[list[Array], list[Array], Array]:
        """a, b, their derivatives without Λ, and k3, at times of one dimension."""
        exact, parts = self.exact, self.exact.integrands
        u, angles = self._path(t)
        bounded, rates = exact.integrals.bounded(u)
        s, c, turn = (0 * u, 1 + 0 * u, 0 * u) if parts.path is None else parts.path.shape(u)
        values, slopes = structure(self._gaps, parts.senses, s, c, turn, rates, 1j, 0.5**0.5)
        half_turns = turns(t, self._pairs["axial"])
        units = []
        for factor, sign, angle, value, start in zip(exact.factors, (-1, 1), angles, bounded[1:],
                                                     exact.angles):
            gained = 2 * np.pi * sign * half_turns + angle + value - double(start)
            units.append(complex(factor) * np.exp(1j * gained))
        height = c * c * double(parts.lower) + s * s * double(parts.upper)
        return [x * e for x, e in zip(values, units)], [x * e for x, e in zip(slopes, units)], height

    def state(self, t: Array) -> Array:
        """(π, k) at times of any shape, shape (..., 6)."""
        times, exact = t.ravel(), self.exact
        x = np.empty((times.size, 6))
        x[:, 2] = double(exact.pi3)
        for first in range(0, times.size, BLOCK):
            part = slice(first, first + BLOCK)
            (a, b), rates, x[part, 5] = self._parameters(times[part])
            p = momentum(double(exact.integrands.I1), a, b, *rates)
            k = 2j * double(exact.r) * b * a.conjugate()
            x[part, 0], x[part, 1], x[part, 3], x[part, 4] = p.real, p.imag, k.real, k.imag
        return x.reshape(*t.shape, 6)

    def attitude(self, t: Array) -> Array:
        """R from body to space, shape (..., 3, 3)."""
        (a, b), _, _ = self._parameters(t.ravel())
        return rotation(a, b).reshape(*t.shape, 3, 3)

    @cached_property
    def _gaps(self) -> list[list[float]]:
        return [[double(x) for x in gap] for gap in self.exact.integrands.gaps]

    @cached_property
    def _pairs(self) -> dict[str, Any]:
        """Periods and turns in two doubles."""
        integrals = self.exact.integrals
        with own_precision(self.exact.precision):
            turn = 2 * arb.pi()
            time, *means = integrals.means
            jump, *jumps = integrals.jumps
            pairs: dict[str, Any] = {"axial": pair(self.exact.axial_rate / (2 * turn))}
            # of what the angles grow by in a unit of time, before and after
            if integrals.quarter is None:
                ratios = [[(mean + side * step) / (time + side * jump) for mean, step in zip(means, jumps)]
                          for side in (-1, 1)]
                pairs["rates"] = [[pair(x / turn) for x in row] for row in ratios]
            else:
                whole = 2 * integrals.quarter
                pairs["period"] = pair(whole * time)
                pairs["angles"] = [pair(whole * mean / turn) for mean in means]
            return pairs

    def _path(self, t: Array) -> tuple[Array, list[Array]]:
        """u, and the linear parts of the two angles."""
        start, means = double(self.exact.t0), [double(x) for x in self.exact.integrals.means[1:]]
        if "period" in self._pairs:
            period = self._pairs["period"]
            n, r = reduced(t, period)
            r = r + start
            k = np.rint(r / period.high)
            r, n = r - k * period.high, n + k
            u = self.exact.integrals.inverse(r)
            return u, [2 * np.pi * turns(n, whole) + mean * u
                       for mean, whole in zip(means, self._pairs["angles"])]
        u = self.exact.integrals.inverse(t + start)
        bounded, late = self.exact.integrals.bounded(u)[0][0], u > 0
        rest, rates = start - bounded, self._pairs["rates"]
        return u, [2 * np.pi * np.where(late, turns(t, after) + after.high * rest,
                                        turns(t, before) + before.high * rest)
                   for before, after in zip(*rates)]

    def ball_state(self, t: arb, _: int) -> list[arb]:
        """(π, k) at a time, to as many bits as the motion was built for."""
        return self.exact.state(t)

    def exact_period(self, _: int) -> arb | None:
        """Of the nutation, as exact as the motion was built."""
        return self.exact.gains[0]

    def exact_angles(self, _: int) -> tuple[arb, arb]:
        """What precession and spin say, as exact as the motion was built."""
        return self.exact.gains[1:]

    @property
    def period(self) -> float | None:
        """Of the nutation [T]; None at rest and on a separatrix."""
        return None if self.exact.gains[0] is None else double(self.exact.gains[0])

    @property
    def precession(self) -> float:
        """What φ gains in a period, or its rate."""
        return double(self.exact.gains[1])

    @property
    def spin(self) -> float:
        """What ψ gains in a period, or its rate."""
        return double(self.exact.gains[2])

    @cached_property
    def name(self) -> str:
        """What kind of motion it is, or how it is computed."""
        parts, level = self.exact.integrands, self.exact.integrands.level
        if parts.path is None:
            point = dict(zip(level.scene.space.coordinates, level.state))
            rests = all(known(rate.xreplace(point)) == 0 for rate in level.scene.vector_field())
            return "equilibrium" if rests else "steady precession"
        roots = parts.path.roots
        if any(roots.double):
            return "separatrix"
        return "elliptic" if roots.leading is not None and not parts.path.rest else "quadrature"

    @property
    def limits(self) -> tuple[float, float]:
        """Lowest and highest k3."""
        return double(self.exact.integrands.lower), double(self.exact.integrands.upper)

    @property
    def nodes(self) -> int:
        """Values of the integrands that were taken."""
        return self.exact.integrals.nodes

    @cached_property
    def error(self) -> float:
        """Of a state in doubles, estimated: the rounding of what turns within a period."""
        parts = self.exact.integrands
        with own_precision(self.exact.precision):
            across = [abs(double(parts.profile.kinetic(end))) ** 0.5 for end in (parts.lower, parts.upper)]
            largest = max(across + [abs(double(enclosed(x))) for x in parts.level.numbers[3:]])
        fastest = max(across + [abs(double(x)) for x in parts.momenta]) / double(parts.I1)
        return 2.0**-52 * (4 + (self.period or 0.0) * fastest) * max(1.0, largest)
