"""E1 and E2 where U has roots of 1 ∓ k3: criteria and ladder, against motions and against smooth fields."""
import json
import random

import mpmath
import numpy as np
import oracle
import pytest
from commands import run
from scipy.integrate import solve_ivp
from slow import slow
from sympy import Rational, acos, asin, cos, exp, lambdify, sqrt

import gyrostat as gs
from gyrostat.errors import EquilibriumError, ScopeError
from gyrostat.mechanics.equilibrium.near_pole import in_powers

k3, m0 = gs.symbol("k3"), gs.symbol("m0")
HALF = Rational(1, 2)
BODY = {"I1": 2, "I3": 1, "l": 0}


def report(U, side=1):
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U))
    return gs.analyze((gs.upright if side == 1 else gs.hanging)(scene))


@pytest.mark.few(2)
@pytest.mark.parametrize("U, side", [
    ((1 - k3)**(5 * HALF), 1), ((1 + k3)**(3 * HALF) - k3**2, -1), ((1 - k3**2)**Rational(4, 3), 1),
    (acos(k3)**2, 1), (asin(k3)**3 * (1 - k3), 1), (acos(-k3)**3, -1), (exp(-(1 - k3)**(3 * HALF)), 1),
    (cos(acos(k3) / 2), 1), (k3 * sqrt(2 - k3) + (1 - k3)**(7 * HALF) / (3 + k3), 1),
    ((1 - k3)**(5 * HALF) + (1 - k3)**Rational(7, 3), 1), (sqrt(1 - k3 + (1 - k3)**2) * (1 - k3), 1)])
def test_the_series_is_that_of_the_field(U, side):
    """At x = 10⁻⁸ ten terms are U within what comes after them, at 60 digits."""
    series = in_powers(U, side)
    count = 10
    with mpmath.workdps(60):
        x = mpmath.mpf(10)**-8
        terms = [mpmath.mpf(str(series.coefficient(n).evalf(60))) * x**(mpmath.mpf(n) / series.order)
                 for n in range(count)]
        value = lambdify(k3, U, "mpmath")(side * (1 - x))
        assert abs(value - mpmath.fsum(terms)) < 100 * x**(mpmath.mpf(count) / series.order)


@pytest.mark.parametrize("power, sign, spin, wanted", [
    (5 * HALF, 1, 0, "STABLE"), (5 * HALF, -1, 0, "UNSTABLE"), (3 * HALF, 1, 0, "STABLE"),
    (3 * HALF, -1, 0, "UNSTABLE"), (Rational(7, 3), 1, 0, "STABLE"), (Rational(7, 3), -1, 0, "UNSTABLE"),
    (5 * HALF, -1, 1, "STABLE"), (3 * HALF, -1, -1, "STABLE")])
def test_without_a_slope_at_the_pole(power, sign, spin, wanted):
    """U = ±(1 − k3)ᵃ: U' = 0 at E1, stable where π3 + l ≠ 0; at π3 + l = 0 as U is least or greatest."""
    found = report(sign * (1 - k3)**power)
    (condition,), = found.sufficient.alternatives
    assert found.necessary.alternatives == ((),) and str(condition) == "π₃⁰ + l ≠ 0"
    decision = found.verdict({"l": 0, "pi3_0": spin})
    assert decision.verdict.name == wanted
    assert spin or f"x^({power + 1})" in decision.reason


@pytest.mark.parametrize("power, sign, wanted", [
    (3 * HALF, -1, "UNSTABLE"), (3 * HALF, 1, "STABLE"), (5 * HALF, -1, "STABLE"), (5 * HALF, 1, "STABLE")])
