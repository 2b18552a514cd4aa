"""One line of Unicode, aligned matrices."""
import pytest
from sympy import Integer, exp, sin, sqrt

import gyrostat as gs
from gyrostat.printing.formats.unicode import matrix_lines, unicode

I1, I3, l, pi3, dU, k3, omega = map(gs.symbol, ("I1", "I3", "l", "pi3_0", "dU", "k3", "omega"))


def test_numbers_of_any_length_are_printed():
    """Products of numbers of a thousand digits too, of which Python refuses to print more than 4300."""
    long = Integer(10)**5000 + 7
    assert unicode(long * I1 - I3 / long) == f"1{'0' * 4999}7 I₁ − I₃/1{'0' * 4999}7"
    assert f"1{'0' * 4999}7" in gs.to_latex(long * I1) and gs.to_latex(I1 / long).count("0") == 4999
    body = gs.Gyrostat((10**1000, 10**1000, 10**1000), (0, 0, 0))
    assert repr(gs.analyze(gs.upright(gs.assemble(body, gs.uniform_field()))))
    with pytest.raises(gs.errors.ValuesError, match="inertia = 1.0*e.5000 is too long"):
        gs.Gyrostat((10**5000, 1, 1), (0, 0, 0))


@pytest.mark.parametrize(("expression", "shown"), [
    ((pi3 + l) ** 2 - 4 * I1 * dU, "(π₃⁰ + l)² − 4 I₁ U′(1)"), (-l / (2 * I1), "−l/(2 I₁)"),
    (I1 - I3, "I₁ − I₃"), (I3 - I1, "I₃ − I₁"),
    (1 - k3**2, "1 − k₃²"), (pi3**2 / I1, "(π₃⁰)²/I₁"), (1 / I1**2, "1/I₁²"),
    (sqrt(1 - k3**2), "√(1 − k₃²)"), (sqrt(l), "√l"),
    (-(l + pi3) / I1, "(−π₃⁰ − l)/I₁"), (I1 * I3 * omega * k3, "I₁ I₃ ω k₃"), (l**-1 * 3, "3/l"),
    (exp(k3) * sin(l), "sin(l) exp(k₃)"),
    (gs.symbol("c") * l / 7, "l c/7"), (abs(k3), "|k₃|"),
    (k3 * gs.symbol("a"), "a k₃"), (exp(k3 * gs.symbol("a")), "exp(a k₃)"),
    (sum(k3**n * gs.symbol(f"a{n}") for n in (10, 9, 2)), "a₂ k₃² + a₉ k₃⁹ + a₁₀ k₃¹⁰"),
    (gs.symbol("d4U") * gs.symbol("b") * k3, "b k₃ U⁽⁴⁾(1)"),
    (gs.axial_potential().expression.diff(k3), "U′(k₃)"),
    (gs.general_potential().expression.diff(gs.symbol("k1"), k3), "∂₁₃U"),
    (gs.symbol("dU") ** 2, "(U′(1))²")])
def test_one_line(expression, shown):
    """As a mechanician writes it."""
    assert unicode(expression, 1) == shown


def test_matrices_are_aligned(scene):
    """Every row has the same width."""
    lines = matrix_lines(scene.space.tensor.tolist())
    assert len({len(line) for line in lines}) == 1 and lines[0][0] == "⎛" and lines[-1][-1] == "⎠"
    assert matrix_lines([[l]]) == ["( l )"]
