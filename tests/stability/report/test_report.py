"""Verdicts: exact, equality included, against an oracle that knows neither the library nor its formulas."""
import random
from fractions import Fraction

import oracle
import pytest
from draw import moments, numbers, tilts
from hypothesis import given, settings
from hypothesis import strategies as st
from slow import sampled
from stability.reported import SIGNS
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.stability.decision import Verdict


def test_readme_example(e1):
    """(π3 + l)² = 9 > 8 = 4 I1 U'(1)."""
    decision = e1.verdict({"I1": 1, "I3": "1/2", "l": 2, "pi3_0": 1, "dU": 2})
    assert (decision.verdict, decision.notion, decision.modulo, decision.note) == (
        Verdict.STABLE,
        "Lyapunov",
        (),
        "",
    )
    assert [value for _, value in decision.margins] == [1] and "definite" in decision.reason


@pytest.mark.few(1)
@pytest.mark.parametrize("s", [1, -1])
@given(I1=moments, l=numbers, pi3=numbers, u=numbers, boundary=st.booleans())
def test_vertical_verdicts_are_exact(e1, e2, s, I1, l, pi3, u, boundary):
    """Stable, unstable or on the boundary as the reduced motion says, g''(±1) < 0, > 0, = 0.

    A fifth exactly on it.
    """
    if boundary:
        u = s * (pi3 + l) ** 2 / (4 * I1)
    decision = (e1 if s == 1 else e2).verdict({"I1": I1, "l": l, "pi3_0": pi3, "dU": u})
    assert decision.verdict is SIGNS[oracle.verdict_vertical(I1, l, pi3, s, u)]


@pytest.mark.slow
@given(I1=moments, I3=moments, l=numbers, omega=numbers, tilt=tilts, u2=numbers, boundary=st.booleans())
@settings(max_examples=40)
def test_inclined_verdicts_are_exact(e3, I1, I3, l, omega, tilt, u2, boundary):
    """Orbital stability at E3 as g''(k3) < 0, > 0, = 0; modulo the spin."""
    z = tilt[1]
    if boundary:                                       # g'' is affine in U'': the root
        at = [oracle.verdict_inclined_margin(I1, I3, l, omega, z, Fraction(n)) for n in (0, 1)]
        u2 = at[0] / (at[0] - at[1])
    decision = e3.verdict({"I1": I1, "I3": I3, "l": l, "omega": omega, "k3": z, "d2U": u2})
    assert decision.verdict is SIGNS[oracle.verdict_inclined(I1, I3, l, omega, z, u2)]
    assert decision.modulo == (gs.symbol("pi3"),)


@pytest.mark.slow
@given(I1=moments, I3=moments, l=numbers, omega=numbers, tilt=tilts, u2=numbers)
@settings(max_examples=15)
def test_unstable_means_a_growing_mode(e3, I1, I3, l, omega, tilt, u2):
    """UNSTABLE exactly where the 6×6 Euler-Poisson field has an eigenvalue with positive real part."""
    x, f = oracle.inclined(I1, I3, l, omega, (tilt[0], Fraction(0), tilt[1]), u2)
    decision = e3.verdict({"I1": I1, "I3": I3, "l": l, "omega": omega, "k3": tilt[1], "d2U": u2})
    assert (decision.verdict is Verdict.UNSTABLE) == oracle.growth(f, x)


