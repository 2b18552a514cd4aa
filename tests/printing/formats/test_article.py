"""LaTeX documents: numbered equations that fit, labels, symbols of a paper, references, fragments."""
import re

import pytest
from sympy import symbols

import gyrostat as gs
from gyrostat.printing.formats.article import LINE, NARROW, document, to_latex
from gyrostat.printing.formats.latex_names import Paper
from gyrostat.printing.formats.linebreaks import width


def displayed(tex):
    """The lines of all numbered equations."""
    for body in re.findall(r"\\begin\{equation\} (?:\\label\{\S*\} )?(.*?) \\end\{equation\}", tex):
        inner = re.fullmatch(r"\\begin\{aligned\}\[b\] (.*) \\end\{aligned\}", body)
        yield from (line.replace("& ", "", 1) for line in re.split(r" \\\\ ", inner[1])) if inner else [body]


def shown_width(line):
    """Width of a line, footnote size counted as what it is."""
    small = re.fullmatch(r"\\text\{\\footnotesize\$\\displaystyle (.*)\$\}", line)
    return 0.83 * width(small[1]) if small else width(line)


@pytest.fixture(scope="module")
def crowded():
    """Three moments, l on axis 3, any U(k): long formulas and wide matrices."""
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, symbols("l"))), gs.general_potential())
    point = (0, 0, gs.symbol("pi3_0"), 0, 0, 1)
    return gs.analyze(gs.equilibrium(scene, point,
                                     relations=((gs.symbol("dU_1"), 0), (gs.symbol("dU_2"), 0))))


@pytest.mark.slow
@pytest.mark.parametrize(("fragment", "limit"), [(False, LINE), (True, NARROW)])
def test_every_equation_fits(e1, e3, crowded, fragment, limit):
    """No line of a display is wider than the column it is made for."""
    for reports in ([e1, e3], [crowded]):
        lines = list(displayed(document(reports, paper=Paper(fragment=fragment))))
        assert len(lines) > 20 and all(shown_width(line) <= limit for line in lines)


def test_a_document_is_complete(e1, e3):
    """Bracket, equations of motion, linearisation, polynomial, second variation, conditions, each numbered;
    theorems are cited.
    """
    tex = document([e1, e3])
    assert tex.startswith(r"\documentclass")
    assert tex.rstrip().endswith(r"\end{document}")
    assert not re.search(r"(?<!\\)\\\[", tex)
    for part in (r"\dot{\pi}_1", "Poisson tensor", r"\lambda^4", "Second variation", "Lyapunov 1892",
                 r"Holm, Marsden, Ratiu \& Weinstein 1985",
                 r"Ortega \& Ratiu 1999", r"Vera \& Viguera 2003, \S3", r"\section*{References}"):
        assert part in tex
    assert tex.count(r"\item") == 6
    # every formula of a sentence has been set
    assert not re.search(r"(?<![a-z@])\{\}", tex)


def test_a_fragment_is_a_part(e1):
    """No preamble, and the works it cites in comments."""
    tex = document([e1], paper=Paper(fragment=True))
    assert r"\documentclass" not in tex
    assert r"\begin{document}" not in tex
    assert tex.startswith("% needs amsmath; it cites\n% A. M. Lyapunov")


def test_results_have_labels(e1, e3):
    """What is cited in a paper: each label once, below the prefix that is asked for."""
    labels = re.findall(r"\\label\{(.*?)\}", to_latex([e1, e3], label="top:heavy"))
    assert len(set(labels)) == len(labels) > 30 and all(label.startswith("top:heavy:") for label in labels)
    assert {"top:heavy:E1:necessary", "top:heavy:E1:sufficient", "top:heavy:E3:linearised",
            "top:heavy:scene:casimir-2", "top:heavy:E1:c4", "top:heavy:scene:symbols"} <= set(labels)
    assert r"\label{gyrostat:E1:sufficient} \left(\pi_3^0 + l\right)^{2} > 4 I_1 U'(1)" in to_latex(e1)
    with pytest.raises(gs.errors.ExpressionError, match="no label: write letters"):
        to_latex(e1, label="a}b")


def test_a_paper_has_its_own_symbols(e1, e3):
    """In every formula, matrix, sentence and derivative of U of a document; what it has not is refused."""
    symbols = {"I1": "A", "I3": "C", "l": r"\sigma", "sigma": r"\rho", "U": "V", "k3": r"\gamma",
               "pi3": "M_3", "vector_M": r"\mathbf{G}", "vector_omega": r"\Omega", "x": r"\xi"}
    tex = to_latex([e1, e3], symbols=symbols)
    assert not re.search(r"I_1|I_3|k_3|\\pi_3(?!\^0)|(?<![A-Za-z{])U(?!p|nder)|\bx\b", tex)
    for part in ("V'(1)", r"V''(\gamma)", r"\dot{M}_3 = 0", r"\dot{\gamma} =",
                 r"$A^{2} \dot{\gamma}^{2}$ = $g$", r"$A$ $>$ 0 & principal",
                 r"gyrostatic momentum $l$ = ($0$, $0$, $\sigma$)", r"is $\mathbf{G} = I \Omega + l$",
                 r"$A$ = $C$, $\sigma$ = 0, $\omega \neq 0$", r"\partial\rho/\partial \gamma", r"c_3 \xi^3"):
        assert part in tex, part
    with pytest.raises(gs.errors.ValuesError, match=r"l and sigma would both be \\sigma: give one of them"):
        to_latex(e3, symbols={"l": r"\sigma"})
    with pytest.raises(gs.errors.ValuesError, match=r"has no parameter I_1: did you mean I1\?"):
        to_latex(e1, symbols={"I_1": "A"})


def test_what_the_symbols_are_stands_in_the_document(e1, e3):
    """Those that occur, with U; positive ones as such."""
    rows = dict(re.findall(r"(?m)^(.*) & (.*) \\\\$", to_latex(e1)))
    assert rows["$I_1$ $>$ 0"] == "principal moment of inertia, axes 1 and 2"
    assert rows["$U(k_3)$"] == "potential, any smooth function; $U', U''$ and so on are its derivatives"
    assert r"$\omega$" not in rows and r"$\omega$ & rate about the vertical" in to_latex(e3)
