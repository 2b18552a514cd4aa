"""Boundary points in fields made for them: no slope, no coefficient at all, transcendental ones."""
from math import factorial

import pytest
from slow import slow
from stability.boundary_ladder import HALF, k3, l, name, pole
from sympy import Rational, S, cos, exp, log, sin, sqrt

import gyrostat as gs
from gyrostat.stability.decision import Verdict


@pytest.mark.few(2)
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


@pytest.mark.slow
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


@pytest.mark.slow
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
