"""All relative equilibria.

Each is one of the Euler-Poisson field, none is missing by Sturm's theorem, the decisions agree.
"""
from fractions import Fraction
from functools import cache

import mpmath
import oracle
import pytest
from draw import moments, nonzero, numbers, tilts
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from slow import slow
from sympy import CRootOf, Rational, S, cos, exp, pi, sqrt

import gyrostat as gs
from gyrostat.algebra.exact import sign_of_constant
from gyrostat.errors import ArgumentError, ScopeError, ValuesError
from gyrostat.stability.relative_equilibria import relative_equilibria

k3, a1, a2 = gs.symbol("k3"), gs.symbol("a1"), gs.symbol("a2")
FIELD = sum(gs.symbol(f"a{n}") * k3**n for n in range(1, 7))
potentials = st.lists(numbers, min_size=6, max_size=6)
ORDER = {"E1": 0, "E3": 1, "precession": 1, "E2": 2}


@pytest.fixture(scope="module")
def polynomial():
    """Gyrostat of revolution in U = a1 k3 + … + a6 k3⁶."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(FIELD))


@pytest.fixture(scope="module")
def top():
    """The Lagrange top, U = m0 k3, with a rotor."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())


@cache
def in_field(expression):
    """A scene in a given U."""
    return gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(expression))


def named(potential):
    """The coefficients of U by name."""
    return {f"a{n}": a for n, a in enumerate(potential, 1)}


def digits(number):
    """A number to 60 digits."""
    return mpmath.mpf(str(number.evalf(60)))


def fraction(number):
    """A rational of SymPy as a Fraction."""
    return Fraction(int(number.p), int(number.q))


def real(a):
    """A fraction as a number of mpmath."""
    return mpmath.mpf(a.numerator) / a.denominator


def residual(branch, I1, I3, l, potential):
    """Size of the Euler-Poisson field plus σ times the rotation about axis 3 at ω = W k + σ e3, to 50 digits;
    k2 = 0.
    """
    with mpmath.workdps(60):
        A, C, rotor, slope = real(I1), real(I3), real(l), [real(c)
                                                           for c in oracle.slope([Fraction(0), *potential])]
        z, W, sigma = map(digits, (branch.k3, branch.omega, branch.sigma))
        k1 = mpmath.sqrt(1 - z * z)
        x = [A * W * k1, mpmath.mpf(0), C * (W * z + sigma), k1, mpmath.mpf(0), z]
        turned = [-x[1], x[0], 0, -x[4], x[3], 0]
        assert abs(x[2] - digits(branch.pi3)) < mpmath.mpf(10) ** -45
        return max(abs(f + sigma * r) for f, r in zip(oracle.axial_field(x, A, C, rotor, slope), turned))


def decided(branch, I1, I3, l, potential):
    """1 where V has a minimum, −1 where a maximum, 0 on a boundary.

    The sign of d(I1 (1 − z²)² V')/dz on the level of the branch.
    """
    with mpmath.workdps(60):
        z, W, pi3 = map(digits, (branch.k3, branch.omega, branch.pi3))
        P = pi3 + real(l)
        v = real(I1) * W * (1 - z * z) + P * z
        value = oracle.polynomial(
            oracle.slope(oracle.level_slope(real(I1), P, v, [mpmath.mpf(0), *map(real, potential)])), z
        )
        # of 60 digits: nothing rational is as near to 0
        return (value > mpmath.mpf(10) ** -30) - (value < -mpmath.mpf(10) ** -30)


def signs(branches):
    """1 for stable, −1 for unstable; undecided is not expected."""
    return [{"STABLE": 1, "UNSTABLE": -1}[b.decision.verdict.name] for b in branches]


def tilted(branches):
    """Those between the poles."""
    return [b for b in branches if b.label not in ("E1", "E2")]


def in_their_order(branches):
    """From E1 down to E2."""
    keys = [(ORDER[b.label], -b.k3.evalf(40)) for b in branches]
    return keys == sorted(keys) and len(set(keys)) == len(keys)


