"""Numbers in one form: exact if short, otherwise digits that are those of the number."""
import re
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import CRootOf, Float, Integer, Pow, Rational, Symbol, nan, oo, pi, rootof, sqrt
from sympy.parsing.sympy_parser import implicit_multiplication, parse_expr, standard_transformations

from gyrostat.printing.formats.latex import tex
from gyrostat.printing.formats.latex_names import Names
from gyrostat.printing.formats.text import number_text
from gyrostat.printing.numbers import number

x = Symbol("x", real=True)
SURDS = st.builds(lambda a, b, n: a + b * sqrt(n), st.fractions(-9, 9, max_denominator=99).map(Rational),
                  st.fractions(-9, 9, max_denominator=99).map(Rational), st.integers(2, 999))
ROOTS = st.builds(lambda a, n: CRootOf(x**3 - 3 * x + Rational(a), n), st.integers(-1, 1), st.integers(0, 2))
NUMBERS = st.one_of(st.fractions().map(Rational), SURDS, ROOTS, st.builds(lambda r, n: r * 10**n, SURDS,
                    st.integers(-20, 20)), ROOTS.map(lambda r: r**2 + pi), SURDS.map(lambda s: s.evalf(30)))
MATHEMATICS = (*standard_transformations, implicit_multiplication)
SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


def read(decimal):
    """The number that a decimal stands for, and one unit of its last digit."""
    mantissa, _, power = decimal.replace("−", "-").partition("·10")
    scale = Fraction(10) ** int(power.translate(SUPERSCRIPTS) or 0)
    digits = mantissa.rstrip("…")
    places = len(digits.partition(".")[2])
    return Fraction(digits) * scale, scale / 10**places


@pytest.mark.parametrize(("value", "said"), [
    (Rational(1, 2), "1/2"), (Rational(-9, 2), "−9/2"), (Integer(0), "0"), (Rational(5, 12), "5/12"),
    (Rational(1234567, 10**6), "1.234567"), (Rational(0.1), "0.100000…"), (Integer(10) ** 35, "1·10³⁵"),
    (sqrt(3) / 4, "√3/4 ≈ 0.4330"), (Rational(3, 4) - sqrt(129) / 12, "3/4 − √129/12 ≈ −0.1965"),
    (100 * pi, "100 π ≈ 314.2"), (sqrt(2) / 10**9, "√2/1000000000 ≈ 1.414·10⁻⁹"),
    (Pow(2, Rational(1, 3)), "2^(1/3) ≈ 1.260"),
    (rootof(x**3 - 3 * x + 1, 0), "−1.87938… (root of x³ − 3 x + 1)"),
    (rootof(x**3 - 3 * x + 1, 0) ** 2, "3.53208…"), (Float("0.25", 20), "0.250000…"),
    (oo, "infinite"), (nan, "undefined")])
def test_a_number_of_each_kind(value, said):
    """Exact and short; a decimal; exact with a decimal; first digits, of a root with its polynomial."""
    assert number_text(value) == said


@given(value=NUMBERS)
def test_what_is_printed_is_true_and_readable(value):
    """The exact form is the number; digits before … are those of the number, those after ≈ are the nearest.

    No name of SymPy is printed, and ≈ stands beside no rational number.
    """
    said = number_text(value)
    assert not re.search("sqrt|Root|[*]|E|[.] ", said) and len(said) <= 60
    exact, near, decimal = said.partition(" ≈ ")
    if not near and "…" not in said and "." not in said and "·" not in said:
        assert Rational(said.replace("−", "-")) == value
        return
    written, unit = read((decimal or said).partition(" (")[0])
    off = abs(Rational(written) - value)
    if near:
        assert not value.is_rational and 2 * off <= Rational(unit) * (1 + Rational(1, 10**9))
        typed = re.sub("√(\\d+)", r"sqrt(\1)", exact).replace("−", "-").replace("π", "pi")
        assert parse_expr(typed, transformations=MATHEMATICS) == value
    elif "…" in said:
        assert off < Rational(unit) and abs(Rational(written)) <= abs(value)
    else:
        assert off == 0


def test_latex_has_the_same_digits():
    """In LaTeX the signs are commands."""
    names = Names()
    assert tex(number(sqrt(3) / 4), names) == r"\frac{\sqrt{3}}{4} \approx 0.4330"
    assert tex(number(rootof(x**3 - 3 * x + 1, 0)), names) == (
        r"-1.87938\dots \; (\text{root of } x^{3} - 3 x + 1)")
    assert tex(number(rootof(x**3 - 3 * x + 1, 0) * 10**9), names) == r"-1.87938\dots \cdot 10^{9}"
