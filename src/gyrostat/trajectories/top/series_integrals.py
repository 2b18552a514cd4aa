"""Integrals of smooth functions as a linear part and a series, at any place in doubles or balls."""
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from flint import arb

from ..._cached import cached_property
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import own_precision
from ..circle import circle
from ..periods import double

# the most steps of Newton's method; the u at which a function has reached its limit in doubles
MOST_STEPS, FAR = 40, 40.0
ROUNDED = 256                                              # bits of sums that are rounded to doubles


class Place(NamedTuple):
    """The place at which a series is summed."""

    y: Any
    """cos w, w = π u/K; at infinity tanh(u/2)."""
    x: Any
    """sin w; at infinity 2 log cosh(u/2) − abs(u)."""


@dataclass(frozen=True)
class Curve:
    """The integral of a function in doubles, and the function.

    Parameters
    ----------
    mean, jump : float
        the linear part is mean u + jump abs(u)
    terms : list of float
        the coefficients of sin(j w), j from 1; at infinity of T_j(y), j from 0
    slopes : list of float
        those of the function: of cos(j w), j from 0; at infinity of (1 − y²)/2 T_j(y)
    periodic : bool
        whether the function has a period, and no limits at infinity
    """

    mean: float
    jump: float
    terms: list[float]
    slopes: list[float]
    periodic: bool

    def bounded(self, place: Place) -> Any:
        """Return the integral less its linear part."""
        if self.periodic:
            return place.x * _clenshaw(self.terms, 2 * place.y)[0]
        return self.jump * place.x + _chebyshev(self.terms, place.y)

    def rate(self, place: Place) -> Any:
        """Return the function."""
        if self.periodic:
            return _chebyshev(self.slopes, place.y)
        y = place.y
        return self.mean + self.jump * y + _chebyshev(self.slopes, y) * (1 - y) * (1 + y) / 2


