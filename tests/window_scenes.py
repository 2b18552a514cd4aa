"""Permanent rotations held by gyroscopic forces: drawn, or with the second variation that is asked for.

Exact. U is a polynomial, given by its terms; near the direction k it is g·(x − k) + (x − k)·H(x − k)/2 + …
"""
from dataclasses import dataclass
from fractions import Fraction as F
from functools import cached_property
from itertools import product

from sympy import Rational

import gyrostat as gs

UNIT = [[F(int(i == j)) for j in range(3)] for i in range(3)]


@dataclass(frozen=True)
class Rotation:
    """ω = omega k of a body with a tensor and a rotor, in the field of the terms."""

    tensor: list
    rotor: list
    k: list
    omega: F
    field: dict

    @property
    def momentum(self):
        """M = π + l."""
        return [self.omega * x + y for x, y in zip(applied(self.tensor, self.k), self.rotor)]

    @cached_property
    def inverse(self):
        return inverted(self.tensor)

    @property
    def parts(self):
        """What the oracle takes."""
        return self.inverse, self.rotor, self.k, self.momentum, self.field

    def equilibrium(self):
        def U(*x):
            return sum(Rational(c.numerator, c.denominator) * x[0]**a * x[1]**b * x[2]**d
                       for (a, b, d), c in self.field.items())
        scene = gs.assemble(gs.Gyrostat(self.tensor, tuple(self.rotor)), gs.general_potential(U))
        pi = [m - l for m, l in zip(self.momentum, self.rotor)]
        return gs.equilibrium(scene, (*pi, *self.k))


def applied(rows, v):
    return [sum(x * y for x, y in zip(row, v)) for row in rows]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def adjugate(a):
    columns = [cross(a[(n + 1) % 3], a[(n + 2) % 3]) for n in range(3)]
    return [[columns[j][i] for j in range(3)] for i in range(3)]


def inverted(a):
    found = adjugate(a)
    size = dot(a[0], [row[0] for row in found])
    return [[x / size for x in row] for row in found]


def unit(rng, size=3):
    """A rational direction."""
    a, b, c, d = (rng.randint(-size, size) for _ in range(4))
    if not any((a, b, c, d)):
        return unit(rng, size)
    length = a * a + b * b + c * c + d * d
    return [F(x, length) for x in (2 * (a * d + b * c), 2 * (b * d - a * c), a * a + b * b - c * c - d * d)]


def number(rng, size=12, denominator=6):
    return F(rng.randint(-size, size), rng.randint(1, denominator))


def tensor_of(rng, principal):
    """Three different moments, or a full tensor that turns with a rational rotation."""
    moments = [F(n, 10) for n in rng.sample(range(4, 31), 3)]
    diagonal = [[moments[i] * (i == j) for j in range(3)] for i in range(3)]
    if principal:
        return diagonal
    turn = frame(unit(rng))
    return [[sum(turn[n][i] * moments[n] * turn[n][j] for n in range(3)) for j in range(3)] for i in range(3)]


def frame(k):
    """Rows e1, e2, k, orthonormal: the half turn about k + e3."""
    n = [k[0], k[1], k[2] + 1]
    size = dot(n, n)
    if size == 0:
        return [UNIT[0], [-x for x in UNIT[1]], list(k)]
    return [[2 * n[i] * n[j] / size - UNIT[i][j] for j in range(3)] for i in range(3)]


def field_about(k, *forms):
    """Σ of products of linear forms: each a number and the vectors a, …, b of (x − k)·a … (x − k)·b."""
    total = {(0, 0, 0): F(0)}
    for value, *vectors in forms:
        term = {(0, 0, 0): value}
        for a in vectors:
            following = {}
            for orders, c in term.items():
                for n in range(3):
                    raised = tuple(m + (j == n) for j, m in enumerate(orders))
                    following[raised] = following.get(raised, 0) + c * a[n]
                following[orders] = following.get(orders, 0) - c * dot(a, k)
            term = following
        for orders, c in term.items():
            total[orders] = total.get(orders, 0) + c
    return {orders: c for orders, c in total.items() if c and any(orders)}


def drawn(rng, quadratic, principal=True, rotor=True):
    """A rotation in a uniform or a quadratic field, and p, q of λ⁴ + p λ² + q and the trace of K."""
    k, tensor = unit(rng), tensor_of(rng, principal)
    l = [number(rng) / 5 if rotor else F(0) for _ in range(3)]
    omega, sigma = number(rng) / 2, number(rng)
    g = [omega**2 * a + omega * b + sigma * c for a, b, c in zip(applied(tensor, k), l, k)]
    half = [[number(rng) / 4 if quadratic else F(0) for _ in range(3)] for _ in range(3)]
    H = [[half[i][j] + half[j][i] for j in range(3)] for i in range(3)]
    forms = [(F(1), g), *((H[i][j] / 2, UNIT[i], UNIT[j]) for i, j in product(range(3), repeat=2))]
    return Rotation(tensor, l, k, omega, field_about(k, *forms)), *invariants(tensor, l, k, omega, sigma, H)


def amended(tensor, l, k, omega, sigma):
    """Of the Hessian K of the amended potential what is not the Hessian of U, for g·k = ω² J + ω l·k + σ."""
    Ik = applied(tensor, k)
    J = dot(k, Ik)
    v = [2 * omega * a + b for a, b in zip(Ik, l)]
    return [[v[i] * v[j] / J - omega**2 * tensor[i][j] - sigma * UNIT[i][j] for j in range(3)]
            for i in range(3)]


def gyroscopic(tensor, l, k, omega):
    """J/det I, the inertia A on the tangent plane and B of p = J (B² + tr AK)/det I."""
    Ik = applied(tensor, k)
    J = dot(k, Ik)
    A = [[tensor[i][j] - Ik[i] * Ik[j] / J for j in range(3)] for i in range(3)]
    B = (dot(l, Ik) + 2 * omega * dot(Ik, Ik)) / J - omega * sum(tensor[n][n] for n in range(3))
    return J / dot(tensor[0], [row[0] for row in adjugate(tensor)]), A, B


def invariants(tensor, l, k, omega, sigma, H):
    share, A, B = gyroscopic(tensor, l, k, omega)
    K = [[x + y for x, y in zip(*rows)] for rows in zip(amended(tensor, l, k, omega, sigma), H)]
    p = share * (B**2 + sum(A[i][j] * K[j][i] for i in range(3) for j in range(3)))
    return p, share * dot(k, applied(adjugate(K), k)), sum(K[n][n] for n in range(3)) - dot(k, applied(K, k))


def windows(rng, *kind):
    """Drawn rotations in windows that no resonance of order 2 to 4 meets, without end."""
    while True:
        rotation, p, q, trace = drawn(rng, *kind)
        if not rotation.field or min(p, q, p * p - 4 * q, -trace) <= 0:
            continue
        if 4 * p * p != 25 * q and 9 * p * p != 100 * q:
            yield rotation
