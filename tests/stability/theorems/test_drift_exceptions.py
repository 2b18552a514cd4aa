"""A tilted equilibrium as a point where its drift vanishes, in part or altogether."""
from fractions import Fraction

import oracle
import pytest
from draw import moments, nonzero, tilts
from hypothesis import assume, given, settings
from stability.precessions import at, k3, precession, ranks, turning
from sympy import Rational, exp, symbols

import gyrostat as gs
from gyrostat.stability.decision import Verdict


def test_the_one_exception():
    """I1 = I3, l = 0, U constant, ω ≠ 0: k and ω are fixed in space.

    The Euler-Poisson field vanishes at all states beside it.
    """
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    values = {"I1": 1, "I3": 1, "omega": 1, "k3": "1/2", "m0": 0}
    decision = report.itself(values)
    assert (decision.verdict, decision.notion, decision.modulo) == (Verdict.STABLE, "Lyapunov", ())
    assert report.itself(values | {"m0": "1/1000"}).verdict is Verdict.UNSTABLE
    assert report.itself(values | {"I3": "1001/1000"}).verdict is Verdict.UNSTABLE
    other = gs.analyze(gs.inclined(gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), gs.axial_potential(0))))
    assert other.itself({"k3": "1/2", "omega": 2}).verdict is Verdict.STABLE
    rest = gs.analyze(gs.static_tilt(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(0))))
    assert rest.itself({"I1": 1, "I3": 1, "l": 1, "k3": "1/2"}).verdict is Verdict.UNSTABLE
    for W, k in ((Fraction(1), (Fraction(3, 5), Fraction(4, 5))),
                 (Fraction(-2, 7), (Fraction(5, 13), Fraction(12, 13)))):
        x = oracle.exact([W * k[0], 0, W * k[1], k[0], 0, k[1]])
        assert not any(oracle.field(x, oracle.exact([1, 1, 1]), oracle.exact([0, 0, 0]),
                                    lambda k: oracle.exact([0, 0, 0])))


def test_a_flat_point_is_no_exception():
    """U = (k3 − 1/2)³ at k3 = 1/2, I1 = I3, l = 0, ω = 1.

    U' = U'' = 0, yet σ = 3 (k3 − 1/2)²/I3 beside it.
    """
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(),
                                                gs.axial_potential((k3 - Rational(1, 2)) ** 3))))
    values = {"I1": 1, "I3": 1, "omega": 1, "k3": "1/2"}
    assert report.verdict(values).verdict is Verdict.STABLE
    decision = report.itself(values)
    assert decision.verdict is Verdict.UNSTABLE and "higher order" in decision.reason
    tilt = Fraction(20, 29), Fraction(21, 29)
    slope = 3 * (tilt[1] - Fraction(1, 2)) ** 2
    sigma = precession(Fraction(1), Fraction(1), Fraction(0), tilt[1], Fraction(1), slope)
    assert sigma == slope > 0
    assert turning(Fraction(1), Fraction(1), Fraction(0), tilt, Fraction(1), sigma, slope)


@pytest.mark.slow
@given(I1=moments, I3=moments, W=nonzero, tilt=tilts, h=nonzero)
@settings(max_examples=15)
def test_rates_of_second_order(e3, drift, I1, I3, W, tilt, h):
    """Where both slopes vanish, l = 2 ω k3 (I1 − I3) and U'' = −ω² (I1 − I3).

    Not stable unless also I1 = I3, where σ = 0.
    """
    z = tilt[1]
    l, u2 = 2 * W * z * (I1 - I3), -(W**2) * (I1 - I3)
    assume(I1 != I3 and z and h != -W)
    values = {"I1": I1, "I3": I3, "l": l, "omega": W, "k3": z, "d2U": u2}
    assert all(at(rate, **values) == 0 for rate in drift.rates)
    u1 = W * l - W**2 * z * (I1 - I3)
    sigma = precession(I1, I3, l, z, W + h, u1)
    assert sigma == z * (I1 - I3) * h**2 / (I3 * (W + h)) and turning(I1, I3, l, tilt, W + h, sigma, u1)
    assume(e3.verdict(values).verdict is Verdict.STABLE)
    decision = e3.itself(values)
    assert decision.verdict is Verdict.UNSTABLE and "second order" in decision.reason


