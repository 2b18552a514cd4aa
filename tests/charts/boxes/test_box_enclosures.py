"""Enclosures of expressions: they contain the exact value, and are not much wider than they must be."""
import math
from fractions import Fraction

import numpy as np
import pytest
from charts.inside import arrays, between, contains
from draw import moments, nonzero, numbers
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import (
    Integer,
    Rational,
    S,
    acos,
    acosh,
    asin,
    asinh,
    atan,
    atanh,
    cos,
    cosh,
    exp,
    log,
    pi,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,
)

import gyrostat as gs
from gyrostat.algebra.reals.exact import evaluate
from gyrostat.charts.boxes.box_enclosures import derivative, enclosure, sharpened
from gyrostat.charts.boxes.intervals import Enclosure

x, y = gs.symbol("x"), gs.symbol("y")
shares = st.fractions(min_value=0, max_value=1, max_denominator=8)


FUNCTIONS = [exp(50 * x), exp(-x * y), log(x + 6), sin(3 * x), cos(x - y), tan(x), asin(x / 6), acos(x / 6),
             atan(x), sinh(x), cosh(x),
             tanh(x), asinh(x), acosh(x + 7), atanh(x / 6), sqrt(x + 6), (x + 6) ** Rational(3, 2),
             (x + 6) ** Rational(-1, 2),
             (x + 6) ** Rational(1, 3), 1 / (x + 6) ** 3, exp(sqrt(x**2 + 1)) * sin(x) + pi * x,
             1 / (1 + exp(x))]


@pytest.mark.few(1)
@pytest.mark.parametrize("function", FUNCTIONS, ids=str)
@given(a=st.tuples(numbers, numbers).map(sorted), b=st.tuples(numbers, numbers).map(sorted), s=shares,
       t=shares)
@settings(max_examples=8)
def test_functions_contain_the_exact_value(function, a, b, s, t):
    """f at rational points of a box lies in the enclosure of f on the box, natural and by the mean value."""
    ends = [tuple(map(float, pair)) for pair in (a, b)]
    box = dict(zip((x, y), arrays(*ends)))
    natural = enclosure(function, box)
    slopes = {name: enclosure(derivative(function, name), box) for name in function.free_symbols}
    with np.errstate(all="ignore"):
        sharp = sharpened(function, natural, box, slopes)
    value = evaluate(function, {x: between(ends[0], s), y: between(ends[1], t)})
    assert contains(natural, value) and contains(sharp, value)


@pytest.mark.parametrize("function, low, high", [
    (log(x), 0, 1), (log(x), -1, 1), (sqrt(x), -1, 1), (sqrt(x), -2, -1), (x ** Rational(1, 3), -8, -1),
    (tan(x), 1, 2), (1 / x, -1, 1),
    (asin(x), 0, 2), (acosh(x), 0, 2), (atanh(x), 0, 1), (exp(x), 0, math.inf), (S.NaN, 0, 1),
    (abs(x), 0, 1)],
    ids=str)
def test_the_whole_line_where_nothing_is_known(function, low, high):
    """Outside of a domain, at a pole, of a function that is not known."""
    bounds = enclosure(function, dict(zip([x], arrays((low, high)))))
    assert (np.min(bounds.low), np.max(bounds.high)) == (-math.inf, math.inf)


def test_slopes_are_not_used_where_the_function_is_not_defined():
    """log has the slope 1/x on (-2, -1) too, and √x no bounded slope at 0."""
    for function, low, high in ((log(x), -2, -1), (sqrt(x), 0, 1)):
        box = dict(zip([x], arrays((low, high))))
        natural = enclosure(function, box)
        with np.errstate(all="ignore"):
            sharp = sharpened(function, natural, box, {x: enclosure(derivative(function, x), box)})
        assert (sharp.low[0], sharp.high[0]) == (natural.low[0], natural.high[0])
    box, unknown = {x: arrays((1, 2))[0]}, arrays((-math.inf, math.inf))[0]
    with np.errstate(all="ignore"):
        sharp = sharpened(log(x), unknown, box, {x: enclosure(1 / x, box)})
    assert (sharp.low[0], sharp.high[0]) == (-math.inf, math.inf)


