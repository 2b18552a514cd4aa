"""Cosine and sine of many angles in turns, from a table of roots of unity: twice as fast as NumPy's."""
from typing import Any

import numpy as np
from flint import arb, fmpq

from ..algebra.enclosures.floats import Array
from ..algebra.enclosures.precision import own_precision
from .periods import double

POINTS = 1024                                              # a power of 2: what is left of a turn is exact


def _cosines() -> Array:
    """Return the cosine of n/1024 of a turn, n from 0, correctly rounded: an eighth of a turn tells all."""
    with own_precision(128):
        sines, cosines = zip(*(arb.sin_cos_pi_fmpq(fmpq(2 * n, POINTS)) for n in range(POINTS // 8 + 1)))
    quarter = np.array([double(x) for x in (*cosines, *sines[-2::-1])])
    return np.concatenate([quarter[:-1], -quarter[:0:-1], -quarter[:-1], quarter[:0:-1]]) + 0.0     # no −0


COSINES = _cosines()
SINES = np.roll(COSINES, POINTS // 4)


def circle(turns: Any) -> tuple[Any, Any]:
    """Return cosine and sine of angles in turns, numbers or arrays, to a unit in the last place of 1.

    The angle is n/1024 and a rest y of at most π/1024: the terms of its series that are left out are below
    10⁻¹⁷.

    Examples
    --------
    >>> circle(np.array([0.0, 0.25, -0.5]))
    (array([ 1.,  0., -1.]), array([0., 1., 0.]))
    """
    near = np.rint(turns * POINTS)
    y = (turns - near * (1 / POINTS)) * (2 * np.pi)
    square = y * y
    less = (square * (1 / 24) - 0.5) * square              # cos y − 1
    side = ((square * (1 / 120) - 1 / 6) * square + 1) * y
    n = near.astype(int) & (POINTS - 1)
    cosine, sine = COSINES.take(n), SINES.take(n)
    return cosine + (cosine * less - sine * side), sine + (sine * less + cosine * side)