@given(I1=moments, I3=moments, l=numbers, omega=numbers, potential=potentials)
@settings(max_examples=6)
def test_all_at_a_rate(polynomial, I1, I3, l, omega, potential):
    """E1, E2, and as many E3 as U' − ω l + ω² z (I1 − I3) has roots in (−1, 1); each with the sign of V''.

    (ω, l) → (−ω, −l).
    """
    values = {"I1": I1, "I3": I3, "l": l, "omega": omega} | named(potential)
    f = oracle.rate_slope(I1, I3, l, omega, [Fraction(0), *potential])
    assume(any(f) and all(oracle.polynomial(oracle.slope(f), r) for r in (1, -1)))
    found = relative_equilibria(polynomial, values)
    assert [found[0].label, found[-1].label] == ["E1", "E2"] and in_their_order(found)
    assert {b.label for b in found[1:-1]} <= {"E3"} and len(found) == 2 + oracle.count_roots(f, -1, 1)
    assert all(b.sigma == 0 and b.omega == Rational(omega.numerator, omega.denominator) for b in found[1:-1])
    for b in found:
        assert residual(b, I1, I3, l, potential) < mpmath.mpf(10) ** -40       # of 60 digits
    assert all(s in (0, sign) for s, sign in zip([decided(b, I1, I3, l, potential) for b in found[1:-1]],
                                                 signs(found[1:-1])))
    for b, s in ((found[0], 1), (found[-1], -1)):
        assert b.k3 == s and b.sigma == 0
        slope = oracle.polynomial(oracle.slope([Fraction(0), *potential]), Fraction(s))
        expected = oracle.verdict_vertical(I1, l, s * I3 * omega, s, slope)
        assert b.pi3 == s * Rational(*(I3 * omega).as_integer_ratio())
        assert (expected == 0 or signs([b]) == [expected])
    mirrored = relative_equilibria(polynomial, values | {"omega": -omega, "l": -l})
    assert [(b.label, b.k3) for b in mirrored] == [(b.label, b.k3) for b in found]
    assert signs(mirrored) == signs(found)


@given(I1=moments, I3=moments, l=numbers, pi3=numbers, v=numbers, pole=st.sampled_from([None, None, 1, -1]),
       potential=potentials)
@settings(max_examples=6)
def test_all_on_a_level(polynomial, I1, I3, l, pi3, v, pole, potential):
    """As many as V' has zeros, E1 and E2 exactly where C1 = ±(π3 + l).

    Minima and maxima of V alternate, minima at the ends.
    """
    P = pi3 + l
    v = v if pole is None else pole * P
    f = oracle.level_slope(I1, P, v, [Fraction(0), *potential])
    assume(any(f))
    found = relative_equilibria(polynomial, {"I1": I1, "I3": I3, "l": l, "pi3_0": pi3, "C1": v}
                                | named(potential))
    assert in_their_order(found) and len(tilted(found)) == oracle.count_roots(f, -1, 1)
    assert [b.label for b in found if b.label in ("E1", "E2")] == ["E1"] * (v == P) + ["E2"] * (v == -P)
    for b in found:
        assert sign_of_constant(b.pi3 - Rational(pi3.numerator, pi3.denominator)) == 0
        assert residual(b, I1, I3, l, potential) < mpmath.mpf(10) ** -40
        assert (b.label == "precession") == (sign_of_constant(b.sigma) != 0)
    between, expected = signs(found), [decided(b, I1, I3, l, potential) for b in tilted(found)]
    # elsewhere V has a point of inflexion; Report.boundary has its own tests
    assume(all(expected))
    assert signs(tilted(found)) == expected
    assert all(a == -b for a, b in zip(between, between[1:]))
    # V → ∞ at a pole, unless v = ±P: a minimum is next to it, or the pole is one
    for s, end in ((1, 0), (-1, -1)):
        assert between[end] == 1 or (v == s * P and between[end] == -1)


