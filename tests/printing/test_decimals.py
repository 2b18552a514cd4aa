"""Conditions with long coefficients are written with decimals whose digits are right."""
import re
from fractions import Fraction as F

from commands import run
from sympy import Rational, sqrt, symbols

import gyrostat as gs
from gyrostat.printing.decimals import in_decimals
from gyrostat.printing.numbers import is_long

ORBIT = "height=500 km"


def test_decimals_are_the_first_digits_of_the_coefficients():
    """Of c/c_lead for the term of the highest degree; a short fraction stays as it is."""
    x, y = symbols("x y", real=True)
    a, b = Rational(10**15 + 7, 3), sqrt(7615634132002083)
    found = in_decimals(a * x**2 * y - b * x + Rational(1, 4) * y * a, scale=True)
    assert found.coeff(x**2 * y) == 1 and found.coeff(x, 0) == y / 4
    exact = (-b / a).evalf(30)
    near = found.coeff(x).coeff(y, 0)
    assert 0 <= abs(exact) - abs(near) < abs(exact) * Rational(1, 10**5)
    assert is_long(a) and not is_long(Rational(10**12 - 1))


def test_the_conditions_of_a_pitch_wheel_in_rad_per_second(capsys):
    """The textbook has J s > 4 ω0 (I3 − I2) and > ω0 (I1 − I2), with ω0² = μ/R³ in floats."""
    _, out, _ = run(capsys, "--orbit", ORBIT, "--inertia", "410,580,250 kg m^2", "--wheel",
                    "axis=0,1,0 inertia=0.01 kg m^2 speed=s", verb="conditions")
    rate = (398600.4418e9 / (6378136.6 + 500e3)**3) ** 0.5
    edge = max(4 * rate * (250 - 580), rate * (410 - 580)) / 0.01
    (told,) = set(re.findall(r"s > (\S+)… rad/s", out))
    assert abs(float(told.replace("−", "-")) - edge) < 2e-4 and "in SI units, s in rad/s." in out
    assert not re.search(r"\d{13}", out)


def test_conditions_in_names_have_decimals_in_their_coefficients(capsys):
    """4 ω0 and ω0; LaTeX too; JSON and a scene without units stay exact."""
    _, out, _ = run(capsys, "--orbit", ORBIT, verb="conditions")
    assert "l + 0.00442713… I₂ > 0.00442713… I₃\n" in out and not re.search(r"\d{13}", out)
    assert "I₁ in kg m², I₂ in kg m², I₃ in kg m², l in kg m² s⁻¹." in " ".join(out.split())
    _, out, _ = run(capsys, "--orbit", ORBIT, "--format", "latex", "--fragment", verb="conditions")
    assert r"l + 0.00442713\dots I_2 >\nobreak 0.00442713\dots I_3" in out
    _, out, _ = run(capsys, "--orbit", ORBIT, "--format", "json", verb="conditions")
    assert "sqrt(7615634132002083)" in out
    _, out, _ = run(capsys, "--orbit", str(F(11, 10)), verb="conditions")
    assert "…" not in out and "SI" not in out


def test_a_name_that_lowers_a_margin_is_below(capsys):
    """Pitch against the normal: l < ω0 (I2 − I1), l < 4 ω0 (I2 − I3)."""
    _, out, _ = run(capsys, "--orbit", ORBIT, "--pointing", "1,-2,-3", "--set", "I1=410 kg m^2",
                    "I2=580 kg m^2", "I3=250 kg m^2", verb="conditions")
    assert "l < 0.188153… kg m² s⁻¹" in out


def test_a_criterion_in_python_reads_the_same():
    """print(report.sufficient) of an orbit by its height."""
    body = gs.Gyrostat((410, 580, 250), (0, gs.symbol("l"), 0))
    scene = gs.assemble(body, gs.circular_orbit(height=ORBIT[7:]))
    report = gs.analyze(gs.earth_pointing(scene))
    assert str(report.sufficient) == "l > −0.188153…"
    assert str(report.necessary).startswith("l² + 1.64910… l + 0.274883… ≥ 0 and l⁴ + 1.10678… l³ ")
