"""Scenes in two directions as text, LaTeX and data."""
from unicodedata import normalize

import pytest
from sympy import Matrix, sympify

import gyrostat as gs
from gyrostat.printing.formats.json_data import report_data

BODY = gs.Gyrostat(gyrostatic_momentum=(0, gs.symbol("l"), 0))
REPORT = gs.analyze(gs.earth_pointing(gs.assemble(BODY, gs.circular_orbit())))


def test_the_text_of_a_scene():
    """Space, Casimirs with their values, energy, nine equations."""
    text = " ".join(normalize("NFC", str(REPORT.equilibrium.system)).split())
    for part in ("the dual of so(3) with two directions", "β = (−ω₀ n₁, −ω₀ n₂, −ω₀ n₃)",
                 "C₁ = 1, C₂ = 0, C₃ = 1", "ṅ₂ = ", "ṙ₃ = ", "n × ∂h/∂n + r × ∂h/∂r", "ω = ∂h/∂M"):
        assert normalize("NFC", part) in text


def test_the_text_of_a_report():
    """K, g and the factors with positive leading coefficients, instead of a form in six coordinates."""
    text = str(REPORT)
    assert "I θ̈ + g × θ̇ + K θ = 0" in text and "f₁ = 3 ω₀² (I₁ − I₃) + I₂ x" in text
    assert "I₁ I₃ x²" in text and "− I₁ I₃ x²" not in text
    assert "Basis, one vector in each row" not in text


@pytest.mark.parametrize("part", [r"n\times\partial h/\partial n", r"\dot{n_{1}}", r"C_{3}", r"\omega_0",
                                  r"I\ddot\theta + g\times\dot\theta + K\theta = 0"])
def test_latex(part):
    """What a paper takes."""
    assert part in gs.to_latex(REPORT)


def test_data():
    """K and g can be read again, and give the sextic that stands there."""
    data = report_data(REPORT)
    names = {name: gs.symbol(name) for name in ("I1", "I2", "I3", "l", "omega0")}
    K = Matrix([[sympify(x, names) for x in row] for row in data["stiffness"]])
    g = Matrix([sympify(x, names) for x in data["gyroscopic"]])
    tensor = Matrix.diag(names["I1"], names["I2"], names["I3"])
    x = names["lamda"] = gs.symbol("lamda")
    polynomial = sympify(data["characteristic_polynomial"], names)
    found = (x**2 * tensor + K).det() + x**2 * (g.T * (x**2 * tensor + K) * g)[0]
    assert (polynomial * tensor.det() - found).expand() == 0
