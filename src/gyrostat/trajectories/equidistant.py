"""Fills in values at many times, in blocks that fit a cache; at equidistant times most are interpolated.

In a short stretch of time a smooth function is, to the last bit, the polynomial through 24 Chebyshev nodes.
At equidistant times one matrix leads in all stretches from values at the nodes to those at the times. If the
last coefficients of a stretch are not 0 but for rounding, its values are computed.
"""
import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev

from .._cached import cached_property
from ..algebra.enclosures.floats import Array

BLOCK, JOINED = 16384, 4096                                # values at once, interpolated ones at once
MANY = 16384                                               # fewer times are not worth a trial
NODES = 24                                                 # nodes of a stretch
LAST, TRIED = 4, 6                                         # coefficients that are to be 0; on trial
LENGTHS = 64, 96, 128, 192, 256, 384, 512                  # times in a stretch
PROBES, GOLDEN = 8, 0.618034                               # stretches on trial, so far apart in the row
# what rounding leaves of a coefficient that is 0, to the largest value of its component, and of all
SMALL, TINY = 2.0**-48, 2.0**-56
# how far, in steps, a time may be from an equidistant one: a stretch of 64 steps follows it to first order,
# and what is of second order is below 2⁻⁵⁴
NEAR = 2.0**-24

CHEBYSHEV = np.cos(np.pi * (2 * np.arange(NODES) + 1) / (2 * NODES))
TO_COEFFICIENTS = np.linalg.inv(chebyshev.chebvander(CHEBYSHEV, NODES - 1)).T
# from values at the nodes to derivatives there
TO_SLOPES = TO_COEFFICIENTS @ chebyshev.chebval(CHEBYSHEV, chebyshev.chebder(np.eye(NODES)))

Fill = Callable[[Array, Any], None]


def filled(function: Fill, t: Array, shape: tuple[int, ...]) -> Array:
    """Return the values that a function fills in, at times of any shape.

    Parameters
    ----------
    function : callable
        enters the values at a number, or at a row of times, into an array that has them along the last axes
    t : array of floats, any shape
    shape : tuple of int
        that of a value

    Returns
    -------
    array, shape (*t.shape, *shape)
    """
    found = np.empty((*t.shape, *shape))
    if t.ndim == 0:
        function(found, t[()])
        return found
    rows, times, done = found.reshape(-1, *shape), t.ravel(), 0
    if times.size >= MANY and (stretches := _longest(function, times, shape)):
        done = times.size // stretches.length * stretches.length
        stretches.fill(rows[:done], times[:done])
    _fill(function, rows[done:], times[done:])
    return found


def _fill(function: Fill, rows: Array, times: Array) -> None:
    """Enter the values at a row of times, in blocks."""
    for first in range(0, times.size, BLOCK):
        function(rows[first:first + BLOCK], times[first:first + BLOCK])


