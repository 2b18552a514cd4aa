"""All relative equilibria.

Each is one of the Euler-Poisson field, none is missing by Sturm's theorem, the decisions agree.
"""
from fractions import Fraction

import mpmath
import oracle
import pytest
from draw import moments, nonzero, numbers, tilts
from equilibria.branching import FIELD, digits, fraction, k3, named, real, signs, tilted
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import Rational

import gyrostat as gs
from gyrostat.algebra.reals.exact import sign_of_constant
from gyrostat.equilibria.search import relative_equilibria

potentials = st.lists(numbers, min_size=6, max_size=6)
ORDER = {"E1": 0, "E3": 1, "precession": 1, "E2": 2}


def residual(branch, I1, I3, l, potential):
    """Size of the Euler-Poisson field plus σ times the rotation about axis 3 at ω = W k + σ e3, to 50 digits;
    k2 = 0.
    """
    with mpmath.workdps(60):
        A, C, rotor, slope = real(I1), real(I3), real(l), [real(c)
                                                           for c in oracle.slope([Fraction(0), *potential])]
        z, W, sigma = map(digits, (branch.place["k3"], branch.place["omega"], branch.place["sigma"]))
        k1 = mpmath.sqrt(1 - z * z)
        x = [A * W * k1, mpmath.mpf(0), C * (W * z + sigma), k1, mpmath.mpf(0), z]
        turned = [-x[1], x[0], 0, -x[4], x[3], 0]
        assert abs(x[2] - digits(branch.place["pi3"])) < mpmath.mpf(10) ** -45
        return max(abs(f + sigma * r) for f, r in zip(oracle.axial_field(x, A, C, rotor, slope), turned))


def decided(branch, I1, I3, l, potential):
    """1 where V has a minimum, −1 where a maximum, 0 on a boundary.

    The sign of d(I1 (1 − z²)² V')/dz on the level of the branch.
    """
    with mpmath.workdps(60):
        z, W, pi3 = map(digits, (branch.place["k3"], branch.place["omega"], branch.place["pi3"]))
        P = pi3 + real(l)
        v = real(I1) * W * (1 - z * z) + P * z
        value = oracle.polynomial(
            oracle.slope(oracle.level_slope(real(I1), P, v, [mpmath.mpf(0), *map(real, potential)])), z
        )
        # of 60 digits: nothing rational is as near to 0
        return (value > mpmath.mpf(10) ** -30) - (value < -mpmath.mpf(10) ** -30)


def in_their_order(branches):
    """From E1 down to E2."""
    keys = [(ORDER[b.label], -b.place["k3"].evalf(40)) for b in branches]
    return keys == sorted(keys) and len(set(keys)) == len(keys)


@pytest.mark.slow
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
    rates = {"omega": Rational(omega.numerator, omega.denominator), "sigma": 0}
    assert all(b.rates == rates for b in found[1:-1])
    for b in found:
        assert residual(b, I1, I3, l, potential) < mpmath.mpf(10) ** -40       # of 60 digits
    assert all(s in (0, sign) for s, sign in zip([decided(b, I1, I3, l, potential) for b in found[1:-1]],
                                                 signs(found[1:-1])))
    for b, s in ((found[0], 1), (found[-1], -1)):
        assert b.place["k3"] == s and b.place["sigma"] == 0
        slope = oracle.polynomial(oracle.slope([Fraction(0), *potential]), Fraction(s))
        expected = oracle.verdict_vertical(I1, l, s * I3 * omega, s, slope)
        assert b.place["pi3"] == s * Rational(*(I3 * omega).as_integer_ratio())
        assert (expected == 0 or signs([b]) == [expected])
    mirrored = relative_equilibria(polynomial, values | {"omega": -omega, "l": -l})
    assert [(b.label, b.place["k3"]) for b in mirrored] == [(b.label, b.place["k3"]) for b in found]
    assert signs(mirrored) == signs(found)


@pytest.mark.slow
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
        assert sign_of_constant(b.place["pi3"] - Rational(pi3.numerator, pi3.denominator)) == 0
        assert residual(b, I1, I3, l, potential) < mpmath.mpf(10) ** -40
        assert (b.label == "precession") == (sign_of_constant(b.place["sigma"]) != 0)
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
    assert [fraction(b.place["omega"]) for b in found] == sorted({rate, u1 / (I1 * z * rate)})
    for b in found:
        W, sigma = fraction(b.place["omega"]), fraction(b.place["sigma"])
        x = [I1 * W * k1, Fraction(0), I3 * (W * z + sigma), k1, Fraction(0), z]
        turned = [-x[1], x[0], 0, -x[4], x[3], 0]
        xdot = oracle.axial_field(x, I1, I3, l, oracle.slope([Fraction(0), *potential]))
        assert xdot == [-sigma * r for r in turned] and fraction(b.place["pi3"]) == x[2] == P - l
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
            if b.place["k3"] == Rational(z.numerator, z.denominator)]
    x = [I1 * omega * k1, Fraction(0), I3 * omega * z, k1, Fraction(0), z]
    assert oracle.axial_field(x, I1, I3, l, oracle.slope([Fraction(0), *potential])) == [0] * 6
    assert (b.label, fraction(b.place["pi3"])) == ("E3", x[2])
    assert decided(b, I1, I3, l, potential) in (0, *signs([b]))
    # the rates of a tilt are the roots of (I1 − I3) k3 ω² − l ω + U' = 0
    other = l / ((I1 - I3) * z) - omega
    found = relative_equilibria(polynomial, values | {"k3": z})
    assert [fraction(b.place["omega"]) for b in found] == sorted({omega, other})


@pytest.mark.slow
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
            z = b.place["k3"]
            jets = {"dU": U.diff(k3).subs(k3, z), "d2U": U.diff(k3, 2).subs(k3, z),
                    "d3U": U.diff(k3, 3).subs(k3, z)}
            jets |= {"d4U": 0, "d5U": 0, "d6U": 0, "d7U": 0}
            if b.label != "E3":
                report, at = (e1 if b.label == "E1" else e2), {"pi3_0": b.place["pi3"]}
            else:
                report, at = (e3, {"omega": b.place["omega"], "k3": z}) if w else (at_rest, {"k3": z})
                jets.pop("dU")
            theirs = report.verdict({**{n: x for n, x in body.items() if n in report.parameters}, **at,
                                     **jets})
            assert (b.decision.verdict, b.decision.notion, b.decision.modulo) == (
                theirs.verdict,
                theirs.notion,
                theirs.modulo,
            )