def test_the_middle_of_a_box_lies_in_it():
    """The mean value form of √x at the least subnormal number, half of which is 0."""
    box = {x: arrays((5e-324, 5e-324))[0]}
    sharp = sharpened(sqrt(x), enclosure(sqrt(x), box), box, {x: enclosure(derivative(sqrt(x), x), box)})
    assert contains(sharp, sqrt(Rational(*5e-324.as_integer_ratio())))


@pytest.mark.slow
@given(I1=moments, I3=moments, l=numbers, omega=nonzero, k3=numbers, u=numbers,
       widths=st.lists(shares, min_size=6, max_size=6),
       place=st.lists(shares, min_size=6, max_size=6), power=st.sampled_from([0, -40, -480, 480]))
def test_margins_contain_their_exact_values(e1, e3, I1, I3, l, omega, k3, u, widths, place, power):
    """Margins of E1 and E3 at corners and rational points of boxes, at scales up to those that underflow and
    overflow.
    """
    names = ("I1", "I3", "l", "omega", "k3", "d2U")
    centres = dict(zip(names, (I1, I3, l, omega, k3, u)))
    ends = {}
    for name, width in zip(names, widths):
        scaled = centres[name] * Fraction(2) ** power, (centres[name] + width) * Fraction(2) ** power
        ends[name] = tuple(map(float, scaled))
    ends["pi3_0"], ends["dU"] = ends["omega"], ends["d2U"]
    for margin in (e1.sufficient.alternatives[0][0].margin, e3.sufficient.alternatives[0][0].margin):
        symbols = sorted(margin.free_symbols, key=str)
        box = dict(zip(symbols, arrays(*(ends[s.name] for s in symbols))))
        natural = enclosure(margin, box)
        slopes = {s: enclosure(derivative(margin, s), box) for s in symbols}
        with np.errstate(all="ignore"):
            sharp = sharpened(margin, natural, box, slopes)
        for shares_of in (place, map(round, place)):
            value = evaluate(margin, {s: between(ends[s.name], share)
                                      for s, share in zip(symbols, shares_of)})
            assert contains(natural, value) and contains(sharp, value)


def test_the_mean_value_form_is_of_second_order(e3):
    """Half the width of the box.

    A quarter of the excess over the range, a half with the natural enclosure.
    """
    margin = e3.sufficient.alternatives[0][0].margin
    centre = {"I1": 1.0, "I3": 0.5, "l": 1.0, "omega": 0.75, "k3": 0.25, "d2U": -2.0}
    excess = {}
    for width in (2.0**-8, 2.0**-9):
        box = {gs.symbol(n): Enclosure(np.array([c - width]), np.array([c + width]))
               for n, c in centre.items()}
        natural = enclosure(margin, box)
        sharp = sharpened(margin, natural, box, {s: enclosure(derivative(margin, s), box) for s in box})
        numbers = {gs.symbol(n): Rational(c) for n, c in centre.items()}
        # of first order the range
        flat = sum(abs(float(evaluate(derivative(margin, s), numbers))) for s in box) * 2 * width
        excess[width] = [float(b.high[0] - b.low[0]) - flat for b in (natural, sharp)]
    (natural, sharp), (half, quarter) = excess.values()
    assert 1.9 < natural / half < 2.2 and 3.8 < sharp / quarter < 4.2      # the limits are 2 and 4


def test_each_interval_is_enclosed_on_its_own():
    """Arrays of boxes give what the boxes give one by one, repeated intervals included."""
    low, high = np.array([0.0, 0.5, 0.0, -1.0]), np.array([1.0, 0.75, 1.0, 2.0])
    together = enclosure(exp(x) * x - Integer(1), {x: Enclosure(low, high)})
    for n in range(4):
        alone = enclosure(exp(x) * x - Integer(1), {x: Enclosure(low[n:n + 1], high[n:n + 1])})
        assert (together.low[n], together.high[n]) == (alone.low[0], alone.high[0])


def test_exact_bounds_of_a_polynomial_are_not_moved():
    """1 − k3² is at most 0 where k3 ≥ 1."""
    k3 = gs.symbol("k3")
    assert enclosure(1 - k3**2, {k3: arrays((1, 2))[0]}).high[0] == 0
