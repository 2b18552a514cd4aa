"""Reads moments of inertia, tensors and momenta: three entries or nine, exact, in one spelling."""
from collections.abc import Sequence
from typing import Any

from sympy import Expr, ImmutableMatrix

from ...errors import ArgumentError, BodyError, article, brief
from ..reals.exact import is_identically_zero, sign_of_constant
from .numbers import exact_expression, shown
from .tensors import rows_of


def as_first_written(values: Sequence[Expr]) -> tuple[Expr, ...]:
    """Return constants that are equal in one spelling, so that a body of revolution is recognised."""
    known: list[Expr] = []
    for value in values:
        same = (x for x in known if not (apart := x - value).free_symbols and sign_of_constant(apart) == 0)
        known.append(next(same, value))
    return tuple(known)


def tensor_of(entries: Sequence[Expr]) -> ImmutableMatrix:
    """Return a symmetric tensor from nine exact entries, row by row.

    Raises
    ------
    BodyError
        it is not symmetric
    """
    tensor = ImmutableMatrix(3, 3, list(entries))
    for i, j in ((0, 1), (0, 2), (1, 2)):
        apart = tensor[i, j] - tensor[j, i]
        if is_identically_zero(apart) is not True:
            raise BodyError(f"inertia is a matrix with the entries {shown(tensor[i, j])} and "
                            f"{shown(tensor[j, i])} in the places {i + 1}{j + 1} and {j + 1}{i + 1}: an "
                            "inertia tensor is symmetric; give the products of inertia twice, with one sign")
    return ImmutableMatrix(3, 3, lambda i, j: tensor[min(i, j), max(i, j)])


def entries_of(given: Any, field: str) -> tuple[Any, ...]:
    """Return three entries of a sequence, an array or a diagonal matrix, or all nine of another matrix."""
    given = rows_of(given) if isinstance(given, str) else given
    if hasattr(given, "__len__") and len(given) > 9:
        raise BodyError(f"{field} has {len(given)} entries: give three, one for each principal axis")
    rows = given.tolist() if hasattr(given, "tolist") else given
    if isinstance(rows, bytes) or not isinstance(rows, Sequence):
        raise ArgumentError(f"{field} = {brief(given)} is {article(type(given))}, not a sequence: give "
                            "three numbers, "
                            f"{field}=({'2, 2, 1' if field == 'inertia' else '0, 0, 1'})")
    entries = tuple(rows)
    if len(entries) == 3 and all(isinstance(row, Sequence) and not isinstance(row, str) and len(row) == 3
                                 for row in entries):
        if field != "inertia":
            raise BodyError(f"{field} is a matrix: give three numbers, one for each axis")
        if any(exact_expression(row[j], field) != 0 for i, row in enumerate(entries)
               for j in range(3) if i != j):
            return tuple(x for row in entries for x in row)
        entries = tuple(row[i] for i, row in enumerate(entries))
    # a matrix of one row, or of one column
    if len(entries) == 1 and isinstance(entries[0], Sequence) and not isinstance(entries[0], str):
        entries = tuple(entries[0])
    if hasattr(given, "tolist") and all(isinstance(row, Sequence) and len(row) == 1 for row in entries):
        entries = tuple(row[0] for row in entries)
    if len(entries) != 3:
        raise BodyError(f"{field} = {brief(given)} is not three numbers: give one for each principal axis")
    return entries
