"""One line of Unicode, aligned matrices, documents in 100 columns."""
import pytest
from sympy import exp, sin, sqrt

import gyrostat as gs
from gyrostat.printing.document import report_blocks, scene_blocks
from gyrostat.printing.unicode import matrix_lines, text, unicode

I1, I3, l, pi3, dU, k3, omega = map(gs.symbol, ("I1", "I3", "l", "pi3_0", "dU", "k3", "omega"))


@pytest.mark.parametrize(("expression", "shown"), [
    ((pi3 + l) ** 2 - 4 * I1 * dU, "(π₃⁰ + l)² − 4 I₁ U′(1)"), (-l / (2 * I1), "−l/(2 I₁)"),
    (I1 - I3, "I₁ − I₃"), (I3 - I1, "I₃ − I₁"),
    (1 - k3**2, "1 − k₃²"), (pi3**2 / I1, "(π₃⁰)²/I₁"), (1 / I1**2, "1/I₁²"),
    (sqrt(1 - k3**2), "√(1 − k₃²)"), (sqrt(l), "√l"),
    (-(l + pi3) / I1, "(−π₃⁰ − l)/I₁"), (I1 * I3 * omega * k3, "I₁ I₃ ω k₃"), (l**-1 * 3, "3/l"),
    (exp(k3) * sin(l), "sin(l) exp(k₃)"),
    (gs.symbol("c") * l / 7, "l c/7"), (abs(k3), "|k₃|"),
    (gs.axial_potential().expression.diff(k3), "U′(k₃)"),
    (gs.general_potential().expression.diff(gs.symbol("k1"), k3), "∂₁₃U"),
    (gs.symbol("dU") ** 2, "(U′(1))²")])
def test_one_line(expression, shown):
    """As a mechanician writes it."""
    assert unicode(expression, 1) == shown


def test_objects_print_as_a_person_reads_them(scene, e1, e3):
    """print(…) of the public objects; a report is its document."""
    assert str(e1.sufficient) == "(π₃⁰ + l)² > 4 I₁ U′(1)"
    assert str(e3.sufficient).endswith("modulo the flow of π₃")
    assert str(e3.casimirs_only) == "no information" and str(scene.potential) == "U = U(k₃)"
    assert str(scene.body) == "gyrostat with inertia (I₁, I₁, I₃) and gyrostatic momentum (0, 0, l)"
    assert str(e1.equilibrium).startswith("E1: (π₁,")
    assert "Poisson tensor" in str(scene)
    assert "Conditions" in repr(e1)
    decision = e1.verdict({"I1": 1, "I3": 9, "l": 0, "pi3_0": 3, "dU": 1})
    assert str(decision).startswith("STABLE, Lyapunov: ") and "note: no rigid body" in str(decision)
    assert "−1/I₁" in str(e1.linearization).splitlines()[2]
    discriminant = gs.spectral_criterion(e1.linearization).alternatives[0][2]
    assert str(discriminant).endswith(" = 0") and len(str(scene.space).splitlines()) == 6


def test_matrices_are_aligned(scene):
    """Every row has the same width."""
    lines = matrix_lines(scene.space.tensor.tolist())
    assert len({len(line) for line in lines}) == 1 and lines[0][0] == "⎛" and lines[-1][-1] == "⎠"
    assert matrix_lines([[l]]) == ["( l )"]


@pytest.mark.parametrize("field", [gs.axial_potential(), gs.uniform_field(), gs.newtonian_field(2)])
def test_reports_fit_100_columns(field):
    """The whole derivation, for every equilibrium, in lines of at most 100 characters."""
    scene = gs.assemble(gs.symmetric_gyrostat(), field)
    blocks = scene_blocks(scene)
    for make in (gs.upright, gs.hanging, gs.inclined):
        blocks += report_blocks(gs.analyze(make(scene)))
    shown = text(blocks)
    assert max(map(len, shown.splitlines())) <= 100
    for part in ("Poisson tensor", "Casimirs", "π̇ = M × ω + k × ∇U", "Integral found",
                 "Characteristic polynomial", "Eigenvalues",
                 "Necessary (spectral)", "Sufficient (formal, hence Lyapunov)", "Casimirs alone", "E1:",
                 "E2:", "E3:"):
        assert part in shown
