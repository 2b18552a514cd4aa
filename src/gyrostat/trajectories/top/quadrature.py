"""Integrates smooth functions by the trapezoidal rule, which converges spectrally.

The integrals are over a period, or from −∞ to ∞ in Chebyshev polynomials of tanh(u/2).
"""
from collections.abc import Callable, Sequence

from flint import acb, arb, fmpq

from ...errors import AccuracyError, ResolutionError
from .series_integrals import Integrals

FEWEST, MOST = 12, 8192                                    # the least and the most nodes
# bits by which the integrands have to be better known than the series
GUARD = 50


def over_a_period(sample: Callable[[arb], Sequence[arb]], quarter: arb, nodes: int, bits: int) -> Integrals:
    """Return integrals of even functions of period 2 K, by the trapezoidal rule.

    The number of nodes is doubled until the series is exhausted. The error of the means is that of twice as
    many terms: the square of the last one.

    Parameters
    ----------
    sample : callable
        gives the values of all functions at u
    quarter : arb
        K
    nodes : int
        the number of nodes in half a period, to begin with
    bits : int
        the last terms are below 2^−bits of the largest value

    Returns
    -------
    Integrals

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
    """Return integrals of functions of u that have limits at −∞ and ∞, in Chebyshev polynomials of tanh(u/2).

    The number of nodes is doubled as in over_a_period.
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
    """Return by what the accuracy of each function is measured, unless it is larger.

    For the first, a time, that is its own size; for angles it is 1 at least.
    """
    first, *angles = sizes
    return [first, *(_size([size, arb(1)]) for size in angles)]


def _converged(values: Callable[[int], list[Sequence[arb]]], least: Sequence[arb], nodes: int,
               bits: int) -> tuple[list[Sequence[arb]], list[list[arb]]]:
    """Return values at so many nodes that their series is exhausted, and the series."""
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
    """Return coefficients of cos(j θ), j from 0, from values at θ = (i + ½) π/n, i from 0.

    They come from the discrete Fourier transform of the row and its mirror image.
    """
    n = len(rows[0])
    shifts = [acb(*reversed(arb.sin_cos_pi_fmpq(fmpq(-j, 2 * n)))) for j in range(n)]
    return [[(x * shift).real / n for x, shift in zip(acb.dft([*row, *reversed(row)]), shifts)]
            for row in rows]


def _enclosed(row: Sequence[arb], size: arb, bits: int) -> Sequence[arb]:
    """Return a row, as 0 if it may be 0 throughout; refuse one too rough for means in two doubles."""
    if not all(x.is_finite() and x.rad() <= size * arb(2) ** -(bits + GUARD) for x in row):
        raise AccuracyError(f"the integrands are not known to {bits + GUARD} bits")
    return [arb(0)] * len(row) if all(x.contains(0) for x in row) else row


def _exhausted(sizes: Sequence[arb], spectra: Sequence[Sequence[arb]], bits: int) -> bool:
    """Tell whether the last terms are below 2^−bits of the size."""
    last = -max(len(spectra[0]) // 6, 2)
    return all(max(map(abs, s[last:]), key=float) <= size * arb(2) ** -bits
               for size, s in zip(sizes, spectra))


def _trimmed(rows: Sequence[Sequence[arb]], sizes: Sequence[arb], spectra: list[list[arb]],
             bits: int) -> list[list[arb]]:
    """Return the series without the terms at the end that are below the rounding error.

    A constant keeps the first term alone.
    """
    spectra = [[s[0], *[arb(0)] * (len(s) - 1)] if all(v.overlaps(row[0]) for v in row) else s
               for row, s in zip(rows, spectra)]
    floors = [size * arb(2) ** -bits for size in sizes]
    needed = max((j for floor, s in zip(floors, spectra) for j, c in enumerate(s) if abs(c) > floor),
                 default=0)
    return [[s[0] / 2, *s[1:max(needed, 1) + 1]] for s in spectra]


def _size(row: Sequence[arb]) -> arb:
    """Return the largest modulus of the middles."""
    return max((abs(x.mid()) for x in row), key=float)


def _antiderivative(a: Sequence[arb]) -> list[arb]:
    """Return coefficients of the integral from 0 of Σ a_j T_j."""
    a = [2 * a[0], *a[1:], arb(0), arb(0)]
    b = [arb(0), *((a[j - 1] - a[j + 1]) / (2 * j) for j in range(1, len(a) - 1))]
    b[0] = -sum(((-1) ** (j // 2) * c for j, c in enumerate(b) if j % 2 == 0), arb(0))     # T_j(0)
    return b
