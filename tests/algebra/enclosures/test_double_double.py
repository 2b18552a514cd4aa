"""Arithmetic of 106 bits, against fractions."""
from fractions import Fraction

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from gyrostat.algebra.enclosures.double_double import Twofold, scaled, two_product, two_sum

doubles = st.floats(min_value=-1e6, max_value=1e6).filter(lambda x: x == 0 or abs(x) > 1e-6)
twofolds = st.tuples(doubles, st.floats(min_value=-0.5, max_value=0.5)).map(
    lambda pair: Twofold(np.float64(pair[0]), np.float64(pair[1] * np.spacing(abs(pair[0]))))
)
ULP = Fraction(1, 2**53)


def exact(number):
    return Fraction(float(number.high)) + Fraction(float(number.low))


@given(twofolds, twofolds)
def test_twofold_arithmetic(a, b):
    """Sums of two doubles to 2⁻¹⁰⁰ of the sizes that enter."""
    x, y = exact(a), exact(b)
    for result, expected, size in ((a + b, x + y, abs(x) + abs(y)), (a - b, x - y, abs(x) + abs(y)),
                                   (a * b, x * y, abs(x * y)), (-a, -x, abs(x))):
        assert abs(exact(result) - expected) <= size / 2**100


@given(doubles, doubles)
def test_the_error_of_a_sum_and_of_a_product_is_a_double(a, b):
    """s is the rounded sum and s + e the sum itself; so of the product."""
    for result, rounded, expected in ((two_sum(a, b), a + b, Fraction(a) + Fraction(b)),
                                      (two_product(a, b), a * b, Fraction(a) * Fraction(b))):
        assert result[0] == rounded and exact(Twofold(*result)) == expected


@settings(max_examples=60)
@given(st.floats(min_value=-1e11, max_value=1e11, allow_subnormal=False), twofolds)
def test_a_double_times_a_sum_of_two(x, factor):
    """The rounded product and what it lacks are x · (high + low) to 2⁻¹⁰⁴ of it."""
    found, expected = scaled(np.array([x]), factor), Fraction(x) * exact(factor)
    rounded, rest = (Fraction(part[0]) for part in found)
    assert rounded == Fraction(x * factor.high)
    assert abs(rounded + rest - expected) <= abs(expected) * 4 * ULP**2 + Fraction(1, 2**1000)