@given(I1=moments, I3=moments, l=numbers, tilt=tilts, rate=nonzero, potential=potentials)
@settings(max_examples=6)
def test_rational_precessions_are_exact(polynomial, I1, I3, l, tilt, rate, potential):
    """k, ω rational and P = U'/ω + I1 k3 ω: found with its other rate U'/(I1 k3 ω).

    The field is −σ times the rotation, exactly.

    U' ≠ 0 has two rates, U' = 0 one more at rest; each vector is a Fraction.
    """
    k1, z = tilt
    assume(z)
    u1 = oracle.polynomial(oracle.slope([Fraction(0), *potential]), z)
    P = u1 / rate + I1 * z * rate
    values = {"I1": I1, "I3": I3, "l": l, "k3": z, "pi3_0": P - l} | named(potential)
    found = relative_equilibria(polynomial, values)
    assert [fraction(b.omega) for b in found] == sorted({rate, u1 / (I1 * z * rate)})
    for b in found:
        W, sigma = fraction(b.omega), fraction(b.sigma)
        x = [I1 * W * k1, Fraction(0), I3 * (W * z + sigma), k1, Fraction(0), z]
        turned = [-x[1], x[0], 0, -x[4], x[3], 0]
        xdot = oracle.axial_field(x, I1, I3, l, oracle.slope([Fraction(0), *potential]))
        assert xdot == [-sigma * r for r in turned] and fraction(b.pi3) == x[2] == P - l
        assert b.label == ("precession" if sigma else "E3")
    assert all(decided(b, I1, I3, l, potential) in (0, sign) for b, sign in zip(found, signs(found)))


@given(I1=moments, I3=moments, tilt=tilts, omega=nonzero, l=numbers, potential=potentials)
@settings(max_examples=6)
def test_rational_tilts_are_exact(polynomial, I1, I3, tilt, omega, l, potential):
    """U' = ω l − ω² k3 (I1 − I3) by the choice of a1: E3 is found, at the rate and at the tilt.

    The field vanishes exactly.
    """
    k1, z = tilt
    assume(z and I1 != I3)
    rest = [Fraction(0), *potential[1:]]
    a = omega * l - omega**2 * z * (I1 - I3) - oracle.polynomial(oracle.slope([Fraction(0), *rest]), z)
    potential = [a, *rest[1:]]
    values = {"I1": I1, "I3": I3, "l": l} | named(potential)
    (b,) = [b for b in relative_equilibria(polynomial, values | {"omega": omega})
            if b.k3 == Rational(z.numerator, z.denominator)]
    x = [I1 * omega * k1, Fraction(0), I3 * omega * z, k1, Fraction(0), z]
    assert oracle.axial_field(x, I1, I3, l, oracle.slope([Fraction(0), *potential])) == [0] * 6
    assert (b.label, fraction(b.pi3)) == ("E3", x[2]) and decided(b, I1, I3, l, potential) in (0, *signs([b]))
    # the rates of a tilt are the roots of (I1 − I3) k3 ω² − l ω + U' = 0
    other = l / ((I1 - I3) * z) - omega
    assert [fraction(b.omega) for b in relative_equilibria(polynomial, values | {"k3": z})] == sorted(
        {omega, other}
    )


