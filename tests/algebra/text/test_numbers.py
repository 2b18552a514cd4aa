"""The whitelist grammar: what it reads is right, everything else is a clear error at once."""
import contextlib
import math
import re
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import example, given
from hypothesis import strategies as st
from sympy import Expr, Rational, Symbol

from gyrostat.algebra.text.bounded_parts import FUNCTIONS
from gyrostat.algebra.text.grammar import parse
from gyrostat.algebra.text.numbers import exact_expression, exact_number
from gyrostat.errors import ExpressionError, ValuesError
from gyrostat.notation import symbol

LEAVES = st.one_of(st.integers(0, 99).map(str), st.decimals(0, 9, places=2).map(str),
                   st.sampled_from(["x", "y", "k3"]))


def _grow(inner):
    return st.one_of(st.tuples(inner, st.sampled_from(["+", "-", "*", "/"]),
                               inner).map(lambda t: f"({t[0]} {t[1]} {t[2]})"),
                     inner.map(lambda t: f"-{t}"),
                     st.tuples(inner, st.integers(0, 3)).map(lambda t: f"({t[0]})**{t[1]}"),
                     st.tuples(inner, inner).map(lambda t: f"{t[0]} - {t[1]}"),
                     st.tuples(inner, inner).map(lambda t: f"{t[0]}*{t[1]}"))


def python_value(text, values):
    """The text as Python reads it, every number a Fraction; None where it divides by zero."""
    exact = re.sub(r"(?<![A-Za-z_0-9.])(\d+(?:\.\d+)?)", r"Fraction('\1')", text)
    try:
        return eval(exact, {"Fraction": Fraction, "__builtins__": {}}, values)
    except ZeroDivisionError:
        return None


@pytest.mark.slow
@given(st.recursive(LEAVES, _grow, max_leaves=8))
def test_arithmetic_is_what_python_makes_of_it(text):
    """Precedence, associativity and signs are Python's, on exact numbers."""
    values = {"x": Fraction(2, 3), "y": Fraction(-7, 5), "k3": Fraction(1, 4)}
    expected = python_value(text, values)
    try:
        ours = parse(text).subs({symbol(n): Rational(v.numerator, v.denominator) for n, v in values.items()})
    except ExpressionError as error:
        assert "divides by zero" in str(error)         # such as x/(y - y)
    else:
        assert expected is None or ours == Rational(Fraction(expected).numerator,
                                                    Fraction(expected).denominator)


@pytest.mark.slow
@given(st.text(max_size=60))
@example("().__class__.__bases__[0]")
@example("𝟙+1")
@example("1" + "+1" * 3000)
def test_any_text_is_an_expression_or_a_clear_error(text):
    """Fuzz: parse returns an expression or raises ExpressionError, nothing else."""
    try:
        assert isinstance(parse(text), Expr)
    except ExpressionError as error:
        assert "cannot read" in str(error) or "longer than" in str(error)


@given(st.lists(st.sampled_from([*"()+-*/. 0123456789", "**", "k3", "x", "exp", "sqrt", "sin", "log", "9**",
                                 "e5", "pi", "_", "__"]),
                max_size=25).map("".join))
def test_token_soup_is_an_expression_or_a_clear_error(text):
    """Fuzz in the alphabet of the grammar, where the deep cases are."""
    with contextlib.suppress(ExpressionError):
        assert isinstance(parse(text), Expr)


@pytest.mark.parametrize("text", [
    "9**9**9", "9**-9**9", "(1+k3)**101", "(x+y+k3+1)**40", "((x+1)**50)**50", "10**99**2", "1e999999999",
    "9" * 1000, "(" * 500,
    "exp(exp(exp(exp(exp(k3)))))", "sin(" * 60 + "k3" + ")" * 60, "2**(1/999983)", "k3**0.123456789",
    "x*" * 3000 + "x",
    "-" * 3000 + "1", "1" + " " * 10**6, "+".join(f"sin({i}*k3)" for i in range(99)),
    "(((((2**99)**99)**99)**99)**99)",
    "1/3**100/7**100*11**100/13**100"
    "/17**100*19**100*23**100*29**100*31**100*37**100*41**100*43**100*47**100*53**100*59**100*61**100"])
