"""LaTeX documents: numbered equations that fit, references, fragments, tables of conditions."""
import re

import pytest
from sympy import symbols

import gyrostat as gs
from gyrostat.printing.article import LINE, NARROW, conditions_table, document
from gyrostat.printing.linebreaks import width


def displayed(tex):
    """The lines of all numbered equations."""
    for body in re.findall(r"\\begin\{equation\} (.*?) \\end\{equation\}", tex):
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


@pytest.mark.parametrize(("fragment", "limit"), [(False, LINE), (True, NARROW)])
def test_every_equation_fits(e1, e3, crowded, fragment, limit):
    """No line of a display is wider than the column it is made for."""
    for reports in ([e1, e3], [crowded]):
        lines = list(displayed(document(reports, fragment=fragment)))
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
    assert tex.count(r"\item") == 5
    # every formula of a sentence has been set
    assert not re.search(r"(?<![a-z])\{\}", tex)


def test_a_fragment_is_a_part(e1):
    """No preamble, and the works it cites in comments."""
    tex = document([e1], fragment=True)
    assert r"\documentclass" not in tex
    assert r"\begin{document}" not in tex
    assert tex.startswith("% needs amsmath; it cites\n% A. M. Lyapunov")


def test_conditions_table(e1, e3):
    """One row for each condition, and where the family exists."""
    tex = conditions_table([e1, e3], fragment=True)
    assert r"E1 & necessary (spectral) & $(\pi_3^0 + l)^{2} \geq 4 I_1 U'(1)$" in tex
    assert r"E3 & exists where & $\left|{k_3}\right| < 1$" in tex
    assert r"\text{modulo the flow of } \pi_3" in tex
    assert conditions_table([e1]).startswith(r"\documentclass")


def test_the_table_says_what_decides_between_the_two(e1, free):
    """The first coefficient has the name, those after it have none, and below the table is what they mean.

    Not where nothing is left between the two conditions.
    """
    rows = [line.split(" & ") for line in conditions_table([e1], fragment=True).splitlines() if " & " in line]
    assert [row[:2] for row in rows] == [
        ["E1", "necessary (spectral)"], ["", "sufficient (formal)"], ["", "between the two"],
        ["", ""], ["", ""]]
    assert [row[2][:6] for row in rows[2:]] == ["$-c_{3", "$-c_{4", "$-c_{5"]
    assert "Between the two, $I_1^2" in conditions_table([e1])
    spin = gs.analyze(gs.principal_rotation(free, 3))
    assert "etween the two" not in conditions_table([spin])