@given(I1=moments, I3=moments, l=numbers, omega=nonzero, potential=st.lists(numbers, min_size=3, max_size=3))
@settings(max_examples=3)
def test_decisions_are_those_of_the_reports(e1, e2, e3, at_rest, polynomial, I1, I3, l, omega, potential):
    """Report.verdict of the unspecified U, with U', U'' of the field at k3 inserted.

    The same verdict, notion and flow.
    """
    potential = [*potential, *[Fraction(0)] * 3]
    U = FIELD.xreplace({gs.symbol(n): Rational(a.numerator, a.denominator)
                        for n, a in named(potential).items()})
    body = {"I1": I1, "I3": I3, "l": l}
    for w in (omega, 0):
        if not any(oracle.rate_slope(I1, I3, l, Fraction(w), [Fraction(0), *potential])):
            continue
        for b in relative_equilibria(polynomial, body | {"omega": w} | named(potential)):
            jets = {"dU": U.diff(k3).subs(k3, b.k3), "d2U": U.diff(k3, 2).subs(k3, b.k3),
                    "d3U": U.diff(k3, 3).subs(k3, b.k3)}
            jets |= {"d4U": 0, "d5U": 0, "d6U": 0, "d7U": 0}
            if b.label != "E3":
                report, at = (e1 if b.label == "E1" else e2), {"pi3_0": b.pi3}
            else:
                report, at = (e3, {"omega": b.omega, "k3": b.k3}) if w else (at_rest, {"k3": b.k3})
                jets.pop("dU")
            theirs = report.verdict({**{n: x for n, x in body.items() if n in report.parameters}, **at,
                                     **jets})
            assert (b.decision.verdict, b.decision.notion, b.decision.modulo) == (
                theirs.verdict,
                theirs.notion,
                theirs.modulo,
            )


def test_rates_of_goldstein(top):
    """I1 = 2, I3 = 1, m g l0 = 3, θ = 60°, ω3 = 6: W = 0.5505102572 and 5.4494897428.

    Both stable (results S4, S5).
    """
    values = {"I1": 2, "I3": 1, "l": 0, "m0": 3, "k3": "1/2", "pi3_0": 6}
    slow, fast = relative_equilibria(top, values)
    assert (slow.omega, fast.omega) == (3 - sqrt(6), 3 + sqrt(6)) and signs([slow, fast]) == [1, 1]
    assert [round(float(b.omega), 10) for b in (slow, fast)] == [0.5505102572, 5.4494897428]
    (level,) = [b for b in relative_equilibria(top,
                                               {"I1": 2, "I3": 1, "l": 0, "m0": 3, "pi3_0": 6,
                                                "C1": "3/2*(3 - sqrt(6)) + 3"})
                if sign_of_constant(b.k3 - S.Half) == 0]
    assert sign_of_constant(level.omega - slow.omega) == 0


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
            assert fraction(found[0].omega) == m0 / total
    z, rate = tilt[1], P                               # P² = 4 I1 m0 cos θ, the two rates in one
    if z and rate:
        (one,) = relative_equilibria(top, {"I1": I1, "I3": I3, "l": l, "m0": I1 * z * rate**2, "k3": z,
                                           "pi3_0": 2 * I1 * z * rate - l})
        assert fraction(one.omega) == rate and signs([one]) == [1]


def test_rates_need_a_large_momentum(top):
    """Below P² = 4 I1 m0 cos θ there is none."""
    values = {"I1": 2, "I3": 1, "l": 0, "m0": 3, "k3": "1/2"}
    assert [
        len(relative_equilibria(top, values | {"pi3_0": p}))
        for p in (3, "sqrt(12)", "-sqrt(12)", "-3.5", "3.46")
    ] == [0, 1, 1, 2, 0]


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
        assert [(b.label, b.k3, b.sigma, b.pi3) for b in found[1:-1]] == [("E3", None, 0, None)]
        body = {n: values[n] for n in ("I1", "I3", "m0", "omega")}
        points = [report.verdict(body | {"k3": z}).verdict for z in ("-9/10", "-1/3", 0, "1/2", "99/100")]
        assert points == [found[1].decision.verdict] * 5
    # U' = −ω² k3 (I1 − I3) with a1 = ω, l = 0
    U = (k3**2 * (gs.symbol("I3") - gs.symbol("I1")) * a1**2) / 2
    assert [
        b.k3
        for b in relative_equilibria(in_field(U), {"I1": 1, "I3": 3, "l": 0, "a1": "1/2", "omega": "-1/2"})
    ] == [1, None, -1]


