"""Random bodies in random fields, exact and in doubles."""
from fractions import Fraction

import numpy as np
from sympy import Matrix

import gyrostat as gs

k1, k2, k3 = DIRECTION = [gs.symbol(f"k{n}") for n in (1, 2, 3)]


def drawn(rng, quadratic):
    """A body, a rotor, U = c·k + k·Qk/2, in fractions."""
    def number():
        return Fraction(rng.randint(-12, 12), rng.randint(1, 6))
    inertia = [Fraction(rng.randint(4, 30), 10) for _ in range(3)]
    half = [[number() if quadratic else Fraction(0) for _ in range(3)] for _ in range(3)]
    Q = [[half[i][j] + half[j][i] for j in range(3)] for i in range(3)]
    return inertia, [number() / 5 for _ in range(3)], [number() / 3 for _ in range(3)], Q, number()


def by_criteria(decision):
    """What spectrum and signature can say; what normal forms say beyond them has tests of its own."""
    by_twist = decision.pointwise or decision.rung is gs.Rung.TWIST
    return "UNDECIDED" if by_twist else decision.verdict.name


def scene_of(inertia, rotor, c, Q):
    slopes = [x + sum(y * k for y, k in zip(row, DIRECTION)) / 2 for x, row in zip(c, Matrix(Q).tolist())]
    U = sum(x * k for x, k in zip(slopes, DIRECTION))
    return gs.assemble(gs.Gyrostat(tuple(inertia), tuple(rotor)), gs.general_potential(U))


def floats(inertia, rotor, c, Q, omega):
    return np.diag([float(x) for x in inertia]), *(np.array(x, float) for x in (rotor, c, Q)), float(omega)
