"""Verdicts on boxes: every claim agrees with the exact verdict at points of the box, its edges and corners
included.
"""
import math
import random
from fractions import Fraction

import pytest
from charts.claimed_boxes import NAMES, assert_claims
from draw import numbers
from hypothesis import example, given
from hypothesis import strategies as st
from sympy import Rational, sqrt

import gyrostat as gs
from gyrostat.charts.boxes.certified_boxes import certified_chart, certify_box
from gyrostat.errors import ValuesError
from gyrostat.stability.decision import Verdict

k3, m0, a = gs.symbol("k3"), gs.symbol("m0"), gs.symbol("a")
STABLE, UNSTABLE, UNDECIDED = Verdict.STABLE, Verdict.UNSTABLE, Verdict.UNDECIDED


@pytest.mark.few(1)
@pytest.mark.parametrize("name",
                         [pytest.param(name, marks=[pytest.mark.slow]
                                       * (name in ("logarithm", "exponential"))) for name in NAMES])
def test_claims_agree_with_the_exact_verdict(regions, name):
    """Stable, unstable and absent boxes of charts, for U unspecified, polynomial, with a pole,
    transcendental, and for no U.
    """
    report, region = regions[name]
    assert name in NAMES and set(NAMES) == set(regions)
    chart = certified_chart(report, region, resolution="1/32", limit=30_000)
    assert_claims(report, chart, random.Random(name))
    assert chart.measure["undecided"] < Fraction(1, 2)


@pytest.mark.slow
@given(l=st.tuples(numbers, numbers), spin=st.tuples(numbers, numbers), u=st.tuples(numbers, numbers),
       I1=st.tuples(numbers, numbers),
       depth=st.integers(min_value=0, max_value=6), seed=st.integers())
@example(l=(0, 1), spin=(1, 3), u=(1, 1), I1=(1, 1), depth=6, seed=0)
def test_boxes_of_the_vertical_agree_with_the_exact_verdict(e1, e2, l, spin, u, I1, depth, seed):
    """Boxes with ends of small denominators, whose corners and edges are often on the boundary, shrunk to
    points too.
    """
    box = {"l": sorted(l), "pi3_0": sorted(spin), "dU": sorted(u), "I1": sorted(I1)}
    for report in (e1, e2):
        if box["I1"][1] <= 0 or box["I1"][0] <= 0 and box["I1"][0] == box["I1"][1]:
            with pytest.raises(ValuesError):
                certify_box(report, box, depth=depth)
            continue
        decision = certify_box(report, box, depth=depth)
        assert_claims(report, decision.chart, random.Random(seed), 10)
        kinds = {kind for kind, share in decision.measure.items() if share}
        if decision.verdict is not UNDECIDED:
            assert kinds - {"no equilibrium"} == {decision.verdict.name.lower()}


@pytest.mark.slow
def test_a_box_that_touches_the_boundary_is_not_claimed(e1, heavy):
    """A box is closed: where only a corner or an edge is on (π3 + l)² = 4 I1 U', no claim is made of the
    parts that have it.
    """
    subcritical = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(),
                                                    gs.axial_potential(3 * k3 - k3**2))))
    # U' = 1: on the boundary, next to stable points
    assert subcritical.verdict({"I1": 1, "l": 1, "pi3_0": 1}).verdict is UNSTABLE
    for report, more in ((subcritical, {}), (e1, {"dU": 1}), (heavy, {"m0": 1})):
        for box in ({"l": (1, 2), "pi3_0": (1, 2)}, {"l": (0, 1), "pi3_0": (0, 1)},
                    {"l": (2, 3), "pi3_0": 0}, {"l": (1, 2), "pi3_0": 0}):
            decision = certify_box(report, {"I1": 1, **more, **box}, depth=12)
            touching = next(iter(n for n, (low,
                                           high) in enumerate(zip(decision.chart.low, decision.chart.high))
                                 if 2 in (low.sum(), high.sum())))
            assert decision.verdict is UNDECIDED and decision.chart.code[touching] == 0
            assert 1 - 2 * decision.measure["undecided"] > 0


