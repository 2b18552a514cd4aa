"""Internal damping: verdicts and growing modes against a body with a viscous sphere inside; conditions."""
import random
from fractions import Fraction

import mpmath as mp
import pytest
from slow import sampled
from sympy import Rational
from viscous_sphere import growing_modes

import gyrostat as gs

TOP = gs.symmetric_gyrostat()
FIELD = gs.assemble(TOP, gs.axial_potential())
POLES = {1: gs.analyze(gs.upright(FIELD)), -1: gs.analyze(gs.hanging(FIELD))}
TILT = gs.analyze(gs.inclined(FIELD))


def signed(rnd):
    return Fraction(rnd.randint(-24, 24), rnd.choice([3, 4, 6, 12]))


def positive(rnd):
    return Fraction(rnd.randint(2, 24), rnd.choice([4, 5, 6]))


def moments(rnd):
    """Three moments, in one case of five two of them equal."""
    found = [positive(rnd) for _ in range(3)]
    if rnd.random() < 0.2:
        found[rnd.randrange(3)] = found[0]
    return found


def unit(rnd):
    """A rational direction, of a quaternion of whole numbers."""
    a, b, c, d = (rnd.randint(-3, 3) for _ in range(4))
    size = a * a + b * b + c * c + d * d
    if not size:
        return unit(rnd)
    row = a * a + b * b - c * c - d * d, 2 * (a * d + b * c), 2 * (b * d - a * c)
    return [Fraction(x, size) for x in row]


def floats(vector):
    with mp.workdps(50):
        return [mp.mpf(x.numerator) / x.denominator for x in vector]


def axial(x):
    """A vector along axis 3."""
    return floats([Fraction(0), Fraction(0), x])


def exact(vector):
    return tuple(Rational(x.numerator, x.denominator) for x in vector)


def pole(rnd, special):
    """E1 or E2; special: no slope of U, so that k moves by itself."""
    side, I1, I3 = rnd.choice([1, -1]), positive(rnd), positive(rnd)
    l, pi, curvature, slope = (signed(rnd) for _ in range(4))
    slope *= not special
    values = {"I1": I1, "I3": I3, "l": l, "pi3_0": pi, "dU": slope}
    return POLES[side].verdict(values, damped=True), growing_modes(
        floats([I1, I1, I3]), axial(l), axial(pi), (0, 0, side), axial(slope), mp.diag(axial(curvature)))


def tilt(rnd, special):
    """E3; special: no torque to first order."""
    I1, I3, l, rate, curvature = positive(rnd), positive(rnd), *(signed(rnd) for _ in range(3))
    m, n = rnd.randint(1, 5), rnd.randint(6, 9)
    k1, k3 = Fraction(2 * m * n, m * m + n * n), rnd.choice([1, -1]) * Fraction(m * m - n * n, m * m + n * n)
    if special:
        l, curvature = rate * k3 * (I1 - I3), Fraction(0)
    slope = rate * l - rate**2 * k3 * (I1 - I3)
    values = {"I1": I1, "I3": I3, "l": l, "omega": rate, "k3": k3, "d2U": curvature}
    pi, k = [I1 * rate * k1, Fraction(0), I3 * rate * k3], [k1, Fraction(0), k3]
    return TILT.verdict(values, damped=True), growing_modes(
        floats([I1, I1, I3]), axial(l), floats(pi), floats(k), axial(slope), mp.diag(axial(curvature)))


def free(rnd, special):
    """A free gyrostat that turns about any axis; special: without a rotor on one of them."""
    I, M, nu = moments(rnd), [signed(rnd) for _ in range(3)], signed(rnd)
    if special:
        M[rnd.randrange(3)] = Fraction(0)
    if not any(M):
        return free(rnd, special)
    rotor = [(1 - nu * i) * m for i, m in zip(I, M)]
    pi = [m - x for m, x in zip(M, rotor)]
    scene = gs.assemble(gs.Gyrostat(exact(I), exact(rotor)))
    return (gs.analyze(gs.equilibrium(scene, exact(pi))).verdict({}, damped=True),
            growing_modes(floats(I), floats(rotor), floats(pi)))


