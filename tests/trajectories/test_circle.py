"""Cosine and sine from a table, against mpmath."""
import mpmath
import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from gyrostat.trajectories.circle import POINTS, circle


@settings(max_examples=200)
@given(x=st.floats(-8, 8))
def test_circle_is_cosine_and_sine(x):
    """To a unit in the last place of 1, and sin to full precision near 0; a number is its place in a row."""
    with mpmath.workdps(40):
        exact = mpmath.cos(2 * mpmath.pi * mpmath.mpf(x)), mpmath.sin(2 * mpmath.pi * mpmath.mpf(x))
        off = [float(abs(mpmath.mpf(float(a)) - b)) for a, b in zip(circle(np.float64(x)), exact)]
        small = abs(x) < 1 / (2 * POINTS)
        assert off[0] < 2.0**-52 and off[1] <= 1e-320 + 2.0**-51 * (float(abs(exact[1])) if small else 0.5)
    np.testing.assert_array_equal(np.array(circle(np.full(9, x))).T, [circle(np.float64(x))] * 9)


def test_quarters_of_a_turn_are_exact():
    """At n/4 both are 0 or ±1."""
    cosine, sine = circle(np.arange(-4, 5) / 4)
    np.testing.assert_array_equal(cosine, [1, 0, -1, 0, 1, 0, -1, 0, 1])
    np.testing.assert_array_equal(sine, [0, 1, 0, -1, 0, 1, 0, -1, 0])
