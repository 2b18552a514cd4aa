"""Where equilibria meet in fields of which it is known, and what is refused."""
from fractions import Fraction

import oracle
import pytest
from equilibria.meetings import FIELD, FIELDS, STEP, TERMS, k3, near, numbers_of, tilts
from slow import slow
from sympy import CRootOf, Rational, sqrt

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign
from gyrostat.equilibria.continuation.bifurcation_kinds import KINDS
from gyrostat.equilibria.continuation.meeting_equations import bifurcations
from gyrostat.equilibria.continuation.meeting_values import bifurcation_points
from gyrostat.equilibria.search import relative_equilibria
from gyrostat.errors import ScopeError, ValuesError
from gyrostat.notation import jet, jet_name


@pytest.mark.slow
@pytest.mark.parametrize("field", ["cubic", "oblate", *slow(("quartic",), ("quintic",))])
def test_where_a_tilt_leaves_a_pole_the_pole_keeps_its_stability(quintic, e1, e2, field):
    """There P² − 4 s I1 U' = (l − s (2 I1 − I3) s ω)² ≥ 0: E1, E2 stable on both sides.

    The tilt that leaves is stable too.
    """
    values = numbers_of(field) | {"omega": Fraction(3, 4)}
    points = [p for p in bifurcation_points(quintic, "l", {n: x for n, x in values.items() if n != "l"})
              if p.kind in STEP]
    poles = [p for p in points if p.kind.startswith("E3 leaves")]
    assert {p.kind for p in poles} == {"E3 leaves E1", "E3 leaves E2"}
    for p in poles:
        s = int(p.k3)
        slope = sum(n * values[f"a{n}"] * s ** (n - 1) for n in range(1, 6))
        exact = slope / values["omega"] + s * values["omega"] * (values["I1"] - values["I3"])
        assert p.value == Rational(exact.numerator, exact.denominator)
        margin = (exact + s * values["I3"] * values["omega"]) ** 2 - 4 * s * values["I1"] * slope
        assert margin == (exact + s * (values["I3"] - 2 * values["I1"]) * values["omega"]) ** 2 > 0
        for step in (0, Fraction(1, 10**8), -Fraction(1, 10**8)):
            found = relative_equilibria(quintic, values | {"l": exact + step})
            pole, beside = (found[0], found[1:2]) if s == 1 else (found[-1], found[-2:-1])
            assert pole.decision.verdict.name == "STABLE"
            if beside and abs(beside[0].place["k3"].evalf(30) - s) < 1e-5:
                assert beside[0].label == "E3" and beside[0].decision.verdict.name == "STABLE"


def test_where_precessions_leave_a_pole(quintic, e1, e2):
    """P² = ±4 I1 U'(±1): the margin is 0, Report.boundary decides.

    E1 and E2 are stable beyond, unstable before.
    """
    for field in FIELDS:
        values = {n: x for n, x in numbers_of(field).items() if n != "I3"}
        points = bifurcation_points(quintic, "pi3_0", values)
        slopes = {s: sum(n * values[f"a{n}"] * s ** (n - 1) for n in range(1, 6)) for s in (1, -1)}
        assert [p.kind for p in points if p.k3 == 1] == ["precessions leave E1"] * 2 * (slopes[1] > 0)
        assert [p.kind for p in points if p.k3 == -1] == ["precessions leave E2"] * 2 * (slopes[-1] < 0)
        for p in points:
            report, s = (e1, 1) if p.k3 == 1 else (e2, -1)
            assert abs((near(p.value) + values["l"]) ** 2 - 4 * s * values["I1"] * slopes[s]) < 1e-25
            jets = {
                jet_name(n): FIELD.diff(k3, n)
                .subs({a: Rational(values[a.name].numerator, values[a.name].denominator) for a in TERMS})
                .subs(k3, s)
                for n in range(1, 7)
            }
            at = {"I1": values["I1"], "l": values["l"], **jets}
            known = {n: x for n, x in at.items() if n in report.parameters or jet(n)}
            decision = report.verdict(known | {"pi3_0": p.value})
            assert "on the boundary" in decision.reason and decision.verdict.name in ("STABLE", "UNSTABLE")
            outward = 1 if near(p.value) + values["l"] > 0 else -1
            beside = [report.verdict(known | {"pi3_0": near(p.value) + d * outward
                                              * Fraction(1, 10**6)}).verdict.name for d in (1, -1)]
            assert beside == ["STABLE", "UNSTABLE"]


