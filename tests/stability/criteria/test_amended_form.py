"""The closed forms of trace, determinant, p and q against matrices, exactly: in any axes, in any field."""
import random
from fractions import Fraction

import heavy_exact
import pytest
from drawn_rotations import KINDS, drawn
from heavy_scenes import scene_of
from slow import sampled
from sympy import Matrix, Rational

import gyrostat as gs
from gyrostat.stability.criteria.amended_form import amended_form


def turned(rng):
    """A rational matrix of rotation, by Euler's parameters."""
    a, b, c, d = (rng.randint(-4, 4) for _ in range(4))
    if not (size := a * a + b * b + c * c + d * d):
        return turned(rng)
    return [[Fraction(x, size) for x in row] for row in (
        (a*a + b*b - c*c - d*d, 2*(b*c - a*d), 2*(b*d + a*c)),
        (2*(b*c + a*d), a*a - b*b + c*c - d*d, 2*(c*d - a*b)),
        (2*(b*d - a*c), 2*(c*d + a*b), a*a - b*b - c*c + d*d))]


def times(R, v):
    return [sum(x * y for x, y in zip(row, v)) for row in R]


def between(R, rows):
    """R rows Rᵀ."""
    half = [times(R, row) for row in rows]
    return [times(R, column) for column in zip(*half)]


def agree(rng):
    """Both at one equilibrium, the closed form in turned axes."""
    moments, rotor, c, Q, omega, k = drawn(rng, rng.choice(KINDS))
    R = turned(rng)
    gradient = [x + y for x, y in zip(c, times(Q, k))]
    tensor = [[moments[i] if i == j else Fraction(0) for j in range(3)] for i in range(3)]
    form = amended_form(between(R, tensor), times(R, rotor), times(R, gradient), between(R, Q), times(R, k),
                        omega)
    p, q, determinant, trace = heavy_exact.decided(moments, rotor, c, Q, omega, k)
    assert form == (trace, determinant, p, q), (moments, rotor, c, Q, omega, k)


def test_against_matrices():
    rng = random.Random("forms")
    for _ in range(25):
        agree(rng)


@pytest.mark.slow
def test_many(full):
    rng = random.Random("many forms")
    for _ in range(sampled(10000, full, 500)):
        agree(rng)


@pytest.mark.slow
def test_against_the_matrices_of_the_library(full):
    """p and q of linearize; definite where the second variation is."""
    rng = random.Random("library forms")
    for _ in range(sampled(300, full, 20)):
        moments, rotor, c, Q, omega, k = drawn(rng, "general")
        scene = scene_of(moments, rotor, c, Q)
        eq = gs.equilibrium(scene, (*(omega * m * x for m, x in zip(moments, k)), *k))
        p, q, determinant, trace = heavy_exact.decided(moments, rotor, c, Q, omega, k)
        assert gs.derivation.linearize(eq).coefficients == (Rational(p), Rational(q))
        second = Matrix(gs.derivation.second_variation(eq).matrix)
        minors = [second[:n, :n].det() for n in range(1, 5)]
        assert all(m > 0 for m in minors) == (determinant > 0 and trace > 0)
        assert (minors[3] > 0) == (determinant > 0)
