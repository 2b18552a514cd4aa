"""Cayley-Klein parameters.

The rotation, the directions and the momenta of a body of revolution from two complex numbers.
"""
from typing import Any

import numpy as np

from ...algebra.floats import Array


def momentum(I1: Any, a: Any, b: Any, a_rate: Any, b_rate: Any) -> Any:
    """π1 + i π2 = 2 I1 (ā ḃ − b ā˙), with the derivatives in the frame in which π3 does no work.

    In doubles or balls.
    """
    return 2 * I1 * (a.conjugate() * b_rate - b * a_rate.conjugate())


def structure(gaps: Any, senses: list[int], s: Any, c: Any, turn: Any, rates: Any, i: Any,
              half: Any) -> tuple[list[Any], list[Any]]:
    """a, b = (c √(1 ± z1) ± i s √(1 ± z2)) · half without their unit factors, and their time derivatives.

    In doubles or balls.

    Parameters
    ----------
    gaps : √(1 + z), √(1 − z) at the lower and the upper end
    senses : 1 or −1 of each
    s, c, turn : of the nutation
    rates : dt/du, and what the two unit factors turn in u
    i, half : √−1 and √½, in the arithmetic wanted
    """
    values, slopes = [], []
    for (low, high), sense, rate in zip(gaps, senses, rates[1:]):
        value = (c * low + i * (sense * s * high)) * half
        values.append(value)
        slopes.append(((i * (sense * c * high) - s * low) * (turn * half) + i * rate * value) / rates[0])
    return values, slopes


def rotation(a: Array, b: Array) -> Array:
    """R from body to space of a = cos(θ/2) exp(i (φ + ψ)/2), b = sin(θ/2) exp(i (φ − ψ)/2).

    Shape (..., 3, 3).

    References
    ----------
    Whittaker, Analytical Dynamics, 4th ed. (1937), §10; the angles are z-x-z, as in
    gyrostat.mechanics.attitude.

    Examples
    --------
    >>> rotation(np.array(0.6), np.array(0.8)).round(12)[2]             # φ = ψ = 0, cos(θ/2) = 0.6
    array([ 0.  ,  0.96, -0.28])
    """
    first, second, across, up = a * a, b * b, -2j * a * b, 2j * b * a.conjugate()
    rows = [[first.real + second.real, second.imag - first.imag, across.real],
            [first.imag + second.imag, first.real - second.real, across.imag],
            [up.real, up.imag, abs(a) ** 2 - abs(b) ** 2]]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)
