"""Rank, kernel and negative squares of FLINT's matrices against SymPy's, with entries of both kinds."""
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Matrix, Rational, radsimp, sqrt

from gyrostat.algebra.reals.number_matrices import (
    NotProvedError,
    form_on,
    kernel,
    matrices_of,
    negative_squares,
    product,
    rank,
    stacked,
)
from gyrostat.notation import symbol

FEW = st.sampled_from([Rational(0), Rational(1), Rational(-2, 3), Rational(5, 7)])


def rows(height, width):
    return st.lists(st.lists(FEW, min_size=width, max_size=width), min_size=height, max_size=height)


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(above=rows(2, 4), below=rows(3, 4))
def test_the_kernel_of_rationals(above, below):
    """Rank and kernel are those that SymPy finds, for matrices that are often singular."""
    whole = stacked(matrices_of(above, below))
    expected = Matrix(above + below)
    assert rank(whole) == expected.rank()
    columns = kernel(whole)
    assert len(columns.tolist()[0]) == 4 - expected.rank() == rank(columns)
    assert not any(x for row in product(whole, columns).tolist() for x in row)


@settings(max_examples=60, deadline=None)
@given(half=rows(3, 3), columns=rows(3, 2))
def test_negative_squares_of_rationals(half, columns):
    """FLINT and SymPy count as many, of the whole form and on a subspace."""
    symmetric = [[half[i][j] + half[j][i] for j in range(3)] for i in range(3)]
    form, some = matrices_of(symmetric, columns)
    assert negative_squares(form) == negative_squares(Matrix(symmetric))
    restricted = Matrix(columns).T * Matrix(symmetric) * Matrix(columns)
    assert negative_squares(form_on(form, some)) == negative_squares(restricted)


def test_roots_among_the_entries():
    """One root makes all of them SymPy's; the form x² + 2√2 x y + y² has one negative square."""
    one = Rational(1)
    form, rational = matrices_of([[one, sqrt(2)], [sqrt(2), one]], [[one], [one]])
    assert negative_squares(form) == 1
    assert form_on(form, rational)[0, 0] == 2 + 2 * sqrt(2)


def test_an_unknown_entry():
    """Nothing is said of the rank of a matrix with a name in it."""
    with pytest.raises(NotProvedError, match="a is 0 is not proved"):
        rank(Matrix([[symbol("a")]]))


@pytest.mark.slow
def test_kernel_and_product_in_the_field_of_one_square_root():
    """A matrix of known rank, by factors with entries a + b √D; what SymPy expands is the same."""
    rng = Random(3)

    def some(height, width):
        return Matrix(height, width, lambda *_: Rational(rng.randint(-5, 5), rng.randint(1, 4))
                      + sqrt(21) * Rational(rng.randint(-3, 3), 2) / (1 + sqrt(21)))

    for left in range(1, 4):
        one, other = some(5, left), some(left, 4)
        whole = product(one, other)
        assert (whole - one * other).applyfunc(lambda x: radsimp(x.expand())) == 0 * whole
        columns = kernel(whole)
        assert columns.shape == (4, 4 - left)
        assert columns.applyfunc(lambda x: x.evalf(30)).rank() == 4 - left
        assert product(whole, columns) == Matrix.zeros(5, 4 - left)
