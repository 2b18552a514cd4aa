"""Claims of stability under internal damping, in files of one's own."""
import pytest
from written_sources import status

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


@pytest.mark.parametrize("scene, printed", [
    (TOP, "(I3*omega3_0 + l)**2 > 4*I1*m0"), (TOP, SLEEPS.replace("I3 - I1", "I1 - I3")),
    (DUAL, "(l + (I3 - I1)*omega3_0)*(l + (I3 - I2)*omega3_0) > 0"), (BOX, "I3 > I1"),
    (TILT, D.replace("2*omega", "omega"))])
def test_other_conditions_are_refuted(tmp_path, scene, printed):
    """By a point where the energy is not least: what is sufficient without damping, among others."""
    assert status(tmp_path, scene, DAMPED, printed) == "misprint"
