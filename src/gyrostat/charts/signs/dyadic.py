"""Proves signs of polynomials at many doubles at once: a double is a whole number times a power of 2.

Whole numbers are taken modulo 2⁶⁴ first, then in any length.
"""
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import Expr, Rational

from ...algebra.enclosures.floats import Array
from ..programs.straightline import Program

WORD = 64                                              # bits of a machine number
NOTHING = 2**20                                        # the power of 0, beyond all others
LONGEST = 4096                                         # the most bits of whole numbers of any length
TOGETHER = 1024                                        # the points for which those are kept in memory


@dataclass(frozen=True, eq=False)
class Dyadics:
    """Numbers whole · 2^power in arrays, the whole ones modulo 2⁶⁴, or Python's, of any length.

    Sums and products are taken without rounding.
    """

    whole: Array
    power: Array

    def __add__(self, other: "Dyadics") -> "Dyadics":
        power = np.minimum(self.power, other.power)
        return Dyadics(self._shifted(power) + other._shifted(power), power)

    def __neg__(self) -> "Dyadics":
        return Dyadics(-self.whole, self.power)

    def __sub__(self, other: "Dyadics") -> "Dyadics":
        power = np.minimum(self.power, other.power)
        return Dyadics(self._shifted(power) - other._shifted(power), power)

    def __mul__(self, other: "Dyadics") -> "Dyadics":
        return Dyadics(self.whole * other.whole, self.power + other.power)

    def _shifted(self, power: Array) -> Array:
        """Return the whole numbers of a lower power."""
        return self.whole << (self.power - power).astype(self.whole.dtype)


def dyadic_signs(program: Program, leaves: Mapping[Expr, Array], most: Array) -> tuple[Array, Array]:
    """Return the signs of a polynomial with whole coefficients at doubles in a row, and where they are found.

    They are taken modulo 2⁶⁴ first: the residue of a whole number is the number itself, if the number is
    known to be small enough, whatever was lost on the way to it. Then they are taken in numbers of any
    length, if those are not too long.

    Parameters
    ----------
    program : Program
        with leaves that are symbols
    leaves : mapping of leaf to array
        finite doubles
    most : array, shape (points,)
        at least abs(value), in doubles

    Returns
    -------
    signs, found : arrays of int8 and bool, shape (points,)

    Examples
    --------
    >>> import gyrostat as gs
    >>> from gyrostat.charts.programs.straightline import program_of
    >>> x, y = gs.symbol("x"), gs.symbol("y")
    >>> x_of, most = np.array([3.0, 2.0**-40 + 1]), np.array([1e-15, 1e-15])
    >>> dyadic_signs(program_of(x**2 - y, {}), {x: x_of, y: x_of**2}, most)[0]
    array([0, 1], dtype=int8)
    """
    exact = {leaf: dyadics(x) for leaf, x in leaves.items()}
    last = _run(program, exact, np.uint64)
    signs = np.broadcast_to(np.sign(last.whole.view(np.int64)), most.shape).astype(np.int8)
    # a whole number below 2⁶² is its residue, read as a signed word
    with np.errstate(over="ignore"):
        found, short = (most < np.ldexp(1.0, last.power + bits) for bits in (WORD - 2, LONGEST))
    left = np.flatnonzero(short & ~found)
    for start in range(0, len(left), TOGETHER):
        here = left[start:start + TOGETHER]
        whole = _run(program, {leaf: Dyadics(*(a[here] if len(a) > 1 else a for a in (x.whole, x.power)))
                               for leaf, x in exact.items()}, object).whole
        signs[here], found[here] = (whole > 0).astype(np.int8) - (whole < 0), True
    return signs, found


def dyadics(x: Array) -> Dyadics:
    """Return the whole numbers and powers of finite doubles, the whole ones odd."""
    fraction, power = np.frexp(x)
    whole = np.ldexp(fraction, 53).astype(np.int64)
    zeros = np.maximum(np.frexp((whole & -whole).astype(np.float64))[1] - 1, 0)
    return Dyadics(whole >> zeros, np.where(whole == 0, NOTHING, power.astype(np.int64) + zeros - 53))


def _run(program: Program, leaves: Mapping[Expr, Dyadics], kind: Any) -> Dyadics:
    """Run the program modulo 2⁶⁴ with NumPy's uint64, or in Python's numbers with objects."""
    def constant(value: Rational) -> Dyadics:
        zeros = max((int(value) & -int(value)).bit_length() - 1, 0)
        odd = int(value) >> zeros
        return Dyadics(np.array([odd if kind is object else odd % 2**WORD], dtype=kind), np.array([zeros]))

    read = {leaf: Dyadics(x.whole.astype(kind), x.power) for leaf, x in leaves.items()}
    return program.run(read.__getitem__, constant)[-1]
