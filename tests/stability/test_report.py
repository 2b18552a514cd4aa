"""Verdicts: exact, equality included, against an oracle that knows neither the library nor its formulas."""
import random
from fractions import Fraction

import numpy as np
import oracle
import pytest
from draw import moments, numbers, tilts
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import CRootOf, GoldenRatio, Rational, asin, exp, expand, log, sqrt, symbols

import gyrostat as gs
from gyrostat.errors import ArgumentError, EquilibriumError, GyrostatError, ValuesError
from gyrostat.stability.report import Verdict

# 0: on the boundary, the next derivative of U not given
SIGNS = {1: Verdict.STABLE, -1: Verdict.UNSTABLE, 0: Verdict.UNDECIDED}
k3 = gs.symbol("k3")


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


@given(I1=moments, I3=moments, l=numbers, omega=numbers, tilt=tilts, u2=numbers)
@settings(max_examples=15)
def test_unstable_means_a_growing_mode(e3, I1, I3, l, omega, tilt, u2):
    """UNSTABLE exactly where the 6×6 Euler-Poisson field has an eigenvalue with positive real part."""
    x, f = oracle.inclined(I1, I3, l, omega, (tilt[0], Fraction(0), tilt[1]), u2)
    decision = e3.verdict({"I1": I1, "I3": I3, "l": l, "omega": omega, "k3": tilt[1], "d2U": u2})
    assert (decision.verdict is Verdict.UNSTABLE) == oracle.growth(f, x)


@pytest.mark.slow
def test_no_wrong_verdict_in_100_000_points(e1, e2, e3):
    """0 wrong verdicts on 10⁵ random rational points over E1, E2, E3, a fifth of them exactly on the
    boundary.
    """
    draw, wrong = random.Random(20261121), 0
    number = lambda low=-50: Fraction(draw.randint(low, 50), draw.randint(1, 20))  # noqa: E731
    for n in range(100_000):
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


@pytest.mark.parametrize("scale", [1.0, 1e-150, 1e150, 1e-308])
@pytest.mark.parametrize("l", [0.1, 1e8, -1e8])
def test_neighbouring_floats_at_the_boundary(e1, scale, l):
    """A float is the rational it is.

    On both sides of the boundary, one unit in the last place away, nothing is wrong.

    Cancelling momenta π3 ≈ −l, scales from subnormal to 10¹⁵⁰.
    """
    I1, spin, l = 0.7 * scale, (0.3 - l) * scale, l * scale
    P = Fraction(spin) + Fraction(l)
    boundary = P * P / (4 * Fraction(I1))
    for u in (float(boundary), np.nextafter(float(boundary), np.inf), np.nextafter(float(boundary), -np.inf),
              boundary):
        got = e1.verdict({"I1": I1, "l": l, "pi3_0": spin, "dU": u}).verdict
        margin = P * P - 4 * Fraction(I1) * Fraction(u)
        assert got is SIGNS[(margin > 0) - (margin < 0)]
    assert got is Verdict.UNDECIDED


def test_nearly_equal_moments_and_nearly_upright(e3):
    """I1 − I3 = 10⁻³⁰ and 1 − k3 = 10⁻³⁰: the oracle's verdict on both sides of its boundary, and on it."""
    tiny = Fraction(1, 10**30)
    for I3, z in ((1 + tiny, Fraction(1, 3)), (Fraction(1, 2), 1 - tiny), (1 - tiny, tiny - 1)):
        at = [oracle.verdict_inclined_margin(Fraction(1), I3, Fraction(2), Fraction(3), z, Fraction(n))
              for n in (0, 1)]
        root = at[0] / (at[0] - at[1])
        for u2 in (root, root + tiny**2, root - tiny**2):
            decision = e3.verdict({"I1": 1, "I3": I3, "l": 2, "omega": 3, "k3": z, "d2U": u2})
            assert (
                decision.verdict
                is SIGNS[oracle.verdict_inclined(Fraction(1), I3, Fraction(2), Fraction(3), z, u2)]
            )


