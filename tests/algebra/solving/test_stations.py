"""Fractions beside numbers, between them, and less than their distance."""
from fractions import Fraction
from itertools import pairwise

import pytest
from sympy import Rational, pi, sqrt

from gyrostat.algebra.reals.exact import sign_of_constant
from gyrostat.algebra.solving.stations import beside, between, distance

NUMBERS = [Rational(1, 3), Rational(-7, 8), sqrt(2), -pi, 10**6 + sqrt(3), Rational(0)]


def increasing(*numbers):
    """Whether each is proved to be less than the next."""
    return all(sign_of_constant(b - a) == 1 for a, b in pairwise(numbers))


@pytest.mark.parametrize("t", NUMBERS, ids=str)
@pytest.mark.parametrize("step", [Fraction(3), Fraction(1, 10**3), Fraction(1, 10**12), Fraction(1, 10**400)])
def test_fractions_on_either_side_are_within_a_step(t, step):
    """And not at the number."""
    low, high = (Rational(x.numerator, x.denominator) for x in beside(t, step))
    assert increasing(low, t, high) and increasing(high - step, t, low + step)


@pytest.mark.few(14)
@pytest.mark.parametrize("gap", [Rational(5), Rational(1, 10**9), Rational(1, 10**400)], ids=str)
@pytest.mark.parametrize("t", NUMBERS, ids=str)
def test_what_lies_between_two_numbers(t, gap):
    """A fraction well inside; their distance, less than a half too small."""
    middle = between(t, t + gap)
    assert increasing(t + gap / 4, Rational(middle.numerator, middle.denominator), t + gap * Rational(3, 4))
    assert gap / 2 < distance(t + gap, t) < gap
