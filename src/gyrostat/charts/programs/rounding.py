"""Bounds how far the floating-point value of a margin is from the exact one, by counting roundings (Higham).

The bound is proved, underflow and overflow included.
"""
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from sympy import Expr

from .straightline import Program

UNIT = 2.0**-53                                        # half the distance from 1 to the next double
SMALLEST = 2.0**-1074
LARGEST = 2.0**1000                                    # above, an overflow on the way is not excluded
# for products of errors and for the rounding of the bound itself
SLACK = 1 + 2.0**-20
Magnitude = Any                                        # a float or an array of them


def error_bound(program: Program, magnitudes: Mapping[Expr, Magnitude], roundings: Mapping[Expr, int],
                computed: Sequence[Magnitude] | None = None) -> Magnitude:
    """Return e such that abs(value in doubles − exact value) < e, if no leaf is larger than its magnitude.

    The value is the last result of the program. Each step is x̂ with abs(x̂ − x) ≤ n u M + A η: u = 2⁻⁵³, η =
    2⁻¹⁰⁷⁴, M the same step with all signs positive, n the number of roundings on the longest way, A what
    underflow adds. A sum of two takes the larger n and one more, a product both and two more (the second for
    the product of the errors); a product may underflow by η, a sum never does. If M may pass 2¹⁰⁰⁰ there is
    no bound, e = ∞.

    Parameters
    ----------
    program : Program
    magnitudes : mapping of leaf to float or array
        at least abs(leaf), in doubles
    roundings : mapping of leaf to int
        how many roundings a leaf has behind it; one that is not among them is exact
    computed : sequence of float or array
        the steps as computed, if they are known: a sum of two exact numbers, and products of such, have a
        small relative error, whatever cancels

    Returns
    -------
    float or array
        broadcast as the magnitudes are

    References
    ----------
    Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. (2002), chapters 2 and 3.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from gyrostat.charts.programs.straightline import program_of
    >>> x, y = gs.symbol("x"), gs.symbol("y")
    >>> program = program_of(x**2 - y, {})
    >>> bool(2.0**-51 < error_bound(program, {x: 1.0, y: 1.0}, {}) < 2.0**-49)
    True
    """
    return error_bounds(program, magnitudes, roundings, computed)[-1]


def error_bounds(program: Program, magnitudes: Mapping[Expr, Magnitude], roundings: Mapping[Expr, int],
                 computed: Sequence[Magnitude] | None = None) -> list[Magnitude]:
    """Return the bounds of all results of a program, as error_bound does for the last."""
    # of each step: M, n, A, and whether it is a leaf, a constant, a sum of exact ones, or a product of such
    known: list[tuple[Magnitude, int, Magnitude, bool]] = []
    fits: Any = True
    with np.errstate(over="ignore", invalid="ignore", under="ignore"):
        for place, step in enumerate(program.steps):
            if step.operation == "leaf":
                assert step.value is not None
                size, count, lost, own = magnitudes[step.value], roundings.get(step.value, 0), 0.0, True
            elif step.operation == "constant":
                size, count = rounded(step.value)
                lost, own = float(count), True         # what rounding adds to a number below 2⁻¹⁰²²
            elif step.operation == "negative":
                size, count, lost, own = known[step.arguments[0]]
            else:
                a, b = step.arguments
                (one, few, tiny, plain), (two, some, small, simple) = known[a], known[b]
                if step.operation == "multiply":
                    size, count, own = one * two, few + some + 2, plain and simple
                    lost = 2 * (tiny * two + small * one + tiny * small * SMALLEST) + 2
                else:
                    size, count, lost = one + two, max(few, some) + 1, tiny + small
                    own = few == some == 0 and all(program.steps[i].operation in ("leaf", "constant")
                                                   for i in (a, b))
            if own and computed is not None:
                size = np.abs(computed[place])
            known.append((size, count, lost, own))
            fits = fits & (size < LARGEST)                 # not where it is NaN
        bounds = (count * UNIT * SLACK * size + (4 * lost + 4) * SMALLEST
                  for size, count, lost, _ in map(known.__getitem__, program.outcomes))
        return [np.where(fits, bound, np.inf) for bound in bounds]


@lru_cache(maxsize=4096)
def rounded(value: Any) -> tuple[float, int]:
    """Return a positive rational constant as a double, and how many roundings that is: 0 or 1."""
    p, q = int(value.p), int(value.q)
    try:
        near = p / q
    except OverflowError:
        return np.inf, 1
    return near, int(near.as_integer_ratio() != (p, q))