def test_stiff_fields():
    """Degree 20 and exp(50 k3): the margin is that of the unspecified field at U'."""
    coefficients = [Fraction(n + 1, 7) * (-1) ** n * 10**n for n in range(21)]
    U = gs.axial_potential(sum(Rational(c.numerator, c.denominator) * k3**n
                               for n, c in enumerate(coefficients)))
    report = gs.analyze(gs.hanging(gs.assemble(gs.symmetric_gyrostat(), U)))
    slope = sum(n * c * (-1) ** (n - 1) for n, c in enumerate(coefficients))
    for spin in (10**10, 10**12, Fraction(10**23, 9)):
        assert report.verdict({"I1": 1, "l": 0, "pi3_0": spin}).verdict is SIGNS[
            oracle.verdict_vertical(Fraction(1), 0, Fraction(spin), -1, slope)]
    stiff = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(exp(50 * k3)))))
    # 4 U'(1) = 200 e⁵⁰ = 1.03694…·10²⁴: the roots of the margin are ± 1.01830…·10¹²
    assert stiff.verdict({"I1": 1, "l": 0, "pi3_0": 1_018_305_000_000}).verdict is Verdict.STABLE
    assert stiff.verdict({"I1": 1, "l": 0, "pi3_0": 1_018_303_000_000}).verdict is Verdict.UNSTABLE


def test_transcendental_margins_are_proved_or_undecided():
    """On the boundary P² = 4 e of U = exp(k3), U' + U'' = 2 e > 0.

    At a zero that SymPy does not see, UNDECIDED with the reason.
    """
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(exp(k3)))))
    assert report.verdict({"I1": 1, "l": 0, "pi3_0": 2 * sqrt(exp(1))}).verdict is Verdict.STABLE
    third = Rational(1, 3)
    close = report.verdict({"I1": 1, "l": 0, "pi3_0": 2 * sqrt(exp(third)) * exp(third)
                            + Rational(1, 10**1500)})
    assert close.verdict is Verdict.UNDECIDED and "no proved sign" in close.reason
    assert (
        report.verdict({"I1": 1, "l": 0, "pi3_0": 2 * sqrt(exp(1)) + Rational(1, 10**900)}).verdict
        is Verdict.STABLE
    )


def test_algebraic_numbers_on_the_boundary(e1):
    """(√2 + √3)² = 5 + 2√6 is exactly on the boundary of 4 I1 U' = 5 + 2√6, and 10⁻¹⁰⁰ away it is not."""
    values = {"I1": "1/4", "l": "sqrt(2)", "pi3_0": "sqrt(3)", "dU": "5 + 2*sqrt(6)"}
    assert e1.verdict(values).verdict is Verdict.UNDECIDED
    assert e1.verdict(values | {"dU": "5 + 2*sqrt(6) + 1e-100"}).verdict is Verdict.UNSTABLE
    assert e1.verdict(values | {"dU": 5 + 2 * sqrt(6) - Rational(1, 10**100)}).verdict is Verdict.STABLE


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
            {gs.symbol(n): gs.algebra.numbers.exact_number(v) for n, v in values.items() if n != "l"})
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
               for root in gs.linearize(eq).eigenvalues())
    assert abs(rate - 0.28867513459) < 1e-11


@pytest.mark.parametrize(("values", "why"), [
    ({"I1": 1, "l": 0, "pi3_0": 1}, "needs dU"),
    ({"I1": 1, "l": 0, "pi3_0": 1, "dU": 1, "mass": 3}, "no parameter mass"),
    ({"I1": 0, "l": 0, "pi3_0": 1, "dU": 1}, "I1 = 0.*must be positive"),
    ({"I1": -1, "l": 0, "pi3_0": 1, "dU": 1}, "must be positive"),
    ({"I1": 1, "l": float("nan"), "pi3_0": 1, "dU": 1}, "l = nan is not finite"),
    ({"I1": float("inf"), "l": 0, "pi3_0": 1, "dU": 1}, "not finite"),
    ({"I1": 1, "l": "x", "pi3_0": 1, "dU": 1}, "contains the names"),
    ({"I1": 1, "l": "1/", "pi3_0": 1, "dU": 1}, "cannot read"),
    ({"I1": 1, "I3": -2, "l": 0, "pi3_0": 1, "dU": 1}, "I3 = -2"),
    ({"I1": GoldenRatio, "l": 0, "pi3_0": 1, "dU": 1}, "cannot be enclosed"),
    ({"I1": 1, "l": None, "pi3_0": 1, "dU": 1}, "NoneType"),
    ({"I1": 1, "l": 0, "omega3_0": 1, "dU": 1}, "no parameter omega3_0")])