def field(rnd, special):
    """Any gyrostat that turns about k in a quadratic field; special: no torque to first order."""
    I, k, rate, along = moments(rnd), unit(rnd), signed(rnd), signed(rnd)
    rotor, curvature = [signed(rnd) for _ in range(3)], [[signed(rnd) for _ in range(3)] for _ in range(3)]
    curvature = [[curvature[min(i, j)][max(i, j)] for j in range(3)] for i in range(3)]
    slope = [rate * (rate * i * x + l) + along * x for i, x, l in zip(I, k, rotor)]
    if special:
        total, u = signed(rnd), curvature[0]
        rotor = [total * x - rate * i * x for i, x in zip(I, k)]
        slope = [along * x for x in k]
        curvature = [[along * (i == j) + k[i] * u[j] + u[i] * k[j] for j in range(3)] for i in range(3)]
    pi = [rate * i * x for i, x in zip(I, k)]
    at, g, H = exact(k), exact(slope), [exact(row) for row in curvature]

    def U(*place):
        d = [x - y for x, y in zip(place, at)]
        return (sum(x * y for x, y in zip(g, d))
                + sum(H[i][j] * d[i] * d[j] for i in range(3) for j in range(3)) / 2)

    scene = gs.assemble(gs.Gyrostat(exact(I), exact(rotor)), gs.general_potential(U))
    return (gs.analyze(gs.equilibrium(scene, exact(pi) + at)).verdict({}, damped=True),
            growing_modes(floats(I), floats(rotor), floats(pi), floats(k), floats(slope),
                          mp.matrix([floats(row) for row in curvature])))


@pytest.mark.few(1)
@pytest.mark.parametrize("cases", [2, pytest.param(260, marks=pytest.mark.slow)])
@pytest.mark.parametrize("special", [False, True])
@pytest.mark.parametrize("scene", [pole, tilt, free, field])
def test_growing_modes_are_those_of_a_viscous_sphere(scene, special, cases, full):
    """STABLE: none grows; UNSTABLE: as many as are said; UNDECIDED only where damping does not reach all."""
    rnd = random.Random(f"{scene.__name__} {special} {cases}")
    for _ in range(sampled(cases, full, 30)):
        decision, modes = scene(rnd, special)
        if decision.verdict is gs.Verdict.UNDECIDED:
            assert "does not reach every motion" in decision.reason or "to decide" in decision.reason
            assert modes == 0 or "from rest" in decision.reason
        elif decision.growing is None:                     # of no linear mode: degenerate
            assert "to fourth order" in decision.reason or "no extremum" in decision.reason
        else:
            assert decision.growing == modes
            assert (decision.verdict is gs.Verdict.STABLE) == (modes == 0)


@pytest.mark.parametrize("report, printed", [
    (gs.analyze(gs.principal_rotation(gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))), 3)),
     "I₃ > I₁ and I₃ > I₂"),
    (gs.analyze(gs.principal_rotation(gs.assemble(TOP), 3)), "(I₃ ω₃⁰ + l) (ω₃⁰ (I₁ − I₃) − l) < 0"),
    (gs.analyze(gs.upright(gs.assemble(TOP, gs.uniform_field()), spin="omega3_0")),
     "ω₃⁰ l > (ω₃⁰)² (I₁ − I₃) + m₀"),
    (gs.analyze(gs.static_tilt(FIELD)), "l² + U″(k₃) (I₁ + I₃ k₃² − I₁ k₃²) > 0, modulo the flow of π₃")])
def test_conditions_of_the_books(report, printed):
    """The major axis; Landon and Iorillo; the sleeping top, P ω > I1 ω² + m0; E3 at rest, D > 0."""
    assert str(report.damped) == printed


def test_the_tilt_is_kept_where_the_drift_is_defective_and_positive():
    """E3: D > 0, D from J³ + p J, another derivation."""
    assert set(TILT.damped.alternatives[0][0].margin.as_ordered_terms()) == set(
        TILT.drift.defect.expand().as_ordered_terms())


@pytest.mark.parametrize("spin, modes", [
    ("1.29", 2), ("sqrt(5/3)", 0), ("1.2909944488", 0), ("1.2909944487", 2)])
def test_the_sleeping_top_with_a_damper(spin, modes):
    """I1 = 1, I3 = 8/5, m0 = 1: stable above 1.25, with damping from 1/√0.6 on, there by the fourth order."""
    top = gs.analyze(gs.upright(gs.assemble(TOP, gs.uniform_field()), spin="omega3_0"))
    values = {"I1": 1, "I3": "1.6", "l": 0, "m0": 1, "omega3_0": spin}
    assert top.verdict(values).verdict is gs.Verdict.STABLE
    assert top.verdict(values, damped=True).growing == modes


