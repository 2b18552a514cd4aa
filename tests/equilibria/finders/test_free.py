"""Permanent rotations: every equilibrium of a free gyrostat on a momentum sphere, with its decision."""

import numpy as np
import oracle
import pytest
from draw import moments, numbers
from hypothesis import assume, given, settings
from sympy import Rational, pi

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError

CASES = [((1, 2, 3), (0, 0, 0), 1), ((1, 2, 3), (0, 0, "0.55"), 1),
         ((2, 1, "3/2"), ("1/5", "1/10", "1/8"), 1),
         ((3, 2, 1), (0, "1/4", 1), 2), ((2, 3, 3), ("1/3", 0, 0), "3/2")]


def rotations(body, radius):
    """All on a momentum sphere."""
    return gs.relative_equilibria(gs.assemble(body), {"M": radius})


def doubles(vector):
    return np.array([float(x) for x in vector])


@pytest.mark.parametrize("inertia, rotor, radius", CASES)
def test_momentum_and_velocity_are_parallel(inertia, rotor, radius):
    """M × ω = 0 on abs(M) = R; the extrema less the saddles are two, Euler's number of the sphere."""
    body = gs.Gyrostat(inertia, rotor)
    points = rotations(body, radius)
    for point in points:
        M = doubles(point.momentum)
        field = oracle.free_field(M - doubles(body.gyrostatic_momentum), doubles(body.inertia),
                                  doubles(body.gyrostatic_momentum))
        np.testing.assert_allclose(field, 0, atol=1e-14)               # round-off of the exact numbers
        assert np.linalg.norm(M) == pytest.approx(float(Rational(radius)), rel=1e-15)
    if all(not point.locus for point in points):
        assert sum(1 if point.decision.verdict is gs.Verdict.STABLE else -1 for point in points) == 2


@settings(max_examples=5)
@given(I1=moments, I2=moments, I3=moments, l=numbers, spin=numbers)
def test_the_verdict_is_that_of_the_library(I1, I2, I3, l, spin):
    """On a principal axis that carries l the 2×2 second variation says what Report.verdict says."""
    M = I3 * spin + l
    assume(M and len({I1, I2, I3}) == 3)
    body = gs.Gyrostat((I1, I2, I3), (0, 0, l))
    (point,) = [p for p in rotations(body, abs(M)) if p.momentum == (0, 0, Rational(M))]
    report = gs.analyze(gs.principal_rotation(gs.assemble(body), 3))
    assert point.decision.verdict is report.verdict({"omega3_0": spin}).verdict


def test_verdict_at_a_general_point_is_that_of_the_spectrum():
    """With a rotor off every axis an equilibrium is stable where the field, differenced, has imaginary
    eigenvalues.
    """
    body = gs.Gyrostat((2, 1, "3/2"), ("1/5", "1/10", "1/8"))
    I, l = doubles(body.inertia), doubles(body.gyrostatic_momentum)
    points = rotations(body, 1)
    assert {p.decision.verdict.name for p in points} == {"STABLE", "UNSTABLE"} and len(points) in (4, 6)
    for point in points:
        J = oracle.jacobian(lambda x: oracle.free_field(x, I, l), doubles(point.momentum) - l,
                            1.0).astype(float)
        # growth rates here exceed 0.1
        assert (np.linalg.eigvals(J).real.max() > 1e-3) == (point.decision.verdict is gs.Verdict.UNSTABLE)


def test_circles_of_equilibria():
    """I1 = I2: the rotations about transverse axes are a circle, at the height l/(1 − I3/I1).

    The circle is stable; a point of it drifts along it.
    """
    (circle,) = [p for p in rotations(gs.Gyrostat((1, 1, 2), (0, 0, "-1/5")), 1) if p.locus]
    assert circle.form.circle == (0, 0, 1)
    assert circle.momentum[2] == Rational(1, 5)
    assert circle.decision.stable and circle.decision.scope == "modulo the flow of pi3"
    assert circle.itself.unstable and circle.itself.scope == ""
    (circle,) = [p for p in rotations(gs.Gyrostat((3, 2, 2), (0, 0, 0)), 1) if p.locus]
    assert circle.form.circle == (1, 0, 0) and circle.momentum[0] == 0


@pytest.mark.parametrize("spin", ["-1/2", "-1"])
def test_a_degenerate_point_is_decided_to_fourth_order(spin):
    """Where rotations meet at the pole, f2 = l + (I3 − I2) ω = 0 or f1 = 0, as Report.verdict decides."""
    inertia, l = (1, 2, 3), Rational(1, 2)
    l, radius = (l, 1) if spin == "-1/2" else (Rational(2), 1)
    south = next(p for p in rotations(gs.Gyrostat(inertia, (0, 0, l)), radius)
                 if p.momentum == (0, 0, 3 * Rational(spin) + l))
    report = gs.analyze(gs.principal_rotation(gs.assemble(gs.Gyrostat(inertia, (0, 0, l))), 3))
    assert south.form.signs[-1] == 0
    assert south.decision.verdict is report.verdict({"omega3_0": spin}).verdict


def test_all_moments_equal_and_no_rotor():
    """M is constant: the sphere is one stable set of equilibria."""
    (anywhere,) = rotations(gs.Gyrostat((2, 2, 2), (0, 0, 0)), 3)
    assert anywhere.form.circle == (0, 0, 0) and anywhere.energy == Rational(9, 4)
    assert anywhere.locus == "the whole sphere" and anywhere.frequencies == ()
    assert anywhere.decision.verdict is gs.Verdict.STABLE
    assert str(anywhere) == "permanent rotation at M = (3, 0, 0), and on the whole sphere: stable"


