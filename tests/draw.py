"""What hypothesis draws: fractions, never floats."""
from fractions import Fraction

from hypothesis import strategies as st

numbers = st.fractions(min_value=-5, max_value=5, max_denominator=8)
nonzero = numbers.filter(bool)
moments = st.fractions(min_value=Fraction(1, 8), max_value=5, max_denominator=8)


def _unit(t, flip):
    """Rational point of the circle: (sin, cos) of a tilt strictly between the poles."""
    s, c = 2 * t / (1 + t * t), (1 - t * t) / (1 + t * t)
    return (s, -c if flip else c)


tilts = st.builds(_unit, st.fractions(min_value=Fraction(1, 40), max_value=40, max_denominator=40),
                  st.booleans())
