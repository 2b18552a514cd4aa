"""Signs in whole numbers times powers of 2: exact, whatever is lost modulo 2⁶⁴ on the way."""
import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Rational

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign
from gyrostat.charts.programs.straightline import program_of
from gyrostat.charts.signs.dyadic import LONGEST, WORD, dyadic_signs, dyadics

x, y, z = map(gs.symbol, "xyz")
doubles = st.builds(math.ldexp, st.integers(-2**53, 2**53),
                    st.sampled_from([-1127, -300, -55, -53, -3, 0, 960]))


@pytest.mark.slow
@given(values=st.lists(doubles, min_size=1, max_size=9))
@settings(max_examples=60)
def test_doubles_are_whole_numbers_times_powers(values):
    """Odd ones, or 0, subnormal doubles included."""
    found = dyadics(np.array([*values, 5e-324, 1.7e308, -0.0]))
    for n, power, value in zip(found.whole.tolist(), found.power.tolist(), [*values, 5e-324, 1.7e308, -0.0]):
        assert n * Fraction(2) ** power == Fraction(value) and (n % 2 or not value)


@pytest.mark.slow
@given(points=st.lists(st.tuples(doubles, doubles), min_size=1, max_size=9), moved=st.integers(-3, 3),
       room=st.integers(-70, 70))
@settings(max_examples=150)
def test_what_is_found_is_the_sign(points, moved, room):
    """Of polynomials that vanish there or nearly, with bounds wide and close."""
    a, b = (np.array(column) for column in zip(*points))
    margin, far = (x + y) ** 2 - x**2 - 2 * x * y - y**2 + moved * z, np.full(len(points), 2.0**-80)
    with np.errstate(all="ignore"):
        most = np.full(len(points), abs(moved) * 2.0**-80 * (1 + 2.0**room) + 5e-324)
        signs, found = dyadic_signs(program_of(margin, {}), {x: a, y: b, z: far}, most)
    assert (signs[found] == np.sign(moved)).all()


@pytest.mark.parametrize("exponent", [0, 10, 31, 32, 63, 64, 65, 200])
def test_a_difference_that_a_word_does_not_hold(exponent):
    """2^n is 0 modulo 2⁶⁴ from n = 64 on, where the bound says that it may not be."""
    large = np.array([1.0, -1.0]) * (2.0**exponent + 1)
    signs, found = dyadic_signs(program_of(x - y, {}), {x: large, y: np.sign(large)}, 2 * abs(large))
    assert found.all() and signs.tolist() == [1, -1]


@pytest.mark.parametrize("power", [WORD - 3, WORD - 2, WORD - 1, WORD, LONGEST // 8])
def test_the_last_bit(power):
    """A value of one unit, and of none, beside terms of many bits."""
    terms, unit = np.array([2.0**power] * 2), np.array([1.0, 0.0])
    program = program_of((x + z) * y - x * y - 3 * z, {})
    signs, found = dyadic_signs(program, {x: terms, y: np.array([3.0 + 2.0**-50]), z: unit}, np.full(2, 4.0))
    margin = (x + z) * y - x * y - 3 * z
    exact = [sign(margin, {x: Rational(terms[0]), y: Rational(3.0 + 2.0**-50), z: Rational(u)}) for u in unit]
    assert found.all() and signs.tolist() == exact == [1, 0]


def test_numbers_that_are_too_long_are_left():
    """And are said to be."""
    values = {x: np.array([2.0**1000 + 2.0**960, 2.0]), y: np.array([2.0**-1000, 3.0])}
    signs, found = dyadic_signs(program_of(x**4 - y**4, {}), values, np.array([np.inf, 100.0]))
    assert found.tolist() == [False, True] and signs[1] == -1
