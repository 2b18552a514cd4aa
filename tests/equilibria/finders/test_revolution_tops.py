"""All relative equilibria of the Lagrange top, and of tilts that turn alike."""
from fractions import Fraction

import pytest
from draw import moments, nonzero, numbers, tilts
from equilibria.branching import a1, fraction, in_field, k3, signs
from hypothesis import given, settings
from sympy import S, cos, exp, sqrt

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign_of_constant
from gyrostat.equilibria.search import relative_equilibria
from gyrostat.errors import ArgumentError, ScopeError, ValuesError


@pytest.fixture(scope="module")
def top():
    """The Lagrange top, U = m0 k3, with a rotor."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())


def test_rates_of_goldstein(top):
    """I1 = 2, I3 = 1, m g l0 = 3, θ = 60°, ω3 = 6: W = 0.5505102572 and 5.4494897428.

    Both stable (results S4, S5).
    """
    values = {"I1": 2, "I3": 1, "l": 0, "m0": 3, "k3": "1/2", "pi3_0": 6}
    slow, fast = relative_equilibria(top, values)
    rates = [b.rates["omega"] for b in (slow, fast)]
    assert rates == [3 - sqrt(6), 3 + sqrt(6)] and signs([slow, fast]) == [1, 1]
    assert [round(float(omega), 10) for omega in rates] == [0.5505102572, 5.4494897428]
    (level,) = [b for b in relative_equilibria(top,
                                               {"I1": 2, "I3": 1, "l": 0, "m0": 3, "pi3_0": 6,
                                                "C1": "3/2*(3 - sqrt(6)) + 3"})
                if sign_of_constant(b.place["k3"] - S.Half) == 0]
    assert sign_of_constant(level.rates["omega"] - rates[0]) == 0


@given(I1=moments, I3=moments, l=numbers, m0=nonzero, tilt=tilts, P=numbers)
@settings(max_examples=6)
def test_steady_precessions_of_the_lagrange_top(top, I1, I3, l, m0, tilt, P):
    """Two rates iff P² > 4 I1 m0 cos θ, one where equal or at cos θ = 0 ≠ P.

    Every one is orbitally stable (results S4, S5).
    """
    for z, total in ((tilt[1], P), (Fraction(0), P),
                     (m0 / I1 * P**2 / 25 / (1 + P**2), 2 * m0 * P / 5 / (1 + abs(P)))):
        if not -1 < z < 1 or z == total == 0:
            continue
        margin = total**2 - 4 * I1 * m0 * z
        found = relative_equilibria(top, {"I1": I1, "I3": I3, "l": l, "m0": m0, "k3": z, "pi3_0": total - l})
        assert len(found) == ((1 if total else 0) if z == 0 else 1 + (margin > 0) - (margin < 0))
        assert all(s == 1 for s in signs(found))
        if z == 0 and total:
            assert fraction(found[0].place["omega"]) == m0 / total
    z, rate = tilt[1], P                               # P² = 4 I1 m0 cos θ, the two rates in one
    if z and rate:
        (one,) = relative_equilibria(top, {"I1": I1, "I3": I3, "l": l, "m0": I1 * z * rate**2, "k3": z,
                                           "pi3_0": 2 * I1 * z * rate - l})
        assert fraction(one.place["omega"]) == rate and signs([one]) == [1]


def test_rates_need_a_large_momentum(top):
    """Below P² = 4 I1 m0 cos θ there is none."""
    values = {"I1": 2, "I3": 1, "l": 0, "m0": 3, "k3": "1/2"}
    assert [
        len(relative_equilibria(top, values | {"pi3_0": p}))
        for p in (3, "sqrt(12)", "-sqrt(12)", "-3.5", "3.46")
    ] == [0, 1, 1, 2, 0]


@pytest.mark.slow
def test_every_tilt_turns_alike(top):
    """I1 = I3, ω l = m0; or U constant, ω = 0.

    Or l = 0 = I1 − I3: one continuum, its decision that of any of its points.
    """
    report = gs.analyze(gs.inclined(top))
    for values in ({"I1": 2, "I3": 2, "l": 3, "m0": 6, "omega": 2},
                   {"I1": 2, "I3": 2, "l": 4, "m0": 8, "omega": 2},
                   {"I1": 1, "I3": 1, "l": -1, "m0": 1, "omega": -1},
                   {"I1": 1, "I3": 1, "l": 0, "m0": 0, "omega": 3}):
        found = relative_equilibria(top, values)
        (every,) = found[1:-1]
        assert every.label == "E3" and every.locus == "every k3 from −1 to 1"
        assert every.place == {"k3": None, "omega": values["omega"], "sigma": 0, "pi3": None}
        body = {n: values[n] for n in ("I1", "I3", "m0", "omega")}
        points = [report.verdict(body | {"k3": z}).verdict for z in ("-9/10", "-1/3", 0, "1/2", "99/100")]
        assert points == [found[1].decision.verdict] * 5
    # U' = −ω² k3 (I1 − I3) with a1 = ω, l = 0
    U = (k3**2 * (gs.symbol("I3") - gs.symbol("I1")) * a1**2) / 2
    assert [
        b.place["k3"]
        for b in relative_equilibria(in_field(U), {"I1": 1, "I3": 3, "l": 0, "a1": "1/2", "omega": "-1/2"})
    ] == [1, None, -1]


@pytest.mark.parametrize(("values", "message"), [
    ({"omega": 1}, "the scene needs l, m0: give a number for each"),
    ({"l": 1, "m0": 1}, "given were no names of the motion: give omega, or pi3_0 and C1, or k3, or k3 and "
                        "pi3_0"),
    ({"l": 1, "m0": 1, "omega": 1, "pi3_0": 1}, "given were omega, pi3_0: give omega, or pi3_0 and C1"),
    ({"l": 1, "m0": 1, "pi3_0": 1}, "given were pi3_0: give"),
    ({"l": 1, "m0": 1, "omega": 1, "k3": 0}, "given were k3, omega"),
    ({"l": 1, "m0": 1, "omegs": 1}, "the scene has no parameter omegs: did you mean omega?"),
    ({"l": 1, "m0": 1, "omega": 1, "m1": 1}, "no parameter m1"),
    ({"l": 1, "m0": 1, "k3": 1},
     "k3 = 1 is not the tilt of a precession: give −1 < k3 < 1; E1 and E2 are found with omega"),
    ({"l": 1, "m0": 1, "k3": -1, "pi3_0": 1}, "k3 = -1 is not the tilt"),
    ({"l": 1, "m0": 1, "k3": 2}, "k3 = 2 is not"),
    ({"l": 1, "m0": 1, "k3": "1/2", "I1": -2, "pi3_0": -9},
     "I1 = -2, but a moment of inertia must be positive"),
    ({"l": 1, "m0": 1, "omega": 1, "I3": 0}, "I3 = 0, but a moment of inertia must be positive"),
    ({"l": float("nan"), "m0": 1, "omega": 1}, "l = nan"),
    ({"l": "x", "m0": 1, "omega": 1}, "l = x contains the names x"),
])
def test_numbers_that_do_not_name_a_motion(top, values, message):
    """Missing, unknown, too many, impossible: refused with what to do."""
    with pytest.raises(ValuesError, match=message.replace("?", r"\?")):
        relative_equilibria(top, {"I1": 2, "I3": 1} | values)


def test_scenes_of_which_not_all_is_known(scene):
    """Unspecified U, transcendental U and numbers: refused."""
    general = gs.assemble(gs.symmetric_gyrostat(), gs.general_potential())
    for refused in (scene, general):
        with pytest.raises(ScopeError, match="is unspecified, and all equilibria are found in a field"):
            relative_equilibria(refused, {"I1": 2, "I3": 1, "l": 1, "omega": 1})
    for U, omega in ((exp(k3), 1), (cos(k3), 1), (sqrt(2 + k3), 1)):
        with pytest.raises(ScopeError, match="is not a fraction of polynomials in k3 with real numbers"):
            relative_equilibria(in_field(U), {"I1": 2, "I3": 1, "l": 1, "omega": omega})
    with pytest.raises(ArgumentError, match="the scene is a"):
        relative_equilibria(gs.upright(scene), {})


def test_each_inclined_equilibrium_is_decided_as_a_point_too():
    """E3 is stable modulo the spin, never as a point; at rest too, where a coefficient of U' vanishes."""
    top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    (e1, e3, e2) = relative_equilibria(top, {"I1": 2, "I3": 1, "l": 1, "m0": 1, "omega": 2})
    assert e3.decision.verdict.name == "STABLE"
    assert e3.itself.verdict.name == "UNSTABLE"
    assert e1.itself is e2.itself is None
    a, b, k3 = map(gs.symbol, ("a", "b", "k3"))
    flat = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(a * k3**2 + b * k3**4))
    found = [x for x in relative_equilibria(flat, {"I1": 2, "I3": 1, "l": 1, "a": 1, "b": 1, "omega": 0})
             if x.label == "E3"]
    assert [(x.place["k3"], x.decision.verdict.name, x.itself.verdict.name) for x in found] == [
        (0, "STABLE", "UNSTABLE")
    ]
    (sphere,) = (x for x in relative_equilibria(top, {"I1": 1, "I3": 1, "l": 0, "m0": 0, "omega": 1})
                 if x.label == "E3")
    # every tilt; the one exception
    assert sphere.place["k3"] is None and sphere.itself.verdict.name == "STABLE"
