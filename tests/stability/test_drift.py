"""A tilted equilibrium as a point: Jordan blocks by exact ranks, drift by the precessions beside it."""
from fractions import Fraction

import oracle
import pytest
from draw import moments, nonzero, numbers, tilts
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import Rational, cancel, exp, symbols

import gyrostat as gs
from gyrostat.stability.drift import Drift
from gyrostat.stability.report import Verdict

k3 = gs.symbol("k3")
I1, I3, l, omega, d2U = map(gs.symbol, ("I1", "I3", "l", "omega", "d2U"))
SLOPE = omega * l - omega**2 * k3 * (I1 - I3)
D = (I1 * (I1 - I3) * omega**2 + (I1 * (1 - k3**2) + I3 * k3**2) * d2U - 2 * k3 * (I1 - I3) * SLOPE
     + ((I1 - I3) * omega * k3 - l) ** 2)


@pytest.fixture(scope="module")
def drift(e3):
    """Of E3 in an unspecified U."""
    return Drift(e3.equilibrium)


def at(expression, **numbers):
    """The expression at numbers, as a Fraction."""
    value = expression.xreplace({gs.symbol(name): Rational(x.numerator, x.denominator)
                                 for name, x in numbers.items()})
    return Fraction(int(value.p), int(value.q))


def precession(I1, I3, l, z, W, slope):
    """σ of the regular precession ω = W k + σ e3 at k3 = z.

    I1 z W² − P W + U'(z) = 0, P = I3 (W z + σ) + l.
    """
    return ((slope + I1 * z * W**2) / W - l) / I3 - W * z


def turning(I1, I3, l, tilt, W, sigma, slope):
    """The state at (k1, 0, k3) of that precession, and whether the Euler-Poisson field there is −σ times the
    rotation about axis 3.
    """
    k1, z = tilt
    x = oracle.exact([I1 * W * k1, 0, I3 * (W * z + sigma), k1, 0, z])
    xdot = oracle.field(x, oracle.exact([I1, I1, I3]), oracle.exact([0, 0, l]),
                        oracle.axial_slope(slope, Fraction(0), z))
    return all(xdot == -sigma * oracle.exact([-x[1], x[0], 0, -x[4], x[3], 0]))


def ranks(I1, I3, l, omega, tilt, u2):
    """Ranks of J and J² on the tangent space of the coadjoint orbit, J of the Euler-Poisson field
    differenced.
    """
    x, f = oracle.inclined(I1, I3, l, omega, (tilt[0], 0, tilt[1]), u2)
    J, basis = oracle.jacobian(f, x), oracle.orbit_basis(x, oracle.exact([0, 0, l]))
    return oracle.rank(J.dot(basis)), oracle.rank(J.dot(J).dot(basis))


def test_the_defect_is_the_one_of_the_theory(drift, at_rest):
    """D = I1 (I1 − I3) ω² + (I1 (1 − k3²) + I3 k3²) U'' − 2 k3 (I1 − I3) U' + ((I1 − I3) ω k3 − l)², up to a
    factor that has a sign.
    """
    assert cancel(drift.defect / D) in (1, -1)
    assert cancel(Drift(at_rest.equilibrium).defect / D.subs(omega, 0)) in (1, -1)


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
    assert report.equilibrium.eliminated == "a"
    assert report.itself({"A": 1, "omega": 1, "k3": "1/3"}).verdict is Verdict.STABLE


def test_a_pole_is_its_own_point(e1, e2):
    """At E1 and E2 nothing is divided out: itself is verdict."""
    for report, values in ((e1, {"I1": 1, "l": 2, "pi3_0": 1, "dU": 2}),
                           (e2, {"I1": 1, "l": 2, "pi3_0": 1, "dU": -4})):
        assert report.itself(values) == report.verdict(values)


def test_unstable_modulo_the_spin_is_unstable(e3):
    """itself repeats an UNSTABLE verdict, modulo nothing; an undecided one stays so, modulo the spin."""
    values = {"I1": 1, "I3": 1, "l": 0, "omega": 1, "k3": 0}
    unstable, undecided = values | {"d2U": -2}, values | {"d2U": -1}
    assert (e3.itself(unstable).verdict, e3.itself(unstable).modulo) == (Verdict.UNSTABLE, ())
    assert e3.verdict(unstable).modulo == (gs.symbol("pi3"),)
    assert e3.itself(unstable).reason == e3.verdict(unstable).reason
    assert e3.itself(undecided) == e3.verdict(undecided) and e3.itself(undecided).verdict is Verdict.UNDECIDED


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
