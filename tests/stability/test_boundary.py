"""The boundary: rungs against the formulas of the theory and by design, published cases, algebraic points."""
from fractions import Fraction
from itertools import islice
from math import factorial

import oracle
import pytest
from slow import slow
from sympy import (
    CRootOf,
    Poly,
    Rational,
    S,
    Symbol,
    cancel,
    cos,
    exp,
    expand,
    integrate,
    invert,
    log,
    radsimp,
    rem,
    sin,
    sqrt,
)

import gyrostat as gs
from gyrostat.errors import ValuesError
from gyrostat.mechanics.reduction import expansion
from gyrostat.notation import jet_name
from gyrostat.stability.report import Verdict

k3, omega, l = gs.symbol("k3"), gs.symbol("omega"), gs.symbol("l")
I1, I3 = gs.symbol("I1"), gs.symbol("I3")
HALF = Rational(1, 2)


def U(n):
    """U^(n) at the equilibrium."""
    return gs.symbol(jet_name(n))


def name(report, values):
    """The verdict, by its name."""
    return report.verdict(values).verdict.name


def pole(potential, s=1, body=None):
    """The report on E1 or E2 in a potential."""
    scene = gs.assemble(body or gs.symmetric_gyrostat(), gs.axial_potential(potential))
    return gs.analyze((gs.upright if s == 1 else gs.hanging)(scene))


@pytest.mark.parametrize("s", [1, -1])
def test_rungs_at_the_poles(e1, e2, s):
    """c_n = 2 I1 (−1)ⁿ [2 U^(n+1)/(n+1)! + U^(n)/n!] at E1, 2 I1 [U^(n)/n! − 2 U^(n+1)/(n+1)!] at E2, margin
    −c_n, n to 8.
    """
    boundary = (e1 if s == 1 else e2).boundary
    assert boundary.pole and boundary.last is None
    for n, rung in enumerate(islice(boundary.rungs(), 8), 1):
        c = (-1) ** n * (2 * U(n + 1) / factorial(n + 1) + U(n) / factorial(n))
        if s == -1:                                    # E1 of z → −z
            c = U(n) / factorial(n) - 2 * U(n + 1) / factorial(n + 1)
        ratio = cancel(-c / rung.condition.margin)
        assert rung.power == n + 2 and not rung.escapes and ratio.is_positive and ratio.is_Rational
        assert rung.condition.at == s and rung.condition.degenerate == ()


def test_rungs_at_a_tilt(e3, at_rest):
    """g^(n) = 2 I1 [−(1 − k3²) U^(n) + 2 n k3 U^(n−1) + n (n − 1) U^(n−2)], margin −g^(n), n = 3 … 8.

    Odd n escapes.
    """
    for report in (e3, at_rest):
        assert not report.boundary.pole
        slope = dict(report.equilibrium.relations)[U(1)]
        for n, rung in enumerate(islice(report.boundary.rungs(), 6), 3):
            g = -(1 - k3**2) * U(n) + 2 * n * k3 * U(n - 1) + n * (n - 1) * U(n - 2).subs(U(1), slope)
            ratio = cancel(-g.subs(U(1), slope) / rung.condition.margin)
            assert ratio.is_Rational
            assert ratio.is_positive
            assert rung.escapes == (n % 2 == 1)
            assert rung.power == n


def test_formal_criterion_and_reduction_agree(e1, e2, e3, at_rest):
    """The margin of the second variation is −(coefficient of x²), up to a positive factor."""
    for report in (e1, e2, e3, at_rest):
        ((condition,),) = report.sufficient.alternatives
        assert cancel(-expansion(report.equilibrium, 2)[2] / condition.margin) in (1, I1)


def test_sleeping_top_at_its_critical_spin():
    """I1 = 1, I3 = 1.6, m0 = 1, ω3 = 1.25: P² = 4 I1 m0, and U' + U'' = m0 > 0.

    Stable, supercritical (Cushman & Bates, chapter V).
    """
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), spin="omega3_0"))
    decision = report.verdict({"I1": 1, "I3": "1.6", "l": 0, "m0": 1, "omega3_0": "1.25"})
    assert (decision.verdict, decision.notion, decision.modulo) == (Verdict.STABLE, "Lyapunov", ())
    assert "supercritical" in decision.reason and "x^3" in decision.reason
    assert [value for _, value in decision.margins] == [0, 1]


@pytest.mark.parametrize(("m0", "expected", "kind"),
                         [(3, "UNSTABLE", "subcritical"), (5, "STABLE", "supercritical")])