@pytest.mark.parametrize("name, box, there, beside", [
    ("a margin that is a square", {"I1": 1, "dU": 0, "l": (1, 2), "pi3_0": (-1, 0)}, UNDECIDED, STABLE),
    ("minus a square", {"I1": 1, "l": 0, "pi3_0": 0, "a": (0, 1)}, STABLE, UNSTABLE)])
def test_a_box_that_touches_a_square_factor_is_not_claimed(regions, name, box, there, beside):
    """Where the number that is squared is 0, the verdict is another one.

    (π3 + l)² > 0 and -a² < 0 decide elsewhere only.
    """
    report = regions[name][0]
    low, high = ({n: v[side] if isinstance(v, tuple) else v for n, v in box.items()} for side in (0, 1))
    assert (report.verdict(low).verdict, report.verdict(high).verdict) == (there, beside)
    decision = certify_box(report, box, depth=6)
    assert decision.verdict is UNDECIDED and 0 < decision.measure["undecided"] < Fraction(1, 16)
    assert decision.chart.code[(decision.chart.low == decision.chart.low.min(axis=0)).all(axis=1)] == [0]


@pytest.mark.slow
@pytest.mark.parametrize("scale", [2.0**-500, 1e-150, 1.0, 1e150, 2.0**500])
@pytest.mark.parametrize("side", [-1, 1])
def test_one_float_beside_the_boundary_is_decided(e1, side, scale):
    """A box of width one float, the boundary one float away; at scales where products are tiny or huge."""
    end = math.nextafter(2 * scale, side * math.inf)
    pair = sorted((end, math.nextafter(end, side * math.inf)))
    box = {"I1": 1, "l": 0, "pi3_0": pair, "dU": Fraction(scale) ** 2}
    decision = certify_box(e1, box)
    expected = {e1.verdict({**box, "pi3_0": p}).verdict for p in pair}
    assert len(expected) == 1 and decision.verdict in {UNDECIDED} | expected
    far = certify_box(e1, {**box, "pi3_0": sorted((end * (1 + side / 1e6), end * (1 + side / 1e5)))})
    assert far.verdict in expected or scale != 1.0 and far.verdict is UNDECIDED
    assert far.verdict in expected or scale < 1e-140 or scale > 1e140


@pytest.mark.few(3)
@pytest.mark.parametrize("low, high", [
    (0, 5e-324), (5e-324, 1e-323), (-5e-324, 5e-324), (0, 2.2e-308), (1e-200, 1e-199), (1e150, 1e200),
    (-1.7e308, 1.7e308),
    (1e308, 1.7e308)])
def test_extreme_scales_give_no_wrong_claim(e1, e3, low, high):
    """Subnormal numbers, underflow and overflow.

    Claims agree with the exact verdict, and no part has the width 0.
    """
    draw = random.Random(0)
    for report, box in ((e1, {"I1": (abs(low), high), "l": (low, high), "pi3_0": 0, "dU": (low, high)}),
                        (e1, {"I1": 1, "l": (low, high), "pi3_0": (-high, -low), "dU": (low, high)}),
                        (e3, {"I1": 1, "I3": 2, "l": (low, high), "omega": (low, high), "k3": (0, 1),
                              "d2U": 0})):
        chart = certify_box(report, box, depth=9).chart
        assert (chart.low < chart.high).all() and sum(chart.measure.values()) == 1
        assert_claims(report, chart, draw, 30)


def test_the_middle_of_large_numbers(e1):
    """Ends whose sum overflows have a middle."""
    spin = Fraction(114, 100) * 10**154                                     # π3² is about 1.3·10³⁰⁸
    decision = certify_box(e1, {"I1": "1/4", "l": 0, "pi3_0": spin, "dU": (1e308, 1.7e308)})
    assert decision.measure["undecided"] < Fraction(1, 10**6)
    assert decision.stable_parts.size
    assert decision.unstable_parts.size


