"""Axes of bodies of revolution that are not entered in the standard way.

Scenes, points and fields about them, for the tests.
"""
from fractions import Fraction as F

from sympy import ImmutableMatrix, Matrix, Rational, sqrt

import gyrostat as gs

K = [gs.symbol(f"k{i}") for i in (1, 2, 3)]
TURNS = {                                              # R with R c = e3, proper
    "axis 1": Matrix([[0, 1, 0], [0, 0, 1], [1, 0, 0]]), "axis 2": Matrix([[0, 0, 1], [1, 0, 0], [0, 1, 0]]),
    "axis 3": Matrix.eye(3),
    "(1, 2, 2)": Matrix([[2, 1, -2], [-2, 2, -1], [1, 2, 2]]) / 3,
    "(3, 4, 0)": Matrix([[0, 0, 5], [4, -3, 0], [3, 4, 0]]) / 5,
    "(1, 1, 1)": Matrix([[1 / sqrt(2), -1 / sqrt(2), 0], [1 / sqrt(6), 1 / sqrt(6), -2 / sqrt(6)],
                         [1 / sqrt(3)] * 3])}
OBLIQUE = [name for name in TURNS if name.startswith("(")]


def rational(x):
    return Rational(F(x).numerator, F(x).denominator)


def turned(name, x):
    """Rᵀ applied to π and to k."""
    back = TURNS[name].T
    return tuple(y for v in (x[:3], x[3:]) for y in back
                 * ImmutableMatrix([y if hasattr(y, "free_symbols") else rational(y) for y in v]))


def scene(name, I1, I3, l, coefficients, other=()):
    """A body of revolution about an axis, U = Σ cₙ (c·k)ⁿ from n = 1 on, and (abs(k)² − 1) (a·k) on top of
    it.
    """
    R = TURNS[name]
    moments = [I1, I1, I1] if name in OBLIQUE else [int(x) for x in abs(R.T) * Matrix([0, 0, 1])]
    moments = moments if name in OBLIQUE else [I3 if x else I1 for x in moments]
    height = (R * Matrix(K))[2]
    U = sum((rational(c) * height**n for n, c in enumerate(coefficients, 1)), 0 * K[0])
    U += (sum(k**2 for k in K) - 1) * sum(rational(a) * k for a, k in zip(other, K))
    rotor = tuple(rational(l) * x for x in R.row(2))
    return gs.assemble(gs.Gyrostat(tuple(map(rational, moments)), rotor), gs.general_potential(U))


def of_quaternion(a, b, c, d):
    """The rational rotation of a quaternion."""
    return Matrix([[a*a + b*b - c*c - d*d, 2*(b*c - a*d), 2*(b*d + a*c)],
                   [2*(b*c + a*d), a*a - b*b + c*c - d*d, 2*(c*d - a*b)],
                   [2*(b*d - a*c), 2*(c*d + a*b), a*a - b*b - c*c + d*d]]) / (a*a + b*b + c*c + d*d)