def test_newtonian_field_of_order_two(m0, expected, kind):
    """I1 − I3 = 2, m1 = 1: U' = m0 − 2, U'' = −2. The boundary is stable only if m0 > 4."""
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.newtonian_field(2))))
    decision = report.verdict({"I1": 4, "I3": 2, "l": 0, "m0": m0, "m1": 1, "pi3_0": 4 * sqrt(m0 - 2)})
    assert decision.verdict.name == expected and kind in decision.reason


@pytest.mark.parametrize(("potential", "expected"), [
    (k3**2 / 2 - k3, "STABLE"), ((k3 - 1) ** 3, "UNSTABLE"), ((1 - k3) ** 3, "STABLE"),
    (-((k3 - 1) ** 6), "UNSTABLE"), (S.Zero, "UNSTABLE"), ((1 - k3) ** 2 / (3 + k3), "STABLE"),
    *slow((k3 - k3**2 / 2, "UNSTABLE"), ((k3 - 1) ** 4, "STABLE"), ((1 - k3) ** 13, "STABLE"),
          (-((1 - k3) ** 14), "UNSTABLE"), (S(7), "UNSTABLE"), (-((1 - k3) ** 2) / (3 + k3), "UNSTABLE"))])
def test_no_total_momentum_and_no_slope(potential, expected):
    """P = 0 = U': the pole is stable exactly where it is a strict minimum of U on the sphere.

    At E2 the mirror image.
    """
    assert name(pole(potential), {"I1": 2, "l": -3, "pi3_0": 3}) == expected
    assert name(pole(potential.subs(k3, -k3), -1), {"I1": 2, "l": -3, "pi3_0": 3}) == expected


def test_all_coefficients_vanish_at_a_pole():
    """U = −(P²/(2 I1)) (1 − z)/(1 + z): g = 0, every k3 is a motion, and E1 is unstable.

    With another numerator it is not.
    """
    P, mirrored = gs.symbol("a"), (1 + k3) / (1 - k3)
    for s, shape in ((1, 1 / mirrored), (-1, mirrored)):
        report = pole(-(P**2) * shape / 6, s, gs.Gyrostat((3, 3, 5), (0, 0, l)))
        for total in (2, "sqrt(2)", "-1/3"):
            decision = report.verdict({"l": 0, "pi3_0": total, "a": total})
            assert decision.verdict is Verdict.UNSTABLE and "vanishes identically" in decision.reason
    bent = pole(-Rational(2, 3) * (1 - k3) / (1 + k3) + (1 - k3) ** 9, 1, gs.Gyrostat((3, 3, 5), (0, 0, 0)))
    assert name(bent, {"pi3_0": 2}) == "STABLE"
    assert [name(pole(S.Zero), {"I1": 1, "l": 1, "pi3_0": spin}) for spin in (-1, 0)] == [
        "UNSTABLE",
        "STABLE",
    ]


@pytest.mark.parametrize(("more", "expected"), [
    (0, "UNSTABLE"), ((k3 - HALF) ** 4, "STABLE"), ((k3 - HALF) ** 3, "UNSTABLE"),
    *slow((-((k3 - HALF) ** 4), "UNSTABLE"), (-((k3 - HALF) ** 3), "UNSTABLE"),
          ((k3 - HALF) ** 6, "STABLE"), ((k3 - HALF) ** 5, "UNSTABLE"))])
def test_all_coefficients_vanish_at_a_tilt(more, expected):
    """U = e − (v − P z)²/(2 I1 (1 − z²)), v and P those of I = (2, 2, 3), l = 1, ω = 2, k3 = 1/2: g = 0.

    And with a bump on it.
    """
    P = 3 * 2 * HALF + 1
    v = 2 * 2 * (1 - HALF**2) + P * HALF
    scene = gs.assemble(gs.Gyrostat((2, 2, 3), (0, 0, 1)),
                        gs.axial_potential(5 - (v - P * k3) ** 2 / (4 * (1 - k3**2)) + more))
    report = gs.analyze(gs.inclined(scene))
    decision = report.verdict({"k3": HALF, "omega": 2})
    assert decision.verdict.name == expected and ("identically" in decision.reason) == (more == 0)