def test_bad_values_are_refused(e1, values, why):
    """What was given, why it is impossible, what to do."""
    with pytest.raises(GyrostatError, match=why):
        e1.verdict(values)


def test_points_off_the_family_are_refused(e3):
    """abs(k3) < 1, ω ≠ 0 where l is eliminated, and the eliminated name, if given, must satisfy the relation
    exactly.
    """
    values = {"I1": 2, "I3": 1, "l": 1, "omega": 1, "k3": "1/2", "d2U": 1}
    assert e3.verdict(values | {"dU": "1/2"}) == e3.verdict(values)
    with pytest.raises(ValuesError, match="not on E3.*omit dU"):
        e3.verdict(values | {"dU": 0.5 + 2**-52})
    for k in (1, -1, "3/2", "sqrt(2)"):
        with pytest.raises(ValuesError, match="exists only where"):
            e3.verdict(values | {"k3": k})
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))
    heavy = {"I1": 2, "I3": 1, "omega": 1, "k3": "1/2", "m0": 1}
    assert report.verdict(heavy | {"l": "3/2"}) == report.verdict(heavy)
    with pytest.raises(ValuesError, match="not on E3: it needs l = 3/2, given was 1; omit l"):
        report.verdict(heavy | {"l": 1})
    with pytest.raises(ValuesError, match="exists only where"):
        report.verdict(heavy | {"omega": 0})
    # U = k3³, I1 − I3 = 1, l = 2: k3 ω² − 2 ω + 3 k3² = 0 has the roots 2 ± √(5/2) at k3 = 1/2
    numeric = gs.analyze(gs.inclined(gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 2)),
                                                 gs.axial_potential(k3**3))))
    assert numeric.verdict({"k3": "1/2", "omega": "2 - sqrt(5/2)"}).verdict is Verdict.STABLE
    with pytest.raises(ValuesError, match="not on E3.*correct"):
        numeric.verdict({"k3": "1/2", "omega": "0.418861169915810"})


def test_fields_that_are_not_real_are_refused():
    """√k3 at k3 = −1/4, log(1 − k3) at k3 = 1: U has to be finite and real there."""
    with pytest.raises(EquilibriumError, match="not a finite real number"):
        gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(log(1 - k3))))
    with pytest.raises(EquilibriumError, match="not a finite real number"):
        gs.hanging(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(log(k3))))
    report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(sqrt(k3)))))
    values = {"I1": 1, "I3": 1, "omega": 1, "k3": "1/4"}
    assert report.verdict(values).verdict in (Verdict.STABLE, Verdict.UNSTABLE)
    with pytest.raises(ValuesError, match="exists only where"):
        report.verdict(values | {"k3": "-1/4"})        # ω √k3 has to be real for l to be
    for U in (log(k3), asin(2 * k3)):
        report = gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(U))))
        with pytest.raises(ValuesError, match="exists only where"):
            report.verdict(values | {"k3": "-1/2"})
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(),
                                               gs.axial_potential(asin(gs.symbol("a") * k3)))))
    assert report.verdict({"I1": 1, "l": 0, "pi3_0": 9, "a": "1/2"}).verdict is Verdict.STABLE
    with pytest.raises(ValuesError, match=r"exists only where 1 - a\*\*2 > 0"):
        report.verdict({"I1": 1, "l": 0, "pi3_0": 9, "a": 1})
    pole = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(),
                                             gs.axial_potential(1 / (gs.symbol("a") - k3)))))
    with pytest.raises(ValuesError, match="not a finite real number"):
        pole.verdict({"I1": 1, "l": 0, "pi3_0": 1, "a": 1})


def test_branch_points_are_no_potentials():
    """(k3 − 1)^(5/2) has two derivatives at k3 = 1, but is not real beside it."""
    with pytest.raises(EquilibriumError, match="not smooth"):
        gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential((k3 - 1) ** Rational(5, 2))))
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(),
                                               gs.axial_potential((k3 + gs.symbol("a")) ** Rational(5, 2)))))
    assert report.verdict({"I1": 1, "l": 0, "pi3_0": 9, "a": 0}).verdict is Verdict.STABLE
    with pytest.raises(ValuesError, match="exists only where a . 1 > 0"):
        report.verdict({"I1": 1, "l": 0, "pi3_0": 9, "a": -1})


