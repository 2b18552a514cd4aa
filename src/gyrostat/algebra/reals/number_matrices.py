"""Rank, kernel and negative squares (index of inertia) of matrices of exact numbers, each zero proved."""
from flint import fmpq_mat
from sympy import Expr, Matrix, Rational

from ..enclosures.rationals import to_flint
from ..rings.matrices import characteristic
from .exact import evaluate, sign_changes, sign_of_constant


class NotProvedError(ArithmeticError):
    """It is not proved whether an entry is 0."""


def exact(x: Expr) -> Expr:
    """Return a number as a Rational if it is written with rationals alone, and any other one as it is."""
    return evaluate(x, {})


def rank(matrix: Matrix) -> int:
    """Return the rank; raise NotProvedError if a pivot is not proved to be 0 or not to be 0.

    Examples
    --------
    >>> from sympy import sqrt
    >>> rank(Matrix([[sqrt(2), 2], [1, sqrt(2)]]))
    1
    """
    if all(isinstance(x, Rational) for x in matrix):
        return fmpq_mat(matrix.rows, matrix.cols, list(map(to_flint, matrix))).rank()
    return int(matrix.rank(simplify=exact, iszerofunc=_is_zero))


def kernel(matrix: Matrix) -> Matrix:
    """Return columns that span {x : matrix x = 0}; NotProvedError is raised as for the rank."""
    found = matrix.nullspace(simplify=exact, iszerofunc=_is_zero)
    return Matrix.hstack(Matrix(matrix.cols, 0, []), *found).applyfunc(exact)


def form_on(form: Matrix, columns: Matrix) -> Matrix:
    """Return the matrix of a bilinear form on the span of some columns."""
    return (columns.T * form * columns).applyfunc(exact)


def negative_squares(form: Matrix) -> int:
    """Return the number of negative squares of a symmetric matrix.

    It is the number of changes of sign in det(λ + A): Descartes' rule is exact, since all roots are real.

    Examples
    --------
    >>> negative_squares(Matrix([[0, 1], [1, 0]]))
    1
    """
    return sign_changes(map(_sign, characteristic(form.tolist()))) if form.rows else 0


def _is_zero(x: Expr) -> bool:
    return _sign(x) == 0


def _sign(x: Expr) -> int:
    sign = None if x.free_symbols else sign_of_constant(exact(x))
    if sign is None:
        raise NotProvedError(f"whether {x} is 0 is not proved")
    return sign
