"""Published formulas about permanent rotations: a point in a field, Staude's cone, the amended potential."""
import pytest
from published.written_sources import CLAIM, status, written

from gyrostat.published import check

REVOLUTION = 'inertia = ["I1", "I1", "I3"]\ngyrostatic_momentum = ["0", "0", "l"]\npotential = "{U}"\n'
UP, DOWN = 'point = ["0", "0", "b", "0", "0", "1"]', 'point = ["0", "0", "b", "0", "0", "-1"]'
# about axis 3 of an asymmetric body, whose centre of mass is off that axis
AXIS = """gyrostatic_momentum = ["c1/w", "0", "l3"]
potential = "c1*k1 + c3*k3"
point = ["0", "0", "w*I3", "0", "0", "1"]"""
STILL = 'potential = "c1*k1 + c2*k2 + c3*k3"'


def finding(tmp_path, scene, quantity, printed, kind, extra=""):
    text = '[source]\nname = "mine"\ntitle = "t"\n[scene.s]\n' + scene + "\n"
    text += CLAIM.format(key="a", quantity=quantity, printed=printed, kind=kind) + extra
    (found,) = check([written(tmp_path, text)])
    return found


@pytest.mark.parametrize(("printed", "expected"), [
    ("(b + l)**2 > 4*I1*m0", "confirmed"), ("(b + l)**2 > 3*I1*m0", "misprint"),
    ("(b - l)**2 > 4*I1*m0", "misprint")])
def test_a_point_on_the_axis_is_the_upright_top(tmp_path, printed, expected):
    """Rumiantsev's condition at a point that is claimed; refuted on the level set of all integrals."""
    scene = REVOLUTION.format(U="m0*k3") + UP
    found = finding(tmp_path, scene, "sufficient for stability", printed, "condition")
    assert found.status == expected
    assert (found.outcome.counterexample is None) == (expected == "confirmed")


def test_a_hanging_point_is_stable(tmp_path):
    """At the pole below, where the third power of g decides at equality, and the level set is the point."""
    scene = REVOLUTION.format(U="m0*k3") + DOWN
    found = finding(tmp_path, scene, "stability", "unstable", "statement", 'given = "m0 > 0"\n')
    assert found.status == "misprint" and "the point alone" in found.outcome.counterexample.confirmation


@pytest.mark.few(2)
@pytest.mark.parametrize(("quantity", "printed", "expected"), [
    ("I1*I2*q*I3", "amended_determinant*I3", "confirmed"), ("I1*I2*q", "amended_trace", "misprint"),
    ("amended_trace", "2*(w*(w*I3 + l3) - c3) - w**2*(I1 + I2) + (c1/w)**2/I3", "confirmed"),
    ("amended_trace", "2*(w*(w*I3 + l3) - c3) - w**2*(I1 + I2)", "misprint")])
def test_a_point_of_an_asymmetric_body(tmp_path, quantity, printed, expected):
    """p, q and the second variation of the amended potential at a point with a rotor across the axis."""
    found = finding(tmp_path, AXIS, quantity, printed, "identity")
    assert found.status == expected
    if expected == "misprint":
        assert "Newton and Euler" in found.outcome.counterexample.confirmation


@pytest.mark.parametrize(("extra", "printed", "expected"), [
    ("", "(I2 - I3)*c1*k2*k3 + (I3 - I1)*c2*k3*k1 + (I1 - I2)*c3*k1*k2", "confirmed"),
    ("", "(I2 - I3)*c1*k2*k3 + (I3 - I1)*c2*k3*k1 - (I1 - I2)*c3*k1*k2", "misprint"),
    ('at = { k1 = "0", k2 = "0" }\n', "0", "confirmed"), ('at = { k1 = "0" }\n', "0", "misprint")])
def test_cone(tmp_path, extra, printed, expected):
    """A sign of Staude's cone, and one of its lines."""
    found = finding(tmp_path, STILL, "staude_cone", printed, "identity", extra)
    assert found.status == expected and (found.outcome.counterexample is None) == (expected == "confirmed")


def test_a_point_that_is_no_equilibrium_is_refused(tmp_path):
    """With the rate that does not vanish."""
    with pytest.raises(ValueError, match="E is not an equilibrium: dpi1/dt = -c2"):
        status(tmp_path, STILL + '\npoint = ["0", "0", "0", "0", "0", "1"]', "p", "0", "identity")