def test_the_lagrange_top():
    """I1 = 2, I3 = 1, m0 = 3, ω = 1: E3 between l = 2 and l = 4; the sleeping top is left at P² = 4 I1 m0.

    No fold at a fixed rate.
    """
    top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    body = {"I1": 2, "I3": 1, "m0": 3}
    assert [(p.kind, p.value, p.k3) for p in bifurcation_points(top, "l", body | {"omega": 1})] == [
        ("E3 leaves E2", 2, -1), ("E3 leaves E1", 4, 1)]
    assert [len(tilts(top, body | {"omega": 1, "l": x})) for x in (1, 2, 3, 4, 5)] == [0, 0, 1, 0, 0]
    assert [(p.kind, p.value) for p in bifurcation_points(top, "pi3_0", body | {"l": 0})] == [
        ("precessions leave E1", -2 * sqrt(6)), ("precessions leave E1", 2 * sqrt(6))]
    # every precession is stable (S5)
    assert [p.kind for p in bifurcation_points(top, "C1", body | {"l": 1, "pi3_0": 1})] == []


def test_a_moment_stays_positive():
    """A free moment by any name: only positive values.

    U = a k3, ω = 1: E3 leaves E1 at I1 = I3 + l − a, E2 at I1 = I3 − l + a.
    """
    A, C, l, a = map(gs.symbol, ("A", "C", "l", "a"))
    for body, name in ((gs.Gyrostat((A, A, C), (0, 0, l)), "A"), (gs.symmetric_gyrostat(), "I1")):
        scene = gs.assemble(body, gs.axial_potential(a * k3))
        third = "I3" if name == "I1" else "C"
        for rotor, field in ((-5, 1), (5, -1), (1, 0), (-1, Rational(1, 2))):
            points = bifurcation_points(scene, name, {third: 1, "l": rotor, "a": field, "omega": 1})
            expected = [(x, s) for x, s in ((1 + rotor - field, 1), (1 - rotor + field, -1)) if x > 0]
            assert [(p.value, p.k3) for p in points] == sorted(expected)


def test_folds_beside_a_value_at_which_every_tilt_turns():
    """l = a, U = a k3 + a² k3²/2 + a k3⁴ at ω = 1: all vanishes at a = 0; the folds are those of U/a."""
    a = gs.symbol("a")
    inside = gs.axial_potential(a * k3 + a**2 * k3**2 / 2 + a * k3**4)
    scene = gs.assemble(gs.Gyrostat((2, 2, 2), (0, 0, a)), inside)
    points = [p for p in bifurcation_points(scene, "a", {"omega": Rational(1, 2)})
              if p.kind == "fold at fixed rate"]
    f = lambda t: [Fraction(1, 2), t, Fraction(0), Fraction(4)]  # noqa: E731
    values = [near(p.value) for p in points]
    assert len(values) == 1
    counts = [oracle.count_roots(f(t), -1, 1) for t in (values[0] - Fraction(1, 100),
                                                        values[0] + Fraction(1, 100))]
    assert sorted(counts) in ([0, 2], [1, 3])


def test_algebraic_numbers_are_given():
    """l = √3 and ω = √2 given: a fold of U = a k3 + k3³ at ω = √2 where 6 k3 + 2 (I1 − I3) = 0, by hand."""
    a = gs.symbol("a")
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(a * k3 + k3**3))
    points = bifurcation_points(scene, "a", {"I1": 2, "I3": 1, "l": sqrt(3), "omega": sqrt(2)})
    assert [(p.kind, p.value, p.k3) for p in points] == [
        ("E3 leaves E1", sqrt(6) - 5, 1), ("E3 leaves E2", sqrt(6) - 1, -1),
        ("fold at fixed rate", sqrt(6) + Rational(1, 3), -Rational(1, 3))]
    rho = CRootOf(k3**3 - k3 - 1, 0)                   # written in k3 itself
    (fold,) = [p for p in bifurcation_points(scene, "a", {"I1": 2, "I3": 1, "l": rho, "omega": 1})
               if p.kind == "fold at fixed rate"]
    assert fold.k3 == -Rational(1, 6) and sign(fold.value - rho - Rational(1, 12), {}) == 0