def test_the_ladder_of_an_unspecified_potential(e1, e2, e3):
    """The next derivative of U is named as long as all coefficients vanish, and decides when it is given."""
    for report, s in ((e1, 1), (e2, -1)):
        values = {"I1": 1, "l": 1, "pi3_0": 1, "dU": s}
        for n in range(2, 8):
            decision = report.verdict(values)
            assert decision.verdict is Verdict.UNDECIDED
            assert decision.notion == ""
            assert f"give {jet_name(n)} to decide" in decision.reason
            # 2 U^(n)/n! + s U^(n−1)/(n−1)! = 0
            u = -s * Fraction(n, 2) * Fraction(values[jet_name(n - 1)])
            # −c ∝ (−1)ⁿ U^(n) at E1
            above, below = ("STABLE", "UNSTABLE") if s == -1 or n % 2 == 0 else ("UNSTABLE", "STABLE")
            assert name(report, values | {jet_name(n): u + Fraction(1, 100)}) == above
            assert name(report, values | {jet_name(n): u - Fraction(1, 100)}) == below
            values[jet_name(n)] = u
    values = {"I1": 1, "I3": 1, "l": 0, "omega": 1, "k3": 0, "d2U": -1}
    for n, zero in ((3, 0), (4, -12), (5, 0), (6, -360)):
        decision = e3.verdict(values)
        assert decision.verdict is Verdict.UNDECIDED and f"give {jet_name(n)} to decide" in decision.reason
        beside = [name(e3, values | {jet_name(n): zero + step}) for step in (1, -1)]
        assert beside == (["STABLE", "UNSTABLE"] if n % 2 == 0 else ["UNSTABLE", "UNSTABLE"])
        values[jet_name(n)] = zero


def test_names_are_missing_in_order(e1):
    """A derivative beyond the one that is wanted does not decide."""
    values = {"I1": 1, "l": 1, "pi3_0": 1, "dU": 1}
    assert "give d2U" in e1.verdict(values | {"d3U": 5}).reason
    assert "give d3U" in e1.verdict(values | {"d2U": -1, "d4U": 5}).reason


@pytest.mark.parametrize(("potential", "s", "expected"), [
    (exp(-k3), -1, "STABLE"), (log(3 + k3), 1, "STABLE"), (sin(k3), 1, "UNSTABLE"),
    (exp(k3) - exp(1) * k3**2 / 2, 1, "UNSTABLE"),
    *slow((exp(k3), 1, "STABLE"), (-exp(-3 * k3), 1, "UNSTABLE"), (-cos(k3), 1, "STABLE"),
          (sin(k3 / 2), 1, "STABLE"), (sqrt(k3 + 2), 1, "STABLE"), (k3 * exp(k3) - exp(k3), 1, "STABLE"),
          (exp(k3**2), 1, "STABLE"))])
def test_transcendental_potentials_on_the_boundary(potential, s, expected):
    """P² = 4 s I1 U'(s), exactly; the sign of U' + s U'', or of the next one that is not 0, is proved."""
    slope = potential.diff(k3).subs(k3, s)
    curvature = potential.diff(k3, 2).subs(k3, s)
    first = (
        float(slope + s * curvature) * s
        or -float(potential.diff(k3, 3).subs(k3, s)) / 3 - s * float(curvature) / 2
    )
    assert expected == ("STABLE" if first > 0 else "UNSTABLE")
    assert name(pole(potential, s), {"I1": 3, "l": 0, "pi3_0": sqrt(12 * s * slope)}) == expected


@pytest.mark.parametrize(("n", "expected"), [
    (5, "STABLE"), (6, "UNSTABLE"), *slow((25, "UNDECIDED"))])
def test_a_flat_transcendental_potential_is_undecided(n, expected):
    """U = exp(y) − 1 − y − … − yⁿ/n!, y = k3 − 1.

    Stable for odd n, but with n = 25 not proved so by 24 coefficients.
    """
    field = exp(k3 - 1) - sum((k3 - 1) ** i / factorial(i) for i in range(n + 1))
    decision = pole(field).verdict({"I1": 1, "l": 1, "pi3_0": -1})
    assert decision.verdict.name == expected
    assert ("all coefficients of g up to x^24 vanish" in decision.reason) == (expected == "UNDECIDED")


def test_a_square_in_a_rung_may_vanish():
    """U = a² (1 − k3)² − (1 − k3)⁴: the first rung is −a², its margin 1.

    At a = 0 its sign is 0, and the next ones decide.
    """
    report = pole(gs.symbol("a") ** 2 * (1 - k3) ** 2 - (1 - k3) ** 4)
    assert report.boundary.rung(3).condition.degenerate == (gs.symbol("a"),)
    assert [name(report, {"I1": 1, "l": 1, "pi3_0": -1, "a": a}) for a in ("1/9", 0, -2)] == [
        "STABLE",
        "UNSTABLE",
        "STABLE",
    ]


