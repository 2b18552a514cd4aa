"""The points of a pencil in balls: those of another way, and none where they are not simple."""
import pickle
from fractions import Fraction
from random import Random

import pytest
from sympy import Matrix, Rational, S, diag, eye, pi, sqrt

import gyrostat as gs
from gyrostat.algebra.pencils.enclosed_points import SimplePoints
from gyrostat.algebra.pencils.exact_points import points_on_sphere
from gyrostat.algebra.solving.real_fields import balls

nu = gs.symbol("nu")


def drawn(chance):
    """A symmetric matrix and a vector of fractions, many with an axis that neither mixes with the others."""
    def number():
        x = Fraction(chance.randint(-12, 12), chance.randint(1, 5))
        return Rational(x.numerator, x.denominator)

    rows = [[number() for _ in range(3)] for _ in range(3)]
    A, b = Matrix(3, 3, lambda i, j: rows[min(i, j)][max(i, j)]), Matrix([number() for _ in range(3)])
    for n in range(chance.choice((0, 0, 1, 2))):
        for m in range(3):
            if m != n:
                A[n, m] = A[m, n] = S.Zero
        b[n] = S.Zero
    return A, b, number() ** 2 + 1


@pytest.mark.few(8)
@pytest.mark.parametrize("seed", range(60))
def test_they_are_those_that_resultants_find(seed):
    """At rational numbers, to 100 bits and all of them, where they are simple."""
    A, b, radius = drawn(Random(seed))
    found = SimplePoints(A + nu * eye(3), b, radius, nu).lists
    exact = [numbers for numbers, circle in points_on_sphere(A + nu * eye(3), b, radius, nu)]
    assert len(found) == len(exact) > 1
    for numbers in exact:
        place = balls(numbers, 128)
        same = [x for x in found if all(a.overlaps(c) for a, c in zip(x.balls(128), place))]
        assert len(same) == 1
        assert all(c.rel_accuracy_bits() > 100 or abs(c) < 1e-30 for c in same[0].balls(128))


def test_other_numbers():
    """They satisfy the equations, as expressions too; an integer is one."""
    A, b = diag(1, 2, pi), Matrix([sqrt(2), 0, 1])
    for point in SimplePoints(A + nu * eye(3), b, S.One, nu).lists:
        root, *x = point
        for rest in [*((A + root * eye(3)) * Matrix(x) - b), Matrix(x).dot(Matrix(x)) - 1]:
            assert abs(rest.evalf(30)) < 1e-28
        assert (x[1] == 0) == point.is_fraction(2)
        assert abs((pickle.loads(pickle.dumps(x[0])) - x[0]).evalf(30)) < 1e-28


@pytest.mark.parametrize(("A", "b"), [
    (diag(1, 1, 3), [0, 0, 5]), (diag(1, 1, 3), [0, 0, 1]), (diag(1, 2, 3), [0, 0, 1]), (eye(3), [0, 0, 0])])
def test_none_where_they_are_not_simple(A, b):
    """Circles; a point that is met twice."""
    assert SimplePoints(A + nu * eye(3), Matrix(b), S.One, nu).lists == []
