"""Claims of stability under internal damping, in files of one's own."""
import pytest
from published.written_sources import BY_KEY, status
from sympy import Integer

from gyrostat.errors import PublishedError
from gyrostat.notation import symbol
from gyrostat.published.independent.counterexample import Model

DAMPED = "sufficient for stability under internal damping"
TOP = ('inertia = ["I1", "I1", "I3"]\ngyrostatic_momentum = ["0", "0", "l"]\npotential = "m0*k3"\n'
       'equilibrium = "E1"\nspin = "omega3_0"')
TILT = ('inertia = ["I1", "I1", "I3"]\ngyrostatic_momentum = ["0", "0", "l"]\npotential = "U(k3)"\n'
        'equilibrium = "E3"\neliminate = "dU"')
DUAL = ('inertia = ["I1", "I2", "I3"]\ngyrostatic_momentum = ["0", "0", "l"]\n'
        'equilibrium = "axis 3"')
BOX = DUAL.replace('"l"', '"0"')
SLEEPS = "l*omega3_0 + (I3 - I1)*omega3_0**2 > m0"
LANDON = ("(I3*omega3_0 + l)*(l + (I3 - I1)*omega3_0) > 0 and "
          "(I3*omega3_0 + l)*(l + (I3 - I2)*omega3_0) > 0")
D = ("(l - 2*omega*k3*(I1 - I3))**2 + (I1*(1 - k3**2) + I3*k3**2)*(omega**2*(I1 - I3) + d2U) > 0")


@pytest.mark.parametrize("scene, printed", [(TOP, SLEEPS), (DUAL, LANDON), (BOX, "I3 > I1 and I3 > I2"),
                                            (TILT, D)])
def test_conditions_of_the_books_are_confirmed(tmp_path, scene, printed):
    """The sleeping top, Landon and Iorillo, the major axis, D > 0."""
    assert status(tmp_path, scene, DAMPED, printed) == "confirmed"


@pytest.mark.few(1)
@pytest.mark.parametrize("scene, printed", [
    (TOP, "(I3*omega3_0 + l)**2 > 4*I1*m0"), (TOP, SLEEPS.replace("I3 - I1", "I1 - I3")),
    (DUAL, "(l + (I3 - I1)*omega3_0)*(l + (I3 - I2)*omega3_0) > 0"), (BOX, "I3 > I1"),
    (TILT, D.replace("2*omega", "omega"))])
def test_other_conditions_are_refuted(tmp_path, scene, printed):
    """By a point where the energy is not least: what is sufficient without damping, among others."""
    assert status(tmp_path, scene, DAMPED, printed) == "misprint"


@pytest.mark.slow
@pytest.mark.parametrize("scene, printed, expected", [
    (DUAL, LANDON.replace(">", ">="), "misprint"), (TOP, SLEEPS.replace(">", ">="), "misprint"),
    (TILT, D.replace(">", ">="), "misprint"),
    pytest.param(BOX, "I3 >= I1 and I3 >= I2", "unchecked", marks=pytest.mark.slow)])
def test_equality_is_decided_by_the_orders_that_follow(tmp_path, scene, printed, expected):
    """Where a square vanishes the energy may rise or fall; of the box nothing is known: least on a circle."""
    assert status(tmp_path, scene, DAMPED, printed) == expected


def test_products_of_signs_are_compared(tmp_path):
    """(I3 − I1) x > 0 and (I3 − I2) x > 0 is (I3 − I1) x > 0 and (I3 − I1) (I3 − I2) > 0."""
    scene = ('potential = "m1/2*(I1*k1**2 + I2*k2**2 + I3*k3**2)"\nequilibrium = "E1"\n'
             'spin = "omega3_0"')
    x = "*(omega3_0**2 - m1) > 0"
    for printed in (f"(I3 - I1){x} and (I3 - I2){x}", f"(I3 - I1){x} and (I3 - I1)*(I3 - I2) > 0"):
        assert status(tmp_path, scene, "sufficient for stability", printed) == "confirmed"
    assert status(tmp_path, scene, "sufficient for stability", f"(I3 - I1){x} and I3 > I2") != "confirmed"


def test_equal_squares_are_counted_twice():
    """At the poles of a body of revolution every square of the second variation occurs twice."""
    values = {symbol(name): Integer(n) for name, n in (("I1", 1), ("I3", 2), ("m0", 1), ("l", 0),
                                                       ("omega3_0", 3))}
    model = Model(BY_KEY["literature", "S11-uniform"].scene, values)
    assert model.inertia_of_second_variation() == (4, 0, 0) and model.is_definite()


VOLTERRA = ('gyrostatic_momentum = ["(1 - nu*I1)*M1", "(1 - nu*I2)*M2", "(1 - nu*I3)*M3"]\n'
            'point = ["nu*I1*M1", "nu*I2*M2", "nu*I3*M3"]')
DELTA = "M1**2*(1/I2 - nu)*(1/I3 - nu) + M2**2*(1/I3 - nu)*(1/I1 - nu) + M3**2*(1/I1 - nu)*(1/I2 - nu)"
TRACE = "M1**2*(1/I2 + 1/I3 - 2*nu) + M2**2*(1/I3 + 1/I1 - 2*nu) + M3**2*(1/I1 + 1/I2 - 2*nu)"


@pytest.mark.few(1)
@pytest.mark.parametrize("quantity, printed, expected", [
    ("sufficient for stability", f"{DELTA} > 0", "confirmed"),
    ("sufficient for stability", f"{DELTA} >= 0", "misprint"),          # at a fold it is unstable
    ("sufficient for instability", f"{DELTA} <= 0", "misprint"),        # without momentum it is stable
    (DAMPED, f"{DELTA} > 0 and {TRACE} > 0", "confirmed"), (DAMPED, f"{DELTA} > 0", "misprint")])
def test_a_rotor_along_any_axis(tmp_path, quantity, printed, expected):
    """At the equilibrium ω = ν M of a free gyrostat, by determinant and trace across M."""
    assert status(tmp_path, VOLTERRA, quantity, printed) == expected


def test_a_point_that_is_no_equilibrium_is_refused(tmp_path):
    """With the rate that does not vanish."""
    with pytest.raises(PublishedError, match="is not an equilibrium"):
        status(tmp_path, VOLTERRA.replace("nu*I1*M1", "nu*I2*M1"), "sufficient for stability", f"{DELTA} > 0")
