"""Enclosures contain what they enclose, and fractions describe them exactly."""
from fractions import Fraction

import pytest
import sympy
from flint import arb
from sympy import Rational, exp, pi, sin, sqrt

from gyrostat.algebra.enclosures.balls import ball, dyadic, fraction_of, interval
from gyrostat.algebra.enclosures.precision import own_precision
from gyrostat.algebra.reals.exact import ALGEBRAIC_LIMIT
from gyrostat.errors import GyrostatError
from gyrostat.notation import symbol

x = symbol("x")


@pytest.mark.parametrize("f", [exp(x) / 3 + sin(x) * pi, sqrt(x) ** 3 + x ** Rational(1, 5),
                               sympy.atan(x) - sympy.tanh(x) ** 2])
def test_balls_enclose_the_value(f):
    """The enclosure contains the value mpmath finds with 50 digits."""
    value = f.subs(x, Rational(7, 5))
    enclosure, reference = ball(value, 100), Rational(value.evalf(50))
    centre, radius = (Fraction(int(part.fmpq().p), int(part.fmpq().q))
                      for part in (enclosure.mid(), enclosure.rad()))
    assert abs(centre - Fraction(int(reference.p), int(reference.q))) <= radius + Fraction(1, 10**45)


def test_fractions_of_balls():
    """Of a ball without a radius the number itself; of an interval both ends; near an enclosed number one."""
    low, high = Fraction(-1, 3), Fraction(5, 7)
    with own_precision(64):
        between = interval(low, high)
        assert fraction_of(arb(3) / 8) == Fraction(3, 8)
        assert fraction_of(between.lower()) <= low and high <= fraction_of(between.upper())
        assert interval(low).contains(interval(low).mid())
        small = Fraction(1, 1000)
        assert abs(dyadic(interval(high), small) - high) < small and dyadic(between, small) is None


def test_bits_that_a_sign_may_take():
    """As many as the sign of an algebraic number asks for, and eight times more; not any number."""
    with own_precision(8 * ALGEBRAIC_LIMIT):
        assert arb(1) / 3 < 1
    for bits in (1, 2**24 + 1, 53.0, True, "53"):
        with pytest.raises(GyrostatError, match="number from 2 to 2²⁴: give 53"), own_precision(bits):
            pass
