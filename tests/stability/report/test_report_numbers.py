"""Verdicts at numbers that are hard: large, nearly equal, algebraic, transcendental, not real."""
from fractions import Fraction

import numpy as np
import oracle
import pytest
from stability.reported import SIGNS
from sympy import CRootOf, Rational, asin, exp, expand, log, sqrt

import gyrostat as gs
from gyrostat.errors import EquilibriumError, ValuesError
from gyrostat.stability.decision import Verdict

k3 = gs.symbol("k3")


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
    with pytest.raises(EquilibriumError, match="not known to be smooth"):
        gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential((k3 - 1) ** Rational(5, 2))))
    report = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(),
                                               gs.axial_potential((k3 + gs.symbol("a")) ** Rational(5, 2)))))
    assert report.verdict({"I1": 1, "l": 0, "pi3_0": 9, "a": 0}).verdict is Verdict.STABLE
    with pytest.raises(ValuesError, match="exists only where a . 1 > 0"):
        report.verdict({"I1": 1, "l": 0, "pi3_0": 9, "a": -1})


@pytest.mark.few(1)
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


def test_huge_numbers_are_decided_and_shown(e1):
    """10⁵⁰⁰⁰ is a number like any other; messages round it."""
    huge = e1.verdict({"I1": 1, "l": 0, "pi3_0": 10**5000, "dU": 10**9999})
    assert huge.verdict is Verdict.STABLE and "6·10⁹⁹⁹⁹" in str(huge)
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
