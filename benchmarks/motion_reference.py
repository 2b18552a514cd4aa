"""The cases of motion_speed_against_error.py, and their motion to any number of digits by Taylor series.

The package gyrostat is not used.

All numbers of a case are float64 and mean the rationals that they are. The field is π̇ = (π + l) × ω + k ×
    ∇U, k̇ = k × ω, ωᵢ = πᵢ/Iᵢ,
with U = slope · k; a free body has no k.
"""
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, cos, hypot, pi, sin, tan
from operator import mul

from mpmath import ellipk, mp, mpf, polyroots, sqrt, workdps

# coefficients that have to be small at the end of a series
LOOK_BACK = 5


@dataclass(frozen=True)
class Case:
    """A body in a uniform field or in none, where it starts, and at which times it is asked for."""

    name: str
    inertia: tuple
    state: tuple                                           # π1, π2, π3, then k1, k2, k3 if there is a field
    times: dict                                            # what is written over the table: the time
    rotor: tuple = (0, 0, 0)
    slope: tuple = (0, 0, 0)

    @property
    def free(self):
        return len(self.state) == 3

    @property
    def revolution(self):
        return (
            not self.free
            and self.inertia[0] == self.inertia[1]
            and not any((*self.rotor[:2], *self.slope[:2]))
        )

    @property
    def turn(self):
        """2π I/abs(π + l), I the least moment across the axis, or of all.

        The unit of the steps of splittings.
        """
        return 2 * pi * min(self.inertia[:2] if self.revolution
                            else self.inertia) / hypot(*map(sum, zip(self.state, self.rotor)))

    def invariants(self, x):
        """h, (π + l)·k and abs(k)², or h and abs(π)² of the free body, in the arithmetic of x."""
        momentum = [p + Fraction(l) for p, l in zip(x, self.rotor)]
        kinetic = sum(p * p / Fraction(i) for p, i in zip(x, self.inertia)) / 2
        if self.free:
            return kinetic, sum(p * p for p in x)
        k = x[3:]
        return (
            kinetic + sum(Fraction(g) * c for g, c in zip(self.slope, k)),
            sum(map(mul, momentum, k)),
            sum(c * c for c in k),
        )

    def drifts(self, x):
        """Relative deviations of the invariants in a state, exactly."""
        now, then = (self.invariants([Fraction(float(c)) for c in state]) for state in (x, self.state))
        return [abs(float(a / b - 1)) for a, b in zip(now, then)]


def cases(quick=False):
    """What is compared; the quick ones are one of each kind of splitting."""
    # of the sleeping top: critical is (π3 + l)² = 4 I1 m0
    gyrostat, M3 = (1.0, 1.0, 0.6), 2 * (1 + 5e-7)
    starts = {"generic gyrostat": (0.3, -0.2, 1.5, sin(0.8), 0.0, cos(0.8)),
              "sleeping top near critical": (0.0, 0.0, M3 - 0.4, sin(1e-3), 0.0, cos(1e-3)),
              "top past the upright": ((0.9 + 1e-6) * tan(0.6), 1.2, 0.5, sin(1.2), 0.0, cos(1.2))}
    period = {name: float(nutation_period(gyrostat, 0.4, 1, start)) for name, start in starts.items()}
    def field(name, *periods):
        times = {f"{n:.0e} nutation periods of {period[name]:.4g}".replace("e+0", "e"): (n + 0.3)
                 * period[name] for n in periods}
        return Case(name, gyrostat, starts[name], times, (0, 0, 0.4), (0, 0, 1.0))
    top = Case("M1: heavy top J = (5, 5, 1)", (5.0, 5.0, 1.0), (0.0, 0.0, 50.0, 0.0, sin(0.05), cos(0.05)),
               {"t = 10": 10.0},
               slope=(0, 0, 20.0))
    free = Case("M2: free body I = (2, 1, 2/3)", (2.0, 1.0, 2 / 3), (cos(1.1), 0.0, sin(1.1)),
                {"t = 32": 32.0})
    chaotic = Case("M3: chaotic gyrostat", (1.0, 2.0, 3.0), (0.5, 0.3, 1.2, 0.6, 0.0, 0.8), {"t = 20": 20.0},
                   (0.3, -0.2, 0.5), (0.2, 0.4, 1.0))
    if quick:
        return [field("generic gyrostat", 3), free, chaotic]
    flips = Case("M4: free body I = (3, 5, 9)", (3.0, 5.0, 9.0), (0.0, 2.0, 0.01), {"t = 620": 620.0})
    near = [Case(f"near a separatrix, d = {d:.0e}".replace("e-0", "e-"), (1.0, 2.0, 3.0),
                 (d / 2, 2.0, 2 * d), {"t = 400": 400.0})
            for d in (1e-2, 1e-4, 1e-6, 1e-7)]
    long = [field(name, 10**2, 10**4, 10**6) for name in ("generic gyrostat", "sleeping top near critical")]
    return [top, free, chaotic, flips, *long, field("top past the upright", 10**2), *near]


