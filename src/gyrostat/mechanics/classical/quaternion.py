"""The quaternion of a rotation, by the products of its entries."""
from collections.abc import Sequence
from typing import Any


def quaternion_products(turn: Sequence[Sequence[Any]]) -> list[list[Any]]:
    """Return the matrix 4 q qᵀ of a rotation, q = w + x i + y j + z k with x_space = q x_body q*.

    Each row is a multiple of q; the row with the largest entry on the diagonal gives it without cancellation.

    Parameters
    ----------
    turn : rows, shape (3, 3)
        numbers, balls or arrays

    Returns
    -------
    list, shape (4, 4)

    References
    ----------
    Shepperd, Journal of Guidance and Control 1 (1978) 223-224.

    Examples
    --------
    >>> quaternion_products([[0, -1, 0], [1, 0, 0], [0, 0, 1]])[0]
    [2, 0, 0, 2]
    """
    (a, b, c), (d, e, f), (g, h, i) = turn
    return [[1 + a + e + i, h - f, c - g, d - b], [h - f, 1 + a - e - i, b + d, c + g],
            [c - g, b + d, 1 - a + e - i, f + h], [d - b, c + g, f + h, 1 - a - e + i]]
