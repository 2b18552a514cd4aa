"""Intervals that contain a number, as tests build and read them."""
import math
from fractions import Fraction

import numpy as np
from sympy import Rational

from gyrostat.algebra.reals.exact import sign_of_constant
from gyrostat.charts.boxes.intervals import Enclosure


def arrays(*pairs):
    """Enclosures of one box each."""
    return [Enclosure(np.array([float(low)]), np.array([float(high)])) for low, high in pairs]


def contains(bounds, value):
    """Whether an exact number lies in the only interval of an enclosure.

    An end may be infinite, never NaN.
    """
    (low,), (high,) = np.broadcast_to(bounds.low, 1).tolist(), np.broadcast_to(bounds.high, 1).tolist()
    if math.isnan(low) or math.isnan(high) or low == math.inf or high == -math.inf:
        return False
    return all(math.isinf(end) or sign_of_constant(side
                                                   * (Rational(*end.as_integer_ratio()) - value)) in (0, 1)
               for end, side in ((low, -1), (high, 1)))


def number(fraction):
    return Rational(fraction.numerator, fraction.denominator)


def between(pair, share):
    low, high = map(Fraction, pair)
    return number(low + share * (high - low))
