"""Initial value problems in floats: the field is the field, and a run goes on, back and stops as it says."""
import math
from fractions import Fraction
from importlib.util import find_spec

import draw
import numpy as np
import pytest
from hypothesis import given
from sympy import Rational, asin, besselj, cosh, exp, log, sin, sqrt, tan

import gyrostat as gs
from gyrostat.algebra.enclosures.arithmetic import in_arithmetic
from gyrostat.errors import AccuracyError, MissingExtraError, ScopeError
from gyrostat.trajectories.integrated.integrators import METHODS, RungeKutta, _compiled, beside, floats
from gyrostat.trajectories.periods import nearest

x, y = map(gs.symbol, ("x", "y"))
KINDS = ["DOP853", pytest.param("heyoka",
                                marks=pytest.mark.skipif(find_spec("heyoka") is None,
                                                         reason="heyoka is not installed"))]
EXPRESSIONS = [x**3 * y - 2 * y, (x + y) ** -2, sqrt(x) + y**Rational(-3, 2), exp(x * y) * sin(x) - cosh(y),
               log(x + 3) / tan(y),
               asin(x / 2) * sqrt(2)]


def run(kind, rates, start, tolerance=None):
    return METHODS[kind](tuple(rates), np.array(start), nearest, tolerance or METHODS[kind].FINE)


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_written_in_floats_is_the_expression(expression):
    """A written expression has the value that SymPy gives."""
    point = {x: Rational(3, 5), y: Rational(7, 4)}
    point_in = floats({x: lambda at: at[0], y: lambda at: at[1]}, nearest)
    value = in_arithmetic(expression, point_in)((0.6, 1.75))
    # a dozen roundings of numbers below 10
    assert abs(value - float(expression.xreplace(point))) < 1e-14


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_heyoka_integrates_the_expression(expression):
    """y′ = f(t, 7/4): the mean of f over a short time, to the third order by Simpson's rule."""
    pytest.importorskip("heyoka")
    start, h = 0.6, 0.01
    end = run("heyoka", [(x, Rational(1)), (y, expression.xreplace({y: Rational(7, 4)}))],
              [start, 0.0]).reach(np.array([h]))[0, 1]
    a, b, c = (float(expression.xreplace({x: Rational(start + step), y: Rational(7, 4)}))
               for step in (0, h / 2, h))
    # h⁵ f⁗ / 2880, f⁗ below 200
    assert abs(end - h * (a + 4 * b + c) / 6) < 1e-11


def test_code_is_compiled_once_for_one_form_of_equations():
    """Other numbers are other parameters of the same code, and each run is that of its own numbers."""
    pytest.importorskip("heyoka")
    _compiled.cache_clear()
    ends = {a: run("heyoka", [(x, a * y), (y, -x / a)], [0.0, 1.0]).reach(np.array([1.0]))[0]
            for a in (Rational(2, 3), Rational(5, 7), Rational(9, 4))}
    assert _compiled.cache_info().misses == 1
    for a, end in ends.items():                            # (a sin t, cos t)
        np.testing.assert_allclose(end, [float(a) * np.sin(1.0), np.cos(1.0)], rtol=0, atol=1e-15)


def test_what_is_not_elementary_is_refused():
    """A Bessel function and a power that is no number are named."""
    for expression in (besselj(0, x), 2**x):
        with pytest.raises(ScopeError, match="cannot be integrated"):
            in_arithmetic(expression, floats({x: lambda at: at[0]}, nearest))


@given(number=draw.numbers)
def test_roundings_agree_exactly_on_doubles(number):
    """The two roundings of a number are next to each other, and equal where it is a double."""
    one, other = nearest(Rational(number)), beside(Rational(number))
    assert other == (one if Fraction(one) == number else math.nextafter(one, math.inf))
    assert beside(sqrt(2)) > nearest(sqrt(2))


@pytest.mark.parametrize("kind", KINDS)
def test_a_run_goes_on_from_where_it_is(kind):
    """x″ = −x in pieces, in one go, and back from 0."""
    whole, pieces = (run(kind, [(x, y), (y, -x)], [0.0, 1.0]) for _ in range(2))
    times = np.array([0.0, 1.0, 2.5, 10.0])
    found = whole.reach(times)
    # 60 steps of 10⁻¹⁴
    np.testing.assert_allclose(found, np.stack([np.sin(times), np.cos(times)], axis=1), atol=1e-12)
    np.testing.assert_allclose(np.concatenate([pieces.reach(some)
                                               for some in (times[:1], times[1:3], times[3:])]), found,
                               atol=1e-12)
    assert 0 < pieces.steps and abs(pieces.time) <= 10
    pieces.restart()
    assert pieces.time == 0
    np.testing.assert_allclose(pieces.reach(-times), found * [-1, 1], atol=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_a_run_stops_where_the_field_is_singular(kind):
    """x′ = −1/x from 1 ends at t = 1/2: an error that says so, and after it the run can be used again."""
    falling = run(kind, [(x, -1 / x)], [1.0])
    with pytest.raises(AccuracyError, match=r"beyond t = 0\.(49999|5)"):
        falling.reach(np.array([0.25, 1.0]))
    assert falling.time == 0
    np.testing.assert_allclose(falling.reach(np.array([0.375]))[0], 0.5, atol=1e-12)    # √(1 − 2t)
    assert kind == "heyoka" or np.isnan(falling.field(0.0, np.zeros(1))).all()


def test_a_missing_package_is_named(monkeypatch):
    """Without SciPy the error has the command that installs it."""
    monkeypatch.setitem(__import__("sys").modules, "scipy.integrate", None)
    with pytest.raises(MissingExtraError, match=r"gyrostat\[trajectories\]"):
        RungeKutta(((x, x),), np.array([1.0]), nearest, 1e-9)
