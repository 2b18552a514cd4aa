"""Symbols, their names and how they are printed."""
import re
from pathlib import Path

import pytest
from sympy import Symbol

from gyrostat.notation import NOTATION, jet, jet_name, own, symbol
from gyrostat.typesetting import typeset

PAGE = Path(__file__).parents[1] / "docs" / "explanation" / "conventions.md"


def test_moments_masses_and_magnitudes_are_positive_and_everything_else_is_real():
    """Assumptions live in one table."""
    for name in NOTATION:
        assert symbol(name).is_real
        assert bool(symbol(name).is_positive) == (
            name in ("I1", "I2", "I3", "r", "p0", "omega0", "mass1", "mass2", "mass3"))
    assert symbol("c").is_real and symbol("c").is_positive is None


def test_dimensions_of_the_named_fields_agree():
    """m0 k3 and m1 I3 k3² are energies, l and π momenta, and dU an energy."""
    d = {name: entry.dimension for name, entry in NOTATION.items()}
    assert d["m0"] == d["dU"] == (d["I1"][0] + d["m1"][0], d["m1"][1]) == (1, 2)
    assert d["l"] == d["pi3_0"] == (d["I1"][0] + d["omega"][0], d["omega"][1]) == (1, 1)


def powers(name):
    """Powers of mass, length and 1/time."""
    (a, b), c = NOTATION[name].dimension, NOTATION[name].length
    return a, 2 * a + c, b


def test_length_is_the_third_dimension():
    """m0 = m g z0, m1 r is an acceleration, Jₙ a mass times a length to the n, p0²/mass an energy, the rest
    as before.
    """
    assert powers("mass1") == powers("mass3") == (1, 0, 0)
    assert powers("r") == (0, 1, 0)
    assert powers("p0") == (1, 1, 1)
    assert tuple(a + b for a, b in zip(powers("m1"), powers("r"))) == (0, 1, 2)
    assert [powers(f"J{n}") for n in (3, 4, 9)] == [(1, 3, 0), (1, 4, 0), (1, 9, 0)]
    assert tuple(2 * a - b for a, b in zip(powers("p0"), powers("mass1"))) == powers("m0") == (1, 2, 2)
    assert {n for n in NOTATION if NOTATION[n].length} == {"r", "p0", "mass1", "mass2", "mass3",
                                                           *(f"J{n}" for n in range(3, 10))}


def test_no_two_names_are_typeset_alike():
    """mass1 is not m1, in LaTeX or in text."""
    for style in ("latex", "text"):
        shown = [typeset(name, None, style) for name in NOTATION]
        assert len(set(shown)) == len(shown)


def test_symbols_are_matched_by_name():
    """A plain Symbol becomes ours, whatever its assumptions."""
    assert own(Symbol("k3") * Symbol("I1", negative=True)) == symbol("k3") * symbol("I1")


@pytest.mark.parametrize(("order", "axes"), [(1, ""), (2, ""), (7, ""), (1, "1"), (2, "13"), (3, "223")])
def test_jet_names_are_read_back(order, axes):
    """jet is the inverse of jet_name."""
    assert jet(jet_name(order, axes)) == (order, axes)


@pytest.mark.parametrize("name", ["d1U", "d0U", "d02U", "dUx", "U", "d2", "xdU", "dU_4"])
def test_other_names_are_no_derivatives(name):
    """Only the names that jet_name gives are derivatives of U."""
    assert jet(name) is None


def test_derivatives_print_with_their_argument():
    """U'(1), U''(k3), as the sources write them."""
    assert typeset("dU", 1) == "U'(1)"
    assert typeset("dU", -1) == "U'(-1)"
    assert typeset("d2U", symbol("k3")) == "U''(k_3)"
    assert typeset("dU", -1, "text") == "U′(−1)" and typeset("d3U", None, "text") == "U‴(k₃)"
    assert typeset("d5U", 1) == "U^{(5)}(1)" and typeset("d2U_13") == r"\partial_{13} U"


def test_parameters_of_the_user_are_typeset():
    """Greek letters and numbers are set, underscores are escaped."""
    assert typeset("alpha2") == r"\alpha_{2}" and typeset("mass_a") == r"\mathrm{mass\_a}"
    assert typeset("mass_1") == r"\mathrm{mass\_1}" and typeset("m_0", style="text") == "m_0"
    assert typeset("c") == "c"
    assert typeset("beta", style="text") == "β"
    assert typeset("a1", style="text") == "a₁"


@pytest.mark.parametrize(("name", "latex", "text"), [
    ("phi_dot", r"\dot{\phi}", "φ\u0307"), ("psi_ddot", r"\ddot{\psi}", "ψ\u0308"),
    ("A1_dot", r"\dot{A_{1}}", "A\u0307₁"),
    ("delta_pi3", r"\delta \pi_3", "δπ₃"), ("Omega_b", r"\Omega_{b}", "Ω_b"), ("omega2", r"\omega_{2}", "ω₂"),
    ("mass1", r"\bar{m}_1", "mass₁"), ("mass3", r"\bar{m}_3", "mass₃"), ("p0", "p_0", "p₀"), ("r", "r", "r"),
    ("J3", "J_3", "J₃"),
    ("J9", "J_9", "J₉"), ("J10", "J_{10}", "J₁₀"), ("spring_rate", r"\mathrm{spring\_rate}", "spring_rate"),
    ("alpha_1", r"\alpha_{1}", "α₁"), ("x_12", "x_{12}", "x₁₂"), ("delta_2", r"\delta_{2}", "δ₂"),
    ("eta", r"\eta", "η"), ("I1_b", "I_{1,b}", "I₁_b"), ("c_phi2", r"c_{\phi_{2}}", "c_φ₂"),
    ("pi_3", r"\mathrm{pi\_3}", "pi_3"), ("spring_2", r"\mathrm{spring}_{2}", "spring₂"),
    ("alpha_", r"\mathrm{alpha\_}", "alpha_")])
def test_names_are_typeset(name, latex, text):
    """A rate has its dots, a variation its δ, a single letter or Greek name its subscripts.

    Masses keep apart from m1 = 3 g/r, names of the user from those of the table.
    """
    assert typeset(name) == latex and typeset(name, style="text") == text


def bare(latex):
    """LaTeX without braces and spaces."""
    return re.sub("[{} ]", "", latex)


def test_the_page_of_one_notation_has_what_is_printed():
    """In conventions: LaTeX on pages, the name in code and the letters in print are those of the table."""
    text = PAGE.read_text(encoding="utf-8").partition("## One notation")[2].partition("\n## ")[0]
    rows = re.findall(r"^\| (\$.*?) \| (`.*?`); (`.*?`) \|", text, re.MULTILINE)
    assert len(rows) >= 12
    for latex, code, printed in rows:
        names, shown = (re.findall("`(.*?)`", cell) for cell in (code, printed))
        for name, letters in zip(names, shown):
            assert typeset(name, style="text").partition("(")[0] == letters
        symbol_on_page = bare(typeset(names[0]).partition("(")[0].removesuffix("^0"))
        assert symbol_on_page in bare(latex), (names[0], latex)