def test_a_field_that_turns_nothing():
    """U = 0 at rest: every tilt, stable with a rotor, unstable without.

    With ω ≠ 0: cos θ = l/(ω (I1 − I3)) alone.
    """
    free = in_field(S.Zero)
    body = {"I1": 2, "I3": 1}
    assert [signs(relative_equilibria(free, body | {"l": l, "omega": 0})) for l in (1, 0)] == [
        [1, 1, 1],
        [-1, -1, -1],
    ]
    assert [b.k3 for b in relative_equilibria(free, body | {"l": 1, "omega": 2})] == [1, S.Half, -1]
    assert [b.k3 for b in relative_equilibria(free, body | {"l": 1, "omega": 1})] == [1, -1]


@pytest.mark.parametrize(("l", "pi3"), [(0, 0), (1, -1), ("-2/3", "2/3")])
def test_a_level_on_which_every_tilt_rests(l, pi3):
    """U = 0, P = v = 0: V is constant, every tilt is a precession with W = 0, and E1, E2 are there.

    All are left by motions.
    """
    found = relative_equilibria(in_field(S.Zero), {"I1": 2, "I3": 1, "l": l, "pi3_0": pi3, "C1": 0})
    assert [(b.label, b.k3, b.omega) for b in found] == [("E1", 1, found[0].omega),
                                                         ("precession", None, None),
                                                         ("E2", -1, found[2].omega)]
    assert signs(found) == [-1, -1, -1]


@pytest.mark.parametrize(("P", "v"), [(1, 0), (1, 1), *slow((3, Rational(-1, 2)), (2, -2))])
def test_a_field_made_for_a_level(P, v):
    """U = −(v − P k3)²/(2 I1 (1 − k3²)): V is constant, g = 0.

    A pole is left out where U is infinite there.
    """
    U = -((v - P * k3) ** 2) / (4 * (1 - k3**2))
    found = relative_equilibria(in_field(U.cancel()),
                                {"I1": 2, "I3": 1, "l": Rational(1, 3), "pi3_0": P - Rational(1, 3), "C1": v})
    assert [b.label for b in found] == ["E1"] * (v == P) + ["precession"] + ["E2"] * (v == -P)
    assert set(signs(found)) == {-1}


def test_a_field_that_is_infinite_somewhere():
    """U = 1/(1 − k3) has no E1, U = 1/k3 no tilt at k3 = 0; the rest is found."""
    body = {"I1": 2, "I3": 1, "l": 0}
    found = relative_equilibria(in_field(1 / (1 - k3)), body | {"omega": 1})
    assert [b.label for b in found] == ["E3", "E2"] and agree(found[0].k3, CRootOf(k3 * (1 - k3) ** 2 + 1, 0))
    assert [b.label for b in relative_equilibria(in_field(1 / k3), body | {"omega": 1})] == ["E1", "E2"]
    with pytest.raises(ValuesError, match="U = 1/k3 is not defined at k3 = 0"):
        relative_equilibria(in_field(1 / k3), body | {"k3": 0})


def agree(a, b):
    """Whether two exact numbers are equal."""
    return sign_of_constant(a - b) == 0


@pytest.mark.parametrize("l", [0, 1, -3])
def test_tilts_at_rest(l):
    """ω = 0: U' = 0, whatever l; U = a1 k3² + a2 k3⁴ rests at k3 = 0 and at k3² = −a1/(2 a2).

    P = I1 (1 − k3²) U'' + l².
    """
    scene = in_field(a1 * k3**2 + a2 * k3**4)
    for b1, b2 in ((1, -1), (-1, 1), (0, 1), (0, -1), (-1, "1/2"), (1, 1)):
        found = relative_equilibria(scene, {"I1": 2, "I3": 1, "l": l, "omega": 0, "a1": b1, "a2": b2})
        square = -Rational(b1) / (2 * Rational(b2))
        expected = [sqrt(square), S.Zero, -sqrt(square)] if 0 < square < 1 else [S.Zero]
        assert [b.k3 for b in found] == [1, *expected, -1]
        for b in found[1:-1]:
            margin = 2 * (1 - b.k3**2) * (2 * Rational(b1) + 12 * Rational(b2) * b.k3**2) + Rational(l) ** 2
            assert b.omega == b.pi3 == 0 and (signs([b]) == [1 if margin > 0 else -1] if margin else True)
            if not margin:                             # U = ± k3⁴: g‴′ ∝ −U⁗
                assert (b1, b.k3) == (0, 0) and signs([b]) == [1 if b2 == 1 else -1]


