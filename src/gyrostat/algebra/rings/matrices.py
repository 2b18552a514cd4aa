"""Linear algebra over polynomial rings without fractions: determinants, Faddeev-LeVerrier, kernels."""
import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from flint import fmpq, fmpq_mpoly
from sympy import Add, Expr, ImmutableMatrix, S

from .polynomials import Ring, Row, cancel, lcm

Key = Callable[[int, fmpq_mpoly], Any]


def immutable(rows: Sequence[Sequence[Expr]], columns: int) -> ImmutableMatrix:
    """Return a matrix of expressions, which ImmutableMatrix(rows) would make expressions once more."""
    return ImmutableMatrix(len(rows), columns, [entry for row in rows for entry in row], copy=False)


def diagonal(entries: Sequence[Expr]) -> ImmutableMatrix:
    """Return the diagonal matrix with these entries."""
    return immutable([[x if i == j else S.Zero for j in range(len(entries))] for i, x in enumerate(entries)],
                     len(entries))


def leading_minors(matrix: ImmutableMatrix) -> tuple[Expr, ...]:
    """Return the leading principal minors of a symmetric matrix, all positive if and only if it is."""
    return tuple(matrix[:n, :n].det(method="berkowitz") for n in range(1, matrix.rows + 1))


def applied(rows: Iterable[Sequence[Expr]], vector: Sequence[Expr]) -> list[Expr]:
    """Return a matrix of expressions times a vector, most entries of which may be 0."""
    return [Add(*(a * b for a, b in zip(row, vector) if a and b)) for row in rows]


def multiply(ring: Ring, a: Sequence[Row], b: Sequence[Row]) -> list[Row]:
    """Return the product of two matrices of polynomials, reduced."""
    columns = list(zip(*b))
    return [[ring.reduce(sum((x * y for x, y in zip(row, column) if x and y), ring.zero))
             for column in columns] for row in a]


def determinant(ring: Ring, matrix: Sequence[Row]) -> fmpq_mpoly:
    """Return the determinant by expansion along the first row.

    It needs no division, so that the relations of the ring do no harm.
    """
    if not matrix:
        return ring.one
    total = ring.zero
    for column, entry in enumerate(matrix[0]):
        if entry:
            minor = [row[:column] + row[column + 1:] for row in matrix[1:]]
            total += (-1) ** column * entry * determinant(ring, minor)
    return ring.reduce(total)


def characteristic_coefficients(ring: Ring, matrix: Sequence[Row]) -> list[fmpq_mpoly]:
    """Return c1, …, cn of det(λ − A) = λⁿ + c1 λⁿ⁻¹ + … + cn (Faddeev, LeVerrier)."""
    size = len(matrix)
    coefficients, power = [], [[ring.one if i == j else ring.zero for j in range(size)] for i in range(size)]
    for n in range(1, size + 1):
        power = multiply(ring, matrix, power)
        c = sum((power[i][i] for i in range(size)), ring.zero) / -n
        coefficients.append(c)
        for i in range(size):
            power[i][i] += c
    return coefficients


def characteristic(form: Sequence[Sequence[Expr]]) -> tuple[Expr, ...]:
    """Return e1, …, en of det(λ + A) = λⁿ + e1 λⁿ⁻¹ + … + en, as expressions."""
    ring = Ring([entry for row in form for entry in row])
    rows, bottom = ring.matrix(form)
    return tuple(ring.quotient((-1) ** n * c, bottom**n)
                 for n, c in enumerate(characteristic_coefficients(ring, rows), 1))


def row_reduce(ring: Ring, rows: Sequence[Row], key: Key, columns: int) -> list[tuple[int, Row]]:
    """Eliminate by Gauss and Jordan without fractions, and return (pivot column, row) pairs.

    In each row the other pivot columns are 0. The next pivot is the entry with the least key(column, entry);
    only the first columns can hold one.
    """
    left = [row for row in rows if any(row)]
    done: list[tuple[int, Row]] = []
    while left:
        choices = [(key(j, row[j]), i, j) for i, row in enumerate(left) for j in range(columns) if row[j]]
        if not choices:
            break
        _, i, j = min(choices)
        pivot = left.pop(i)
        left = [cleared for row in left if any(cleared := _clear(ring, row, pivot, j))]
        done = [(column, _clear(ring, row, pivot, j)) for column, row in done] + [(j, pivot)]
    return done


def _clear(ring: Ring, row: Row, pivot: Row, column: int) -> Row:
    if not row[column]:
        return row
    own, other = cancel(pivot[column], row[column])
    cleared = [ring.reduce(own * x - other * y) for x, y in zip(row, pivot)]
    return primitive(ring, cleared)


def primitive(ring: Ring, row: Row) -> Row:
    """Return the row divided by the greatest common divisor of its entries."""
    common, numbers = ring.zero, [c for entry in row for c in entry.coeffs()]
    for entry in filter(None, row):
        common = common.gcd(entry) if common else entry
    if not common:
        return row
    scale = fmpq(math.lcm(*(int(c.q) for c in numbers)), math.gcd(*(int(c.p) for c in numbers)))
    return [entry * scale if common.is_constant() else (entry / common) for entry in row]


def null_space(ring: Ring, rows: Sequence[Row], key: Key, size: int) -> list[tuple[int, Row]]:
    """Return a polynomial basis of {v : rows·v = 0}, as (free column, vector) pairs.

    Each vector is 0 in the free columns of the others.
    """
    reduced = row_reduce(ring, rows, key, size)
    basis = []
    for free in sorted(set(range(size)) - {column for column, _ in reduced}):
        scale = ring.one
        for column, row in reduced:
            scale = lcm(scale, cancel(row[free], row[column])[1]) if row[free] else scale
        vector = [ring.zero] * size
        vector[free] = scale
        for column, row in reduced:
            vector[column] = ring.reduce(-row[free] * scale / row[column]) if row[free] else ring.zero
        basis.append((free, primitive(ring, vector)))
    return basis


def cross(a: Sequence[Any], b: Sequence[Any]) -> tuple[Any, Any, Any]:
    """Return the cross product a × b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def adjugate(rows: Sequence[Sequence[Any]]) -> list[tuple[Any, Any, Any]]:
    """Return the adjugate of a symmetric matrix of three rows: the cross products of its rows."""
    return [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])]


def solved(rows: Sequence[Sequence[Expr]], vector: Sequence[Expr]) -> list[Expr]:
    """Return A⁻¹v in lowest terms, for a symmetric matrix A of three rows."""
    ring = Ring([*(entry for row in rows for entry in row), *vector])
    (form, below), ((values,), bottom) = ring.matrix(rows), ring.matrix([vector])
    across = adjugate(form)
    whole = sum((x * y for x, y in zip(form[0], across[0])), ring.zero) * bottom
    return [ring.quotient(sum((x * v for x, v in zip(row, values)), ring.zero) * below, whole)
            for row in across]


def blocks(rows: Sequence[Sequence[Any]]) -> list[list[int]]:
    """Return the indices of a symmetric matrix in blocks: those together that entries connect."""
    blocks: list[list[int]] = []
    for i, row in enumerate(rows):
        joined = [block for block in blocks if any(row[j] for j in block)]
        blocks = [block for block in blocks if block not in joined]
        blocks.append(sorted([i, *(j for block in joined for j in block)]))
    return sorted(blocks)
