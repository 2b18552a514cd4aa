"""A vehicle in a fluid by its velocities, in fractions: nothing here imports gyrostat, no matrix is inverted.

J Ω̇ + D v̇ = (π + l) × Ω + p × v + γ × (−w), Dᵀ Ω̇ + M v̇ = p × Ω, γ̇ = γ × Ω, π = J Ω + D v, p = Dᵀ Ω + M v.
"""
from fractions import Fraction
from typing import NamedTuple

import mpmath as mp
from two_directions import Scene, characteristic, cross, dot

SPHERE = Fraction(1, 9)                                    # moment of a sphere in a viscous cavity


class Vehicle(NamedTuple):
    """J, D, M by rows, the weight times the centre of gravity, and the rotor."""

    J: list
    D: list
    M: list
    weight: list
    rotor: list

    def momenta(self, omega, v):
        """π and p."""
        columns = [list(c) for c in zip(*self.D)]
        return ([dot(j, omega) + dot(d, v) for j, d in zip(self.J, self.D)],
                [dot(d, omega) + dot(m, v) for d, m in zip(columns, self.M)])

    def rates(self, z):
        """π̇, ṗ, γ̇ of (Ω, v, γ)."""
        omega, v, down = z[:3], z[3:6], z[6:]
        pi, p = self.momenta(omega, v)
        M = [a + b for a, b in zip(pi, self.rotor)]
        force = [-w for w in self.weight]
        turning = [x + y + t for x, y, t in zip(cross(M, omega), cross(p, v), cross(down, force))]
        return [*turning, *cross(p, omega), *cross(down, omega)]

    def jacobian(self, z):
        """Of the velocities' rates: central differences of a field of degree two are exact."""
        columns = []
        for n in range(9):
            ahead, behind = ([x + (step if i == n else 0) for i, x in enumerate(z)] for step in (1, -1))
            columns.append(self.accelerations([(p - q) / 2 for p, q in zip(self.rates(ahead),
                                                                           self.rates(behind))]))
        return [list(row) for row in zip(*columns)]

    def accelerations(self, rates):
        """Ω̇, v̇, γ̇ of π̇, ṗ, γ̇, by elimination."""
        columns = [list(c) for c in zip(*self.D)]
        rows = [[*j, *d, x] for j, d, x in zip(self.J, self.D, rates)]
        rows += [[*d, *m, x] for d, m, x in zip(columns, self.M, rates[3:])]
        for n in range(6):                                 # positive definite: every pivot is positive
            rows = [row if i == n else [x - row[n] * y / rows[n][n] for x, y in zip(row, rows[n])]
                    for i, row in enumerate(rows)]
        return [*(row[6] / row[n] for n, row in enumerate(rows)), *rates[6:]]

    def polynomial(self, z):
        """1, c1, …, c9 of the characteristic polynomial at a steady motion."""
        return characteristic(self.jacobian(z))

    def energy(self):
        """The same as h = ½ π·Aπ + π·Bx + ½ x·Sx + s·x in x = (p, γ): the inverse of T, by elimination."""
        columns = [self.accelerations([Fraction(i == n) for i in range(9)])[:6] for n in range(6)]
        rows, none = [list(row) for row in zip(*columns)], [Fraction(0)] * 3
        return Scene([row[:3] for row in rows[:3]], self.rotor, [[*row[3:], *none] for row in rows[:3]],
                     [*([*row[3:], *none] for row in rows[3:]), *([*none, *none] for _ in range(3))],
                     [*none, *(-w for w in self.weight)])

    def growing(self, z, damping=Fraction(1, 2)):
        """The growing modes with a sphere inside, which is part of J, about a motion of both as one."""
        body = self._replace(J=[[x - SPHERE * (i == j) for j, x in enumerate(row)]
                                for i, row in enumerate(self.J)])

        def field(state):
            omega, inner = state[:3], state[9:]
            torque = [damping * (a - b) for a, b in zip(omega, inner)]
            rates = body.rates(state[:9])
            rates = [*(a - b for a, b in zip(rates, torque)), *rates[3:]]
            spin = [a + b / SPHERE for a, b in zip(cross(inner, omega), torque)]
            return [*body.accelerations(rates), *spin]

        start, columns = [*z, *z[:3]], []
        for n in range(12):
            ahead, behind = ([x + (step if i == n else 0) for i, x in enumerate(start)] for step in (1, -1))
            columns.append([(p - q) / 2 for p, q in zip(field(ahead), field(behind))])
        with mp.workdps(60):
            matrix = mp.matrix([[mp.mpf(x.numerator) / x.denominator for x in row] for row in zip(*columns)])
            values = mp.eig(matrix, left=False, right=False)
            scale = max(map(abs, values))
            return sum(mp.re(x) > scale * mp.mpf(10) ** -14 for x in values)


def random_vehicle(rng, weight=True):
    """With a positive kinetic energy: G Gᵀ for a random 6 × 6 G."""
    G = [[Fraction(rng.randint(-3, 3), rng.randint(1, 2)) + (2 if i == j else 0) for j in range(6)]
         for i in range(6)]
    T = [[dot(a, b) for b in G] for a in G]
    if not _positive(T):
        return random_vehicle(rng, weight)
    some = [[Fraction(rng.randint(-4, 4), rng.randint(1, 3)) for _ in range(3)] for _ in range(2)]
    return Vehicle([row[:3] for row in T[:3]], [row[3:] for row in T[:3]], [row[3:] for row in T[3:]],
                   some[0] if weight else [Fraction(0)] * 3, some[1])


def _positive(T):
    rows = [list(row) for row in T]
    for n in range(6):
        if rows[n][n] <= 0:
            return False
        rows = [row if i <= n else [x - row[n] * y / rows[n][n] for x, y in zip(row, rows[n])]
                for i, row in enumerate(rows)]
    return True
