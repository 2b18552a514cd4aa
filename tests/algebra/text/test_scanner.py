"""Plain numerals are read at once, and what is read at once the grammar reads in the same way."""
from fractions import Fraction

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from sympy import Rational, pi, srepr

from gyrostat.algebra.text import quantities
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.algebra.text.quantities import not_mixed, quantity
from gyrostat.algebra.text.scanner import SHORT, numeral
from gyrostat.errors import ExpressionError, ValuesError

DIGITS = st.text("0123456789", min_size=1, max_size=12)
SPACE = st.sampled_from(["", " ", "\t ", "\n"])
DECIMALS = st.one_of(DIGITS, st.tuples(DIGITS, DIGITS).map(".".join), DIGITS.map(lambda d: f"{d}."),
                     DIGITS.map(lambda d: f".{d}"))
EXPONENTS = st.one_of(st.just(""), st.tuples(st.sampled_from("eE"), st.sampled_from(["", "+", "-"]),
                                             st.integers(0, 99).map(str)).map("".join))
SIGNS = st.sampled_from(["", "+", "-"])
UNITS = st.sampled_from(["kg m^2", "rpm", "N·m", "e3", "E", "m0", "kg)", "deg/s", "pi", "furlong", "mN m s"])
SOUP = st.lists(st.sampled_from([
    *"0123456789+-*/.eE ()_^,", "\t", "\u00a0", "−", "²", "٣", "1_0", "0x1", "nan", "inf", "1e400", "e-99",
    "e100", "/0", "kg", " m", "rpm", "9" * 30]), max_size=8).map("".join)


def outcome(road, text):
    """What a road makes of a text: number and dimension, or why it refuses."""
    try:
        number, dimension = road(text)
    except ExpressionError as error:
        return str(error)
    return srepr(number), dimension


def by_grammar(text):
    return quantities._Quantity(text).quantity()


@pytest.mark.slow
@given(SPACE, SIGNS, SPACE, DECIMALS, EXPONENTS, SPACE)
@example("", "-", "", "0.50", "", "")
@example("", "", "", ".250", "e+1", "")
def test_a_numeral_is_the_fraction_that_python_reads(before, sign, between, decimal, exponent, after):
    """Fraction of the standard library reads the same numerals, without blanks after the sign."""
    number, rest = numeral(f"{before}{sign}{between}{decimal}{exponent}{after}")
    expected = Fraction(f"{sign}{decimal}{exponent}")
    assert rest == "" and type(number.p) is type(number.q) is int
    assert (number.p, number.q) == (expected.numerator, expected.denominator)
    assert srepr(number) == srepr(Rational(expected.numerator, expected.denominator))


@given(SIGNS, DECIMALS, SPACE, SPACE, st.integers(1, 10**9))
@example("-", "5", "", " ", 100)
def test_a_quotient_is_a_fraction(sign, decimal, before, after, divisor):
    """5/100 is 1/20, whatever stands around the stroke."""
    number, _ = numeral(f"{sign}{decimal}{before}/{after}{divisor}")
    assert Fraction(int(number.p), int(number.q)) == Fraction(f"{sign}{decimal}") / divisor


@given(st.one_of(SOUP, st.tuples(SIGNS, DECIMALS, EXPONENTS, SPACE, UNITS).map("".join)))
@example("5e123 kg")
@example("5e100")
@example("1.e-400")
@example("1/0")
@example("1/00 kg")
@example("0x10")
@example("5 e3")
@example("1/2/3")
@example("-0")
@example("1\u00a0")
def test_both_roads_read_the_same(text):
    """Number, dimension and refusal are those of the grammar for every text."""
    assert outcome(quantity, text) == outcome(by_grammar, text)


@pytest.mark.parametrize("text", [
    "1e100", "1/0", "0.0/0", "2*3", "1_0", "--1", "1/2/3", "1/-2", "1/2.5", "nan", "", ".", "e5", "٣",
    "1,5", "1\u00a0", "(1)", "5e123 kg", "1" * (SHORT + 1), "5 ²"])
def test_all_other_texts_are_left_to_the_grammar(text):
    """Whatever could be too long, divides by zero, or is no plain numeral."""
    assert numeral(text) is None


def test_a_unit_after_a_numeral_is_read_once():
    """The units that come again with other numbers are not parsed again."""
    quantities.units_in.cache_clear()
    for n in range(5):
        assert quantity(f"{n}.5 rpm")[0] == Rational(2 * n + 1, 2) * pi / 30
    assert quantities.units_in.cache_info()[:2] == (4, 1)


def test_a_text_is_read_once(monkeypatch):
    """A check of units and the number after it share what was read, also of an expression."""
    read = []
    whole = quantities._Quantity.quantity
    monkeypatch.setattr(quantities._Quantity, "quantity", lambda self: read.append(self.text) or whole(self))
    quantity.cache_clear()
    given = {"I1": "sqrt(2) + 3/7", "l": "sqrt(3)"}
    not_mixed(given.items())
    for name, text in given.items():
        exact_number(text, name)
    assert read == list(given.values())


def test_the_refusals_of_short_numbers_stay():
    """A name, a wrong dimension and a mixture are refused as before."""
    with pytest.raises(ValuesError, match="is a number of kg"):
        exact_number("5 kg", "I1")
    with pytest.raises(ValuesError, match="contains the names x"):
        exact_number("x", "I1")
    with pytest.raises(ValuesError, match="I1 = '5 kg m.2' has a unit and l = '3' has none"):
        not_mixed([("l", "3"), ("I1", "5 kg m^2")])