def test_cancelling_momenta_and_vanishing_tilt(e1, e3):
    """π3 ≈ -l to 10⁻¹⁵, abs(k3) → 1 and I1 → I3: claims hold, most of the region is decided."""
    nearly = 10**6 + Fraction(1, 10**9)
    draw = random.Random(1)
    charts = [(e1, {"I1": 1, "dU": Fraction(1, 10**18), "l": (10**6, nearly), "pi3_0": (-nearly, -10**6)}),
              (e3, {"I1": 1, "I3": 1 + Fraction(1, 10**15), "l": 1, "d2U": (-3, 3), "omega": 1,
                    "k3": (1 - Fraction(1, 2**40), 1)}),
              (e3, {"I1": 1, "I3": (1 - Fraction(1, 2**50), 1 + Fraction(1, 2**50)), "l": 1, "d2U": (-3, 3),
                    "omega": 1, "k3": 0})]
    for report, region in charts:
        chart = certified_chart(report, region, resolution="1/64")
        assert_claims(report, chart, draw, 60)
        assert chart.measure["undecided"] < Fraction(1, 4)


def test_a_box_that_exists_in_part_is_not_split_once_it_is_decided(e3):
    """Beyond k3 = 1 there is no equilibrium.

    The verdict on the rest of the box needs the mean value form, and no bisection.
    """
    decision = certify_box(e3, {"I1": 1, "I3": 2, "l": 2, "omega": ("7/4", "9/4"), "k3": ("11/16", "21/16"),
                                "d2U": -4})
    assert decision.verdict is STABLE and len(decision.chart.code) == 1


def test_a_criterion_that_never_holds():
    """At rest on top of U = -k3², without a rotor, the margin is -2 I1: unstable whatever the moments."""
    I1, I3 = gs.symbol("I1"), gs.symbol("I3")
    body = gs.Gyrostat(inertia=(I1, I1, I3), gyrostatic_momentum=(0, 0, 0))
    report = gs.analyze(gs.equilibrium(gs.assemble(body, gs.axial_potential(-k3**2)), (0, 0, 0, 1, 0, 0)))
    assert report.necessary.alternatives == ()
    assert certify_box(report, {"I1": (1, 2)}).verdict is UNSTABLE


def test_a_region_between_the_criteria_is_left_as_it_is(asymmetric):
    """Stabilised by its rotor, nearly of revolution: spectrally stable, not formally.

    A normal form decides points of it; nothing to bisect for.
    """
    report = gs.analyze(gs.upright(asymmetric))
    box = {"I1": 1, "I2": "11/10", "I3": 1, "m0": 1, "m1": 0, "l": (3, "31/10"), "pi3_0": ("1/10", "1/5")}
    assert report.verdict({**box, "l": 3, "pi3_0": "1/10"}).pointwise
    decision = certify_box(report, box)
    assert decision.verdict is UNDECIDED and len(decision.chart.code) == 1


def test_a_point_is_decided_exactly(heavy, e1):
    """Single numbers: the verdict of the report, on the boundary too, at rational, irrational and enclosing
    numbers.
    """
    on = {"I1": 2, "m0": 1, "l": 0, "pi3_0": 2 * sqrt(2)}
    decision = certify_box(heavy, on)
    assert (decision.verdict, decision.reason) == (STABLE, heavy.verdict(on).reason)
    assert decision.measure["stable"] == 1
    assert decision.stable_parts.shape == (1, 0, 2)
    assert decision.chart.axes == ()
    assert dict(decision.chart.fixed)[str(gs.symbol("pi3_0"))] == 2 * sqrt(2)
    assert certify_box(e1, {"I1": 1, "l": (1, "1"), "pi3_0": 1, "dU": 1}).verdict is UNDECIDED
    # one number in two forms
    same = certify_box(heavy, {**on, "l": (sqrt(2) + sqrt(3), sqrt(5 + 2 * sqrt(6)))})
    assert same.chart.axes == () and same.verdict is STABLE
    assert certify_box(e1, {"I1": 1, "l": 1, "pi3_0": 1, "dU": 2}).verdict is UNSTABLE


def test_ends_are_rounded_outward(heavy):
    """A box with ends that are no floats is contained in the boxes of its chart."""
    chart = certify_box(heavy, {"I1": 1, "m0": 1, "l": ("1/3", sqrt(2)), "pi3_0": 3}).chart
    assert Fraction(chart.low.min()) < Fraction(1, 3) < Fraction(math.nextafter(chart.low.min(), 1))
    assert Rational(chart.high.max()) > sqrt(2) > Rational(math.nextafter(chart.high.max(), 0))
