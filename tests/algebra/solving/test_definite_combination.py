"""Definite combinations of symmetric matrices."""
import random

import pytest
from sympy import ImmutableMatrix, Matrix, Rational, diag, exp, eye, sqrt

from gyrostat.algebra.solving.definite_combination import definite, definite_combination


def symmetric(draw, n):
    rows = [[Rational(draw.randint(-9, 9), draw.randint(1, 4)) for _ in range(n)] for _ in range(n)]
    return ImmutableMatrix(n, n, lambda i, j: rows[min(i, j)][max(i, j)])


def combined(form, others, found):
    return Matrix(sum((a * other for a, other in zip(found, others)), form))


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("count", [1, 2, 3])
def test_one_that_exists_is_found(seed, count):
    """P − Σ a B, P definite: some combination is definite, and that which is found is."""
    draw = random.Random(seed)
    others = [symmetric(draw, 4) for _ in range(count)]
    root = symmetric(draw, 4)
    rest = combined(Matrix.zeros(4), others, [Rational(draw.randint(-5, 5), 3) for _ in others])
    form = ImmutableMatrix((-1) ** seed * (root * root.T + eye(4)) - rest)
    found = definite_combination(form, others)
    assert found and all(isinstance(a, Rational) for a in found)
    whole = combined(form, others, found)
    assert whole.is_positive_definite or (-whole).is_positive_definite


def test_none_where_a_vector_is_null():
    """All forms vanish at one vector, or they are of two blocks of opposite sign."""
    draw = random.Random(1)
    forms = [Matrix(symmetric(draw, 3)) for _ in range(3)]
    for form in forms:
        form[0, 0] = 0
    assert definite_combination(ImmutableMatrix(forms[0]), [ImmutableMatrix(forms[1])]) is None
    assert definite_combination(forms[0].as_immutable(), [form.as_immutable() for form in forms[1:]]) is None
    assert definite_combination(diag(1, -1), [diag(-1, 1)]) is None
    assert definite(diag(0, 1)) == 0 and definite(-eye(3)) == -1


def test_numbers_that_are_not_rational():
    """Algebraic numbers by their norm, transcendental ones by search and proof."""
    for number in (sqrt(2), exp(1)):
        form = ImmutableMatrix(diag(1, -number, 2, -1))
        (a,) = definite_combination(form, [ImmutableMatrix(diag(0, 1, 0, 1))])
        assert a.is_Rational and a > number