@dataclass(frozen=True)
class Integrals:
    """The integrals ∫₀ᵘ f for each f of a list: means[i] u + 2 jumps[i] log cosh(u/2) + a series.

    Parameters
    ----------
    means : tuple of arb
        mean values; at infinity the mean of the two limits
    jumps : tuple of arb
        half the difference of the limits; 0 for periodic functions
    series : list of list of arb
        the coefficients of sin(j π u/K), j from 1; at infinity of Chebyshev's T_j of tanh(u/2), j from 0
    quarter : arb or None
        K, half a period of u; None if the functions have limits at infinity
    nodes : int
        values of each f that were used
    """

    means: tuple[arb, ...]
    jumps: tuple[arb, ...]
    series: list[list[arb]]
    quarter: arb | None
    nodes: int

    @cached_property
    def constant(self) -> list[bool]:
        """Whether each of the functions is a constant."""
        return [all(x == 0 for x in (*row, jump)) for row, jump in zip(self.series, self.jumps)]

    def curve(self, weights: Sequence[int], unit: arb | int = 1) -> Curve:
        """Return a sum of the integrals in doubles, each so many times, in a unit."""
        with own_precision(ROUNDED):
            mean, jump, *terms = (double(sum((n * x for n, x in zip(weights, column)), arb(0)) / unit)
                                  for column in (self.means, self.jumps, *zip(*self.series)))
            if self.quarter is None:
                slopes = np.polynomial.chebyshev.chebder(terms).tolist()
            else:
                slopes = [mean, *(j * x * double(arb.pi() / self.quarter) for j, x in enumerate(terms, 1))]
        return Curve(mean, jump, _needed(terms, mean), _needed(slopes, mean), self.quarter is not None)

    @cached_property
    def time(self) -> Curve:
        """The first of the integrals in doubles."""
        return self.curve([1] + [0] * (len(self.means) - 1))

    @cached_property
    def rate(self) -> float:
        """The rate 1/2K, 0 at infinity."""
        with own_precision(ROUNDED):
            return 0.0 if self.quarter is None else double(1 / (2 * self.quarter))

    def half(self, u: Any) -> tuple[Any, Any] | None:
        """Return cosine and sine of π u/2K; None at infinity."""
        return circle(self.rate / 2 * u) if self.rate else None

    def place(self, u: Any) -> Place:
        """Return the place where curves are summed for u, numbers or arrays."""
        if not self.rate:
            return Place(np.tanh(u / 2), 2 * (np.log1p(np.exp(-np.abs(u))) - np.log(2.0)))
        return Place(*circle(self.rate * u))               # from the half angle it would be off by more

    def at(self, u: arb) -> tuple[list[arb], list[arb]]:
        """Return the integrals, linear parts included, and the functions, in balls."""
        values, slopes = [], []
        if self.quarter is not None:
            w = arb.pi() / self.quarter
            turns = [(j * w * u).sin_cos() for j in range(1, len(self.series[0]) + 1)]
            for mean, row in zip(self.means, self.series):
                values.append(mean * u + sum((c * s for c, (s, _) in zip(row, turns)), arb(0)))
                slopes.append(mean + w * sum((j * c * cosine
                                              for j, (c, (_, cosine)) in enumerate(zip(row, turns), 1)),
                                             arb(0)))
            return values, slopes
        y, square = (u / 2).tanh(), (u / 2).sech() ** 2 / 2
        T = [arb(1), y]
        V = [arb(0), arb(1)]                               # T_j′ = j V_j
        while len(T) < len(self.series[0]):
            T.append(2 * y * T[-1] - T[-2])
            V.append(2 * y * V[-1] - V[-2])
        for mean, jump, row in zip(self.means, self.jumps, self.series):
            values.append(mean * u + 2 * jump * (u / 2).cosh().log()
                          + sum((c * t for c, t in zip(row, T)), arb(0)))
            slopes.append(mean + jump * y + square
                          * sum((j * c * v for j, (c, v) in enumerate(zip(row, V))), arb(0)))
        return values, slopes

    def inverse(self, values: Any) -> Any:
        """Return the u at which the first of the integrals, which is monotonic, has these values.

        The values are numbers or an array; Newton's method starts from a table.
        """
        time = self.time
        if self.constant[0]:
            return values / time.mean
        grid, known = self._grid
        u, moving = np.interp(values, known, grid), True
        for _ in range(MOST_STEPS):
            place = self.place(u)
            gained = (time.mean + time.jump * np.sign(u)) * u + time.bounded(place)
            step = (gained - values) / time.rate(place) * moving
            u = u - step
            moving = np.abs(step) > 4e-16 * (1 + np.abs(u))         # what has arrived stays
            if not np.any(moving):
                break
        return u

    @cached_property
    def _grid(self) -> tuple[Array, Array]:
        """The u and the first integral, in the order of its values, at which Newton's method begins."""
        end = FAR if self.quarter is None else double(self.quarter)
        time = self.time
        grid = np.linspace(-end, end, 8 * len(self.series[0]) + 64) * np.sign(time.mean)
        bounded = time.bounded(self.place(grid))
        return grid, time.mean * grid + time.jump * np.abs(grid) + bounded


def _needed(terms: Sequence[float], mean: float) -> list[float]:
    """Return the terms without those at the end that the sum of them all, in doubles, does not see."""
    least = 2.0**-60 * max(map(abs, [mean, *terms]))
    return list(terms[:max((j for j, x in enumerate(terms, 1) if abs(x) > least), default=0)])


def _clenshaw(terms: Sequence[float], twice: Any) -> tuple[Any, Any]:
    """Return the last two of b_j = c_j + 2 y b_(j+1) − b_(j+2), the first being Σ c_j U_j(y)."""
    here: Any = 0.0
    last: Any = 0.0
    for c in reversed(terms):
        new = twice * here
        new -= last
        new += c
        here, last = new, here
    return here, last


def _chebyshev(terms: Sequence[float], y: Any) -> Any:
    """Return Σ c_j T_j(y), by Clenshaw's recurrence."""
    here, last = _clenshaw(terms[1:], 2 * y)
    return y * here - last + (terms[0] if terms else 0.0)