def test_input_made_to_be_slow_is_refused(text):
    """Each of these would hang or fill the memory if it were computed."""
    with pytest.raises(ExpressionError):
        parse(text)


@pytest.mark.parametrize(("text", "hint"), [
    ("__import__('os').system('true')", "grammar"), ("k3.__class__", "grammar"), ("lambda: 1", "grammar"),
    ("k3[0]", "grammar"),
    ("k3 if k3 else 1", "operator"), ("f(k3)", "functions are"), ("k3 m0", "write *"), ("", "too early"),
    ("(k3", "closing"),
    ("k3)", "operator"),
    ("2 k3", "operator"), ("sqrt", "argument"), ("sqrt k3", "argument"), ("1/0", "zero"),
    ("1/(2-2)", "zero"), ("sqrt(-1)", "real"),
    ("log(0)", "real"), ("k3**k3", "exp"), ("sin(1, 2)", "grammar"), ("'k3'", "grammar"),
    ("k3;k3", "grammar"),
    ("exp()", "number or a name"),
    ("(-8)**(1/3)", "real"), ("１２", "grammar"), ("٣", "grammar")])
def test_errors_say_what_to_do(text, hint):
    """What was given, why it is impossible, what to do."""
    with pytest.raises(ExpressionError, match="cannot read") as error:
        parse(text)
    assert hint in str(error.value)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_elementary_functions_are_read(name):
    """Each function of the grammar is SymPy's."""
    x = 1.5 if name == "acosh" else 0.5
    assert math.isclose(parse(f"{name}({x})").evalf(), getattr(math, name)(x))


def test_numbers_are_exact():
    """Decimals are the fractions they denote, floats the dyadic rationals they are."""
    assert parse("0.1") == Rational(1, 10)
    assert parse("1.25e-2") == Rational(1, 80)
    assert parse(".5") == Rational(1, 2)
    assert exact_number(0.1) == Rational(*(0.1).as_integer_ratio()) != Rational(1, 10)
    assert (
        exact_number(Decimal("0.1"))
        == exact_number("1/10")
        == exact_number(Fraction(1, 10))
        == Rational(1, 10)
    )
    assert exact_number(np.float64(0.1)) == exact_number(0.1) and exact_number(np.int32(7)) == 7
    assert exact_number(np.float32(0.1)) == exact_number(float(np.float32(0.1)))
    assert exact_number("sqrt(3)/2") == sympy.sqrt(3) / 2
    assert exact_number(sympy.Float("0.1")) == exact_number(0.1)


def test_decimals_are_no_longer_than_texts():
    """10^999999999 is refused at once, as the text is."""
    assert exact_number(Decimal("-1.5E-7")) == Rational(-3, 20000000)
    with pytest.raises(ExpressionError, match="too long"):
        exact_number(Decimal("1e999999999"))


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, np.nan, True, None, 1j, [1], "x + 1",
                                   Symbol("x"), sympy.oo, sympy.nan,
                                   sympy.I, Decimal("NaN"), Decimal("Infinity"), {}])
def test_what_is_no_exact_real_number_is_refused(value):
    """The message names the value and asks for a number."""
    with pytest.raises(ValuesError, match="I1 = .*give"):
        exact_number(value, "I1")


def test_floats_inside_expressions_become_exact():
    """0.5*k3 is k3/2."""
    assert exact_expression(0.5 * Symbol("k3")) == symbol("k3") / 2


@pytest.mark.parametrize("value", [1 << 2**18, Rational(1, 1 << 2**18), mpmath.ldexp(1, 10**9),
                                   sympy.Float(2) ** -(2**18)], ids=range(4))
def test_numbers_of_python_are_bounded_too(value):
    """Their digits would not be printed, or not even be made."""
    with pytest.raises(ValuesError, match="too long"):
        exact_number(value, "l")
