"""Finds where permanent rotations of a free gyrostat meet, in a plane of two components of its rotor."""
from itertools import pairwise

import numpy as np
from sympy import Expr

from ...algebra.enclosures.floats import Array
from ...algebra.reals.exact import evaluate, proved_sign
from ...algebra.solving.roots import in_order, real_roots
from ...mechanics.scenes.body import Gyrostat
from ..finders.free import NU

HALVINGS = 36                                              # to find the least value between two poles


def fold_squares(body: Gyrostat, radius: Expr, held: int) -> tuple[Expr, Expr]:
    """Return the squares of the two free components of the rotor at a fold with ν.

    Both are linear in Σ M² = abs(M)² and Σ I M²/(1 − ν I) = 0.
    """
    i, j = (n for n in range(3) if n != held)
    turned = [1 - NU * moment for moment in body.moments]
    slopes = [moment / u for moment, u in zip(body.moments, turned)]
    fixed = (body.gyrostatic_momentum[held] / turned[held]) ** 2
    rest, tilt = radius**2 - fixed, -slopes[held] * fixed
    first = (tilt - slopes[j] * rest) / (slopes[i] - slopes[j])
    return first * turned[i] ** 2, (rest - first) * turned[j] ** 2


def fold_intervals(body: Gyrostat, radius: Expr, held: int) -> list[tuple[Expr, Expr]]:
    """Return the intervals of ν, with exact ends, on which there is a fold."""
    squares = fold_squares(body, radius, held)
    ends = {root for square in squares for root in real_roots(square, NU) or ()}
    ends |= {1 / moment for moment in body.moments}
    order, found = in_order(list(ends)), []
    for a, b in pairwise(order):
        middle = (a + b) / 2
        if all(proved_sign(evaluate(square, {NU: middle})) == 1 for square in squares):
            found.append((a, b))
    return found


def numbers_of_rotations_over(moments: Array, rotor: list[Array], radius: float) -> Array:
    """Return how many rotations there are, in doubles, if no component of the rotor is 0.

    Σ l²/(1 − ν I)² is convex between two poles and monotone outside: there are 2 rotations, and 2 more for
    either gap in which the sum falls below abs(M)².
    """
    poles, count = np.sort(1 / moments), 2
    for low, high in pairwise(poles):
        a, b = (np.full(np.broadcast(*rotor).shape, end) for end in (low, high))
        for _ in range(HALVINGS):
            nu = (a + b) / 2
            rising = sum(i * l**2 / (1 - nu * i) ** 3 for i, l in zip(moments, rotor)) > 0
            a, b = np.where(rising, a, nu), np.where(rising, nu, b)
        least = sum((l / (1 - (a + b) / 2 * i)) ** 2 for i, l in zip(moments, rotor))
        count = count + 2 * (least < radius**2)
    return np.asarray(count)
