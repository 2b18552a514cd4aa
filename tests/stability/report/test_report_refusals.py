"""Values that are no values: refused with what to give, or noted."""
import pytest
from sympy import GoldenRatio, Rational, sqrt, symbols

import gyrostat as gs
from gyrostat.errors import ArgumentError, EquilibriumError, GyrostatError, ValuesError
from gyrostat.stability.decision import Verdict

k3 = gs.symbol("k3")


@pytest.mark.parametrize(("values", "why"), [
    ({"I1": 1, "l": 0, "pi3_0": 1}, "needs dU"),
    ({"I1": 1, "l": 0, "pi3_0": 1, "dU": 1, "mass": 3}, "no parameter mass"),
    ({"I1": 0, "l": 0, "pi3_0": 1, "dU": 1}, "I1 = 0.*must be positive"),
    ({"I1": -1, "l": 0, "pi3_0": 1, "dU": 1}, "must be positive"),
    ({"I1": 1, "l": float("nan"), "pi3_0": 1, "dU": 1}, "l = nan is not finite"),
    ({"I1": float("inf"), "l": 0, "pi3_0": 1, "dU": 1}, "not finite"),
    ({"I1": 1, "l": "x", "pi3_0": 1, "dU": 1}, "contains the names"),
    ({"I1": 1, "l": "1/", "pi3_0": 1, "dU": 1}, "cannot read"),
    ({"I1": 1, "I3": -2, "l": 0, "pi3_0": 1, "dU": 1}, "I3 = -2"),
    ({"I1": GoldenRatio, "l": 0, "pi3_0": 1, "dU": 1}, "cannot be enclosed"),
    ({"I1": 1, "l": None, "pi3_0": 1, "dU": 1}, "NoneType"),
    ({"I1": 1, "l": 0, "omega3_0": 1, "dU": 1}, "no parameter omega3_0")])
def test_bad_values_are_refused(e1, values, why):
    """What was given, why it is impossible, what to do."""
    with pytest.raises(GyrostatError, match=why):
        e1.verdict(values)


def test_points_off_the_family_are_refused(e3):
    """abs(k3) < 1, ω ≠ 0 where l is eliminated, and the eliminated name, if given, must satisfy the relation
    exactly.
    """
    values = {"I1": 2, "I3": 1, "l": 1, "omega": 1, "k3": "1/2", "d2U": 1}
    assert e3.verdict(values | {"dU": "1/2"}) == e3.verdict(values)
    with pytest.raises(ValuesError, match="not on E3.*omit dU"):
        e3.verdict(values | {"dU": 0.5 + 2**-52})
    for k in (1, -1, "3/2", "sqrt(2)"):
        with pytest.raises(ValuesError, match="exists only where"):
            e3.verdict(values | {"k3": k})
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    heavy = {"I1": 2, "I3": 1, "omega": 1, "k3": "1/2", "m0": 1}
    assert report.verdict(heavy | {"l": "3/2"}) == report.verdict(heavy)
    with pytest.raises(ValuesError, match="not on E3: it needs l = 3/2, given was 1; omit l"):
        report.verdict(heavy | {"l": 1})
    with pytest.raises(ValuesError, match="exists only where"):
        report.verdict(heavy | {"omega": 0})
    # U = k3³, I1 − I3 = 1, l = 2: k3 ω² − 2 ω + 3 k3² = 0 has the roots 2 ± √(5/2) at k3 = 1/2
    numeric = gs.analyze(gs.inclined(gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 2)),
                                                 gs.axial_potential(k3**3))))
    assert numeric.verdict({"k3": "1/2", "omega": "2 - sqrt(5/2)"}).verdict is Verdict.STABLE
    with pytest.raises(ValuesError, match="not on E3.*correct"):
        numeric.verdict({"k3": "1/2", "omega": "0.418861169915810"})


