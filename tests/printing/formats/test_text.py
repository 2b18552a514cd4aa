"""What print shows of the public objects, and documents in 100 columns."""
from unicodedata import normalize

import pytest
from slow import slow

import gyrostat as gs
from gyrostat.printing.formats.text import plain, text
from gyrostat.printing.results.document import report_blocks
from gyrostat.printing.results.scene import scene_blocks


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
    discriminant = gs.derivation.spectral_criterion(e1.linearization).alternatives[0][2]
    assert str(discriminant).endswith(" = 0") and len(str(scene.space).splitlines()) == 6


def test_what_is_negative_stands_on_the_right():
    """Of a condition at a tilt; at a pole all but the square does."""
    l, m0, k3 = map(gs.symbol, ("l", "m0", "k3"))
    assert str(gs.Condition(m0 - l, True, "", (), k3)) == "m₀ > l"
    assert str(gs.Condition(m0**2 + (l + k3) ** 2, False, "", (), l / l)) == "(l + k₃)² ≥ −m₀²"


def test_only_objects_of_the_library_are_shown():
    """Anything else is refused by its type."""
    with pytest.raises(TypeError, match="int is not shown as text"):
        plain(1)


@pytest.mark.parametrize("field", [
    gs.axial_potential(), *slow((gs.uniform_field(),), (gs.newtonian_field(2),))])
def test_reports_fit_100_columns(field):
    """The whole derivation, for every equilibrium, in lines of at most 100 characters."""
    scene = gs.assemble(gs.symmetric_gyrostat(), field)
    blocks = scene_blocks(scene)
    for make in (gs.upright, gs.hanging, gs.inclined):
        blocks += report_blocks(gs.analyze(make(scene)))
    shown = normalize("NFC", text(blocks))
    assert max(map(len, shown.splitlines())) <= 100
    for part in ("Poisson tensor", "Casimirs", "M = Iω + l", normalize("NFC", "Ṁ = M × ω + k × ∇U"),
                 "An integral was found",
                 "characteristic polynomial", "eigenvalues",
                 "Necessary (spectral)", "Sufficient (formal, hence Lyapunov)", "Casimirs alone", "E1:",
                 "E2:", "E3:"):
        assert part in shown


def test_gravity_is_not_the_square_of_the_rate():
    """Where U has a parameter g, the polynomial that decides has another name."""
    U = gs.axial_potential(gs.symbol("m") * gs.symbol("g") * gs.symbol("k3"))
    shown = str(gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), U))))
    assert "I₁² k̇₃² = f with\n    f = 2 I₁" in shown and "m g k₃" in shown
    assert "At equality f = c₃ x³" in shown


def test_of_a_given_potential_the_derivatives_that_are_needed_are_said():
    """U′ at a pole; at a tilt U″ too."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(lambda k3: gs.symbol("m0") * k3 + k3**2))
    shown = [text(report_blocks(gs.analyze(make(scene)))) for make in (gs.upright, gs.inclined)]
    assert "For this potential U′(1) = m₀ + 2.\n" in shown[0]
    assert "For this potential U′(k₃) = m₀ + 2 k₃, U″(k₃) = 2.\n" in shown[1]
