"""Matrices of exact numbers: rank, kernel and negative squares (index of inertia), each zero proved.

Matrices of rationals are FLINT's, all others SymPy's, with exact signs. Those with one square root are
multiplied and reduced in its field.
"""
from collections.abc import Iterable, Sequence
from functools import reduce
from operator import mul
from typing import TypeAlias

from flint import fmpq_mat
from sympy import QQ, Add, Expr, Matrix, Mul, Pow, Rational, S, preorder_traversal
from sympy.polys.matrices import DomainMatrix

from ..enclosures.rationals import to_flint
from ..rings.matrices import characteristic
from .exact import evaluate, sign_changes, sign_of_constant

Numbers: TypeAlias = fmpq_mat | Matrix


class NotProvedError(ArithmeticError):
    """It is not proved whether an entry is 0."""


def exact(x: Expr) -> Expr:
    """Return a number as a Rational if it is written with rationals alone, and any other one as it is."""
    return evaluate(x, {})


def matrices_of(*several: Sequence[Sequence[Expr]]) -> list[Numbers]:
    """Return matrices by their rows of exact numbers: all of them FLINT's if every entry is rational."""
    if all(isinstance(x, Rational) for rows in several for row in rows for x in row):
        return [fmpq_mat([list(map(to_flint, row)) for row in rows]) for rows in several]
    return [Matrix(rows) for rows in several]


def rank(matrix: Numbers) -> int:
    """Return the rank; raise NotProvedError if a pivot is not proved to be 0 or not to be 0.

    Examples
    --------
    >>> from sympy import sqrt
    >>> rank(Matrix([[sqrt(2), 2], [1, sqrt(2)]]))
    1
    """
    if isinstance(matrix, fmpq_mat):
        return matrix.rank()
    return int(matrix.rank(simplify=exact, iszerofunc=_is_zero))


def kernel(matrix: Numbers) -> Numbers:
    """Return columns that span {x : matrix x = 0}; NotProvedError is raised as for the rank.

    Examples
    --------
    >>> kernel(fmpq_mat([[1, 2, 0], [2, 4, 3]]))
    [-2]
    [ 1]
    [ 0]
    """
    if not isinstance(matrix, fmpq_mat):
        if (field := _in_field(matrix)) is not None:
            return field[0].nullspace().to_Matrix().T
        found = matrix.nullspace(simplify=exact, iszerofunc=_is_zero)
        return Matrix.hstack(Matrix(matrix.cols, 0, []), *found).applyfunc(exact)
    reduced, size = matrix.rref()
    pivots = [next(j for j in range(matrix.ncols()) if reduced[i, j]) for i in range(size)]
    free = [j for j in range(matrix.ncols()) if j not in pivots]
    columns = fmpq_mat(matrix.ncols(), len(free))
    for n, j in enumerate(free):
        columns[j, n] = 1
        for i, pivot in enumerate(pivots):
            columns[pivot, n] = -reduced[i, j]
    return columns


def product(*factors: Numbers) -> Numbers:
    """Return the product of matrices, all of them FLINT's or all SymPy's."""
    if not isinstance(factors[0], fmpq_mat) and (field := _in_field(*factors)) is not None:
        return reduce(mul, field).to_Matrix()
    found = reduce(mul, factors)
    return found if isinstance(found, fmpq_mat) else found.applyfunc(exact)


def _in_field(*matrices: Matrix) -> list[DomainMatrix] | None:
    """Return matrices over the field of the one square root in them; None if more than that is in them."""
    roots = square_roots(x for m in matrices for x in m)
    if roots is None or len(roots) != 1:
        return None
    field = QQ.algebraic_field(*roots)
    return [DomainMatrix.from_Matrix(m, extension=True).convert_to(field) for m in matrices]


def stacked(blocks: Sequence[Numbers]) -> Numbers:
    """Return the matrix with the rows of all blocks."""
    if isinstance(blocks[0], fmpq_mat):
        return fmpq_mat([row for block in blocks for row in block.tolist()])
    return Matrix.vstack(*blocks)


def form_on(form: Numbers, columns: Numbers) -> Numbers:
    """Return the matrix of a bilinear form on the span of some columns."""
    return product(columns.transpose(), form, columns)


def negative_squares(form: Numbers) -> int:
    """Return the number of negative squares of a symmetric matrix.

    It is the number of changes of sign in det(λ + A): Descartes' rule is exact, since all roots are real.

    Examples
    --------
    >>> negative_squares(Matrix([[0, 1], [1, 0]]))
    1
    """
    if isinstance(form, fmpq_mat):
        return sign_changes((c > 0) - (c < 0) for c in reversed((-form).charpoly().coeffs()))
    return sign_changes(map(_sign, characteristic(form.tolist()))) if form.rows else 0


def square_roots(numbers: Iterable[Expr]) -> set[Expr] | None:
    """Return the square roots of rationals that numbers are written with; None if more is in them.

    Examples
    --------
    >>> from sympy import S, pi, sqrt
    >>> square_roots([1 + sqrt(2) / 3, S(5)]), square_roots([pi])
    ({sqrt(2)}, None)
    """
    parts = {part for x in numbers for part in preorder_traversal(x)}
    roots = {part for part in parts if isinstance(part, Pow) and not part.exp.is_Integer}
    if (not all(isinstance(part, Add | Mul | Pow | Rational) for part in parts)
            or not all(root.exp == S.Half and root.base.is_Rational for root in roots)):
        return None
    return roots


def _is_zero(x: Expr) -> bool:
    return _sign(x) == 0


def _sign(x: Expr) -> int:
    sign = None if x.free_symbols else sign_of_constant(exact(x))
    if sign is None:
        raise NotProvedError(f"whether {x} is 0 is not proved")
    return sign
