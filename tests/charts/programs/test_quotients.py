"""Programs of named fractions: without division, with the sign of the fraction."""
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.charts.programs.straightline import program_of, programs_of

I1, x, y, z, a, b, c, d, e = map(gs.symbol, ("I1", "x", "y", "z", "a", "b", "c", "d", "e"))
fractions = st.fractions(-4, 4, max_denominator=9)
moments = st.fractions(Rational(1, 8), 4, max_denominator=9)


class Numbers:
    """Named numbers by a function of three others and a moment, in any arithmetic."""

    def __init__(self, *formulas):
        self.formulas = formulas

    def values(self, number):
        given = map(number, (x / (1 + x**2), y**2 / I1 - z / 2, (x - 2 * z) / (y - x), 3 + x**2))
        return dict(zip((a, b, c, d, e), (f(*values) for values in [[*given]] for f in self.formulas)))


NAMED = Numbers(lambda p, q, r, s: p * q - r, lambda p, q, r, s: (p + r) / s - q**2 / 3,
                lambda p, q, r, s: (p + r) / s - (r + p) / s, lambda p, q, r, s: 5 * p**2 - p * p * 4 - p**2,
                lambda p, q, r, s: -q / (s * s) + (1 - p) * Fraction(2, 7) - s * r)


def sign(value):
    return (value > 0) - (value < 0)


def run(program, numbers):
    results = program.run(lambda leaf: numbers[leaf], lambda k: Fraction(int(k.p), int(k.q)))
    return [results[place] for place in program.results]


@given(numbers=st.tuples(fractions, fractions, fractions), moment=moments)
def test_signs_are_those_of_the_fractions(numbers, moment):
    """Whatever is taken out of sums, and also where two names give a margin together."""
    here = dict(zip((x, y, z, I1), (*numbers, moment)))
    if here[x] == here[y]:
        return

    def value(expression):
        exact = expression.subs({s: Rational(v.numerator, v.denominator) for s, v in here.items()})
        return Fraction(int(exact.p), int(exact.q))

    exact = NAMED.values(value)
    margins = {a: exact[a], b: exact[b], a**2 - 4 * b: exact[a]**2 - 4 * exact[b],
               e * a - x: exact[e] * exact[a] - here[x], x * y - 1: here[x] * here[y] - 1}
    found = run(programs_of(tuple(margins), {}, NAMED), here)
    assert list(map(sign, found)) == list(map(sign, margins.values()))
    assert run(programs_of((c, d), {}, NAMED), here) == [0, 0]
    for margin, expected in margins.items():
        assert sign(run(program_of(margin, {}, NAMED), here)[0]) == sign(expected)


def test_coefficients_are_whole():
    """Fractions are taken out with the denominators, so that doubles are decided in whole numbers."""
    steps = programs_of((a, b, e, a**2 - 4 * b), {}, NAMED).steps
    assert all(step.value.is_Integer for step in steps if step.operation == "constant")
    assert all(step.value.is_Symbol for step in steps if step.operation == "leaf")


def test_a_denominator_of_any_sign_is_squared():
    """Of x/(y − x) the numerator alone has another sign where y < x; the square of y − x has none."""
    named = Numbers(lambda p, q, r, s: r)
    for here in ({x: 1, y: 3, z: 0}, {x: 3, y: 1, z: 0}):
        assert sign(run(program_of(a, {}, named), here)[0]) == sign(Fraction(here[x], here[y] - here[x]))


def test_margins_share_their_steps():
    """A number that differs from another by a positive factor is the same step."""
    named = Numbers(lambda p, q, r, s: 7 * p, lambda p, q, r, s: 3 * p / s, lambda p, q, r, s: p / s / s)
    program = programs_of((a, b, c), {}, named)
    assert len(set(program.results)) == 1
    alone = program_of(b, {}, named)
    assert len(alone.steps) == len(program.steps)
    assert alone.needed(alone.outcomes) == {*range(len(alone.steps))}


def test_what_is_no_polynomial_in_named_numbers_is_refused():
    with pytest.raises(TypeError, match="no polynomial in named numbers"):
        program_of(gs.symbol("sigma") + sqrt(a), {}, NAMED)
