"""Integrals of smooth functions by the trapezoidal rule, which converges spectrally.

Of even periodic functions, or of those with limits at infinity: a linear part and a series.
"""
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from flint import acb, arb, fmpq

from ...algebra.floats import Array
from ...errors import AccuracyError, ResolutionError
from ..periods import double

FEWEST, MOST = 12, 8192                                    # nodes
# of Newton's method; where a function has reached its limit
MOST_STEPS, FAR = 40, 40.0
# bits by which the integrands are better known than the series
GUARD = 50


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


def over_a_period(sample: Callable[[arb], Sequence[arb]], quarter: arb, nodes: int, bits: int) -> Integrals:
    """Integrals of even functions of period 2 K by the trapezoidal rule, the number of nodes doubled until
    the series is exhausted.

    The error of the means is that of twice as many terms: the square of the last one.

    Parameters
    ----------
    sample : function of u
        the values of all functions
    quarter : arb
        K
    nodes : int
        in half a period, to begin with
    bits : int
        the last terms are below 2^−bits of the largest value

    Raises
    ------
    ResolutionError
        8192 nodes do not reach it

    References
    ----------
    Trefethen & Weideman, SIAM Review 56 (2014) 385-458.
    """
    def values(n: int) -> list[Sequence[arb]]:
        return list(zip(*(sample(quarter * fmpq(2 * j + 1, 2 * n)) for j in range(n))))

    rows, spectra = _converged(values, _sizes([arb(0)] * len(sample(quarter))), nodes, bits)
    series = [[c * quarter / (arb.pi() * j) for j, c in enumerate(s[1:], 1)] for s in spectra]
    return Integrals(tuple(sum(row, arb(0)) / len(row) for row in rows), (arb(0),) * len(rows), series,
                     quarter, len(rows[0]))


def to_infinity(sample: Callable[[arb], Sequence[arb]], limits: tuple[Sequence[arb], Sequence[arb]],
                bits: int) -> Integrals:
    """Integrals of functions of u that have limits at −∞ and ∞, in Chebyshev polynomials of tanh(u/2).

    See over_a_period.
    """
    means = [(a + b) / 2 for a, b in zip(*limits)]
    jumps = [(b - a) / 2 for a, b in zip(*limits)]

    def values(n: int) -> list[Sequence[arb]]:
        places = [arb.cos_pi_fmpq(fmpq(2 * j + 1, 2 * n)) for j in range(n)]
        found = zip(*(sample(2 * y.atanh()) for y in places))
        return [[2 * (x - mean - jump * y) / ((1 - y) * (1 + y)) for x, y in zip(row, places)]
                for row, mean, jump in zip(found, means, jumps)]

    rows, spectra = _converged(values, _sizes([_size(pair) for pair in zip(*limits)]), 2 * FEWEST, bits)
    return Integrals(tuple(means), tuple(jumps), [_antiderivative(s) for s in spectra], None, len(rows[0]))


def _sizes(sizes: Sequence[arb]) -> list[arb]:
    """By what the accuracy of each function is measured, unless it is larger.

    Of the first, a time, by itself; of angles, by 1.
    """
    first, *angles = sizes
    return [first, *(_size([size, arb(1)]) for size in angles)]


def _converged(values: Callable[[int], list[Sequence[arb]]], least: Sequence[arb], nodes: int,
               bits: int) -> tuple[list[Sequence[arb]], list[list[arb]]]:
    """Values at so many nodes that their series is exhausted, and the series."""
    while nodes <= MOST:
        rows = values(nodes)
        sizes = [_size([size, *row]) for size, row in zip(least, rows)]
        rows = [_enclosed(row, size, bits) for row, size in zip(rows, sizes)]
        spectra = _spectra(rows)
        if _exhausted(sizes, spectra, bits):
            return rows, _trimmed(rows, sizes, spectra, bits)
        nodes *= 2
    raise ResolutionError(f"{MOST} nodes do not reach the accuracy of {bits} bits: other roots of g are "
                          "too close to the motion")


def _spectra(rows: Sequence[Sequence[arb]]) -> list[list[arb]]:
    """Coefficients of cos(j θ), j from 0, of values at θ = (i + ½) π/n, i from 0.

    By the discrete Fourier transform of twice the row.
    """
    n = len(rows[0])
    shifts = [acb(*reversed(arb.sin_cos_pi_fmpq(fmpq(-j, 2 * n)))) for j in range(n)]
    return [[(x * shift).real / n for x, shift in zip(acb.dft([*row, *reversed(row)]), shifts)]
            for row in rows]


def _enclosed(row: Sequence[arb], size: arb, bits: int) -> Sequence[arb]:
    """The row, one that may be 0 throughout as 0, if it is known well enough for means in two doubles."""
    if not all(x.is_finite() and x.rad() <= size * arb(2) ** -(bits + GUARD) for x in row):
        raise AccuracyError(f"the integrands are not known to {bits + GUARD} bits")
    return [arb(0)] * len(row) if all(x.contains(0) for x in row) else row


def _exhausted(sizes: Sequence[arb], spectra: Sequence[Sequence[arb]], bits: int) -> bool:
    """Whether the last terms are below 2^−bits of the size."""
    last = -max(len(spectra[0]) // 6, 2)
    return all(max(map(abs, s[last:]), key=float) <= size * arb(2) ** -bits
               for size, s in zip(sizes, spectra))


def _trimmed(rows: Sequence[Sequence[arb]], sizes: Sequence[arb], spectra: list[list[arb]],
             bits: int) -> list[list[arb]]:
    """Without the terms at the end that are below the rounding error.

    Of a constant, without any but the first.
    """
    spectra = [[s[0], *[arb(0)] * (len(s) - 1)] if all(v.overlaps(row[0]) for v in row) else s
               for row, s in zip(rows, spectra)]
    floors = [size * arb(2) ** -bits for size in sizes]
    needed = max((j for floor, s in zip(floors, spectra) for j, c in enumerate(s) if abs(c) > floor),
                 default=0)
    return [[s[0] / 2, *s[1:max(needed, 1) + 1]] for s in spectra]


def _size(row: Sequence[arb]) -> arb:
    """The largest modulus, of the middle."""
    return max((abs(x.mid()) for x in row), key=float)


def _antiderivative(a: Sequence[arb]) -> list[arb]:
    """Coefficients of the integral from 0 of Σ a_j T_j."""
    a = [2 * a[0], *a[1:], arb(0), arb(0)]
    b = [arb(0), *((a[j - 1] - a[j + 1]) / (2 * j) for j in range(1, len(a) - 1))]
    b[0] = -sum(((-1) ** (j // 2) * c for j, c in enumerate(b) if j % 2 == 0), arb(0))     # T_j(0)
    return b