def designed(moments, z, w, total, power, first, order):
    """Derivatives of U at a tilt where g = first · x^power exactly, and l.

    2 I1 (e − U)(1 − k3²) = (v − P k3)² + first · x^power.
    """
    A, C = moments
    v = A * w * (1 - z**2) + total * z
    wanted = [radsimp(expand(c)) for c in ((v - total * z) ** 2, -2 * (v - total * z) * total, total**2)] + [
        S.Zero
    ] * order
    wanted[power] += first
    sphere, series = [2 * A * (1 - z**2), -4 * A * z, -2 * A], []
    for n in range(order + 1):
        rest = wanted[n] - sum(sphere[j] * series[n - j] for j in (1, 2) if j <= n)
        series.append(radsimp(expand(rest / sphere[0])))
    jets = {jet_name(n): radsimp(expand(-factorial(n) * c)) for n, c in enumerate(series) if n}
    return jets, radsimp(expand(total - C * w * z))


@pytest.mark.parametrize(("power", "first", "expected"), [
    (2, -1, "STABLE"), (3, 1, "UNSTABLE"), (4, Rational(1, 10**30), "UNSTABLE"),
    (4, 12 * sqrt(2) - 17, "STABLE"), (6, 2, "UNSTABLE"),
    *slow((2, 1, "UNSTABLE"), (3, -1, "UNSTABLE"), (4, -1, "STABLE"), (4, 17 - 12 * sqrt(2), "UNSTABLE"),
          (5, 1, "UNSTABLE"), (6, -1, "STABLE"))])
def test_quadratic_surds_at_a_tilt(e3, power, first, expected):
    """k3 = 1/3, ω = 1 + √2, P = √2 − 3, every derivative of U in ℚ(√2), so that g begins with first ·
    x^power: by design.
    """
    z, w, total = Rational(1, 3), 1 + sqrt(2), sqrt(2) - 3
    jets, rotor = designed((S(2), S(3)), z, w, total, power, first, 6)
    assert name(e3, {"I1": 2, "I3": 3, "l": rotor, "omega": w, "k3": z} | jets) == expected
    surd = radsimp(1 / (2 + sqrt(2)))                  # and a k3 that is a surd itself, 1 − √2/2
    jets, rotor = designed((S(2), S(3)), surd, w, total, power, first, 6)
    assert name(e3, {"I1": 2, "I3": 3, "l": rotor, "omega": w, "k3": surd} | jets) == expected


@pytest.mark.parametrize(("b", "expected"), [(0, "UNSTABLE"), (3, "STABLE"), *slow((-3, "UNSTABLE"))])
def test_an_algebraic_rate_at_a_given_tilt(b, expected):
    """I = (1, 1, 3), l = 0, k3 = 1/2, nothing eliminated: ω² = U' = 2, p = 3/4 U″ + 2 = 0, g‴ = 0.

    B moves U⁗ off g⁗ = 0.
    """
    y, across = k3 - HALF, Rational(3, 4)
    u1, u2 = S(2), -2 / across
    u3 = (6 * HALF * u2 + 6 * u1) / across
    u4 = (8 * HALF * u3 + 12 * u2) / across + b
    u5 = 1 + (10 * HALF * u4 + 20 * u3) / across       # g^(5) is not 0
    field = expand(u1 * y + u2 * y**2 / 2 + u3 * y**3 / 6 + u4 * y**4 / 24 + u5 * y**5 / 120)
    report = gs.analyze(gs.inclined(gs.assemble(gs.Gyrostat((1, 1, 3), (0, 0, 0)),
                                                gs.axial_potential(field))))
    assert report.equilibrium.eliminated is None
    for w in (sqrt(2), -sqrt(2)):
        assert name(report, {"k3": HALF, "omega": w}) == expected
    with pytest.raises(ValuesError, match="not on E3"):
        report.verdict({"k3": HALF, "omega": "1.41421356237309504880"})