@pytest.mark.parametrize("U", [k3 * sqrt((-k3 - 2) / (k3 - 3)), k3 * sqrt((k3 + 2) / (3 - k3)),
                               k3 * sqrt(k3 + 2) / sqrt(3 - k3)])
def test_the_sign_of_a_root_of_a_fraction(U):
    """√(N/D) is positive whatever the signs of N and D.

    Three ways to write one potential, one verdict (here p = 1.2 > 0).
    """
    scene = gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, 1)), gs.axial_potential(gs.symbol("a") * U / k3))
    assert (
        gs.analyze(gs.inclined(scene, eliminate="a")).verdict({"k3": "1/2", "omega": "1/3"}).verdict
        is Verdict.STABLE
    )
    heavy = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), gs.axial_potential(U))
    assert gs.analyze(gs.upright(heavy)).verdict({"pi3_0": 1}).verdict is Verdict.UNSTABLE


def test_the_sign_of_a_root_of_a_fraction_of_moments():
    """√((−I1 − 2)/(−I1 − 1)) is positive: P² = 1 < 4 √(3/2) is unstable."""
    I1 = gs.symbol("I1")
    scene = gs.assemble(gs.Gyrostat((I1, I1, 1), (0, 0, 0)),
                        gs.axial_potential(k3 * sqrt((-I1 - 2) / (-I1 - 1))))
    assert gs.analyze(gs.upright(scene)).verdict({"I1": 1, "pi3_0": 1}).verdict is Verdict.UNSTABLE


def test_eliminated_moments_are_positive_too():
    """A moment that the relation makes −21 is no moment."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    for name, values in (("I1", {"I3": 1, "l": -10, "m0": 1, "k3": "1/2", "omega": 1}),
                         ("I3", {"I1": 1, "l": 10, "m0": 1, "k3": "1/2", "omega": 1})):
        with pytest.raises(ValuesError, match="exists only where"):
            gs.analyze(gs.inclined(scene, eliminate=name)).verdict(values)
    with pytest.raises(EquilibriumError, match="moments of inertia are positive"):
        gs.equilibrium(scene, (0, 0, 1, 0, 0, 1), relations=(("I1", -1),))


def test_a_point_may_use_the_names_of_coordinates():
    """k = (k3, 0, √(1 − k3²)): the parameter k3 is not the coordinate k3."""
    k2, k1 = gs.symbol("k2"), gs.symbol("k1")
    scene = gs.assemble(gs.Gyrostat((1, 2, 3), (1, 0, 0)), gs.general_potential(k2**2 * k1))
    family = gs.equilibrium(scene, (0, 0, 0, k3, 0, sqrt(1 - k3**2)), domain=(1 - k3**2,))
    at = gs.equilibrium(scene, (0, 0, 0, Rational(-3, 5), 0, Rational(4, 5)))
    assert (
        gs.analyze(family).verdict({"k3": "-3/5"}).verdict
        is gs.analyze(at).verdict({}).verdict
        is Verdict.UNSTABLE
    )
    other = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 0)),
                        gs.general_potential(lambda x, y, z: x**2 + z**2 + y**3))
    assert gs.equilibrium(other, (0, 0, 0, k3, 0, sqrt(1 - k3**2)), domain=(1 - k3**2,))


def test_relations_that_the_field_does_not_satisfy():
    """U = k3 has U' = 1: no relation makes it 0, alone or followed by another."""
    scene = gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, 3)), gs.axial_potential(k3))
    for more in ((), (("a", 1),)):
        with pytest.raises(EquilibriumError, match="off by 1"):
            gs.equilibrium(scene, (0, 0, 0, sqrt(1 - k3**2), 0, k3), relations=(("dU", 0), *more),
                           domain=(1 - k3**2,))


