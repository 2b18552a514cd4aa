"""The family of permanent rotations: its equations, what is eliminated, what is refused."""
import pytest
from sympy import Matrix, cos, simplify, sin

import gyrostat as gs
from gyrostat.errors import EquilibriumError, PotentialError, ScopeError, ValuesError

a, m0, omega, sigma = map(gs.symbol, ("a", "m0", "omega", "sigma"))
c = [gs.symbol(f"c{n}") for n in (1, 2, 3)]
ROTOR = tuple(gs.symbol(f"l{n}") for n in (1, 2, 3))
PLANE = sin(a), 0, cos(a)


def linear(*k):
    return sum(x * y for x, y in zip(c, k))


def family(U, direction, body=None):
    scene = gs.assemble(body or gs.Gyrostat(gyrostatic_momentum=ROTOR), gs.general_potential(U))
    return gs.permanent_rotation(scene, direction)


def test_stereographic_directions_are_unit_vectors():
    """On the line from −e3 to k lies (u1, u2, 0)."""
    k = Matrix(gs.stereographic())
    assert simplify(k.dot(k)) == 1
    south = Matrix([0, 0, -1])
    place = ((k - south) / (1 + k[2]) + south).applyfunc(simplify)
    assert place == Matrix([gs.symbol("u1"), gs.symbol("u2"), 0])


@pytest.mark.few(1)
@pytest.mark.parametrize("direction", [("1/3", "2/3", "2/3"), (0, 0, 1), PLANE, gs.stereographic()])
@pytest.mark.parametrize("U", [None, linear, lambda *k: linear(*k) + m0 * k[0] * k[1]])
def test_the_field_is_that_of_the_rotation(U, direction):
    """∇U = omega² Ik + omega l + sigma k, whatever U is; nothing else is asked of the family."""
    eq = family(U, direction)
    k = Matrix(eq.point[3:])
    slope = eq.insert(eq.at_point(Matrix(eq.system.potential.gradient())))
    wanted = omega**2 * eq.system.body.tensor * k + omega * Matrix(ROTOR) + sigma * k
    assert (slope - wanted).applyfunc(simplify) == Matrix([0, 0, 0])
    assert eq.point[:3] == tuple(omega * eq.system.body.tensor * k)
    assert eq.eliminated == (("c1", "c2", "c3") if U else ("dU_1", "dU_2", "dU_3"))
    assert eq.constraints == eq.domain == ()


@pytest.mark.parametrize(("U", "names", "domain"), [
    (lambda x, y, z: m0 * z, ("m0",), ()), (lambda x, y, z: m0 * (a * x + z), ("a", "m0"), ("m0**2",)),
    (lambda x, y, z: linear(x, y, z) + m0 * x**3, ("c1", "c2", "c3"), ()),
    (lambda x, y, z: m0 * x + a * y * z, ("m0", "a"), ())])
def test_a_parameter_goes_for_each_equation(U, names, domain):
    """One with a number before it first; what divides must not vanish."""
    eq = family(U, ("2/3", "1/3", "2/3"))
    assert eq.eliminated == names and tuple(map(str, eq.domain)) == domain
    assert len(eq.constraints) == 3 - len(names)


def test_equations_that_are_left_are_checked():
    """m0 of U = m0 k3 follows from the third equation; in a plane without a rotor the first fixes sigma."""
    eq = family(lambda x, y, z: m0 * z, ("3/5", 0, "4/5"), gs.Gyrostat((1, 2, 3), (0, 0, 0)))
    report = gs.analyze(eq)
    assert report.verdict({"omega": 2, "sigma": -4}).verdict.name == "UNSTABLE"
    assert report.verdict({"omega": 2, "sigma": -4, "m0": "32/5"}).verdict.name == "UNSTABLE"
    with pytest.raises(ValuesError, match="not on permanent rotation: .* is -3/5, not 0"):
        report.verdict({"omega": 2, "sigma": -3})
    with pytest.raises(ValuesError, match="needs m0 = 32/5, given was 6; omit m0, or correct it"):
        report.verdict({"omega": 2, "sigma": -4, "m0": 6})