def at_a_root(modulus, moments, rotor, w, rungs, last):
    """A numeric polynomial U with E3 at every root of the modulus m, and g″, g‴, … 0 there, as many as rungs.

    U' = ω l − ω² k3 (I1 − I3) + m h1 + m² h2 + … + last m^(rungs + 1), each h chosen modulo m.
    """
    A, C = moments
    slope = w * rotor - w**2 * k3 * (A - C)
    for n in range(2, 2 + rungs):
        d = [None, *(slope.diff(k3, i) for i in range(n))]                # U', U″, …, without the new term
        if n == 2:
            g = -2 * (A * (1 - k3**2) * d[2] - 2 * A * k3 * d[1] + A**2 * w**2
                      + ((A - C) * w * k3 - rotor) ** 2)
        else:
            g = 2 * A * (-(1 - k3**2) * d[n] + 2 * n * k3 * d[n - 1] + n * (n - 1) * d[n - 2])
        pivot = 2 * A * (1 - k3**2) * factorial(n - 1) * modulus.diff(k3) ** (n - 1)
        inverse = invert(rem(expand(pivot), modulus, k3), modulus, k3)
        slope = expand(slope + modulus ** (n - 1) * rem(expand(g * inverse), modulus, k3))
    return integrate(expand(slope + last * modulus ** (rungs + 1)), k3)


QUARTIC, QUINTIC = 3 * k3**4 + k3**3 - 2 * k3 - 1, 5 * k3**5 - 10 * k3 + 3


@pytest.mark.parametrize(("modulus", "rungs", "last"), [
    (QUARTIC, 0, 1), (QUINTIC, 1, 0),
    *slow((QUINTIC, 0, -20), (QUARTIC, 1, 1), (QUARTIC, 2, -9), (QUARTIC, 2, 9))])
def test_tilts_that_are_roots_of_polynomials(modulus, rungs, last):
    """k3 a root of degree 4 or 5, ω and l given: off the boundary, on it, and on it with g‴ = 0 too.

    Always decided.

    Expected is the first coefficient of g at the root that is not 0, g written with the numbers of 120
    digits.
    """
    assert Poly(modulus, k3).is_irreducible
    (A, C), rotor, w = (Rational(3, 2), S(2)), Rational(1, 3), S(2)
    root = next(r for r in Poly(modulus, k3).real_roots() if abs(r.evalf(20)) < 1)
    field = at_a_root(modulus, (A, C), rotor, w, rungs, last)
    report = gs.analyze(gs.inclined(gs.assemble(gs.Gyrostat((A, A, C), (0, 0, rotor)),
                                                gs.axial_potential(field))))
    assert report.equilibrium.eliminated is None and isinstance(root, CRootOf)
    z = root.evalf(120)
    P = C * w * z + rotor
    v, e = A * w * (1 - z**2) + P * z, A * w**2 * (1 - z**2) / 2 + field.subs(k3, z)
    g = Poly(expand(2 * A * (e - field) * (1 - k3**2) - (v - P * k3) ** 2), k3)
    taylor = oracle.taylor(g.all_coeffs()[::-1], z)
    n = next(n for n, c in enumerate(taylor) if abs(c) > Rational(1, 10**60))
    assert n == 2 + rungs
    expected = "STABLE" if n % 2 == 0 and taylor[n] < 0 else "UNSTABLE"
    decision = report.verdict({"omega": w, "k3": root})
    assert decision.verdict.name == expected and ("on the boundary" in decision.reason) == (rungs > 0)


def test_a_body_at_rest_on_its_boundary(at_rest):
    """I1 = 2, l = 1, k3 = 0, U″ = −l²/I1: g‴ ∝ −U‴, g⁗ ∝ −U⁗ − 6."""
    values = {"I1": 2, "I3": 1, "l": 1, "k3": 0, "d2U": "-1/2"}
    assert "give d3U" in at_rest.verdict(values).reason
    assert [name(at_rest, values | {"d3U": u}) for u in (1, -1)] == ["UNSTABLE", "UNSTABLE"]
    assert [name(at_rest, values | {"d3U": 0, "d4U": u}) for u in (-5, -6, -7)] == [
        "STABLE",
        "UNDECIDED",
        "UNSTABLE",
    ]
    scene = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 1)), gs.axial_potential(-(k3**2) / 4 - k3**4 / 5))
    report = gs.analyze(gs.static_tilt(scene))
    assert name(report, {"k3": 0}) == "STABLE"         # U⁗ = −24/5 > −6


UP, DOWN, RATIONAL, SURD = (0, 0, 1), (0, 0, -1), ("-2/7", "3/7", "6/7"), (0, sqrt(3) / 2, "-1/2")


