"""Recorded computations, repeated over arrays: the balls hold the exact values."""
from fractions import Fraction

import numpy as np
import pytest
from sympy import Symbol

from gyrostat.charts.signs.ball_arrays import BallArray
from gyrostat.charts.signs.recorded import Recorded, Recording

X, Y = Symbol("x"), Symbol("y")


def formula(x, y):
    """A computation with cancellation, constants that are no doubles, and divisions."""
    a = (x - y) * (x + y) / 3 - x * x / 3
    b = 1 / (x**2 + y**2 * Fraction(1, 7).denominator + 1)
    return [a * b**3 - x**4 * 5, a + y**2 / 3, (x - y) / (x * y + 5), 0 * x + 1 - x]


def recorded():
    recording = Recording()
    return recording.computation(formula(recording.leaf(X), recording.leaf(Y)))


def test_balls_hold_the_exact_values():
    """At random doubles, and at the corners of boxes about them, over more points than one block."""
    rng = np.random.default_rng(4)
    middles = rng.uniform(-2, 2, (2, 5000))
    for width in (0.0, 2.0**-20):
        leaves = {s: BallArray(x, np.full(x.shape, width)) for s, x in zip((X, Y), middles)}
        found = recorded().balls(leaves, 5000)
        for n in range(0, 5000, 97):
            for i, j in ((-1, 1), (1, 1), (1, -1), (0, 0)):
                x, y = (Fraction(float(m[n])) + side * Fraction(width) for m, side in zip(middles, (i, j)))
                for exact, ball in zip(formula(x, y), found):
                    assert abs(exact - Fraction(float(ball.middle[n]))) <= Fraction(float(ball.radius[n]))
    narrow = recorded().balls({s: BallArray(x) for s, x in zip((X, Y), middles)}, 5000)
    assert all((ball.radius < 1e-10).all() for ball in narrow)


def test_doubles_are_the_middles():
    """The same steps without bounds."""
    rng = np.random.default_rng(5)
    x, y = rng.uniform(-2, 2, (2, 100))
    program = recorded()
    for value, ball in zip(program.doubles({X: x, Y: y}), program.balls({X: BallArray(x), Y: BallArray(y)},
                                                                       100)):
        np.testing.assert_array_equal(value, ball.middle)


def test_equal_parts_and_constants_are_recorded_once():
    """Nothing is computed that is known: sums with 0, products with 0 and 1, fractions."""
    recording = Recording()
    x = recording.leaf(X)
    assert 0 * x == 0 and (x * 1).place == x.place and (x + 0).place == x.place and x - 0 != 0
    assert (x * x + 1).place == (1 + x**2).place
    assert (recording.constant(1) / 3 * 3 - 1) == 0 and isinstance(x, Recorded)
    assert [step[0] for step in recording.computation([x * 2]).steps] == ["leaf", "constant", "multiply"]


@pytest.mark.parametrize(("x", "sign"), [(2.0**-600, 0), (2.0**-400, 1), (-(2.0**-300), -1)])
def test_underflow_proves_nothing_that_is_false(x, sign):
    """x³ is below all doubles: where it underflows no sign is claimed, or the right one."""
    recording = Recording()
    number = recording.leaf(X)
    (cube,) = recording.computation([number**3 * 2**100]).balls({X: BallArray(np.array([x, 1.0]))}, 2)
    assert cube.sign()[0] in (0, np.sign(x)) and cube.sign()[1] == 1
    assert abs(Fraction(x)**3 * 2**100 - Fraction(float(cube.middle[0]))) <= Fraction(float(cube.radius[0]))


def test_what_may_be_zero_has_no_inverse():
    """The radius is infinite where the divisor may be 0, and where a number is not finite."""
    recording = Recording()
    program = recording.computation([1 / recording.leaf(X)])
    numbers = BallArray(np.array([1.0, 0.5, 0.0, np.nan]), np.array([1.0, 0.1, 0.0, 0.0]))
    (found,) = program.balls({X: numbers}, 4)
    assert found.sign().tolist() == [0, 1, 0, 0] and np.isinf(found.radius[[0, 2]]).all()
