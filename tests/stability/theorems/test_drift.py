"""A tilted equilibrium as a point: Jordan blocks by exact ranks, drift by the precessions beside it."""
from dataclasses import replace
from fractions import Fraction

import oracle
import pytest
from draw import moments, nonzero, numbers, tilts
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from stability.precessions import I1, I3, at, d2U, k3, l, omega, precession, ranks, turning
from sympy import Rational, cancel

import gyrostat as gs
from gyrostat.stability.decision import Verdict
from gyrostat.stability.theorems.drift import Drift

SLOPE = omega * l - omega**2 * k3 * (I1 - I3)
D = (I1 * (I1 - I3) * omega**2 + (I1 * (1 - k3**2) + I3 * k3**2) * d2U - 2 * k3 * (I1 - I3) * SLOPE
     + ((I1 - I3) * omega * k3 - l) ** 2)


def test_the_defect_is_the_one_of_the_theory(drift, at_rest):
    """D = I1 (I1 − I3) ω² + (I1 (1 − k3²) + I3 k3²) U'' − 2 k3 (I1 − I3) U' + ((I1 − I3) ω k3 − l)², up to a
    factor that has a sign.
    """
    assert cancel(drift.defect / D) in (1, -1)
    assert cancel(Drift(at_rest.equilibrium).defect / D.subs(omega, 0)) in (1, -1)


@pytest.mark.slow
@given(I1=moments, I3=moments, l=numbers, omega=numbers, tilt=tilts, u2=numbers, semisimple=st.booleans())
@settings(max_examples=15)
def test_jordan_blocks_by_exact_ranks(e3, drift, I1, I3, l, omega, tilt, u2, semisimple):
    """On the 4-dimensional tangent space rank J = 3 > rank J² = 2 where D ≠ 0 ≠ p, 2 = 2 where D = 0 ≠ p.

    Nilpotent where p = 0.
    """
    values = {"I1": I1, "I3": I3, "l": l, "omega": omega, "k3": tilt[1]}
    if semisimple:                                     # D is affine in U''
        zero, one = (at(drift.defect, **values, d2U=Fraction(n)) for n in (0, 1))
        u2 = zero / (zero - one)
    values["d2U"] = u2
    p = oracle.verdict_inclined_margin(I1, I3, l, omega, tilt[1], u2)
    first, second = ranks(I1, I3, l, omega, tilt, u2)
    if p:
        assert (first, second) == ((2, 2) if at(drift.defect, **values) == 0 else (3, 2))
    else:
        assert first > second
    if p > 0:
        decision = e3.itself(values)
        assert decision.verdict is Verdict.UNSTABLE
        assert ("Jordan block" in decision.reason) == (first > second)
        assert ("semisimple" in decision.reason) == (first == second)


def test_a_semisimple_example():
    """I = (4, 4, 5), l = 2, U = 2 k3, k3 = 0, ω = 1: linearly stable, and it drifts all the same."""
    report = gs.analyze(gs.inclined(gs.assemble(gs.Gyrostat((4, 4, 5), (0, 0, 2)),
                                                gs.axial_potential(2 * k3))))
    values = {"k3": 0, "omega": 1}
    assert report.verdict(values).verdict is Verdict.STABLE
    decision = report.itself(values)
    assert (decision.verdict, decision.notion, decision.modulo) == (Verdict.UNSTABLE, "Lyapunov", ())
    assert "semisimple" in decision.reason and 0 in [value for _, value in decision.margins]
    assert ranks(*map(Fraction, (4, 5, 2, 1)), (Fraction(1), Fraction(0)), Fraction(0)) == (2, 2)
    beside = report.itself({"k3": Rational(8, 9), "omega": Rational(3, 4)})        # 2 = 2 ω + k3 ω²
    assert "Jordan" in beside.reason and beside.verdict is Verdict.UNSTABLE


@pytest.mark.slow
@given(I1=moments, I3=moments, l=numbers, W=nonzero, tilt=tilts, near=tilts, u2=numbers)
@settings(max_examples=15)
def test_rates_are_those_of_the_precessions_beside_it(drift, I1, I3, l, W, tilt, near, u2):
    """σ of the precessions at other k3, W, that the Euler-Poisson field has there.

    Its slopes at the equilibrium.

    U' = u1 + u2 (k3 − z): σ is affine in k3, and its difference quotient in W is off by −U' h/(I3 W² (W +
        h)).
    """
    z = tilt[1]
    u1 = W * l - W**2 * z * (I1 - I3)
    values = {"I1": I1, "I3": I3, "l": l, "omega": W, "k3": z, "d2U": u2}
    along, across = (at(rate, **values) for rate in drift.rates)
    assert precession(I1, I3, l, z, W, u1) == 0
    slope = u1 + u2 * (near[1] - z)
    sigma = precession(I1, I3, l, near[1], W, slope)
    assert turning(I1, I3, l, near, W, sigma, slope) and sigma == along * (near[1] - z)
    for h in (W / 7, W / 10**9):
        sigma = precession(I1, I3, l, z, W + h, u1)
        assert turning(I1, I3, l, tilt, W + h, sigma, u1)
        assert sigma / h - across == -(-u1 * h) / (I3 * W**2 * (W + h))


@given(I3=moments, I1=moments, l=numbers, spin=nonzero, tilt=tilts, u2=nonzero)
@settings(max_examples=15)
def test_at_rest_any_rate_goes_with_the_tilt(at_rest, I1, I3, l, spin, tilt, u2):
    """ω = 0, U' = 0: π = (0, 0, I3 σ) at the same k turns at −σ, however small σ is."""
    assert turning(I1, I3, l, tilt, Fraction(0), spin, Fraction(0))
    values = {"I1": I1, "I3": I3, "l": l, "k3": tilt[1], "d2U": u2}
    assume(at_rest.verdict(values).verdict is Verdict.STABLE)
    decision = at_rest.itself(values)
    assert decision.verdict is Verdict.UNSTABLE and "any rate" in decision.reason


def test_inclined_at_rest(e3):
    """ω = 0 in E3, where U' is eliminated, is E3 at rest."""
    values = {"I1": 1, "I3": 2, "l": 1, "omega": 0, "k3": "1/2", "d2U": 1}
    assert e3.verdict(values).verdict is Verdict.STABLE and "any rate" in e3.itself(values).reason


def test_a_pole_is_its_own_point(e1, e2):
    """At E1 and E2 nothing is divided out: itself is verdict."""
    for report, values in ((e1, {"I1": 1, "l": 2, "pi3_0": 1, "dU": 2}),
                           (e2, {"I1": 1, "l": 2, "pi3_0": 1, "dU": -4})):
        assert report.itself(values) == report.verdict(values)


def test_unstable_modulo_the_spin_is_unstable(e3):
    """itself repeats an UNSTABLE verdict, modulo nothing; an undecided one stays so."""
    values = {"I1": 1, "I3": 1, "l": 0, "omega": 1, "k3": 0}
    unstable, undecided = values | {"d2U": -2}, values | {"d2U": -1}
    assert (e3.itself(unstable).verdict, e3.itself(unstable).modulo) == (Verdict.UNSTABLE, ())
    assert e3.verdict(unstable).modulo == (gs.symbol("pi3"),)
    assert e3.itself(unstable).reason == e3.verdict(unstable).reason
    assert e3.itself(undecided) == replace(e3.verdict(undecided), modulo=())
    assert e3.itself(undecided).verdict is Verdict.UNDECIDED
