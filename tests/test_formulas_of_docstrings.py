"""What the site typesets of docstrings: their formulas, and nothing else."""
import inspect
import re

import pytest
from formulas import formulas

import gyrostat as gs

TYPESET = [
    ("The rate is ω = σ/I3 there.", [r"\omega = \sigma / I_{3}"]),
    ("π̇ = (π + l) × ω + k × ∇U", [r"\dot{\pi} = ( \pi + l ) \times \omega + k \times \nabla U"]),
    ("dim is 4 where k ≠ 0, at most 2 where k = 0.", [r"k \ne 0", "k = 0"]),
    ("(π₃⁰ + l)² > 4 I₁ U′(1)", [r"( \pi_{3}^{0} + l )^{2} > 4 I_{1} U^{\prime} ( 1 )"]),
    ("U = k3^4 − k3²/2 and √(1 − k3²)", ["U = k_{3} ^{4} - k_{3}^{2} / 2", r"\sqrt{1 - k_{3}^{2}}"]),
    ("{f, g} = ∇f·B∇g, and abs(M) = 1", [r"\{ f , g \} = \nabla f \cdot B \nabla g", r"\lvert M \rvert = 1"]),
    ("c_p (P − A Ω_p) > 0", [r"c_{p} ( P - A \Omega_{p} ) > 0"]),
    ("(p_φ, p_ψ) = ∂L/∂(φ̇, ψ̇)",
     [r"( p_{\varphi } , p_{\psi } ) = \partial L / \partial ( \dot{\varphi} , \dot{\psi} )"]),
    ("∇U = omega² Ik + omega l, and U' = 0", [r"\nabla U = \mathtt{omega}^{2} I k + \mathtt{omega} l",
                                              r"U^{\prime} = 0"]),
    ("ẋ = B∇h, ½ π·I⁻¹π", [r"\dot{x} = B \nabla h", r"\tfrac12 \pi \cdot I^{- 1} \pi"]),
    ("sin θ ≠ 0 and p² − 4q ≥ 0", [r"\sin \theta \ne 0", r"p^{2} - 4 q \ge 0"]),
    ("k3 = -1, λ² + c2 + … there, sin² θ",
     ["k_{3} = - 1", r"\lambda^{2} + c_{2} + \dots", r"\sin^{2} \theta"])]
PROSE = ["a body of one axis, E1 or E3, and an x-y plane",
         "see VV2003, N2025 and § 5.7; the rank of a matrix",
         "give omega or sigma, the body's rate and the k's",
         "pi3_0 is a name, I've k of n - 1, and 3.11 to 3.13", "at a rate, if a = is missing (or not)"]


@pytest.mark.parametrize(("text", "wanted"), TYPESET, ids=[text for text, _ in TYPESET])
def test_a_formula_is_typeset_whole(text, wanted):
    """Each formula is found from its first letter to its last, and no word beside it."""
    found = list(formulas(text))
    assert [latex for _, _, latex in found] == wanted
    assert all(text[begin:end].strip() == text[begin:end] for begin, end, _ in found)


@pytest.mark.parametrize("text", PROSE)
def test_prose_stays_prose(text):
    """Articles, labels, names of the code, years and numbers are no formulas."""
    assert not list(formulas(text))


def test_every_public_docstring_gives_balanced_latex():
    """Braces and brackets of what is typeset are balanced, and nothing in it is left in Unicode."""
    count = 0
    for name in gs.__all__:
        for _, _, latex in formulas(inspect.getdoc(getattr(gs, name)) or ""):
            bare = latex.replace(r"\{", "").replace(r"\}", "")
            assert bare.count("{") == bare.count("}") and latex.isascii(), (name, latex)
            assert latex.count("(") == latex.count(")") or re.search(r"[()]\^", latex), (name, latex)
            count += 1
    assert count > 100
