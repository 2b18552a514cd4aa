"""Points of a sphere that a symmetric pencil takes to a vector: counted and checked by hand."""
import random

import numpy as np
import pytest
from sympy import Matrix, Rational, S, Symbol, diag, eye, sqrt

from gyrostat.algebra.enclosures.balls import ball
from gyrostat.algebra.pencils.exact_points import points_on_sphere
from gyrostat.algebra.solving.real_fields import FieldNumbers, balls

NU = Symbol("nu")


def floats(found):
    """ν and x of each, sorted."""
    rows = sorted([float(x.mid()) for x in balls(numbers, 128)] for numbers, _ in found)
    return np.array(rows).reshape(-1, 4)


def drawn(seed):
    """A symmetric matrix and a vector, whole numbers, for which Lagrange's multipliers are found by NumPy."""
    rng = random.Random(seed)
    half = [[rng.randint(-4, 4) for _ in range(3)] for _ in range(3)]
    b = Matrix([rng.randint(-9, 9) or 1 for _ in range(3)])
    return Matrix(3, 3, lambda i, j: half[i][j] + half[j][i]), b


@pytest.mark.parametrize("seed", range(6))
def test_all_multipliers_are_found_at_rational_numbers(seed):
    """ν is an eigenvalue of the quadratic pencil (A + ν)² − b bᵀ, linearised: NumPy's real ones."""
    A, b = drawn(seed)
    found = list(points_on_sphere(A + NU * eye(3), b, S.One, NU))
    a, v = np.array(A.tolist(), float), np.array(b.tolist(), float)
    whole = np.block([[-a, np.eye(3)], [v @ v.T, -a]])     # y = (A + ν) z, (A + ν) y = b bᵀ z
    wanted = np.linalg.eigvals(whole)
    wanted = np.sort(wanted[np.abs(wanted.imag) < 1e-9].real)
    numbers = floats(found)
    # NumPy's eigenvalues of a matrix that is not symmetric, then rounding of floats
    np.testing.assert_allclose(numbers[:, 0], wanted, atol=1e-7)
    for nu, *x in numbers:
        np.testing.assert_allclose((a + nu * np.eye(3)) @ x, v.ravel(), atol=1e-10)
        assert abs(np.dot(x, x) - 1) < 1e-12
    first = next(numbers for numbers, _ in found if isinstance(numbers, FieldNumbers))
    assert all(ball(x, 256).overlaps(enclosed) for x, enclosed in zip(first, first.balls(192)))


@pytest.mark.parametrize("moments, vector", [
    ((1, 2, 4), (0, 0, 1)), ((1, 1, 3), (0, 0, 1)), ((2, 2, 2), (0, 0, 0)), ((1, 2, 4), (0, 3, 1)),
    ((1, 2, 2), (2, 1, 0)), ((1, 2, 4), (0, 1, 1))])
def test_the_same_in_a_field_of_algebraic_numbers(moments, vector):
    """√2 times the pencil and the vector: the same x, among them those along the kernel, and its axes."""
    pencil, b = diag(*moments) + NU * eye(3), Matrix(vector)
    plain, scaled = (list(points_on_sphere(s * pencil, s * b, S.One, NU)) for s in (S.One, sqrt(2)))
    assert len(plain) == len(scaled)
    np.testing.assert_allclose(floats(plain), floats(scaled), atol=1e-12)     # rounding of floats
    assert [axis is None for _, axis in plain] == [axis is None for _, axis in scaled]


def test_along_the_kernel():
    """diag(1, 2, 4) + ν and b = (0, 0, 1): at ν = −1 and −2 there are x with any part along axis 1, or 2."""
    pencil = diag(1, 2, 4) + NU * eye(3)
    found = {tuple(numbers) for numbers, _ in points_on_sphere(pencil, Matrix([0, 0, 1]), S.One, NU)}
    third, half = Rational(1, 3), Rational(1, 2)
    assert found == {(-5, 0, 0, -1), (-3, 0, 0, 1), *((-1, s * sqrt(8) / 3, 0, third) for s in (1, -1)),
                     *((-2, 0, s * sqrt(3) / 2, half) for s in (1, -1))}
