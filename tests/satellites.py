"""Random satellites that rest in a circular orbit, in fractions, and the same in the oracle."""
from fractions import Fraction

from sympy import Rational
from two_directions import Scene, dot
from two_directions import random_fraction as some


def rotation(rng):
    """Rows of a rational rotation."""
    a, b, c, d = (rng.randint(-4, 4) for _ in range(4))
    s = a * a + b * b + c * c + d * d
    if not s:
        return rotation(rng)
    return [[Fraction(x, s) for x in row] for row in (
        (a*a + b*b - c*c - d*d, 2*(b*c - a*d), 2*(b*d + a*c)),
        (2*(b*c + a*d), a*a - b*b + c*c - d*d, 2*(c*d - a*b)),
        (2*(b*d - a*c), 2*(c*d + a*b), a*a - b*b - c*c + d*d))]


def body_of(rng):
    """Three different moments."""
    return [Fraction(rng.randint(4, 30), 10) for _ in range(3)]


def satellite(rng):
    """Moments, n, r, and the rotor that holds them, ω0 = 1."""
    I, (t, n, r) = body_of(rng), rotation(rng)
    along = [i * x for i, x in zip(I, n)]
    # t·Ir = 0 has to hold: turn t and r about n until it does is irrational, so one moment is solved for
    others = [t[i] * r[i] for i in range(3)]
    free = next((i for i in range(3) if others[i]), None)
    if free is not None:
        I[free] = -sum(I[i] * others[i] for i in range(3) if i != free) / others[free]
        along = [i * x for i, x in zip(I, n)]
    if min(I) <= 0 or len(set(I)) < 3:                     # no body of revolution
        return satellite(rng)
    parts = (-dot(t, along), some(rng), -4 * dot(r, along))
    return I, n, r, [sum(p * v[i] for p, v in zip(parts, (t, n, r))) for i in range(3)]


def of_orbit(I, n, r, l):
    """The same in the oracle, and its state."""
    one, zero = Fraction(1), Fraction(0)
    A = [[1 / I[i] if i == j else zero for j in range(3)] for i in range(3)]
    B = [[-one if i == j else zero for j in range(6)] for i in range(3)]
    S = [[3 * I[i - 3] if i == j and i > 2 else zero for j in range(6)] for i in range(6)]
    return Scene(A, l, B, S, [*(-x for x in l), zero, zero, zero]), [*(i * x for i, x in zip(I, n)), *n, *r]


def exact(values):
    """As SymPy's numbers."""
    return [Rational(x.numerator, x.denominator) for x in values]
