"""LaTeX in the notation of the sources; every public object; documents that are complete."""
import os
import re
import subprocess
import sys

import pytest
from sympy import Matrix, symbols

import gyrostat as gs
from gyrostat.algebra.text.grammar import parse
from gyrostat.printing.formats.article import to_latex
from gyrostat.printing.formats.text import text
from gyrostat.printing.formats.unicode import unicode
from gyrostat.printing.results.document import report_blocks


def test_conditions_are_in_the_notation_of_the_source(e1, e2, e3):
    """U'(1), U'(-1), U''(k_3), \\pi_3^0, \\omega."""
    assert to_latex(e1.sufficient) == r"\left(\pi_3^0 + l\right)^{2} > 4 I_1 U'(1)"
    assert to_latex(e1.necessary) == r"\left(\pi_3^0 + l\right)^{2} \geq 4 I_1 U'(1)"
    assert to_latex(e2.sufficient) == r"\left(\pi_3^0 + l\right)^{2} > - 4 I_1 U'(-1)"
    assert "U''(k_3)" in to_latex(e3.sufficient) and r"\omega" in to_latex(e3.sufficient)
    assert to_latex(e3.casimirs_only) == r"\text{no information}"


def test_degenerate_factors_are_shown(e1):
    """The unreduced test says where the discriminant vanishes through its square factor."""
    discriminant = gs.derivation.spectral_criterion(e1.linearization).alternatives[0][2]
    assert to_latex(discriminant).endswith("= 0") and r"\lor" in to_latex(discriminant)


def test_of_several_alternatives_one_is_enough():
    """The conditions of an alternative are joined by ∧, the alternatives by ∨."""
    a, b, c = (gs.Condition(symbols(name), True, "", (), gs.symbol("k3")) for name in "abc")
    assert to_latex(gs.Criterion("formal", ((a, b), (c,)))) == (
        r"\left[a > 0 \;\land\; b > 0\right] \;\lor\; \left[c > 0\right]")


@pytest.mark.parametrize("get", [
    lambda r: r.equilibrium.system.body, lambda r: r.equilibrium.system.potential,
    lambda r: r.equilibrium.system.space,
    lambda r: r.equilibrium.system, lambda r: r.equilibrium, lambda r: r.linearization,
    lambda r: r.second_variation,
    lambda r: r.necessary, lambda r: r.sufficient.alternatives[0][0], lambda r: r,
    lambda r: r.verdict({"I1": 1, "l": 0, "pi3_0": 3, "dU": 1})])
def test_jupyter_shows_every_public_object(e1, get):
    """_repr_latex_ is one displayed formula with balanced braces and environments, not a document."""
    shown = get(e1)._repr_latex_()
    assert shown.startswith("$") and shown.endswith("$") and "documentclass" not in shown
    assert shown.count("{") == shown.count("}")
    assert sorted(re.findall(r"\\begin{(\w+)}", shown)) == sorted(re.findall(r"\\end{(\w+)}", shown))
    assert shown.count(r"\left") == shown.count(r"\right") and not re.search("[^\\x00-\\x7f]", shown)


def test_matrices_and_polynomials(e1):
    """Expressions and matrices of the user too."""
    assert to_latex(e1.linearization.matrix).startswith(r"\begin{pmatrix} 0 & ")
    assert r"\lambda^{4}" in to_latex(e1.linearization.characteristic_polynomial())
    assert to_latex(Matrix([[1, 2]])) == r"\begin{pmatrix} 1 & 2 \end{pmatrix}"
    assert to_latex(symbols("alpha") / 2) == r"\frac{\alpha}{2}"
    with pytest.raises(TypeError, match="not str"):
        to_latex("I1")


@pytest.mark.slow
def test_a_report_is_a_document(e1, e2, e3):
    """A plain article; one document for several reports; only ASCII, balanced."""
    for document in (to_latex(e1), to_latex([e1, e2, e3])):
        assert document.startswith(r"\documentclass{article}")
        assert document.rstrip().endswith(r"\end{document}")
        assert document.count("{") == document.count("}")
        assert document.count(r"\begin{equation}") == document.count(r"\end{equation}") > 20
        assert document.isascii()
    assert to_latex([e1, e2, e3]).count(r"\section*") == 5       # scene, three equilibria, references


def test_products_are_written_as_the_papers_do():
    """Numbers, moments, what is in the motion, parameters, k, sums and functions; terms alike."""
    a, b, I1, k3, omega = map(gs.symbol, ("a", "b", "I1", "k3", "omega"))
    U = gs.axial_potential(a * k3 + b * k3**2)
    assert to_latex(U) == "U = a k_3 + b k_3^{2}"
    assert to_latex(I1 * omega**2 * k3 * a) == r"I_1 \omega^{2} a k_3"
    assert to_latex(U.expression.diff(k3) * k3 * (1 - k3**2)) == (
        r"k_3 \left(1 - k_3^{2}\right) \left(a + 2 b k_3\right)")


@pytest.mark.slow
def test_the_order_is_that_of_no_process():
    """Another seed of the hashes, symbols made in another order: the same formula."""
    code = ("import gyrostat as gs; d, k3, b, a = map(gs.symbol, ('d', 'k3', 'b', 'a')); "
            "print(gs.to_latex(gs.analyze(gs.hanging(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential("
            "d*k3**3 + b*k3**2 + a*k3))))))")
    shown = {subprocess.run([sys.executable, "-c", code], env=os.environ | {"PYTHONHASHSEED": seed},
                            capture_output=True, text=True, check=True).stdout for seed in "12"}
    assert len(shown) == 1 and "a - 2 b + 3 d" in shown.pop()


@pytest.mark.parametrize("potential", [
    "m0*k3", pytest.param("m0/(k3 + 2)", marks=pytest.mark.slow),
    pytest.param("exp(a*k3)", marks=pytest.mark.slow)])
def test_a_given_field_is_inserted_throughout(potential):
    """U' stands only where it is said what it is.

    In the derivation, the eigenvalues and the proofs its value does.
    """
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(parse(potential)))
    for family in (gs.upright, gs.hanging, gs.inclined):
        report = gs.analyze(family(scene))
        for part in (report.linearization, report.second_variation, report.necessary, report.sufficient):
            assert "U'" not in to_latex(part) and "U′" not in unicode(part)
        lines = text(report_blocks(report)).splitlines()
        said = [line for line in lines if re.search("U[′″]|dU|d2U", line)]
        assert said and all(re.match(r"  For this potential U′|    U′\(k₃\) = ", line) for line in said)
