"""Frequencies and growth rate of a relative equilibrium, by the roots λ² of its characteristic polynomial.

The motion is spectrally stable if all of these roots are real and at most 0.
"""
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import reduce
from typing import Any

from flint import acb, acb_poly, arb, ctx
from sympy import Expr, Float, S, sqrt

from ..algebra.enclosures.precision import doubled, own_precision

DIGITS, BITS = 30, 256                                     # decimals of a rate, and bits to compute it
Signs = tuple[int | None, ...]


def conditions(spectrum: Sequence[Any]) -> list[Any]:
    """Return what is positive if and only if all roots, one to three, are negative and distinct.

    For two roots their product has to be positive, too: its sign is that of det of the second variation,
    which is known elsewhere. The last entry for two or three roots is the discriminant of the polynomial.
    """
    if len(spectrum) == 2:
        return [spectrum[1]]
    if len(spectrum) == 3:
        d, p, q = spectrum
        return [p, p * p - 4 * d * q]
    d, a, b, c = spectrum                      # products: ** gives no finite power of a ball that contains 0
    return [a, b, c, a * a * b * b - 4 * d * b * b * b - 4 * a * a * a * c + 18 * d * a * b * c
            - 27 * d * d * c * c]


def exact_rates(spectrum: Sequence[Expr], whole: int | None, signs: Signs) -> tuple[tuple[Expr, ...],
                                                                                     Expr | None]:
    """Return frequencies and growth rate, by a monic spectrum with one or two roots λ².

    The sign of the product of the roots, 0 if one of them is 0, and the signs of the conditions tell which
    roots are negative.
    """
    if not whole:
        spectrum = spectrum[:-1]
    if not spectrum:
        return (), None
    if len(spectrum) == 1:
        (x,) = spectrum
        return ((sqrt(x),) if signs[0] == 1 else ()), sqrt(-x) if signs[0] == -1 else None
    p, q = spectrum
    half, root = p / 2, sqrt(abs(p**2 / 4 - q)) if signs[1] else S.Zero
    if signs[1] == -1:
        return (), sqrt((sqrt(half**2 + root**2) - half) / 2)
    slow = (sqrt(half - root),) * (whole == signs[0] == 1)
    fast = (sqrt(half + root),) * (whole == -1 or signs[0] == 1)
    return slow + fast, sqrt(root - half) if -1 in (whole, signs[0]) else None


def rates_in_balls(spectrum: Callable[[int], list[arb]], whole: bool) -> tuple[tuple[Expr, ...], Expr | None]:
    """Return frequencies and growth rate, by a spectrum in balls of any precision.

    If the spectrum is not whole, its last root is 0 and is dropped.
    """
    for precision in doubled(BITS):
        with own_precision(precision), suppress(ValueError):           # roots are not told apart: more bits
            found = squares(spectrum(precision) if whole else spectrum(precision)[:-1])
            if all(x.rel_accuracy_bits() > 4 * DIGITS for x in found):
                break
    with own_precision(BITS):
        slow = [(-x.real).sqrt() for x in found if x.real < 0 and x.imag.contains(0)]
        grow = [x.sqrt().real for x in found if not (x.real < 0 and x.imag.contains(0))]
        largest = max((x for x in grow if x > 0), key=lambda x: float(x.mid()), default=None)
        return (tuple(_decimal(x) for x in sorted(slow, key=lambda x: float(x.mid()))),
                None if largest is None else _decimal(largest))


def squares(spectrum: Sequence[arb]) -> list[acb]:
    """Return the roots λ² of a spectrum in balls, up to three; two that cannot be told apart are made one."""
    if len(spectrum) < 2:
        return []
    if len(spectrum) == 2:
        return [acb(-spectrum[1] / spectrum[0])]
    # without a gap two roots are one, and solving for them would lose half of the bits
    gap = conditions(spectrum)[-1]
    if not gap.contains(0):
        size = reduce(arb.max, (abs(x / spectrum[0]).upper().root(n) for n, x in enumerate(spectrum[1:], 1)))
        return list(acb_poly(list(reversed(spectrum))).roots(arb(2) ** (-3 * ctx.prec // 4) * size))
    if len(spectrum) == 3:
        d, p, _ = spectrum
        return [acb(-p / (2 * d))] * 2
    d, a, b, c = spectrum
    if (apart := a * a - 3 * b * d).contains(0):
        return [acb(-a / (3 * d))] * 3
    double = (9 * d * c - a * b) / (2 * apart)
    return [acb(x) for x in (double, double, -a / d - 2 * double)]


def _decimal(x: arb) -> Expr:
    return Float(x.mid().str(DIGITS, radius=False), DIGITS)
