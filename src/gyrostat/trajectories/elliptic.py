"""Jacobi's elliptic functions sn, cn, dn from the complementary parameter m1 = 1 − m.

They are computed by Landen's transformation in sums of positive terms, so that nothing is lost as m1 goes to
0.
"""
import math
from collections.abc import Iterable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from flint import acb, arb, ctx

from ..algebra.enclosures.floats import Array
from ..algebra.enclosures.precision import own_precision
from .circle import circle
from .periods import double


def jacobi(u: Array, complement: float) -> tuple[Array, Array, Array]:
    """Return (sn, cn, dn) at an array of arguments, to a few units in the last place of 1.

    Parameters
    ----------
    u : array of floats, any shape
        some K at most: it has its own rounding error
    complement : float
        m1 from 0, the hyperbolic functions, to 1, the circular ones

    Returns
    -------
    three arrays, shape of u

    References
    ----------
    Descending Landen transformation (Gauss's), Abramowitz & Stegun, 16.12, in the steps a, b of the
    arithmetic-geometric mean, with 1 = sn² + cn² inserted wherever terms would cancel; Bulirsch, Numerische
    Mathematik 7 (1965) 78-90.

    Examples
    --------
    >>> sn, cn, dn = jacobi(np.array([0.0, 1.0]), 0.0)
    >>> bool(sn[1] == np.tanh(1.0)), cn.tolist() == dn.tolist()
    (True, True)
    """
    if complement == 0:
        sech = 1 / np.cosh(np.clip(u, -710, 710))
        return np.tanh(u), sech, sech
    steps = landen(complement)
    sn, cn, dn = raised(*circle(u * steps.turns), steps)
    return sn, cn, dn if steps.levels else np.ones_like(u)


class Landen(NamedTuple):
    """The descending transformation of a parameter: 1/4K; a, b and their mean from the last step up."""

    turns: float
    levels: tuple[tuple[float, float, float], ...]


@lru_cache(maxsize=64)
def landen(complement: float) -> Landen:
    """Return the steps from m1 to the circular functions, in doubles."""
    with own_precision(128):
        turns = double(1 / (4 * quarter_period(arb(complement))))
    levels, a, b = [], 1.0, math.sqrt(complement)
    while a - b > 4e-16 * a:
        mean = (a + b) / 2
        levels.append((a, b, mean))
        a, b = mean, math.sqrt(a * b)
    return Landen(turns, tuple(reversed(levels)))


def raised(cosine: Any, sine: Any, steps: Landen) -> tuple[Any, Any, Any]:
    """Return (sn, cn, dn) from the cosine and sine of π u/2K, numbers or arrays."""
    return _ascended(sine, cosine, 1.0, steps.levels)


def _ascended(sn: Any, cn: Any, dn: Any, levels: Iterable[tuple[Any, Any, Any]]) -> tuple[Any, Any, Any]:
    """Return the functions of the first parameter from those of the last, by the a, b and mean of each step.

    It is the descending Landen transformation (Gauss's) read backwards, Abramowitz & Stegun, 16.12.2-4: with
    √μ = (a − b)/(a + b) the parameter below, 1 + √μ = a/mean and sn = (1 + √μ) sn'/(1 + √μ sn'²).
    """
    for a, b, mean in levels:
        cosine, sine = mean * cn * cn, sn * sn
        below = cosine + a * sine
        sn, cn, dn = a * sn / below, mean * cn * dn / below, (cosine + b * sine) / below
    return sn, cn, dn


def means(complement: arb) -> list[tuple[arb, arb]]:
    """Return the arithmetic and geometric means from 1 and √m1 on, until they agree at the set precision."""
    found = [(arb(1), complement.sqrt())]
    while abs(found[-1][0] - found[-1][1]) > found[-1][0] * arb(2) ** -ctx.prec:
        a, b = found[-1]
        found.append(((a + b) / 2, (a * b).sqrt()))
    return found


def jacobi_ball(u: arb, complement: arb, steps: list[tuple[arb, arb]] | None = None) -> tuple[arb, arb, arb]:
    """Return (sn, cn, dn) as enclosures, at the precision that is set.

    Each halving of the exponent of m1 costs two or three bits. The steps, means(complement), serve many
    arguments. They end with a parameter m below ε, at which the amplitude lies between u and u − ε abs(u),
    since its derivative is √(1 − m sin²).

    Examples
    --------
    >>> sn, cn, dn = jacobi_ball(arb(1), arb(1) / 2)
    >>> (sn**2 + cn**2).contains(1), (dn**2 + sn**2 / 2).contains(1)
    (True, True)
    """
    if complement == 0:
        return u.tanh(), u.sech(), u.sech()
    steps = steps or means(complement)
    a, b = steps[-1]
    phase, parameter = a * u, 1 - (b / a) * (b / a)
    nothing = arb(0, 1) * parameter * (1 + abs(phase))
    return _ascended((phase + nothing).sin(), (phase + nothing).cos(), 1 + nothing,
                     ((a, b, mean) for (a, b), (mean, _) in zip(steps[-2::-1], steps[:0:-1])))


def quarter_period(complement: arb) -> arb:
    """Return K = π / (2 agm(1, √m1)), at the precision that is set.

    Examples
    --------
    >>> quarter_period(arb(1)).contains(arb.pi() / 2)
    True
    """
    return arb.pi() / (2 * acb(1).agm(acb(complement.sqrt())).real)


def argument(sine: arb, cosine: arb, complement: arb) -> arb:
    """Return the argument u between 0 and 2 K for which sn u : cn u = sine : cosine, where sine ≥ 0.

    Its relative precision is that of the two and of m1. With s² + c² = 1 it is u = s R_F(c², c² + m1 s², 1).
    Near K it is taken from there, as sn : cn = c : s √m1 at K − u.

    References
    ----------
    NIST Digital Library of Mathematical Functions, 19.25.31, 22.4.3.

    Examples
    --------
    >>> argument(arb(3), arb(4), arb(0)).overlaps(arb("0.6").atanh())
    True
    """
    if (cosine * cosine - complement * sine * sine) > 0:
        direct = _integral(sine, abs(cosine), complement)
        return direct if cosine > 0 else 2 * quarter_period(complement) - direct
    return quarter_period(complement) - _integral(cosine, sine * complement.sqrt(), complement)


def _integral(sine: arb, cosine: arb, complement: arb) -> arb:
    size = (sine * sine + cosine * cosine).sqrt()
    s, c = sine / size, cosine / size
    return s * acb.elliptic_rf(acb(c * c), acb(c * c + complement * s * s), acb(1)).real