def test_huge_numbers_are_decided_and_shown(e1):
    """10⁵⁰⁰⁰ is a number like any other; messages round it."""
    huge = e1.verdict({"I1": 1, "l": 0, "pi3_0": 10**5000, "dU": 10**9999})
    assert huge.verdict is Verdict.STABLE and "6.00000000000e+9999" in str(huge)
    for values in ({"I1": -(10**5000), "l": 0, "pi3_0": 1, "dU": 1},
                   {"I1": 1, "l": 10**5000, "pi3_0": 1, "dU": "x"}):
        with pytest.raises(ValuesError, match="give a"):
            e1.verdict(values)


def test_algebraic_boundaries_of_high_degree(e1):
    """Exactly on the boundary with nested roots of degree 2¹⁰, and 10⁻³⁰⁰⁰ beside it.

    A root of x³ − x − 1.
    """
    inner = (sqrt(2) + sqrt(3)) * (sqrt(5) + sqrt(7))
    values = {"I1": sqrt(sqrt(2) + sqrt(3)), "l": 0, "dU": sqrt(sqrt(5) + sqrt(7)),
              "pi3_0": 2 * expand(inner) ** Rational(1, 4)}
    assert e1.verdict(values).verdict is Verdict.UNDECIDED
    assert e1.verdict(values | {"l": Rational(1, 10**3000)}).verdict is Verdict.STABLE
    plastic = CRootOf(gs.symbol("x") ** 3 - gs.symbol("x") - 1, 0)
    assert (
        e1.verdict({"I1": plastic, "l": 0, "dU": plastic, "pi3_0": 2 * plastic}).verdict is Verdict.UNDECIDED
    )
    assert (
        e1.verdict({"I1": plastic, "l": 0, "dU": plastic - Rational(1, 10**99), "pi3_0": 2 * plastic}).verdict
        is Verdict.STABLE
    )


def test_moments_with_names_of_the_user_are_positive():
    """A body of moments A, C: both must be positive, as I1 and I3 are."""
    A, C = symbols("A C")
    report = gs.analyze(gs.upright(gs.assemble(gs.Gyrostat((A, A, C), (0, 0, 0)), gs.uniform_field())))
    assert len(report.sufficient.alternatives) == 1
    assert report.verdict({"A": 1, "C": 1, "m0": 1, "pi3_0": 3}).verdict is Verdict.STABLE
    with pytest.raises(ValuesError, match="exists only where"):
        report.verdict({"A": -1, "C": 1, "m0": 1, "pi3_0": 4})


def test_wrong_kinds_are_named(scene):
    """A scene where an equilibrium is wanted, arguments in the wrong order."""
    for call in (lambda: gs.analyze(scene), lambda: gs.assemble(gs.uniform_field(), gs.symmetric_gyrostat()),
                 lambda: gs.Gyrostat(1),
                 lambda: gs.upright(gs.symmetric_gyrostat()), lambda: gs.inclined(None),
                 lambda: gs.equilibrium(3, (0,))):
        with pytest.raises(ArgumentError,
                           match="is an? .*, (not an? |a scene: choose one of its equilibria, upright)"):
            call()


def test_names_are_suggested(e1):
    """omega3 is no parameter; pi3_0 is, and omega3_0 with spin=."""
    with pytest.raises(ValuesError, match=r'did you mean omega3_0\? .*spin="omega3_0"'):
        e1.verdict({"I1": 1, "l": 0, "omega3": 1, "dU": 1})


def test_unusual_moments_are_noted(e1):
    """I3 > I1 + I2 belongs to no rigid body: a note, never an error."""
    decision = e1.verdict({"I1": 1, "I3": 5, "l": 0, "pi3_0": 3, "dU": 1})
    assert decision.verdict is Verdict.STABLE and "no rigid body" in decision.note
    assert e1.verdict({"I1": 1, "I3": 2, "l": 0, "pi3_0": 3, "dU": 1}).note == ""


def test_reports_are_lazy(scene):
    """Nothing is derived before it is asked for."""
    report = gs.analyze(gs.upright(scene))
    assert "linearization" not in vars(report)
    report.verdict({"I1": 1, "l": 0, "pi3_0": 3, "dU": 1})
    assert "casimirs_only" not in vars(report)


def test_undecided_says_what_it_means():
    """The value of a verdict is a sentence."""
    assert all(len(verdict.value.split()) > 5 for verdict in Verdict)