def test_on_the_boundary_with_a_slope(power, sign, wanted):
    """U = k3 ± (1 − k3)ᵃ on (π3 + l)² = 4 I1: a = 3/2 decides before x³, by which k3 is held, 5/2 after."""
    found = report(k3 + sign * (1 - k3)**power)
    assert found.verdict(BODY | {"pi3_0": sqrt(8)}).verdict.name == wanted
    assert found.verdict(BODY | {"pi3_0": 3}).verdict.name == "STABLE"
    assert found.verdict(BODY | {"pi3_0": Rational(14, 5)}).verdict.name == "UNSTABLE"


def leaves(U, I1, I3, spin, start, time):
    """The largest distance from e3 of k that begins at so great a one, at rest about the axis across."""
    slope = lambdify(k3, U.diff(k3), "numpy")
    state = [0, 0, spin, np.sin(start), 0, np.cos(start)]

    def field(_, x):
        return oracle.field(x, np.array([I1, I1, I3]), np.zeros(3),
                            lambda k: np.array([0, 0, slope(min(k[2], 1.0))]))

    motion = solve_ivp(field, (0, time), state, method="DOP853", rtol=1e-11, atol=1e-13)
    return np.hypot(motion.y[3], motion.y[4]).max()


@pytest.mark.parametrize("U, spin, stable", slow(
    (k3 - (1 - k3)**(3 * HALF), 8**0.5, False), (k3 + (1 - k3)**(3 * HALF), 8**0.5, True),
    (k3 - (1 - k3)**(5 * HALF) / 10, 8**0.5, True), ((1 - k3)**(3 * HALF), 0.0, True),
    ((1 - k3)**(5 * HALF), 0.0, True), (-(1 - k3)**(5 * HALF), 0.0, False), (-acos(k3)**2 / 2, 8**0.5, True),
    (-(1 - k3)**Rational(4, 3), 0.0, False), (-(1 - k3)**Rational(4, 3), 3.0, True)))
def test_motions_beside_it(U, spin, stable):
    """Integrated: what is stable stays within a multiple of a power of its start, what is not goes far."""
    pi3 = sqrt(8) if spin == 8**0.5 else Rational(spin).limit_denominator(100)
    found = report(U).verdict(BODY | {"pi3_0": pi3})
    assert (found.verdict.name == "STABLE") is stable
    for start in (0.1, 0.05):
        far = leaves(U, 2.0, 1.0, spin, start, 500.0)
        assert far < 2 * start**0.5 if stable else far > 0.8, (U, start, far)


@pytest.mark.slow
def test_a_smooth_field_in_the_angle():
    """cos(θ/2)² is (1 + k3)/2, θ²/2 is 1 − k3 + (1 − k3)²/6 + …: the same conditions and ladder as theirs."""
    x = 1 - k3
    rng = random.Random("angle")
    pairs = ((m0 * cos(acos(k3) / 2)**2, m0 * (1 + k3) / 2),
             (-m0 * acos(k3)**2 / 2, -m0 * (x + x**2 / 6 + 2 * x**3 / 45 + x**4 / 70)))
    for U, smooth in pairs:
        one, other = report(U), report(smooth)
        assert str(one.sufficient) == str(other.sufficient) and str(one.necessary) == str(other.necessary)
        for _ in range(4):
            height = Rational(rng.randint(1, 9), rng.randint(1, 4))
            slope = height / 2 if U.has(cos) else height
            for spin in (sqrt(8 * slope), Rational(rng.randint(0, 9), 2)):
                values = BODY | {"m0": height, "pi3_0": spin}
                first, second = one.verdict(values), other.verdict(values)
                assert first.verdict is second.verdict and first.verdict.name != "UNDECIDED"
                assert one.verdict(values, damped=True).verdict is other.verdict(values, damped=True).verdict


def test_under_damping():
    """At rest, where h has a strict minimum of the power 5/2, and where the damping cannot be told."""
    least, greatest = ((sign * (1 - k3)**(5 * HALF)) for sign in (1, -1))
    assert report(least).verdict(BODY | {"pi3_0": 0}, damped=True).verdict.name == "STABLE"
    assert "power 5/2" in report(least).verdict(BODY | {"pi3_0": 0}, damped=True).reason
    assert report(greatest).verdict(BODY | {"pi3_0": 0}, damped=True).verdict.name == "UNDECIDED"


