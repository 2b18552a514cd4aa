"""Vectors and forms of exact numbers in balls."""
from collections.abc import Sequence
from typing import Any

from flint import arb
from sympy import Expr, Matrix

from ...algebra.solving.real_fields import balls

BITS = 128                                             # of all balls of wells


def in_balls(numbers: Sequence[Expr]) -> list[arb]:
    """Enclose numbers, without their expressions being written out where that can be avoided."""
    return balls(numbers, BITS)


def rows_in_balls(matrix: Matrix) -> list[list[arb]]:
    """Enclose a matrix of shape (3, 3)."""
    return [in_balls(row) for row in matrix.tolist()]


def dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    """Return a·b, of balls or of power series of balls."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def form(matrix: Sequence[Sequence[Any]], k: Sequence[Any]) -> Any:
    """Return k·Ak."""
    return dot([dot(row, k) for row in matrix], k)