def nutation_period(inertia, rotor, m0, state):
    """Time between two passages of k3 through its lowest value for a body of revolution in U = m0 k3, 30
    digits.

    I1² k̇3² = 2 I1 (abs(k)² − k3²)(E − m0 k3) − (C − P k3)², with P = π3 + l, C = (π + l)·k and E the energy
    but for the spin: a cubic with roots a < b < c, and the period is 4 K/√(2 m0 (c − a)/I1) with the
    parameter (b − a)/(c − a).
    """
    with workdps(40):
        I1, g, P, k3 = mpf(inertia[0]), mpf(m0), mpf(state[2]) + mpf(rotor), mpf(state[5])
        x, k = [*map(mpf, state[:2]), P], [*map(mpf, state[3:])]
        E, C, square = (x[0]**2 + x[1]**2) / 2 / I1 + g * k3, sum(map(mul, x, k)), sum(map(mul, k, k))
        cubic = [2 * I1 * g, -2 * I1 * E - P**2, 2 * C * P - 2 * I1 * g * square, 2 * I1 * E * square - C**2]
        a, b, c = sorted(root.real for root in polyroots(cubic, maxsteps=200, extraprec=300))
        return 4 * ellipk((b - a) / (c - a)) / sqrt(2 * g / I1 * (c - a))


def taylor(case, time, digits=40):
    """The state at a time, by Taylor series in whole numbers with a common denominator 2ⁿ; a list of mpf.

    Orders grow with the digits; a step is such that the last coefficients are below 10^−digits, or it is
    taken again. The guard bits are for the growth of what is lost: exponential near a separatrix.
    """
    order, bits = digits + 14, ceil(3.33 * digits) + 64
    small = (1 << bits) // 10**digits
    def fixed(x):
        x = Fraction(x)
        return (x.numerator << bits) // x.denominator
    x, left, step = [fixed(c) for c in case.state], fixed(time), fixed(case.turn / 8)
    coefficients = _coefficients(case, fixed, bits)
    while left:
        now = min(step, left)
        series = coefficients(x, now, order)
        last = max(max(map(abs, column[-LOOK_BACK:])) for column in series)
        factor = Fraction((small / max(last, 1)) ** (1 / order)).limit_denominator(1000)
        if last > 64 * small:
            step = int(now * factor)
            continue
        x, left = [sum(column) for column in series], left - now
        if now == step:
            step = int(now * factor)
    with workdps(digits + 20):
        return [mpf(c) / mpf(1 << bits) for c in x]


def _coefficients(case, fixed, bits):
    """(x, h, order) ↦ the terms xₙ hⁿ of each coordinate, from products of series term by term."""
    rate = [fixed(1 / Fraction(i)) for i in case.inertia]
    l, g = [fixed(c) for c in case.rotor], [fixed(c) for c in case.slope]
    gap = [rate[2] - rate[1], rate[0] - rate[2], rate[1] - rate[0]]
    def shift(*terms):
        return sum(terms) >> bits
    def product(a, b):
        return sum(map(mul, a, reversed(b))) >> bits
    def series(x, h, order):
        columns = [[c] for c in x]
        p, k = columns[:3], columns[3:]
        w = [[] for _ in p]
        for n in range(1, order + 1):
            for i in range(3):
                w[i].append(shift(p[i][-1] * rate[i]))
            new = []
            for i, j, m in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
                change = shift(gap[i] * product(p[j], p[m]) if gap[i] else 0, l[j] * w[m][-1],
                               -l[m] * w[j][-1])
                new.append(change + shift(k[j][-1] * g[m], -k[m][-1] * g[j]) if k else change)
            if k:
                new += [product(k[j], w[m]) - product(k[m], w[j]) for j, m in ((1, 2), (2, 0), (0, 1))]
            for column, change in zip(columns, new):
                column.append((change * h >> bits) // n)
        return columns
    return series


def error(x, reference):
    """Largest deviation of a coordinate."""
    with workdps(mp.dps + 60):
        return float(max(abs(mpf(float(c)) - r) for c, r in zip(x, reference)))