@pytest.mark.parametrize("spin, growing", [("-1/4", 1), ("-1/2", None), ("-1/8", 0)])
def test_a_free_gyrostat_where_rotations_meet(spin, growing):
    """Degenerate: a negative square falls, as with a viscous sphere; at −1/2 terms of higher degree do."""
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/2")))
    report = gs.analyze(gs.principal_rotation(scene, 3))
    decision = report.verdict({"omega3_0": spin}, damped=True)
    assert decision.growing == growing and decision.stable == (growing == 0)


@pytest.mark.parametrize("values, verdict", [
    ({"d2U": -4}, "STABLE"), ({"d2U": -6}, "UNSTABLE"), ({}, "UNDECIDED"),
    ({"d2U": -5, "d3U": -37}, "STABLE"), ({"d2U": -5, "d3U": -35}, "UNSTABLE"), ({"d2U": -5}, "UNDECIDED")])
def test_where_the_second_variation_is_degenerate_the_next_term_decides(values, verdict):
    """E1 with I1 = 2, I3 = 1, l = 0, ω = 1, U′ = −1: W = U + 1/(2 (2 − k3²)), at k3 = 1 W″ = U″ + 5,
    W‴ = U‴ + 36, and k3 − 1 is negative.
    """
    report = gs.analyze(gs.upright(FIELD, spin="omega3_0"))
    given = {"I1": 2, "I3": 1, "l": 0, "omega3_0": 1, "dU": -1}
    decision = report.verdict(given | values, damped=True)
    assert decision.verdict.name == verdict


def test_another_axis_is_recognised():
    """A top about axis 1 is the top about axis 3."""
    body = gs.Gyrostat(("8/5", 1, 1), (0, 0, 0))
    scene = gs.assemble(body, gs.general_potential(lambda x, y, z: x))
    for spin, growing in (("1.28", 2), ("1.3", 0)):
        pi = Rational(8, 5) * Rational(spin)
        report = gs.analyze(gs.equilibrium(scene, (pi, 0, 0, 1, 0, 0)))
        assert report.verdict({}, damped=True).growing == growing


@pytest.mark.parametrize("curvature, verdict", [(-4, "UNDECIDED"), (1, "STABLE")])
def test_at_rest_no_damping_reaches_the_spin(curvature, verdict):
    """E3 with ω = 0: a spin about the axis goes on, so that D < 0 lets nothing grow; in arrays too."""
    values = {"I1": "6/5", "I3": "11/5", "l": "3/2", "omega": 0, "k3": "-15/17", "d2U": curvature}
    decision = TILT.verdict(values, damped=True)
    assert decision.verdict.name == verdict and decision.growing == (0 if curvature > 0 else None)
    rest = {name: x for name, x in values.items() if name != "omega"}
    still = gs.analyze(gs.static_tilt(FIELD)).verdict(rest, damped=True)
    assert still.verdict is decision.verdict
    assert growing_modes(floats([Fraction(6, 5), Fraction(6, 5), Fraction(11, 5)]), axial(Fraction(3, 2)),
                         (0, 0, 0), floats([Fraction(8, 17), Fraction(0), Fraction(-15, 17)]), (0, 0, 0),
                         mp.diag(axial(Fraction(curvature)))) == 0
    assert gs.charts.verdicts(TILT, values, damped=True) == (curvature > 0)


def test_names_that_only_the_modes_need_are_asked_for():
    """The inertias say that a satellite is at no minimum; the count of its modes needs omega0."""
    scene = gs.assemble(gs.Gyrostat(gyrostatic_momentum=(0, 0, 0)), gs.circular_orbit())
    report = gs.analyze(gs.earth_pointing(scene, 2, 3, 1))
    inertias = {"I1": "3/2", "I2": 1, "I3": 1}
    assert "omega0" not in report.secular.compared and "omega0" in report.secular.required
    decision = report.verdict(inertias, damped=True)
    assert (decision.verdict.name, decision.reason) == ("UNDECIDED", "give omega0 to decide")
    assert report.verdict({**inertias, "omega0": 1}, damped=True).reason != decision.reason
