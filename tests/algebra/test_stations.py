"""Fractions beside numbers, between them, and less than their distance."""
from fractions import Fraction

import pytest
from sympy import Rational, pi, sqrt

from gyrostat.algebra.stations import beside, between, distance

NUMBERS = [Rational(1, 3), Rational(-7, 8), sqrt(2), -pi, 10**6 + sqrt(3), Rational(0)]


@pytest.mark.parametrize("t", NUMBERS, ids=str)
@pytest.mark.parametrize("step", [Fraction(3), Fraction(1, 1000), Fraction(1, 10**12)], ids=str)
def test_fractions_on_either_side_are_within_a_step(t, step):
    """And not at the number."""
    low, high = (Rational(x.numerator, x.denominator) for x in beside(t, step))
    assert low < t < high and t - low < Rational(step) > high - t


@pytest.mark.parametrize("gap", [Rational(5), Rational(1, 10**9)], ids=str)
@pytest.mark.parametrize("t", NUMBERS, ids=str)
def test_what_lies_between_two_numbers(t, gap):
    """A fraction well inside; their distance, less than a half too small."""
    middle = between(t, t + gap)
    assert gap / 4 < Rational(middle.numerator, middle.denominator) - t < gap * Rational(3, 4)
    apart = distance(t + gap, t)
    assert gap / 2 < Rational(apart.numerator, apart.denominator) < gap