def test_a_linear_field_never_rests():
    """U = 3 k3, without parameters: E1 and E2 at rest; with a rotor, tilts at other rates."""
    scene = in_field(3 * k3)
    assert [b.label for b in relative_equilibria(scene, {"I1": 2, "I3": 1, "l": 1, "omega": 0})] == [
        "E1",
        "E2",
    ]
    assert [b.k3 for b in relative_equilibria(scene, {"I1": 2, "I3": 1, "l": 1, "omega": 2})] == [
        1,
        Rational(-1, 4),
        -1,
    ]


def test_every_rate_of_a_tilt():
    """l = 0 = k3 (I1 − I3) and U' = 0: every rate; P = 0 = k3 and U' = 0: every rate; both are said."""
    for values in ({"k3": 0}, {"k3": 0, "pi3_0": 0}):
        with pytest.raises(ValuesError, match="every rate about the vertical"):
            relative_equilibria(in_field(k3**2), {"I1": 2, "I3": 1, "l": 0} | values)
    assert relative_equilibria(in_field(k3), {"I1": 2, "I3": 1, "l": 0, "k3": 0}) == []


def outcome(branches):
    """What is asked of a branch, without the text of its decision."""
    return [(b.label, b.k3, b.omega, b.sigma, b.pi3, b.decision.verdict) for b in branches]


NEWTONIAN = {"m0": "1/2", "m1": 3}


@cache
def newtonian(moments, rotor):
    """A scene of a body of revolution in the Newtonian field of second order."""
    return gs.assemble(gs.Gyrostat(moments, (0, 0, rotor)), gs.newtonian_field(2))


@pytest.mark.parametrize("motion", [{"omega": 1}, {"pi3_0": 1, "C1": "3/4"}, {"k3": "1/3", "pi3_0": 5}])
def test_bodies_by_any_name(motion):
    """I = (2, 2, 3), l = 1 as symbols A, C, h, as numbers, as 2 I1, and with names in each other's places.

    The same branches.
    """
    A, C, h, I1, I2, I3, l = map(gs.symbol, ("A", "C", "h", "I1", "I2", "I3", "l"))
    plain = outcome(relative_equilibria(newtonian((I1, I1, I3), l),
                                        {"I1": 2, "I3": 3, "l": 1, **NEWTONIAN, **motion}))
    for body, values in (((A, A, C, h), {"A": 2, "C": 3, "h": 1}), ((2, 2, 3, 1), {}),
                         ((2 * I1, 2 * I1, I3, l), {"I1": 1, "I3": 3, "l": 1}),
                         ((I3, I3, I1, l), {"I3": 2, "I1": 3, "l": 1}),
                         ((A, A, I2, I3), {"A": 2, "I2": 3, "I3": 1}),
                         ((A, A, 3, 1), {"A": 2}), ((I2, I2, I3, 2 * l), {"I2": 2, "I3": 3, "l": "1/2"})):
        scene = newtonian(body[:3], body[3])
        assert outcome(relative_equilibria(scene, {**values, **NEWTONIAN, **motion})) == plain


def test_the_rotor_may_be_in_the_field():
    """U = l k3 is U = m0 k3 with m0 = l, also at ω = 1, where l drops out of the relation."""
    for omega in (1, 2):
        theirs = relative_equilibria(in_field(gs.symbol("m0") * k3),
                                     {"I1": 2, "I3": 1, "l": 1, "m0": 1, "omega": omega})
        assert outcome(
            relative_equilibria(in_field(gs.symbol("l") * k3), {"I1": 2, "I3": 1, "l": 1, "omega": omega})
        ) == outcome(theirs)


