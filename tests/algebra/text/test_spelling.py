"""Texts as papers and the library's own output write them."""
import pytest
from sympy import Rational, pi, sqrt

from gyrostat.algebra.text.grammar import parse
from gyrostat.algebra.text.inputs import is_name, name_of
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.algebra.text.spelling import RELATIONS, SIGNS, spelled
from gyrostat.errors import ExpressionError
from gyrostat.notation import NOTATION, jet_name, symbol
from gyrostat.printing.formats.latex_names import Names
from gyrostat.printing.formats.unicode import unicode
from gyrostat.published.checks.comparisons import comparisons
from gyrostat.published.language import read
from gyrostat.published.printed_latex import formula_of
from gyrostat.typesetting import GREEK, typeset

m0, k3, I1, l, spin = map(symbol, ("m0", "k3", "I1", "l", "pi3_0"))


@pytest.mark.parametrize("name", NOTATION)
def test_every_symbol_is_read_as_it_is_printed(name):
    """And as it is named; derivatives of U with the argument that they are printed with."""
    for shown in (NOTATION[name].text, typeset(name, style="text"), name):
        assert spelled(shown) == name and parse(shown) == symbol(name)


@pytest.mark.parametrize(("order", "axes"), [(4, ""), (12, ""), (1, "1"), (2, "13"), (3, "223")])
def test_every_derivative_is_read_as_it_is_printed(order, axes):
    """U⁽⁴⁾(k₃), ∂₁₃U."""
    name = jet_name(order, axes)
    assert parse(typeset(name, style="text")) == symbol(name)


@pytest.mark.parametrize("word", sorted(set(GREEK) - {"lambda", "pi", "delta"}))
def test_greek_parameters_are_read_as_they_are_printed(word):
    """With a number and a subscript too; π is a number, λ the eigenvalue, δ a variation."""
    for name in (word, f"{word}3", f"{word}_b"):
        assert parse(typeset(name, style="text")) == symbol(name)


@pytest.mark.parametrize(("text", "value"), [
    ("m0*k3^2", m0 * k3**2), ("k3^2^3", k3**8), ("-k3^2", -k3**2), ("k3^-1", 1 / k3), ("k3^(1/2)", sqrt(k3)),
    ("2*k3^2*m0", 2 * k3**2 * m0),
    ("m₀·k₃ − k₃²/2", m0 * k3 - k3**2 / 2), ("m₀⋅k₃", m0 * k3), ("k₃⁻¹²", k3**-12), ("(π₃⁰)²", spin**2),
    ("√2·k₃", sqrt(2) * k3), ("√k₃", sqrt(k3)), ("√(1 − k₃²)", sqrt(1 - k3**2)), ("√(k₃ + 1)²", k3 + 1),
    ("ω_a", symbol("omega_a")), ("π/2", pi / 2), ("ϑ + µ", symbol("theta") + symbol("mu"))])
def test_powers_roots_and_signs_are_read(text, value):
    """^ is ** in value and order; superscripts bind as closely as they are printed."""
    assert parse(text) == value


def test_a_formula_that_is_printed_is_read_back():
    """With * between the factors, which the text leaves out."""
    margin = (spin + l)**2 - 4 * I1 * m0
    assert unicode(margin) == "(π₃⁰ + l)² − 4 I₁ m₀"
    assert parse("(π₃⁰ + l)² − 4·I₁·m₀") == margin
    with pytest.raises(ExpressionError, match=r"write \* between factors"):
        parse(unicode(margin))


@pytest.mark.parametrize(("text", "said"), [
    ("к3*m0", r"'к' \(CYRILLIC SMALL LETTER KA\) at character 1 is not part"),
    ("m0*k3*А", r"'А' \(CYRILLIC CAPITAL LETTER A\) at character 7"),
    ("k3 × 2", "MULTIPLICATION SIGN"), ("½*k3", "VULGAR FRACTION"),
    ("k3\u200b", r"'\\u200b' \(ZERO WIDTH SPACE"),
    ("k₃⁰", "the superscript ⁰ is no exponent; write π₃⁰ as pi3_0"),
    ("π₃⁰²", "superscript ⁰² is no exponent"),
    ("k3⁻", "superscript ⁻ is no exponent"), ("k3²^3", "a power follows"), ("k₃²³⁰", "230 is too large"),
    ("k3" + "²" * 500, "too long"),
    ("√k₃²", "what is under √ is not clear"), ("√sin(k3)", "not clear"), ("√√2", "stands before no name"),
    ("√", "stands before no name"), ("αβ", "write \\* between factors"), ("2π", "between factors"),
    ("k3(1 - k3)", r"write k3\*\(\.\.\.\) for a product"), ("k3^^2", "'\\*\\*' stands where")])
def test_what_is_not_clear_is_refused(text, said):
    """Look-alikes by name, and what could be read in two ways."""
    with pytest.raises(ExpressionError, match=said) as error:
        parse(text)
    assert str(error.value).isprintable() and len(str(error.value)) < 500


def test_each_sign_has_one_meaning():
    """What a sign is read as is ASCII, and no other sign of the table."""
    assert all(meant.isascii() and meant not in SIGNS for meant in SIGNS.values())
    assert "a ≤ b ≥ c".translate(RELATIONS) == "a <= b >= c"


def test_names_are_spelled_in_ascii():
    """Of options; a table of TOML has ASCII names."""
    assert name_of("ω₃⁰") == "omega3_0" and name_of("I₁") == "I1" and is_name("I1")
    for text in ("", "а", "é", "_x", "x-", "k₃²", "3x", "ω" * 61, "x y"):
        assert name_of(text) == "" and not is_name(text)
    assert not is_name("I₁")


def test_numbers_and_published_formulas_are_read_alike():
    """One scanner for all texts, also of conditions and of their LaTeX."""
    assert exact_number("−√3/2") == -sqrt(3) / 2 and exact_number("10^−2") == Rational(1, 100)
    names = {"a": symbol("a"), "omega": symbol("omega")}
    assert read("a·ω²", names) == symbol("a") * symbol("omega")**2
    assert comparisons("0 < a ≤ ω²", names) == comparisons("0 < a <= omega**2", names)
    assert formula_of("√a ≥ ω²", Names()) == formula_of("sqrt(a) >= omega**2", Names())