def test_a_field_that_is_infinite_at_a_pole():
    """U = a/(1 − k3): nothing leaves E1, which does not exist."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(gs.symbol("a") / (1 - k3)))
    body = {"I1": 2, "I3": 1, "a": -1}
    points = bifurcation_points(scene, "l", body | {"omega": 1}) + bifurcation_points(
        scene, "pi3_0", body | {"l": 0}
    )
    kinds = {p.kind for p in points}
    assert "E3 leaves E2" in kinds and not any(kind.endswith("E1") for kind in kinds)


def test_a_field_of_numbers_that_is_infinite_at_a_pole():
    """U = 1/(1 − k3) at ω = 1, I1 − I3 = 1: E3 leaves E2 where l = 1/4 − 1; nothing leaves E1."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(1 / (1 - k3)))
    points = bifurcation_points(scene, "l", {"I1": 2, "I3": 1, "omega": 1})
    assert [(p.kind, p.value) for p in points if p.kind.startswith("E3")] == [
        ("E3 leaves E2", Rational(1, 4) - 1)
    ]
    assert {p.kind for p in bifurcation_points(scene, "pi3_0", {"I1": 2, "I3": 1, "l": 0})} <= {
        "precessions leave E2"
    }


def test_a_tilt_that_exists_at_every_rate_is_crossed():
    """U = k3⁴ − k3²/2, l = 0: k3 = 0 is E3 at every ω.

    4 k3² = 1 − (I1 − I3) ω² branches from it where ω² = 1.
    """
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(k3**4 - k3**2 / 2))
    points = bifurcation_points(scene, "omega", {"I1": 2, "I3": 1, "l": 0})
    assert [(p.value, p.k3) for p in points if p.kind == "pitchfork at fixed rate"] == [(-1, 0), (1, 0)]
    assert not [p for p in points if p.kind == "fold at fixed rate"]


def test_every_kind_says_what_happens(scene):
    """The kinds of the equations, of a top and of free gyrostats, are those that are described."""
    tops = [b.kind for b in bifurcations(scene)]
    free = [gs.Gyrostat(gyrostatic_momentum=(0, gs.symbol("l2"), gs.symbol("l3"))), gs.symmetric_gyrostat()]
    rotations = {b.kind for body in free for b in bifurcations(gs.assemble(body))}
    assert tops == list(KINDS)[:len(tops)] and rotations == set(KINDS) - {*tops}


@pytest.mark.parametrize(("values", "name", "message"), [
    ({"omega": 1, "m0": 1}, "foo", "no parameter foo"),
    ({"omega": 1, "m0": 1, "foo": 1}, "l", "no parameter foo"),
    ({"omega": 1}, "l", "E3 leaves E1 needs m0: give a number"),
    ({"m0": 1, "omega": 1, "pi3_0": 1}, "l", "given were"),
    ({"m0": 1, "l": 1}, "m0", "m0 is free"), ({"m0": 1, "C1": 1}, "l", "l is free"),
    ({"m0": 1, "omega": 1, "I1": -1}, "l", "I1 = -1, but a moment"),
    ({"m0": 1, "omega": 1, "l": 1}, "l", "l is free"),
    ({"m0": 1, "omega": 1, "k3": 0}, "l", "no parameter k3")])
def test_what_is_asked_must_be_clear(values, name, message):
    """Unknown and missing names, a name both given and free, rate and level together: refused."""
    top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    with pytest.raises(ValuesError, match=message):
        bifurcation_points(top, name, {"I1": 2, "I3": 1} | values)


def test_scenes_out_of_scope(scene, asymmetric):
    """Unspecified U, three moments, a transcendental U."""
    for refused, why in ((scene, "is unspecified, and all equilibria are found in a field"),
                         (asymmetric, "no body of revolution about axis 3 .*continuation marks")):
        with pytest.raises(ScopeError, match=why):
            bifurcation_points(refused, "l", {"I1": 2, "I3": 1, "omega": 1})
    k1, k2 = gs.symbol("k1"), gs.symbol("k2")
    for inertia in ((1, 2, 3), [[2, 1, 0], [1, 2, 0], [0, 0, 3]]):
        other = gs.assemble(gs.Gyrostat(inertia, (1, 0, 1)), gs.general_potential(k1 + k2))
        for asked in (lambda: bifurcation_points(other, "omega", {}), lambda: gs.bifurcations(other)):  # noqa: B023
            with pytest.raises(ScopeError, match="no body of revolution about axis 3 .*continuation marks"):
                asked()
    waves = gs.assemble(gs.symmetric_gyrostat(),
                        gs.axial_potential(lambda k3: gs.symbol("a") * 2 ** (k3 / 2)))
    with pytest.raises(ScopeError, match="algebraic coefficients"):
        bifurcation_points(waves, "l", {"I1": 2, "I3": 1, "omega": 1, "a": 1})