def test_no_momentum():
    """M = 0: a point that is its orbit."""
    (rest,) = gs.relative_equilibria(gs.assemble(gs.Gyrostat((1, 2, 3), (1, 0, "1/2"))), {"M": 0})
    assert rest.momentum == (0, 0, 0) and rest.energy == Rational(1, 2) + Rational(1, 24)
    assert rest.decision.verdict is gs.Verdict.STABLE and rest.form.nu is None and rest.growth_rate is None


@pytest.mark.parametrize("inertia, rotor, radius", [CASES[0], CASES[1], ((1, 2, 3), (0, "1/2", 0), 2)])
def test_the_one_verb_finds_them_and_the_report_agrees(inertia, rotor, radius):
    """relative_equilibria of a free scene; each decision is that of the report of its point."""
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=rotor))
    values = dict(zip(("I1", "I2", "I3"), inertia)) | {"M": radius}
    found = gs.relative_equilibria(scene, values)
    body = gs.Gyrostat(inertia, rotor)
    assert found == rotations(body, radius)
    free = gs.assemble(body)
    for rotation in found:
        point = [m - l for m, l in zip(rotation.momentum, body.gyrostatic_momentum)]
        decision = gs.analyze(gs.equilibrium(free, point)).verdict({})
        assert rotation.decision.verdict is decision.verdict and rotation.decision.notion == decision.notion
    assert str(found[0]).startswith("permanent rotation at M = (")


TENSOR = ((5, 1, 0), (1, 4, 0), (0, 0, 3))


@pytest.mark.few(1)
@pytest.mark.parametrize("inertia", [(5, 4, 3), TENSOR], ids=["moments", "tensor"])
def test_a_wheel_in_rpm_and_a_momentum_with_pi(inertia):
    """In units of π both are rational: the rotations are those of the rational ones, π times as large."""
    plain = gs.assemble(gs.Gyrostat(inertia, (1, 2, 2)))
    turned = gs.assemble(gs.Gyrostat(inertia, ("pi", "2*pi", "2*pi")))
    found, expected = (gs.relative_equilibria(s, {"M": M}) for s, M in ((turned, "30*pi"), (plain, 30)))
    assert len(found) > 2 and [x.form.nu for x in found] == [x.form.nu for x in expected]
    for x, y in zip(found, expected):
        np.testing.assert_allclose(doubles(x.momentum), np.pi * doubles(y.momentum), rtol=1e-14)
        assert x.decision == y.decision and x.damped == y.damped


@pytest.mark.slow
def test_a_range_of_rates_in_rpm():
    """The folds of l = π n (1, 2, 2) on abs(M) = 9 π are those of l = n (1, 2, 2) on 9."""
    folds = []
    for unit, M in ((pi, "9*pi"), (1, 9)):
        n = unit * gs.symbol("n")
        scene = gs.assemble(gs.Gyrostat((5, 4, 3), (n, 2 * n, 2 * n)))
        folds.append([mark.value for mark in gs.continuation(scene, "n", (0, 3), {"M": M}).marks])
    assert folds[0] == folds[1] and len(folds[0]) == 2


@pytest.mark.few(1)
@pytest.mark.parametrize("inertia", [(5, 4, 3), TENSOR], ids=["moments", "tensor"])
def test_a_wheel_in_rpm_and_a_rational_momentum(inertia):
    """As with a decimal for π; where rotations meet is not found."""
    scene, near = (gs.assemble(gs.Gyrostat(inertia, tuple(n * x for n in (1, 2, 2))))
                   for x in (pi, Rational("3.14159265358979323846")))
    found, wanted = (gs.relative_equilibria(s, {"M": 9}) for s in (scene, near))
    assert len(found) == len(wanted) >= 2
    for one, other in zip(found, wanted):
        assert np.allclose(*([float(x) for x in r.momentum] for r in (one, other)), rtol=0, atol=1e-12)
        assert one.decision.verdict is other.decision.verdict
        assert one.damped.verdict is other.damped.verdict
        assert abs(float(one.energy - other.energy)) < 1e-12
    with pytest.raises(ScopeError, match=r"l = \(pi, 2\*pi, 2\*pi\) and M = .*if only one of them contains pi"
                                         ".*rotations meet are not found; give M as a multiple of pi too"):
        gs.continuation(scene, "M", (1, 9), {})


@pytest.mark.parametrize("scene, values, error, words", [
    (gs.assemble(gs.Gyrostat((1, 2, 3))), {"l1": 0, "l2": 0, "l3": 0}, ValuesError, "need M: give"),
    (gs.assemble(gs.Gyrostat((1, 2, gs.symbol("I3")), (0, 0, 0))), {"M": 1}, ValuesError, "need I3: give"),
    (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))), {"M": -1}, ValuesError, "is not negative"),
    (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))), {"M": 1, "omega": 1}, ValuesError, "omega"),
    (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, gs.symbol("M")))), {"M": 1}, ScopeError,
     "has a parameter M, .* such as m")])
def test_what_is_refused(scene, values, error, words):
    """Names that are missing, unknown or taken, and a radius that is none."""
    with pytest.raises(error, match=words):
        gs.relative_equilibria(scene, values)