class Stretches:
    """Equidistant times in stretches of a length, and the interpolation between the nodes of each.

    Parameters
    ----------
    function : callable
        as for filled
    shape : tuple of int
        that of a value
    length : int
        the times in a stretch
    step : float
        from one to the next
    unit : float
        a power of 2 of which no time is too large to be a multiple: those nearest to the middle times, and
        the nodes, have exact sums
    """

    def __init__(self, function: Fill, shape: tuple[int, ...], length: int, step: float, unit: float):
        self.function, self.shape, self.length, self.step, self.unit = function, shape, length, step, unit
        self.half = length / 2 * step
        self.nodes = self.rounded(self.half * CHEBYSHEV)
        off = self.nodes / self.half - CHEBYSHEV           # what rounding does, to first order
        self.to_coefficients = TO_COEFFICIENTS - TO_SLOPES @ (off[:, None] * TO_COEFFICIENTS)
        self.places = step * (np.arange(length) - length // 2)
        self.size = np.zeros(1)

    def rounded(self, t: Array) -> Array:
        """Return the nearest multiples of the unit."""
        return np.rint(t / self.unit) * self.unit

    def around(self, middles: Array) -> Array:
        """Return the times of the nodes around multiples of the unit, in a row."""
        return (middles[:, None] + self.nodes).ravel()

    def spread(self, values: Array) -> tuple[Array, Array]:
        """Return the values at the first node of each stretch, and how much more they are at each node.

        Their shape is (stretches, components, nodes). So a constant is not rounded by sums.
        """
        x = np.ascontiguousarray(values.reshape(-1, NODES, math.prod(self.shape)).swapaxes(1, 2))
        base = x[:, :, :1].copy()
        x -= base
        return base, x

    def exact_around(self, values: Array) -> bool:
        """Tell whether all stretches are exact around some times, from values at the nodes around them."""
        self.size = np.abs(values).max(axis=0).ravel()
        return bool(self._exact(self.spread(values)[1], TRIED).all())

    def fill(self, rows: Array, times: Array) -> None:
        """Enter the values at the times of whole stretches."""
        rows, times = rows.reshape(-1, self.length, *self.shape), times.reshape(-1, self.length)
        for first in range(0, len(times), BLOCK // NODES):
            part = slice(first, first + BLOCK // NODES)
            self._fill(rows[part], times[part])

    def _fill(self, rows: Array, times: Array) -> None:
        middles = self.rounded(times[:, self.length // 2, None])
        values = np.empty((middles.size * NODES, *self.shape))
        self.function(values, self.around(middles[:, 0]))
        base, x = self.spread(values)
        exact = self._exact(x)
        into = rows.reshape(*times.shape, -1).swapaxes(1, 2)
        for first in range(0, len(times), JOINED // self.length):
            part = slice(first, first + JOINED // self.length)
            late = times[part] - middles[part]
            late -= self.places
            exact[part] &= np.abs(late).max(axis=1) <= NEAR * abs(self.step)
            found, rates = ((x[part].reshape(-1, NODES) @ matrix).reshape(len(late), -1, self.length)
                            for matrix in self._matrices)
            rates *= late[:, None]
            found += base[part]
            np.add(found, rates, out=into[part])
        if not exact.all():
            left = times[~exact]
            found = np.empty((left.size, *self.shape))
            _fill(self.function, found, left.ravel())
            rows[~exact] = found.reshape(*left.shape, *self.shape)

    def _exact(self, x: Array, last: int = LAST) -> Array:
        """Tell for each stretch whether nothing but rounding is left of the last coefficients."""
        return (np.abs(x @ self.to_coefficients[:, -last:]).max(axis=2)
                <= SMALL * self.size + TINY * self.size.max()).all(axis=1)

    @cached_property
    def _matrices(self) -> tuple[Array, Array]:
        """The matrices from values at the nodes to the values and to the derivatives at the times."""
        polynomials, slopes = _polynomials(self.length)
        return self.to_coefficients @ polynomials, self.to_coefficients @ slopes / self.half


@lru_cache(maxsize=len(LENGTHS))
def _polynomials(length: int) -> tuple[Array, Array]:
    """Return Chebyshev's polynomials at the places of a stretch from −1 on, and their derivatives."""
    places = 2 * np.arange(length) / length - 1
    return (chebyshev.chebvander(places, NODES - 1).T,
            chebyshev.chebval(places, chebyshev.chebder(np.eye(NODES))))


def _longest(function: Fill, t: Array, shape: tuple[int, ...]) -> Stretches | None:
    """Return the longest stretches of which all that are tried are exact; None if there are none."""
    step, unit = (t[-1] - t[0]) / (t.size - 1), np.spacing(np.abs(t[[0, -1]]).max())
    if not 4 * unit < NEAR * abs(step):
        return None
    # places far from any rhythm of the motion
    places = (np.arange(1, PROBES + 1) * GOLDEN % 1 * (t.size - LENGTHS[-1])).astype(int) + LENGTHS[-1] // 2
    found = None
    for lengths in (LENGTHS[:1], LENGTHS[1:]):             # the others only if the shortest are exact
        some = [Stretches(function, shape, length, step, unit) for length in lengths]
        tried = np.concatenate([one.around(one.rounded(t[places])) for one in some])
        values = np.empty((tried.size, *shape))
        function(values, tried)
        for one, part in zip(some, np.split(values, len(some))):
            if not one.exact_around(part):
                return found
            found = one
    return found
