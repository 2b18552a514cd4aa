"""Reads what is given for a name: floats, and exact numbers if a float is only near."""
from decimal import Decimal
from fractions import Fraction
from math import isfinite
from typing import Any

import numpy as np
from sympy import Expr, Rational

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.rationals import to_sympy
from ...algebra.reals.exact import LIMIT
from ...algebra.text.numbers import exact_number
from ...arguments import MOST
from ...errors import ValuesError


def read_entry(name: str, value: Any, kind: Any, finite: bool) -> tuple[Array, Array | None]:
    """Return floats, and the exact numbers if some float is not one; else None."""
    if isinstance(value, str | Decimal | Fraction | Expr) or (
            isinstance(value, int) and not isinstance(value, bool)):
        value = np.array(exact_number(value, name), dtype=object)
    if isinstance(value, range) and len(value) > MOST:
        raise ValuesError(f"{name} has {len(value)} values: give at most {MOST}, or an array of NumPy")
    try:
        array = np.asarray(value)
    except MemoryError:
        raise ValuesError(f"{name} has more values than there is memory for: give fewer") from None
    except ValueError:
        raise ValuesError(f"{name} is a sequence of sequences that differ in length: give rows of one "
                          "length") from None
    if array.dtype.kind in "iu":
        long = array.size and max(abs(int(array.min())), abs(int(array.max()))) > 2**53
        array = array.astype(object if long else kind)
    if array.dtype.kind == "f" and array.dtype.itemsize <= 8:
        if finite and not all_finite(array):
            where = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
            raise ValuesError(f"{name}{list(where) if where else ''} = {array[where]} is not a finite "
                              "number: remove it")
        return array.astype(kind, copy=False), None
    if array.dtype.kind != "O":
        raise ValuesError(f"{name} is an array of {array.dtype}, not of real numbers: give floats of at "
                          "most 64 bits, integers, or exact numbers such as Fraction")
    numbers = np.empty(array.shape, dtype=object)
    for where in np.ndindex(array.shape):
        if finite or not isinstance(x := array[where], float) or isfinite(x):
            numbers[where] = exact_number(array[where], f"{name}{list(where) if where else ''}")
        else:
            numbers[where] = float("nan")              # the only floats among the exact numbers
    floats = np.array([_near(x) for x in numbers.flat], dtype=float).reshape(array.shape)
    if all(to_sympy(x) == n if np.isfinite(x) else False
           for x, n in zip(floats.ravel().tolist(), numbers.flat)):
        return floats.astype(kind), None
    return floats.astype(kind), numbers


def all_finite(array: Array) -> bool:
    """Tell whether an array of floats has no NaN and no infinity, without making another array."""
    if array.size <= 1:
        return not array.size or isfinite(array.item())
    return isfinite(array.min()) and isfinite(array.max())


def largest_size(array: Array) -> float:
    """Return the size of the largest number of an array, NaN aside, without making another array."""
    if not array.size:
        return 0.0
    return float(np.fmax(np.fmax.reduce(array, axis=None), -np.fmin.reduce(array, axis=None)))


def _near(number: Expr | float) -> float:
    """Return a double within one rounding of an exact number.

    It is NaN if there is none, or if the number is too small to be rounded well.
    """
    if isinstance(number, float):
        return number
    if isinstance(number, Rational):
        try:
            near = int(number.p) / int(number.q)       # correctly rounded
        except OverflowError:
            return float("nan")
    else:
        enclosure = ball(number, precision := 128)
        while enclosure.rel_accuracy_bits() < 60 and precision < LIMIT:
            enclosure = ball(number, precision := 2 * precision)
        near = float(enclosure.mid()) if enclosure.rel_accuracy_bits() >= 60 else float("nan")
    return near if abs(near) >= 2.0**-1022 or number == 0 else float("nan")