def test_eliminated_moments_are_positive_too():
    """A moment that the relation makes −21 is no moment."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    for name, values in (("I1", {"I3": 1, "l": -10, "m0": 1, "k3": "1/2", "omega": 1}),
                         ("I3", {"I1": 1, "l": 10, "m0": 1, "k3": "1/2", "omega": 1})):
        with pytest.raises(ValuesError, match="exists only where"):
            gs.analyze(gs.inclined(scene, eliminate=name)).verdict(values)
    with pytest.raises(EquilibriumError, match="moments of inertia are positive"):
        gs.equilibrium(scene, (0, 0, 1, 0, 0, 1), relations=(("I1", -1),))


def test_a_point_may_use_the_names_of_coordinates():
    """k = (k3, 0, √(1 − k3²)): the parameter k3 is not the coordinate k3."""
    k2, k1 = gs.symbol("k2"), gs.symbol("k1")
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (1, 0, 0)), gs.general_potential(k2**2 * k1))
    family = gs.equilibrium(scene, (0, 0, 0, k3, 0, sqrt(1 - k3**2)), domain=(1 - k3**2,))
    at = gs.equilibrium(scene, (0, 0, 0, Rational(-3, 5), 0, Rational(4, 5)))
    assert (
        gs.analyze(family).verdict({"k3": "-3/5"}).verdict
        is gs.analyze(at).verdict({}).verdict
        is Verdict.UNSTABLE
    )
    other = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)),
                        gs.general_potential(lambda x, y, z: x**2 + z**2 + y**3))
    assert gs.equilibrium(other, (0, 0, 0, k3, 0, sqrt(1 - k3**2)), domain=(1 - k3**2,))


def test_relations_that_the_field_does_not_satisfy():
    """U = k3 has U' = 1: no relation makes it 0, alone or followed by another."""
    scene = gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, 3)), gs.axial_potential(k3))
    for more in ((), (("a", 1),)):
        with pytest.raises(EquilibriumError, match="off by 1"):
            gs.equilibrium(scene, (0, 0, 0, sqrt(1 - k3**2), 0, k3), relations=(("dU", 0), *more),
                           domain=(1 - k3**2,))


def test_moments_with_names_of_the_user_are_positive():
    """A body of moments A, C: both must be positive, as I1 and I3 are."""
    A, C = symbols("A C")
    report = gs.analyze(gs.upright(gs.assemble(gs.Gyrostat((A, A, C), (0, 0, 0)), gs.uniform_field())))
    assert len(report.sufficient.alternatives) == 1
    assert report.verdict({"A": 1, "C": 1, "m0": 1, "pi3_0": 3}).verdict is Verdict.STABLE
    with pytest.raises(ValuesError, match="exists only where"):
        report.verdict({"A": -1, "C": 1, "m0": 1, "pi3_0": 4})


def test_wrong_kinds_are_named(scene):
    """A scene where an equilibrium is wanted, arguments in the wrong order."""
    for call in (lambda: gs.analyze(scene), lambda: gs.assemble(gs.uniform_field(), gs.symmetric_gyrostat()),
                 lambda: gs.Gyrostat(1),
                 lambda: gs.upright(gs.symmetric_gyrostat()), lambda: gs.inclined(None),
                 lambda: gs.equilibrium(3, (0,))):
        with pytest.raises(ArgumentError,
                           match="is an? .*, (not an? |a scene: choose one of its equilibria, upright)"):
            call()


def test_names_are_suggested(e1):
    """omega3 is no parameter; pi3_0 is, and omega3_0 with spin=."""
    with pytest.raises(ValuesError, match=r'did you mean omega3_0\? .*spin="omega3_0"'):
        e1.verdict({"I1": 1, "l": 0, "omega3": 1, "dU": 1})


def test_unusual_moments_are_noted(e1):
    """I3 > I1 + I2 belongs to no rigid body: a note, never an error."""
    decision = e1.verdict({"I1": 1, "I3": 5, "l": 0, "pi3_0": 3, "dU": 1})
    assert decision.verdict is Verdict.STABLE and "no rigid body" in decision.note
    assert e1.verdict({"I1": 1, "I3": 2, "l": 0, "pi3_0": 3, "dU": 1}).note == ""