@pytest.mark.parametrize(("k", "power", "first"), [
    (UP, 3, 1), (DOWN, 3, -1), (RATIONAL, 4, -1), (SURD, 4, 1),
    *slow(*((k, 3, first) for k in (RATIONAL, SURD) for first in (1, -1)),
          *((k, 4, first) for k in (UP, DOWN) for first in (1, -1)),
          (UP, 3, -1), (DOWN, 3, 1), (RATIONAL, 4, 1), (SURD, 4, -1))])
def test_claimed_points_have_a_boundary(k, power, first):
    """A point given by numbers, π = I ω k, P = 2, with g = ±x³ or ±x⁴ by design.

    The ladder of its tilt decides.
    """
    k = [S(c) for c in k]
    z, w, (A, C), P = k[2], S(2), (S(2), S(3)), S(2)
    v = A * w * (1 - z**2) + P * z
    y = 1 - z * k3 if z**2 == 1 else k3 - z
    field = cancel(-((v - P * k3) ** 2 + first * y**power) / (2 * A * (1 - k3**2)))
    scene = gs.assemble(gs.Gyrostat((A, A, C), (0, 0, P - C * w * z)), gs.axial_potential(field))
    report = gs.analyze(gs.equilibrium(scene, [A * w * k[0], A * w * k[1], C * w * k[2], *k]))
    stable = first < 0 and (z**2 == 1 or power == 4)
    assert report.boundary.pole == (z**2 == 1)
    assert name(report, {}) == ("STABLE" if stable else "UNSTABLE")


def test_the_ladder_ends_where_nothing_new_comes():
    """A rational U has finitely many rungs, an unspecified one any number, a transcendental one a fixed
    number.
    """
    assert pole(k3**6).boundary.last == 8
    assert pole(1 / (k3 + 3)).boundary.last == 3
    assert pole(S.Zero).boundary.last == 2
    assert pole(exp(k3)).boundary.last is pole(None).boundary.last is None
    assert [rung.power for rung in pole(k3**3).boundary.rungs()] == [3, 4, 5]


def test_three_moments_have_no_boundary(asymmetric):
    """Three moments, a1 = (I3 − I1)(ω² − m1) + l ω − m0 = 0, a2 = −3, p > 0, q = 0.

    No minimum, and nothing decides.
    """
    report = gs.analyze(gs.upright(asymmetric, spin="omega3_0"))
    assert report.boundary is None
    decision = report.verdict(values := {"I1": 1, "I2": 2, "I3": 3, "l": 3, "omega3_0": 2, "m1": 1, "m0": 12})
    assert decision.verdict is Verdict.UNDECIDED and "gyroscopic" in decision.reason and decision.notion == ""
    assert report.itself(values) == decision


def test_a_tilt_of_a_symbol_has_no_boundary():
    """k = (√(1 − b²), 0, b) with abs(b) < 1 not said: a pole or not, so no ladder; with the domain, one."""
    b = gs.symbol("b")
    scene = gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, 0)), gs.axial_potential((k3 - b) ** 3))
    point = (0, 0, 0, sqrt(1 - b**2), 0, b)
    assert gs.analyze(gs.equilibrium(scene, point)).boundary is None
    inside = gs.analyze(gs.equilibrium(scene, point, domain=(1 - b**2,)))
    assert inside.boundary is not None
    assert not inside.boundary.pole
    assert name(inside, {"b": "1/2"}) == "UNSTABLE"


@pytest.mark.parametrize(("beside", "expected"), [(0, "UNSTABLE"), *slow((1, "STABLE"), (-1, "UNSTABLE"))])
def test_a_claimed_point_at_the_root_of_a_polynomial(beside, expected):
    """k3 = CRootOf in the point itself, exactly on p = 0 and beside it: never undecided."""
    k3, root = gs.symbol("k3"), CRootOf(9 * Symbol("x") ** 3 - 4 * Symbol("x") + 1, 0)
    I1, I3, l = 2, 1, 1
    slope = l - root * (I1 - I3)                           # ω = 1
    flat = -((I3 * root + l - 2 * I1 * root) ** 2) / (I1 * (1 - root**2)) - I1
    scene = gs.assemble(gs.Gyrostat((I1, I1, I3), (0, 0, l)),
                        gs.axial_potential(slope * k3 + (flat + beside) / 2 * (k3 - root) ** 2))
    point = (I1 * sqrt(1 - root**2), 0, I3 * root, sqrt(1 - root**2), 0, root)
    assert name(gs.analyze(gs.equilibrium(scene, point)), {}) == expected