def test_moments_that_differ_are_enough(e3):
    """l = 0, k3 = 0, U″ = −ω² (I1 − I3) ≠ 0: both slopes vanish, no U is constant near it, and it drifts."""
    values = {"I1": 3, "I3": 2, "l": 0, "omega": 1, "k3": 0, "d2U": -1}
    assert e3.verdict(values).verdict is Verdict.STABLE
    decision = e3.itself(values)
    assert decision.verdict is Verdict.UNSTABLE and "second order" in decision.reason


def test_an_unspecified_potential_may_be_constant(e3):
    """I1 = I3, l = 0, U' = U'' = 0 of an unspecified U: not decided, and no notion claimed."""
    values = {"I1": 1, "I3": 1, "l": 0, "omega": 1, "k3": "1/2", "d2U": 0}
    assert e3.verdict(values).verdict is Verdict.STABLE
    decision = e3.itself(values)
    assert (decision.verdict, decision.notion) == (Verdict.UNDECIDED, "")
    assert "depends on U" in decision.reason
    assert e3.itself(values | {"d2U": "1/10"}).verdict is Verdict.UNSTABLE


def test_a_constant_is_recognised():
    """U = a exp(k3), I1 = I3 = A, l = 0: U' = 0 asks for a = 0, and there the point is stable itself."""
    a, A = symbols("a A")
    report = gs.analyze(gs.inclined(gs.assemble(gs.Gyrostat((A, A, A), (0, 0, 0)),
                                                gs.axial_potential(a * exp(k3)))))
    assert report.equilibrium.eliminated == ("a",)
    assert report.itself({"A": 1, "omega": 1, "k3": "1/3"}).verdict is Verdict.STABLE


def test_the_boundary_is_linearly_unstable(e3):
    """p = 0, orbitally stable by the next rungs.

    J is nilpotent, not 0, so there is a Jordan block whatever D is.
    """
    values = {"I1": 1, "I3": 1, "l": 0, "omega": 1, "k3": 0, "d2U": -1, "d3U": 0, "d4U": 0}
    assert oracle.verdict_inclined_margin(*map(Fraction, (1, 1, 0, 1, 0, -1))) == 0
    first, second = ranks(*map(Fraction, (1, 1, 0, 1)), (Fraction(1), Fraction(0)), Fraction(-1))
    assert first > second
    assert "Jordan" in e3.itself(values).reason        # g = 2 I1 (−U + 12 U'') = −24
    assert e3.verdict(values | {"d4U": "-11.9"}).verdict is Verdict.STABLE
    assert e3.verdict(values | {"d4U": "-12.1"}).verdict is Verdict.UNSTABLE


def test_a_nilpotent_field_with_no_defect(drift, e3):
    """I1 = ω = 1, k3 U' = 1, k3² U″ = −1, here k3 = 3/5: p = D = 0, and J is nilpotent, not 0.

    U⁗ > 12 U″/(1 − k3²) holds it.
    """
    z, I3 = Fraction(3, 5), Fraction(2)
    values = {"I1": Fraction(1), "I3": I3, "l": 1 / z + z * (1 - I3), "omega": Fraction(1), "k3": z,
              "d2U": -1 / z**2}
    assert (
        at(drift.defect, **values)
        == 0
        == oracle.verdict_inclined_margin(1, I3, values["l"], Fraction(1), z, values["d2U"])
    )
    first, second = ranks(1, I3, values["l"], Fraction(1), (Fraction(4, 5), z), values["d2U"])
    assert first > second
    values |= {"d3U": 0, "d4U": 12 * values["d2U"] / (1 - z**2) + 1}           # g‴ ∝ U‴, for k3 U″ + U' = 0
    assert e3.verdict(values).verdict is Verdict.STABLE and "Jordan" in e3.itself(values).reason
    assert e3.verdict(values | {"d4U": values["d4U"] - 2}).verdict is Verdict.UNSTABLE
