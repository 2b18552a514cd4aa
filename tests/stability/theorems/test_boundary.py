"""The boundary: rungs against the formulas of the theory, the ladder, published cases."""
from fractions import Fraction
from itertools import islice
from math import factorial

import pytest
from stability.boundary_ladder import I1, k3, name, pole
from sympy import S, cancel, exp, sqrt

import gyrostat as gs
from gyrostat.mechanics.equilibrium.reduced_series import expansion
from gyrostat.notation import jet_name
from gyrostat.stability.decision import Verdict


def U(n):
    """U^(n) at the equilibrium."""
    return gs.symbol(jet_name(n))


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

    The amended potential falls along one direction to second order, rises along the other to fourth: a motion
    leaves (integrated: a tilt of 0.01 grows to 0.79).
    """
    report = gs.analyze(gs.upright(asymmetric, spin="omega3_0"))
    assert report.boundary is None
    decision = report.verdict(values := {"I1": 1, "I2": 2, "I3": 3, "l": 3, "omega3_0": 2, "m1": 1, "m0": 12})
    assert decision.verdict is Verdict.UNSTABLE and "degree 4" in decision.reason
    assert decision.notion == "Lyapunov"
    assert report.itself(values) == decision
