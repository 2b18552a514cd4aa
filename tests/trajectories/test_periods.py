"""Times of any length, against fractions."""
from fractions import Fraction as F
from math import isqrt

import numpy as np
import pytest
from flint import arb, ctx, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Rational, sqrt

from gyrostat.algebra.enclosures.double_double import Twofold
from gyrostat.errors import ValuesError
from gyrostat.trajectories.periods import LONGEST, double, nearest, pair, reduced, turns

fractions = st.fractions(min_value=F(1, 1000), max_value=1000, max_denominator=10**12)
exponents = st.integers(min_value=-300, max_value=300)
times = st.floats(min_value=-1e11, max_value=1e11, allow_subnormal=False)
some = settings(max_examples=60)
ULP = F(1, 2**53)


def enclosed(x):
    with ctx.workprec(400):
        return arb(fmpq(x.numerator, x.denominator))


@some
@given(x=fractions, n=exponents, sign=st.sampled_from((1, -1)))
def test_double_is_the_nearest(x, n, sign):
    """The middle of an enclosure is rounded to the nearest double, as Python rounds a fraction."""
    value = sign * x * F(2) ** n
    assert double(enclosed(value)) == float(value)


@some
@given(x=fractions, n=exponents, root=st.sampled_from((2, 3, 5)))
def test_nearest_is_the_nearest_double(x, n, root):
    """A fraction, and what is left of a root if nearly all of it is taken away, to 60 digits."""
    value = x * F(2) ** n
    assert nearest(Rational(value.numerator, value.denominator)) == float(value)
    whole = isqrt(root * 10**80)                           # 40 digits of the root
    left = sqrt(root) - Rational(whole, 10**40)
    assert nearest(x.numerator * left) == float(x.numerator * F(isqrt(root * 10**240) - whole * 10**80,
                                                                10**120))


def test_double_of_an_enclosure_is_that_of_its_middle():
    """The radius does not matter, zero and whole numbers are exact."""
    assert double(arb(3, "0.5")) == 3.0 and double(arb(0)) == 0.0 and double(arb(2) ** 80) == 2.0**80
    with ctx.workprec(100):
        assert double(arb(1) + arb(2) ** -53 + arb(2) ** -90) == 1 + 2.0**-52          # float(arb) truncates


@some
@given(x=fractions, sign=st.sampled_from((1, -1)))
def test_a_pair_has_106_bits(x, sign):
    """high is the nearest double, high + low is within 2⁻¹⁰⁶ of the number."""
    found = pair(enclosed(sign * x))
    assert found.high == float(sign * x) and abs(F(found.high) + F(found.low) - sign * x) <= x * ULP**2


@some
@given(t=times, period=fractions)
def test_reduced_times_are_exact(t, period):
    """t = n · period + r with abs(r) at most half a period, to a rounding of r and 2⁻¹⁰⁴ of t."""
    n, r = reduced(np.array([t]), pair(enclosed(period)))
    error = abs(F(t) - int(n[0]) * period - F(r[0]))
    assert n[0] == int(n[0]) and error <= 2 * ULP * abs(F(r[0])) + 8 * ULP**2 * abs(F(t))
    assert abs(F(r[0])) <= period / 2 * (1 + F(1, 10**6))


@pytest.mark.slow
@some
@given(n=st.integers(min_value=-2**49, max_value=2**49), delta=fractions, sign=st.sampled_from((1, -1)))
def test_turns_of_a_whole_number_are_exact(n, delta, sign):
    """x · δ mod 1, between −1/2 and 1/2, for as many periods as there may be."""
    found = turns(np.array([float(n)]), pair(enclosed(sign * delta)))[0]
    difference = F(found) - n * sign * delta
    assert abs(found) <= 0.5 and abs(difference - round(difference)) <= 2 * ULP + 8 * ULP**2 * abs(n) * delta


def test_turns_at_the_ends():
    """Whole turns are 0, halves stay halves, an array keeps its shape."""
    half = Twofold(0.5, 0.0)
    np.testing.assert_array_equal(np.abs(turns(np.array([[0.0, 1.0], [2.0, -3.0]]), half)),
                                  [[0, 0.5], [0, 0.5]])
    assert turns(np.array([1.0]), Twofold(1.0, 2.0**-60))[0] == 2.0**-60
    assert turns(np.array([3.0]), Twofold(0.5, 2.0**-50))[0] == -0.5 + 3 * 2.0**-50


@pytest.mark.parametrize("t", [np.nan, np.inf, -np.inf, 2 * LONGEST, -2 * LONGEST])
def test_times_that_are_not_counted(t):
    """More than 2⁴⁹ periods, or no number, is refused, and which one is said."""
    with pytest.raises(ValuesError, match=f"t = {t} is not within 6e\\+14 periods"):
        reduced(np.array([1.0, t, 2.0]), Twofold(1.0, 0.0))
    n, r = reduced(np.array([LONGEST, -LONGEST, 0.25]), Twofold(1.0, 0.0))
    assert n.tolist() == [LONGEST, -LONGEST, 0] and r.tolist() == [0, 0, 0.25]
