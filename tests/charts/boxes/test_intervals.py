"""Interval arithmetic: an interval contains the exact value, at any scale, and is not wider than need be."""
import math
import operator
from fractions import Fraction

import numpy as np
import pytest
from charts.inside import arrays, between, contains, number
from hypothesis import example, given
from hypothesis import strategies as st
from sympy import (
    Rational,
    exp,
    pi,
    sqrt,
)

from gyrostat.charts.boxes.intervals import Enclosure, rounded

floats = st.floats(allow_nan=False, allow_infinity=False)      # subnormal ones and the largest included
intervals = st.tuples(floats, floats).map(sorted)
shares = st.fractions(min_value=0, max_value=1, max_denominator=8)


@given(value=st.fractions(), power=st.integers(min_value=-1100, max_value=1100))
@example(Fraction(0), 0)
@example(Fraction(2) - Fraction(1, 2**53), 1023)
@example(Fraction(1, 3), -1074)
def test_a_number_is_rounded_to_the_floats_beside_it(value, power):
    """low is the greatest float ≤ x, high the least ≥ x: neighbours, or the same where x is a float."""
    exact = value * Fraction(2) ** power
    low, high = rounded(number(exact))
    assert (low == -math.inf or Fraction(low) <= exact) and (high == math.inf or exact <= Fraction(high))
    assert low == high if low == exact else math.nextafter(low, math.inf) == high


@pytest.mark.parametrize("constant", [sqrt(2), pi, -exp(pi), sqrt(2) * Rational(10) ** -310, exp(710),
                                      sqrt(2) - sqrt(3) + Rational(1, 3)])
def test_an_irrational_number_is_rounded_to_the_floats_beside_it(constant):
    """As rational ones; compared exactly."""
    low, high = rounded(constant)
    assert math.nextafter(low, math.inf) == high
    assert contains(Enclosure(np.array([low]), np.array([high])), constant)


@given(a=intervals, b=intervals, s=shares, t=shares)
@example([5e-324, 5e-324], [0.5, 0.5], Fraction(0), Fraction(0))                      # underflow
@example([1.7e308, 1.7e308], [-1.7e308, 1.7e308], Fraction(0), Fraction(1))           # overflow
@example([0.1, 0.1], [0.2, 0.2], Fraction(0), Fraction(0))
@example([3.0, 3.0], [0.1, 0.1], Fraction(0),
         Fraction(0))                            # one factor of single precision
@example([1e16, 1e16], [-1.0, 1.0], Fraction(0), Fraction(0))
def test_arithmetic_contains_the_exact_result(a, b, s, t):
    """+ − × and 1/x of points of two intervals, at their ends and inside, lie in the result of the intervals.
    """
    one, other = arrays(a, b)
    with np.errstate(all="ignore"):
        for p, q in ((between(a, s), between(b, t)), (between(a, round(s)), between(b, round(t)))):
            assert contains(one + other, p + q)
            assert contains(one - other, p - q)
            assert contains(one * other, p * q)
            assert contains(one * one, p * p)
            assert contains(-one, -p)
            assert not p or contains(one.reciprocal(), 1 / p)


@given(a=intervals)
def test_a_square_is_not_negative(a):
    """x·x of one and the same x; 0 is its least value exactly where the interval has 0."""
    with np.errstate(all="ignore"):
        (one,) = arrays(a)
        square = one * one
    assert square.low[0] >= 0
    assert a[0] > 0 or a[1] < 0 or square.low[0] == 0


def test_exact_bounds_are_not_moved():
    """Exact sums, and products of numbers of single precision, have sharp bounds."""
    for a, b, total, product in (((-1, 1), (0.25, 3), (-0.75, 4), (-3, 3)),
                                 ((0, 2), (-3, 0), (-3, 2), (-6, 0)),
                                 ((1, 1 + 2**-23), (1, 1 + 2**-23), (2, 2 + 2**-22),
                                  (1, 1 + 2**-22 + 2**-46))):
        for operation, ends in ((operator.add, total), (operator.mul, product)):
            result = operation(*arrays(a, b))
            assert (result.low[0], result.high[0]) == ends


def test_infinite_ends_stay_valid():
    """∞ − ∞ and 0·∞ are the whole line, never NaN; 1/x next to 0 too."""
    ends = [-math.inf, -1e308, -1.0, -0.0, 0.0, 5e-324, 1e308, math.inf]
    pairs = [(a, b) for a in ends for b in ends if a <= b]
    with np.errstate(all="ignore"):
        for one in arrays(*pairs):
            for other in arrays(*pairs):
                for result in (one + other, one - other, one * other, one * one, one.reciprocal()):
                    assert not np.isnan([result.low, result.high]).any()
        whole = arrays((-math.inf, math.inf))[0]
        for result in (whole * arrays((0, 0))[0], whole + whole, arrays((-1, 2))[0].reciprocal()):
            assert (result.low[0], result.high[0]) == (-math.inf, math.inf)
