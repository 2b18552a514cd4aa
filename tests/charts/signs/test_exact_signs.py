"""Signs on a grid where floats say nothing: functions, constants, fractions, single points."""
import math
from fractions import Fraction

import numpy as np
import pytest
from charts.grid_signs import exactly, signs_of
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational, cos, exp, log, pi, sin, sqrt

import gyrostat as gs
from gyrostat.charts.signs import grid_signs as arraysigns
from gyrostat.charts.signs.grid_signs import PRECISION, UNKNOWN, ExactSign

x, y, z, b = map(gs.symbol, ("x", "y", "z", "b"))
BACKENDS = ["numpy", "numba"]


def test_functions_are_those_of_the_numbers_not_of_the_doubles():
    """exp(50 x) at x = 1/3, between the doubles next to it: the double next to x is off by more."""
    near = math.exp(50 / 3)
    values = {"x": np.array([Fraction(1, 3)] * 21), "y": near * (1 + np.arange(-10, 11) * 2.0**-52)}
    found = signs_of(exp(50 * x) - y, values)
    assert (found == exactly(exp(50 * x) - y, values)).all() and {-1, 1} == set(found.tolist())


def test_functions_of_which_few_digits_are_known():
    """log(1 + 4/3·2⁻¹²⁰), of which 128 bits leave eight, against doubles on both sides."""
    small = 2.0**-120 * 4 / 3
    values = {"x": np.ones(81), "y": np.full(81, small), "z": small * (1 + np.arange(-40, 41) / 8192)}
    assert (signs_of(log(x + y) - z, values) == exactly(log(x + y) - z, values)).all()


fractions = st.builds(lambda p, q, e: Fraction(p, q) * Fraction(2) ** e,
                      st.integers(-2**60, 2**60), st.integers(1, 2**60), st.integers(-80, 80))


@given(rows=st.lists(st.tuples(fractions, fractions), min_size=1, max_size=4), near=st.integers(-3, 3))
def test_signs_at_fractions_are_exact(rows, near):
    """At fractions that are no doubles, next to the zero of x y − z, the sign is that of the fractions, not
    of the doubles.
    """
    values = {name: np.empty(len(rows), dtype=object) for name in "xyz"}
    for n, (p, q) in enumerate(rows):
        values["x"][n], values["y"][n], values["z"][n] = p, q, p * q * (1 + Fraction(near, 2**60))
    assert (signs_of(x * y - z, values) == exactly(x * y - z, values)).all()


CONSTANTS = [sqrt(2), -sqrt(3), sqrt(2) - Rational(math.isqrt(2 << 120), 2**60),
             sqrt(2) - Rational(math.isqrt(2 << 250), 2**125),
             Rational(math.isqrt(2 << 250), 2**125) - sqrt(2),
             sqrt(2) + sqrt(3) - sqrt(5 + 2 * sqrt(6)),
             pi, exp(800), exp(-800), -exp(-800)]


@pytest.mark.parametrize("constant", CONSTANTS, ids=str)
def test_signs_at_constants(constant):
    """At roots and functions of numbers, of every size and however they cancel, signs are those of exact.py.
    """
    for expression in (x, x * y, x + y - 1, x**2 - y):
        for other in (1.0, -1.0, 0.0, 0.5):
            values = {"x": constant, "y": np.array([other, 2.0])}
            assert (signs_of(expression, values) == exactly(expression, values)).all()


@pytest.mark.parametrize("bits", [60, 100, 115, 120, 125, 128])
def test_constants_that_cancel_against_floats(bits):
    """x² − y at x = √2 − p/2ⁿ and at doubles y on both sides of x², however few digits 128 bits leave of x.
    """
    constant = sqrt(2) - Rational(math.isqrt(2 << 2 * bits), 2**bits)
    square = float((constant**2).evalf(60))
    values = {"x": constant, "y": np.array([square * (1 + n / 256) for n in range(-40, 41)])}
    assert (signs_of(x**2 - y, values) == exactly(x**2 - y, values)).all()


FUNCTIONS = [(exp(b * x) - y, {"b": [0.0, 1.0, 50.0, 700.0], "x": np.array([[-1.0], [0.0], [1.0]]),
                               "y": np.array([[[1.0]], [[math.e]]])}),
             (x * exp(50 * x) - y, {"x": np.linspace(-1, 1, 21), "y": np.linspace(-1, 1, 5)[:, None]}),
             (log(x) - y, {"x": [1.0, 2.0, 1e300, 5e-324], "y": [[0.0], [1.0]]}),
             (sqrt(x) - y, {"x": [4.0, 2.0, 0.0], "y": [[2.0], [0.0]]}),
             (sin(x) ** 2 + cos(x) ** 2 - y, {"x": [1.0, 3.0], "y": [[0.5], [2.0]]}),
             (sqrt(2) * x - y, {"x": [1.0, -1.0], "y": [[math.sqrt(2)]]}),
             (pi * x - y, {"x": [1.0], "y": [math.pi, math.nextafter(math.pi, 4), 0.0]}),
             (exp(x) * y - 1, {"x": [800.0, -800.0], "y": [1.0, 5e-324]})]


@pytest.mark.few(1)
@pytest.mark.parametrize(("expression", "values"), FUNCTIONS, ids=[str(e) for e, _ in FUNCTIONS])
@pytest.mark.parametrize("backend", BACKENDS)
def test_functions_are_enclosed(expression, values, backend):
    """Functions of numbers, overflowing and vanishing ones too, have the signs of exact.py."""
    assert (signs_of(expression, values, backend) == exactly(expression, values)).all()


def signed(expression, point):
    """The sign at one point."""
    exact = ExactSign(expression)
    return exact(tuple(point[s] for s in exact.symbols))


@pytest.mark.slow
@pytest.mark.parametrize(("expression", "point", "expected"), [
    (x - y, {x: 1.0, y: 1.0}, 0), (x - y, {x: 1.0, y: 1 + 2.0**-52}, -1), (x**2 - y, {x: sqrt(2), y: 2.0}, 0),
    (x**3 - y, {x: 1e200, y: 1e-300}, 1), (x * y - 1, {x: Rational(1, 3), y: 3.0}, 0),
    (x**2 - y**2, {x: 1 + 2.0**-52, y: 1.0}, 1), (x - y, {x: math.nan, y: 1.0}, UNKNOWN),
    (x - y, {x: math.inf, y: 1.0}, UNKNOWN), (x - y, {x: sqrt(2) + sqrt(3), y: sqrt(5 + 2 * sqrt(6))}, 0),
    ((x + y) ** 2 - z - 2 * y, {x: 1.0, y: 2.0**-100, z: 1.0}, 1),
    (z + 2 * y - (x + y) ** 2, {x: 1.0, y: 2.0**-100, z: 1.0}, -1),
    (exp(x) - y, {x: 0.0, y: 1.0}, 0), (x - y, {x: sqrt(2), y: Rational(math.isqrt(2 << 800), 2**400)}, 1),
    (x * 2**200 - y, {x: 1.0, y: Rational(2**200)}, 0)])
def test_exact_sign(expression, point, expected):
    """Balls, then rationals or more bits: 0 is found, neighbours of 0 are told from it."""
    assert signed(expression, point) == expected


def test_exact_sign_needs_rationals_only_near_zero(monkeypatch):
    """Where 128 bits tell the sign, no rational arithmetic is done."""
    monkeypatch.setattr(arraysigns, "to_flint", None)
    assert PRECISION == 128 and signed(x**2 - y, {x: 1 + 2.0**-52, y: 1.0}) == 1