@pytest.mark.slow
def test_no_wrong_verdict_in_100_000_points(e1, e2, e3, full):
    """0 wrong verdicts on 10⁵ random rational points over E1, E2, E3, on 30 000 without --full, a fifth of
    them exactly on the boundary.
    """
    draw, wrong = random.Random(20261121), 0
    number = lambda low=-50: Fraction(draw.randint(low, 50), draw.randint(1, 20))  # noqa: E731
    for n in range(sampled(100_000, full, 20_000)):
        I1, I3, l, spin, u = number(1), number(1), number(), number(), number()
        if n % 3 < 2:
            s = 1 - 2 * (n % 3)
            if n % 5 == 0:
                u = s * (spin + l) ** 2 / (4 * I1)
            got = (e1 if s == 1 else e2).verdict({"I1": I1, "l": l, "pi3_0": spin, "dU": u}).verdict
            wrong += got is not SIGNS[oracle.verdict_vertical(I1, l, spin, s, u)]
            continue
        z = Fraction(draw.randint(-99, 99), 100)
        if n % 5 == 0:
            at = [oracle.verdict_inclined_margin(I1, I3, l, spin, z, Fraction(m)) for m in (0, 1)]
            u = at[0] / (at[0] - at[1])
        got = e3.verdict({"I1": I1, "I3": I3, "l": l, "omega": spin, "k3": z, "d2U": u}).verdict
        wrong += got is not SIGNS[oracle.verdict_inclined(I1, I3, l, spin, z, u)]
    assert wrong == 0


def test_sleeping_top():
    """I1 = 1, I3 = 1.6, m0 = 1: critical spin 1.25 (Marsden & Ratiu, §15.10)."""
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), spin="omega3_0"))
    top = {"I1": 1, "I3": "1.6", "l": 0, "m0": 1}
    verdicts = [report.verdict(top | {"omega3_0": spin}).verdict.name
                for spin in ("1.2499999", "1.25", "1.2500001")]
    # at 1.25 U' + U'' = m0 > 0 holds it (Cushman & Bates)
    assert verdicts == ["UNSTABLE", "STABLE", "STABLE"]
    assert report.verdict(top | {"omega3_0": -1.26}).verdict is Verdict.STABLE


def test_steady_precession_of_the_heavy_top():
    """I1 = 2, I3 = 1, m g l0 = 3, θ = 60°, ω3 = 6.

    W = 0.5505…, 5.4494…, both orbitally stable, with their nutation (Goldstein §5.7).
    """
    W = gs.symbol("omega")
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    for s, rate, nutation in ((-1, 0.5505102572, 2.4954551003), (1, 5.4494897428, 5.3172082753)):
        root = 3 + s * sqrt(6)                         # I1 cos θ W² − I3 ω3 W + m g l0 = W² − 6 W + 3 = 0
        l = 6 - root / 2                               # the spin seen from E3: l = I3 (ω3 − W cos θ)
        values = {"I1": 2, "I3": 1, "m0": 3, "k3": "1/2", "omega": root, "l": l}
        assert abs(float(root) - rate) < 1e-10 and report.verdict(values).verdict is Verdict.STABLE
        p = report.equilibrium.insert(report.linearization.coefficients[0]).subs(
            {gs.symbol(n): gs.algebra.text.numbers.exact_number(v) for n, v in values.items() if n != "l"})
        assert abs(float(sqrt(p)) - nutation) < 1e-9
        assert W in report.linearization.coefficients[0].free_symbols


def test_hanging_heavy_top_is_stable():
    """Always, for m0 > 0 (Kibble & Berkshire)."""
    report = gs.analyze(gs.hanging(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    for spin in (0, "1/10", -7):
        assert report.verdict({"I1": 1, "l": 0, "m0": "1/9", "pi3_0": spin}).verdict is Verdict.STABLE


def test_intermediate_axis():
    """Growth rate 0.28867513459 for I = (1, 2, 3), abs(M) = 1 (Landau & Lifshitz §37)."""
    eq = gs.principal_rotation(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0))), 2)
    rate = max(float(root.subs(gs.symbol("omega2_0"), Rational(1, 2)).evalf().as_real_imag()[0])
               for root in gs.derivation.linearize(eq).eigenvalues())
    assert abs(rate - 0.28867513459) < 1e-11


def test_reports_are_lazy(scene):
    """Nothing is derived before it is asked for."""
    report = gs.analyze(gs.upright(scene))
    assert "linearization" not in vars(report)
    report.verdict({"I1": 1, "l": 0, "pi3_0": 3, "dU": 1})
    assert "casimirs_only" not in vars(report)


def test_undecided_says_what_it_means():
    """The value of a verdict is a sentence."""
    assert all(len(verdict.value.split()) > 5 for verdict in Verdict)