def test_algebraic_numbers(polynomial):
    """ω = √2/3, and an l, k3, π3 that are roots of polynomials: found and decided.

    Results may be given back.
    """
    field = named(map(Fraction, ("1/2", "-3", "2/7", "0", "0", "0")))
    body = {"I1": 2, "I3": 3, "l": "1/2"} | field
    found = relative_equilibria(polynomial, body | {"omega": sqrt(2) / 3})
    f = [float(c) for c in (Rational(1, 2) - sqrt(2) / 6, -6 - Rational(2, 9), Rational(6, 7))]
    assert [round(float(b.k3), 12) for b in found[1:-1]] == [round(float(r.real), 12)
                                                             for r in mpmath.polyroots(f[::-1])
                                                             if -1 < r.real < 1]
    rho = CRootOf(k3**3 - k3 - 1, 0)                   # written in k3 itself
    for motion in ({"omega": "1/2", "l": rho}, {"k3": 1 / (1 + rho), "pi3_0": 4},
                   {"pi3_0": sqrt(2) / 3, "C1": "1/3", "a3": 0}):
        values = body | motion
        found = relative_equilibria(polynomial, values)
        assert tilted(found) and set(signs(found)) <= {1, -1}
        with mpmath.workdps(60):
            l = digits(rho) if "l" in motion else mpmath.mpf(1) / 2
            for b in tilted(found):
                z, W, sigma, pi3 = map(digits, (b.k3, b.omega, b.sigma, b.pi3))
                slope = oracle.polynomial([real(Fraction(values[f"a{n}"])) * n for n in range(1, 7)], z)
                assert abs(slope - (pi3 + l) * W + 2 * z * W**2) < mpmath.mpf(10) ** -45
                assert abs(pi3 - 3 * (W * z + sigma)) < mpmath.mpf(10) ** -45
    for b in relative_equilibria(polynomial, body | {"omega": "1/2"})[1:-1]:
        rates = relative_equilibria(polynomial, body | {"k3": b.k3, "pi3_0": b.pi3})
        (back,) = [c for c in rates if c.label == "E3"]
        assert agree(back.omega, S.Half) and signs([back]) == signs([b])


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


def test_scenes_of_which_not_all_is_known(scene, asymmetric):
    """Unspecified U, three moments, U(k1, k2, k3), names of levels: refused.

    Transcendental U and numbers too.
    """
    general = gs.assemble(gs.symmetric_gyrostat(), gs.general_potential())
    for refused in (scene, asymmetric, general):
        with pytest.raises(ScopeError, match="for a body of revolution in a given U.k3.; this scene has"):
            relative_equilibria(refused, {"I1": 2, "I3": 1, "l": 1, "omega": 1})
    for name in ("C1", "p_psi", "p_phi", "energy"):
        with pytest.raises(ScopeError,
                           match=f"depends on {name}, a name of the motion or of its levels: rename it"):
            relative_equilibria(in_field(gs.symbol(name) * k3),
                                {"I1": 2, "I3": 1, "l": 1, name: 1, "omega": 1})
    for U, omega in ((exp(k3), 1), (cos(k3), 1), (k3**4, pi), (sqrt(2 + k3), 1)):
        with pytest.raises(ScopeError, match="is not a polynomial in k3 with algebraic coefficients"):
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
    assert [(x.k3, x.decision.verdict.name, x.itself.verdict.name) for x in found] == [
        (0, "STABLE", "UNSTABLE")
    ]
    (sphere,) = (x for x in relative_equilibria(top, {"I1": 1, "I3": 1, "l": 0, "m0": 0, "omega": 1})
                 if x.label == "E3")
    # every tilt; the one exception
    assert sphere.k3 is None and sphere.itself.verdict.name == "STABLE"
