"""Signs: exact for rational and algebraic numbers, proved or None for transcendental ones."""

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from sympy import Integer, Rational, atan, exp, log, pi, sqrt

from gyrostat.algebra.reals.exact import evaluate, sign, sign_of_constant
from gyrostat.notation import symbol

x, y = symbol("x"), symbol("y")
fractions = st.fractions(max_denominator=50, min_value=-9, max_value=9)


@given(fractions, fractions)
def test_rational_signs_are_those_of_fractions(a, b):
    """Sign and value of a fraction of polynomials, zero included, None where it is not defined."""
    f = (x**3 - 2 * x * y + 1) / (x - y)
    values = {x: Rational(a.numerator, a.denominator), y: Rational(b.numerator, b.denominator)}
    if a == b:
        assert sign(f, values) is None
    else:
        expected = (a**3 - 2 * a * b + 1) / (a - b)
        assert evaluate(f, values) == Rational(expected.numerator, expected.denominator)
        assert sign(f, values) == (expected > 0) - (expected < 0)


@given(st.integers(2, 40), st.integers(2, 40), st.integers(-3, 3))
def test_algebraic_zeros_are_found_and_near_misses_are_not(a, b, n):
    """√a √b − √(ab) is 0, and moved by 10⁻⁴⁰⁰ it has the sign of the move."""
    zero = sympy.Add(sqrt(a) + sqrt(b), -sqrt(a + b + 2 * sqrt(a * b)), evaluate=False)
    assert sign_of_constant(zero + n * Rational(1, 10**400)) == (n > 0) - (n < 0)


def test_zeros_that_do_not_simplify():
    """√(2 + √3) − (√6 + √2)/2 and ρ⁵ − ρ + 1 at a root ρ of x⁵ − x + 1."""
    root = sympy.CRootOf(x**5 - x + 1, 0)
    for hidden in (sqrt(2 + sqrt(3)) - (sqrt(6) + sqrt(2)) / 2, root**5 - root + 1):
        assert hidden != 0 and sign_of_constant(hidden) == 0


@pytest.mark.parametrize("zero", [
    sqrt(1 + sympy.cbrt(2)) * sqrt(1 + sympy.cbrt(3))
    - sqrt(sympy.expand((1 + sympy.cbrt(2)) * (1 + sympy.cbrt(3)))),
    1 / (sqrt(2) + sqrt(3) + sqrt(5) + sqrt(7)) - sympy.radsimp(1 / (sqrt(2) + sqrt(3) + sqrt(5) + sqrt(7))),
    sympy.cbrt(sqrt(5) + 2) - sympy.cbrt(sqrt(5) - 2) - 1, sqrt(2) ** 3 / 2 - sqrt(2)])
def test_separation_bounds(zero):
    """Zero where it is zero, and of the right sign at the least distance that the bound allows to be seen."""
    held = sympy.Add(zero, sqrt(2) - sympy.root(4, 4), evaluate=False)
    assert sign_of_constant(held) == 0
    assert sign_of_constant(zero + Rational(1, 10**5000)) == 1
    assert sign_of_constant(zero - sqrt(2) / 10**5000) == -1


def test_small_units_are_not_zero():
    """A unit of ℚ(√2, √3) with three conjugates of size 10²⁰ is itself 10⁻⁶⁰.

    Small beside its coefficients, and not 0.
    """
    unit = sympy.expand((sqrt(2) - 1) ** 52 * (sqrt(3) - sqrt(2)) ** 40 * (2 - sqrt(3)) ** 36)
    assert unit.is_Add and sign_of_constant(unit) == 1 and sign_of_constant(-unit) == -1


def test_transcendental_signs_are_proved():
    """e^π − π^e > 0, and a difference of 10⁻⁹⁹⁹ is still seen."""
    assert sign_of_constant(exp(pi) - pi**3) == -1
    assert sign_of_constant(exp(Integer(1)) - exp(1 - Rational(1, 10**999))) == 1
    assert sign(exp(x) - 3, {x: Integer(1)}) == -1


def test_what_cannot_be_proved_is_none():
    """A zero between numbers that have no normal form, a distance below 4096 bits, a root of a negative
    number.
    """
    third = Rational(1, 3)
    assert sign_of_constant(16 * atan(Rational(1, 5)) - 4 * atan(Rational(1, 239)) - pi) is None
    assert sign_of_constant(exp(third) - exp(third + Rational(1, 10**1500))) is None
    assert sign(sqrt(x), {x: Integer(-1)}) is None
    assert sign(log(x), {x: Integer(-1)}) is None
    assert sign(1 / x, {x: Integer(0)}) is None
