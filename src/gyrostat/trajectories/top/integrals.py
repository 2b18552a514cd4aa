"""Integrals of smooth functions: a linear part and a series, at any place in doubles or balls."""
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from flint import arb

from ...algebra.floats import Array
from ..periods import double

# of Newton's method; where a function has reached its limit
MOST_STEPS, FAR = 40, 40.0


@dataclass(frozen=True)
class Integrals:
    """∫₀ᵘ f for each f of a list: means[i] u + 2 jumps[i] log cosh(u/2) + a series.

    Parameters
    ----------
    means : tuple of arb
        mean values; at infinity the mean of the two limits
    jumps : tuple of arb
        half the difference of the limits; 0 of periodic functions
    series : list of list of arb
        of sin(j π u/K), j from 1; at infinity the Chebyshev polynomials T_j of tanh(u/2), j from 0
    quarter : arb or None
        K, half a period of u; None: the functions have limits at infinity
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
        """Which of the functions are constants."""
        return [all(x == 0 for x in (*row, jump)) for row, jump in zip(self.series, self.jumps)]

    @cached_property
    def coefficients(self) -> Array:
        """The series in doubles, the first terms first, shape (terms, functions)."""
        return np.array([[double(x) for x in row] for row in self.series]).T

    @cached_property
    def _linear(self) -> tuple[Array, Array]:
        return np.array([double(x) for x in self.means]), np.array([double(x) for x in self.jumps])

    def bounded(self, u: Array) -> tuple[Array, Array]:
        """The integrals less their linear parts limits(u) · u, and the functions themselves.

        Shape (functions, points) each.
        """
        means, jumps = (x[:, None] for x in self._linear)
        if self.quarter is not None:
            w = np.pi / double(self.quarter)
            value, slope = _sines(self.coefficients, w * u)
            return value, means + w * slope
        far = 2 * (np.log1p(np.exp(-np.abs(u))) - np.log(2.0))
        y = np.tanh(u / 2)
        value = np.polynomial.chebyshev.chebval(y, self.coefficients)
        slope = np.polynomial.chebyshev.chebval(y, np.polynomial.chebyshev.chebder(self.coefficients))
        return jumps * far + value, means + jumps * y + slope * (1 - y) * (1 + y) / 2

    def at(self, u: arb) -> tuple[list[arb], list[arb]]:
        """The integrals, linear parts included, and the functions, in balls."""
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

    def inverse(self, values: Array) -> Array:
        """u where the first of the integrals, which is monotonic, has these values."""
        mean, jump = (x[0] for x in self._linear)
        if self.constant[0]:
            return values / mean
        grid, known = self._grid
        u = np.interp(values, known, grid)
        for _ in range(MOST_STEPS):
            bounded, rates = self.bounded(u)
            step = ((mean + jump * np.sign(u)) * u + bounded[0] - values) / rates[0]
            u = u - step
            if (np.abs(step) <= 4e-16 * (1 + np.abs(u))).all():
                break
        return u

    @cached_property
    def _grid(self) -> tuple[Array, Array]:
        """u and the first integral, in the order of its values, where Newton's method begins."""
        end = FAR if self.quarter is None else double(self.quarter)
        mean, jump = (x[0] for x in self._linear)
        grid = np.linspace(-end, end, 8 * len(self.coefficients) + 64) * np.sign(mean)
        return grid, mean * grid + jump * np.abs(grid) + self.bounded(grid)[0][0]


def _sines(coefficients: Array, w: Array) -> tuple[Array, Array]:
    """Σ b_j sin(j w) and Σ j b_j cos(j w), j from 1, for each column b, by Clenshaw's recurrence."""
    both = np.concatenate([coefficients, coefficients * np.arange(1, len(coefficients) + 1)[:, None]],
                          axis=1)[:, :, None]
    twice = 2 * np.cos(w)
    here, last = np.zeros((both.shape[1], w.size)), np.zeros((both.shape[1], w.size))
    for row in both[::-1]:
        here, last = row + twice * here - last, here
    n = coefficients.shape[1]
    return here[:n] * np.sin(w), here[n:] * (twice / 2) - last[n:]
