"""Documents as JSON."""
import json
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from slow import slow
from sympy import CRootOf, Float, Rational, Symbol, pi, sqrt

from gyrostat.cli.parser import main
from gyrostat.notation import symbol
from gyrostat.printing.formats.exact_text import exact_text
from gyrostat.printing.formats.json_data import decision_data, json_text
from gyrostat.stability.decision import undecided
from gyrostat.version import DOCUMENT_FORMAT

TOP = ("--potential", "m0*k3", "--equilibrium", "E1")


@pytest.mark.parametrize("words", [
    ("report", *TOP), ("conditions", *TOP), ("conditions", *TOP, "--solve-for", "l"),
    ("decide", *TOP, *(w for x in ("I1=1", "m0=1", "l=0", "pi3_0=3") for w in ("--set", x))),
    *slow((("verify", "AR"),))],
    ids=" ".join)
def test_every_document_says_its_format(words, capsys):
    """The format is the first key of what any verb prints as JSON."""
    assert main([*words, "--format", "json"]) == 0
    assert next(iter(json.loads(capsys.readouterr().out).items())) == ("format", DOCUMENT_FORMAT)


def test_no_document_holds_what_json_lacks():
    """NaN and Infinity are refused, not written."""
    with pytest.raises(ValueError, match="JSON compliant"):
        json_text({"x": float("nan")})


@given(st.fractions())
def test_a_fraction_is_written_as_sympy_writes_it(fraction):
    """As p or p/q, with its sign."""
    value = Rational(fraction.numerator, fraction.denominator)
    decision = replace(undecided(""), margins=((symbol("l"), value),))
    assert decision_data(decision)["margins"] == {"l": str(value)}


def test_an_exact_text_is_that_of_the_number():
    """The polynomial of a root is read once; a sum with two roots, a power, a quotient look as by str."""
    x = Symbol("x", real=True)
    a, b = (CRootOf(x**5 - 5 * x + c, 1) for c in (1, 3))
    for number in (a, a**2 - 3 * a + 1, -a, (a - b) / (2 - a * b**3), sqrt(2 + a) * pi, Rational(-1, 3),
                   Float("0.1", 30)):
        assert exact_text(number) == str(number)