@pytest.mark.parametrize("U, why", [
    ((1 - k3)**Rational(3, 4), "the power 3/4 of 1 - k3, and on the sphere it has one derivative, not two"),
    (sqrt(1 - k3**2), "the power 1/2 of 1 - k3, and on the sphere it has no slope: that is no equilibrium"),
    (acos(k3), "the power 1/2 of 1 - k3, and on the sphere it has no slope"),
    ((1 - k3)**Rational(1, 4), "the power 1/4 of 1 - k3, and on the sphere it has no slope")])
def test_what_is_no_field_of_class_c2(U, why):
    with pytest.raises(EquilibriumError, match=f"E1 cannot be analysed: U changes near it as {why}"):
        report(U)


def test_an_asymmetric_body():
    """The criteria have U' alone: K is that of U = k3 without the root; what lies beyond is not decided."""
    bodies = [gs.assemble(gs.Gyrostat((2, 3, 4), (0, 0, 0)), gs.axial_potential(U))
              for U in (k3 + (1 - k3)**(3 * HALF), k3)]
    for rate, wanted in ((0, "UNSTABLE"), (2, "STABLE")):
        for scene in bodies:
            found = gs.analyze(gs.equilibrium(scene, (0, 0, 4 * rate, 0, 0, 1))).verdict({})
            assert found.verdict.name == wanted
    eq = gs.equilibrium(bodies[0], (0, 0, 4, 0, 0, 1))     # omega² = 1/(4 − 3)
    assert "powers of 1 ∓ k3 that are not whole" in gs.analyze(eq).verdict({}).reason
    with pytest.raises(ScopeError, match="has no normal form: U has powers of 1 ∓ k3"):
        gs.analyze(gs.equilibrium(bodies[0], (0, 0, 8, 0, 0, 1))).normal_form({})


def test_what_is_printed(capsys):
    """The ladder with its fractions, as text and as JSON; every relative equilibrium at a level."""
    given = ["--potential", "m0*k3 + a*(1-k3)^(5/2)", "--equilibrium", "E1"]
    said = " ".join(run(capsys, *given, verb="conditions")[1].split())
    assert "= Σ cₚ xᵖ, p = 5/2, 3, …" in said and "−c₃ ∝ m₀ −c₇/₂ ∝ a" in said
    data = json.loads(run(capsys, *given, "--format", "json", verb="conditions")[1])
    rungs = data["equilibria"][0]["boundary"]["rungs"]
    assert [rung["power"] for rung in rungs] == [3, "7/2"]


@pytest.mark.parametrize("text", ["(1-k3)^a", "2*(1+k3)^(a+1)"])
def test_a_name_in_an_exponent(text):
    """A text says what to write; in Python it works where the base is not 0, and where numbers are given."""
    with pytest.raises(gs.errors.ExpressionError, match=r"put a number in its place, or write exp\(.*log\("):
        gs.axial_potential(text)
    a = gs.symbol("a")
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential((1 - k3)**a))
    with pytest.raises(EquilibriumError, match=r"a power of 0 whose exponent has a in it; .* U.subs\(a, 2\)"):
        gs.upright(scene)
    whole = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential((1 - k3)**2))
    values = BODY | {"pi3_0": 1}
    assert gs.analyze(gs.hanging(scene)).verdict(values | {"a": 2}).verdict is gs.analyze(
        gs.hanging(whole)).verdict(values).verdict
    found, wanted = (gs.relative_equilibria(s, v | {"I1": 2, "I3": 1, "l": 0, "omega": 3})
                     for s, v in ((scene, {"a": 2}), (whole, {})))
    assert [(b.label, b.place["k3"], b.decision.verdict) for b in found] == [
        (b.label, b.place["k3"], b.decision.verdict) for b in wanted]
