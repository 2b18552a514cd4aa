"""Symbols of a paper in the place of those of the notation."""
import pytest

import gyrostat as gs
from gyrostat.printing.formats.latex_names import LONGEST, Names

I1, l, k3, pi3, dU = map(gs.symbol, ("I1", "l", "k3", "pi3_0", "dU"))


@pytest.mark.parametrize("symbol", [
    "A", r"\sigma", "I_{xx}", r"\bar{m}_1", r"\dot\psi", r"\dot x", r"\mathcal{C}", r"A_{\mathrm{rot}}",
    "I_1'", "A'", "J'_1", r"\pi_3^{0}", "A^0_3", r"\varphi", r"\hat{\boldsymbol{\mu}}", "p^*"])
def test_a_symbol_is_taken_as_it_is(symbol):
    """A letter, plain, Greek or styled, with an accent, primes and scripts."""
    assert gs.to_latex(l, symbols={"l": symbol}) == gs.to_latex(l, symbols={l: symbol}) == symbol


@pytest.mark.parametrize("symbol", [
    "", "AB", "A+B", r"\cos\theta", r"\input{x}", r"\write18", r"\bar", "x^", "{A}", "A\n", "$A$", r"\alphab",
    "A_1_2", "A'^0'", "A^0'", r"\mathrm{\input}", "A_{\\input}", "A%", "2", "é", "A" * (LONGEST + 1), 3])
def test_what_is_not_one_symbol_is_refused(symbol):
    """Commands, expressions, and what LaTeX would not read."""
    with pytest.raises(gs.errors.ExpressionError, match="for l is not one symbol: write a letter"):
        gs.to_latex(l, symbols={"l": symbol})


def test_powers_rates_and_derivatives_of_renamed_symbols():
    """Primes and superscripts are closed before a power; U renames its derivatives, k3 their argument."""
    assert gs.to_latex(l**2 * I1, symbols={"l": "A'", "I1": "J^0"}) == r"J^0 \left(A'\right)^{2}"
    names = Names({"l": "A'", "U": "V^0", "k3": r"\bar{m}_1", "pi3": "M_3"})
    assert names.of("d2U", k3) == r"{V^0}''(\bar{m}_1)" and names.of("d4U", 1) == "{V^0}^{(4)}(1)"
    assert names.of("d2U_13") == r"\partial_{13} V^0"
    assert names.fill("⟨l⟩^2 ⟨k3_dot⟩^2 ⟨pi3_dot⟩ ⟨k3⟩_n ⟨U⟩''") == (
        r"\left(A'\right)^2 \dot{\bar{m}}_1^2 \dot{M}_3 {\bar{m}_1}_n {V^0}''")
    assert gs.to_latex(dU, symbols={"dU": r"\beta"}) == r"\beta"


def test_two_names_never_have_one_symbol():
    """Two that are given, one that is given and one that is there; not one that does not occur."""
    with pytest.raises(gs.errors.ValuesError, match="I1 and I3 would both be A: give one of them another"):
        gs.to_latex(l, symbols={"I1": "A", "I3": "A"})
    with pytest.raises(gs.errors.ValuesError, match=r"l and pi3_0 would both be \\pi_3\^0"):
        gs.to_latex(l * pi3, symbols={"l": r"\pi_3^{0}"})
    assert gs.to_latex(l * I1, symbols={"l": r"\pi_3^{0}", "mine": "B"}) == r"I_1 \pi_3^{0}"
    assert gs.to_latex(l * I1, symbols={"l": "I_1", "I1": "l"}) == "l I_1"
