"""Boundary points of bodies of revolution, moved, and how far k3 goes from them.

The reduced motion of z = k3 is I1² ż² = g(z) = 2 I1 (e − U(z))(1 − z²) − (v − P z)². A boundary point is a
root z0 of g of multiplicity m = n + 2 > 2. Put z = z0 + σ y, with σ = −s at E1, E2 (z0 = s = ±1, y ≥ 0) and
σ = 1 at E3 (y of both signs); g = c y^m + …. Stable: c < 0, at E3 with m even. The states, the perturbations
and g are exact; turning points are proved enclosures of the roots of g.
"""
import random
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

import numpy as np
import oracle
from flint import arb, fmpq, fmpq_poly

CASES, DEGREE, REACH = 15, 6, fmpq(1, 4)
NAMED = tuple(fmpq(1, 10**d) for d in (2, 3, 4))
KINDS = [(family, verdict, n) for family in ("upright", "hanging") for verdict in ("STABLE", "UNSTABLE")
         for n in (1, 2, 3)]
# m = 3 is never stable at E3
KINDS += [("inclined", "STABLE", n) for n in (2, 4)] + [("inclined", "UNSTABLE", n) for n in (1, 2, 3)]


@dataclass(frozen=True)
class Case:
    """A boundary point: moments, l, U = a1 z + … + a6 z⁶, state (π, k), σ, spin ω (E3), direction (rotation
    of k, δπ).
    """

    family: str
    I1: fmpq
    I3: fmpq
    l: fmpq
    potential: list
    state: np.ndarray
    sigma: int
    omega: fmpq
    first: fmpq
    direction: tuple

    def integrals(self, x):
        return oracle.axial_integrals(x, self.I1, self.l, self.potential)

    def reduced(self, x):
        """g of the motion through x, in powers of y."""
        return oracle.expand(oracle.reduced_motion(self.I1, *self.integrals(x), self.potential),
                             self.state[5], self.sigma)

    def moved(self, step, level=False):
        """The state with k turned and π moved by about abs(step), abs(k) = 1 exactly.

        On its level: the same π3, at E3 also C1.
        """
        turn, change = self.direction
        k, pi = turned(self.state[3:], step * vector(turn) / 2), self.state[:3] + step * vector(change)
        if level:
            pi[2] = self.state[2]
            if self.family == "inclined":
                v = self.integrals(self.state)[1]
                pi[:2] += k[:2] * ((v - self.integrals(np.concatenate([pi, k]))[1]) / (k[0] ** 2 + k[1] ** 2))
        return np.concatenate([pi, k])

    def values(self):
        """What the library is given."""
        named = {f"a{i}": a for i, a in enumerate(self.potential) if i} | {"I1": self.I1, "I3": self.I3}
        named |= {"l": self.l} | ({"omega": self.omega, "k3": self.state[5]} if self.family == "inclined"
                                  else {"pi3_0": self.state[2]})
        return {name: Fraction(int(a.p), int(a.q)) for name, a in named.items()}


def plain(x):
    """A rational as a float."""
    return int(x.p) / int(x.q) if isinstance(x, fmpq) else float(x)


def vector(numbers):
    return np.array([fmpq(a) for a in numbers], dtype=object)


def turned(k, a):
    """k rotated about a by 2 arctan abs(a), rational where both are."""
    once = np.cross(a, k)
    return k + 2 * (once + np.cross(a, once)) / (1 + a.dot(a))


@cache
def cases(family, verdict, n):
    """Random boundary points; every fifth of E1, E2 has P = 0 = U'."""
    draw = random.Random(f"{family} {verdict} {n}")

    def number(low, high):
        return fmpq(draw.randint(32 * low, 32 * high), 32)

    def signed(low, high):
        return draw.choice((-1, 1)) * number(low, high)

    found, m = [], n + 2
    while len(found) < CASES:
        I1, P = number(1, 3), fmpq(0) if len(found) % 5 == 0 and family != "inclined" else signed(1, 2)
        I3, first = I1 * number(1, 7) / 4, number(4, 8) * (4 if family == "inclined" else 1)
        if verdict == "STABLE":
            first = -first
        elif family == "inclined" and m % 2:
            first *= draw.choice((-1, 1))
        if family == "inclined":
            t, sigma, omega = number(1, 3) / 2, 1, signed(1, 2)
            k = [2 * t / (1 + t * t), 0, draw.choice((-1, 1)) * (1 - t * t) / (1 + t * t)]
            pi = [I1 * omega * k[0], 0, I3 * omega * k[2]]
        else:
            s = 1 if family == "upright" else -1
            sigma, omega, k, pi = -s, fmpq(0), [0, 0, s], [0, 0, signed(0, 3)]
        l = P - pi[2]
        v = pi[0] * k[0] + P * k[2]
        # 2 I1 (e − U)(1 − z²) = (v − P z)² + c y^m + …, a power series in y: U up to y⁶
        sphere = oracle.expand([fmpq(1), 0, -1], k[2], sigma)
        drift = oracle.expand([v, -P], k[2], sigma)
        wanted = oracle.product(drift, drift) + [fmpq(0)] * (DEGREE + 2)
        wanted[m] += first
        for j in range(m + 1, DEGREE + 2):
            wanted[j] += first * signed(0, 1) / 2
        energy = oracle.quotient(wanted, [2 * I1 * c for c in sphere], DEGREE)
        potential = oracle.expand([-c for c in energy], -sigma * k[2], sigma)        # y = σ (z − z0)
        potential[0] = fmpq(0)
        turn, change = [[signed(1, 3) / 6 for _ in range(3)] for _ in range(2)]
        case = Case(family, I1, I3, l, potential, vector(pi + k), sigma, omega, first, (turn, change))
        g = case.reduced(case.state)
        assert g[:m] == [0] * m and g[m] == first
        if sum(abs(c) * REACH ** (j + 1) for j, c in enumerate(g[m + 1:])) <= abs(first) / 2:
            found.append(case)
    return found


def roots(g):
    """Real roots of a polynomial with rational coefficients, as disjoint proved balls of relative radius
    2⁻⁵³; and all roots.
    """
    every = [r for r, _ in fmpq_poly(g).complex_roots()]
    return sorted((r.real for r in every if r.imag == 0), key=float), every


def turning_points(case, x):
    """The ends of the interval of y in which k3 moves from x: the roots of g next to it."""
    g, y = case.reduced(x), case.sigma * (x[5] - case.state[5])
    assert oracle.polynomial(g, y) == (x[3] * x[1] - x[4] * x[0]) ** 2 > 0             # g(z) = I1² ż²
    y, real = arb(y), roots(g)[0]
    assert all((r < y) != (r > y) for r in real)       # the balls decide: one of the two is proved
    return [r for r in real if r < y][-1], [r for r in real if r > y][0]


def excursion(case, eps, level=False):
    """max abs(k3 − z0) over the motions from the point moved by +ε and by −ε, and the step of the larger one.
    """
    return max((max(abs(float(y)) for y in turning_points(case, case.moved(step, level))), step)
               for step in (eps, -eps))


def names(kind):
    return "-".join(map(str, kind))