@pytest.mark.parametrize("name", ["c1", "c2", "c3"])
def test_every_eliminated_name_is_checked(name):
    report = gs.analyze(family(linear, (0, 0, 1), gs.Gyrostat((2, 3, 1), (1, 0, -1))))
    needs = {"c1": 2, "c2": 0, "c3": 7}
    values = {"omega": 2, "sigma": 5}
    assert report.verdict(values).verdict is report.verdict(values | needs).verdict
    with pytest.raises(ValuesError, match=f"it needs {name} = {needs[name]}, given was 9"):
        report.verdict(values | needs | {name: 9})


def test_what_a_claimed_point_expresses_is_checked():
    """Derivatives of an unspecified U too, and each of several names."""
    scene = gs.assemble(gs.Gyrostat((2, 3, 1), (0, 0, 0)), gs.general_potential())
    eq = gs.equilibrium(scene, (0, 0, omega, 0, 0, 1), relations=[("dU_1", 0), ("dU_2", 0)])
    values = {"omega": 1, "dU_3": 1, "d2U_11": 1, "d2U_22": 1, "d2U_12": 0}
    assert gs.analyze(eq).verdict(values | {"dU_1": 0}).verdict is gs.analyze(eq).verdict(values).verdict
    with pytest.raises(ValuesError, match="needs dU_1 = 0, given was 3"):
        gs.analyze(eq).verdict(values | {"dU_1": 3})


@pytest.mark.parametrize(("direction", "message"), [
    ((1, 1, 0), r"k = \(1, 1, 0\) with \|k\|² − 1 = 1: k is a direction"),
    ((1, 0), "direction has 2 entries: give the three components of k"),
    ((sin(gs.symbol("c1")), 0, cos(gs.symbol("c1"))), "c1 is a name of the scene and one of the direction"),
    ((sin(sigma), 0, cos(sigma)), "direction depends on sigma, the multiplier"),
    ((sin(omega), 0, cos(omega)), "direction depends on omega, the rate about the vertical")])
def test_directions_that_are_none(direction, message):
    with pytest.raises(EquilibriumError, match=message):
        family(linear, direction)


@pytest.mark.parametrize(("scene", "message"), [
    (gs.assemble(gs.Gyrostat()), "this scene has none: use principal_rotation"),
    (gs.assemble(gs.Gyrostat(), gs.axial_potential()), "has U = U.k3.: use U.k1, k2, k3., general_potential"),
    (gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), "has U = k3.m0: use U.k1, k2, k3.")])
def test_scenes_that_have_no_such_family(scene, message):
    with pytest.raises(ScopeError, match=message):
        gs.permanent_rotation(scene, (0, 0, 1))


def test_a_field_along_axis_3_is_one_in_k1_k2_k3():
    """Of an asymmetric body: m0 k3 is entered as U(k3)."""
    body, direction = gs.Gyrostat((1, 2, 3), (0, 0, 0)), ("3/5", 0, "4/5")
    axial = gs.permanent_rotation(gs.assemble(body, gs.uniform_field()), direction)
    general = family(lambda x, y, z: m0 * z, direction, body)
    assert (axial.point, axial.relations, axial.constraints) == (
        general.point, general.relations, general.constraints)


def test_a_field_in_numbers_has_no_family():
    with pytest.raises(EquilibriumError, match="no parameter that ∇U.k. determines.* relative_equilibria"):
        family(lambda x, y, z: x + 2 * y, (0, 0, 1))
    with pytest.raises(PotentialError, match="depends on sigma, the multiplier .*, as in U = k1.s"):
        family(lambda x, y, z: sigma * x, (0, 0, 1))
