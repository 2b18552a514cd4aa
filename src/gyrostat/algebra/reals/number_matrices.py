"""Rank, kernel and negative squares of matrices of exact numbers, each zero proved."""
from flint import fmpq_mat
from sympy import Expr, Matrix, Rational

from ..enclosures.rationals import to_flint
from ..rings.matrices import characteristic
from .exact import evaluate, sign_changes, sign_of_constant


class NotProvedError(ArithmeticError):
    """Whether an entry is 0 is not proved."""


def exact(x: Expr) -> Expr:
    """The number in its shortest form."""
    return evaluate(x, {})


def rank(matrix: Matrix) -> int:
    """The rank; NotProvedError if a pivot is not proved to be 0 or not.

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
    """Columns that span {x : matrix x = 0}; NotProvedError as for the rank."""
    found = matrix.nullspace(simplify=exact, iszerofunc=_is_zero)
    return Matrix.hstack(Matrix(matrix.cols, 0, []), *found).applyfunc(exact)


def form_on(form: Matrix, columns: Matrix) -> Matrix:
    """The bilinear form on the span of some columns."""
    return (columns.T * form * columns).applyfunc(exact)


def negative_squares(form: Matrix) -> int:
    """How many a symmetric matrix has.

    The changes of sign in its characteristic polynomial: Descartes' rule is exact where all roots are real.

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
