"""Tables of conditions in LaTeX."""
import pytest

import gyrostat as gs
from gyrostat.printing.formats.latex_names import Paper
from gyrostat.printing.formats.tables import conditions_table

PART = Paper(fragment=True)


def test_conditions_table(e1, e3):
    """One row for each condition, and where the family exists."""
    tex = conditions_table([e1, e3], paper=PART)
    assert r"E1 & necessary (spectral) & $(\pi_3^0 + l)^{2} \geq 4 I_1 U'(1)$" in tex
    assert r"E3 & satisfies & $U'(k_3) = \omega l - \omega^{2} k_3 (I_1 - I_3)$" in tex
    assert r" & exists if & $\left|{k_3}\right| < 1$" in tex and tex.count("exists if") == 1
    assert r"\geq\nobreak 0$\newline $\text{modulo the flow of } \pi_3$" in tex
    assert conditions_table([e1]).startswith(r"\documentclass")


def test_the_table_says_what_decides_between_the_two(e1, free):
    """The first coefficient has the name, those after it have none, and below the table is what they mean.

    Not where nothing is left between the two conditions.
    """
    table = conditions_table([e1], paper=PART).partition(r"\end{tabular}")[0]
    rows = [line.split(" & ") for line in table.splitlines() if " & " in line]
    assert [row[:2] for row in rows] == [
        ["E1", "necessary (spectral)"], ["", "sufficient (formal)"], ["", "between the two"],
        ["", ""], ["", ""], ["", "under internal damping (secular)"]]
    assert [row[2][:6] for row in rows[2:-1]] == ["$-c_{3", "$-c_{4", "$-c_{5"]
    assert "in $I_1^{2} \\dot{k}_3^{2} = c_3 x^3" in conditions_table([e1])
    spin = gs.analyze(gs.principal_rotation(free, 3))
    assert "etween the two" not in conditions_table([spin]) and "c_3" not in conditions_table([spin])


def test_what_the_coefficients_mean_is_said_of_poles_and_tilts_apart(e1, e3):
    """At a pole x is a distance; at a tilt it has either sign, and an odd power is unstable."""
    pole, tilt, both = (conditions_table(reports, paper=PART) for reports in ([e1], [e3], [e1, e3]))
    assert r"At E1, $x = 1 - |k_3| \geq 0$" in pole and "either sign" not in pole
    assert "At E3, $x$ is the deviation of $k_3$ and has either sign" in tilt and r"x = 1" not in tilt
    assert "At E1, $x" in both and "At E3, $x" in both


def test_a_given_field_stands_in_the_caption_and_in_the_relation():
    """U, how each equilibrium moves, and l by the rate and the tilt."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    tex = conditions_table([gs.analyze(gs.inclined(scene))], paper=PART)
    assert (r"\caption{Conditions for stability in the potential $U$ = $m_0 k_3$. E3: precessing about the "
            r"vertical, inclined. The cosine of the tilt is $k_3$.}") in tex
    assert r" &  & $l = \frac{\omega^{2} k_3 (I_1 - I_3) + m_0}{\omega}$ \\" in tex
    assert r" &  & $\omega \neq 0$" in tex
    free = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0)))
    assert "without a field" in conditions_table([gs.analyze(gs.principal_rotation(free, 3))], paper=PART)


def test_the_table_says_what_its_symbols_are(e1, e3):
    """U, and of the symbols those that occur; with a caption and a label."""
    a, k3 = gs.symbol("a"), gs.symbol("k3")
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(a * k3))))
    tex = conditions_table([report], Paper(label="my", fragment=True))
    assert r"\caption{Conditions for stability in the potential $U$ = $a k_3$." in tex
    assert r"\label{my:conditions}" in tex
    (said,) = (line for line in tex.splitlines() if "principal moment" in line)
    assert "$U$: potential, $U$ = $a k_3$; $a$: a real parameter." in said
    assert r"$\pi_3^0$: angular momentum of the locked body, axis 3, at the equilibrium" in said
    assert "$l$: gyrostatic momentum, axis 3" in said and "I_2" not in said and r"\omega" not in said
    assert r"$\omega$: rate about the vertical" in conditions_table([e1, e3])


def test_the_table_in_the_symbols_of_a_paper(e1):
    """In the conditions, between them, and where they are said."""
    tex = conditions_table([e1], Paper({"I1": "A", "l": r"\sigma", "k3": r"\gamma", "c": "C_x"}))
    assert r"$(\pi_3^0 + \sigma)^{2} > 4 A U'(1)$" in tex and r"$A^{2} \dot{\gamma}^{2} = {C_x}_3 x^3" in tex
    assert r"$\sigma$: gyrostatic momentum, axis 3" in tex and "$U(\\gamma)$: potential" in tex
    with pytest.raises(gs.errors.ValuesError, match="has no parameter alpha"):
        conditions_table([e1], Paper({"alpha": "b"}))
