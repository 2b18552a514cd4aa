"""Verdicts on boxes: every claim agrees with the exact verdict at points of the box, its edges and corners
included.
"""
import math
import random
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from draw import numbers
from hypothesis import example, given
from hypothesis import strategies as st
from sympy import Rational, cos, exp, log, pi, sqrt

import gyrostat as gs
from gyrostat.charts.boxes import certified_chart, certify_box
from gyrostat.charts.codes import BOX_KINDS
from gyrostat.errors import ArgumentError, ScopeError, ValuesError
from gyrostat.stability.report import Verdict

k3, m0, a = gs.symbol("k3"), gs.symbol("m0"), gs.symbol("a")
STABLE, UNSTABLE, UNDECIDED = Verdict.STABLE, Verdict.UNSTABLE, Verdict.UNDECIDED
CODES = {1: STABLE, -1: UNSTABLE}
shares = st.fractions(min_value=0, max_value=1, max_denominator=8)
HEAVY = {"I1": 1, "m0": 1, "l": (-4, 4), "pi3_0": (-4, 4)}


@pytest.fixture(scope="session")
def heavy():
    """E1 of the heavy gyrostat: stable for (π3 + l)² > 4 I1 m0, its boundary too."""
    return gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())))


@pytest.fixture(scope="session")
def reports(e1, e2, e3, at_rest, asymmetric, free):
    """Reports, and for each a region with several kinds of verdict."""
    def of(family, potential):
        return gs.analyze(family(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(potential))))

    third = Fraction(1, 3)
    tilted = {"I1": 1, "I3": "1/2", "omega": (-2, 2), "k3": (-1, 1)}
    return {
        "E1": (e1, {"I1": (-third, 1), "l": (-2, 2), "pi3_0": 1, "dU": (-1, 1)}),
        "E2": (e2, {"I1": 1, "l": (-2, 2), "pi3_0": (-2, 2), "dU": (-1, 1)}),
        "E3": (e3, {"I1": 1, "I3": (third, 2), "l": 1, "omega": (-2, 2), "k3": (-1.25, 1.25), "d2U": -2}),
        "E3 at rest": (at_rest, {"I1": 1, "l": (-2, 2), "k3": (-1, 1), "d2U": (-2, 2)}),
        "uniform field": (of(gs.inclined, m0 * k3), {**tilted, "m0": (-1, 1)}),
        "tilt eliminated": (gs.analyze(gs.inclined(gs.assemble(gs.symmetric_gyrostat(),
                                                               gs.axial_potential(m0 * k3 + a * k3**2)),
                                                   "k3")),
                            {"I1": 1, "I3": (0, 2), "l": 1, "omega": (-2, 2), "m0": 1, "a": 1}),
        "quartic": (of(gs.inclined, k3**4 - k3**2 + k3 / 3), tilted),
        "pole": (of(gs.inclined, 1 / (k3 - third)), tilted),
        "steep exponential": (of(gs.inclined, exp(50 * k3)), tilted),
        "exponential": (of(gs.inclined, -exp(a * k3)), {**tilted, "a": (-5, 1)}),
        "logarithm": (of(gs.inclined, log(k3 + third) + cos(3 * k3)), tilted),
        "logarithm at E1": (of(gs.upright, log(a + k3 - 2)),
                            {"I1": 1, "l": 1, "pi3_0": (-2, 2), "a": (0, 3)}),
        "irrational numbers": (of(gs.inclined, a * k3**2),
                               {"I1": sqrt(2), "I3": pi, "omega": (-2, 2), "k3": (-1, sqrt(3) / 2),
                                "a": (-2, 2)}),
        "general body": (gs.analyze(gs.upright(asymmetric)),
                         {"I1": 1, "I2": 2, "I3": "5/2", "m0": 1, "m1": (-1, 1), "l": (-4, 4),
                          "pi3_0": (-4, 4)}),
        "free body": (gs.analyze(gs.principal_rotation(free, 3)),
                      {"I1": 1, "I2": 2, "I3": (1, 3), "l": 1, "omega3_0": (-2, 2)}),
        "a margin that is a square": (e1, {"I1": 1, "dU": 0, "l": (-2, 2), "pi3_0": (-1, 1)}),
        "minus a square": (of(gs.upright, a**2 * k3 + (k3 - 1) ** 2),
                           {"I1": (1, 2), "l": 0, "pi3_0": 0, "a": (-1, 1)}),
        "nothing but a spin": (of(gs.upright, k3), {"I1": 1, "l": 1, "pi3_0": (-4, 4)}),
    }


NAMES = ("E1", "E2", "E3", "E3 at rest", "uniform field", "tilt eliminated", "quartic", "pole",
         "steep exponential", "exponential",
         "logarithm", "logarithm at E1", "irrational numbers", "general body", "free body",
         "a margin that is a square", "minus a square",
         "nothing but a spin")


def points(draw, low, high, number=2):
    """Corners, points of edges and of the inside of a box, exact."""
    ends = [(Fraction(x), Fraction(y)) for x, y in zip(low.tolist(), high.tolist())]
    yield from product(*ends) if len(ends) < 3 else [tuple(draw.choice(pair) for pair in ends)]
    for _ in range(number):
        yield tuple(x + (y - x) * Fraction(draw.choice([0, 1, draw.randint(1, 99) / 100])) for x, y in ends)


def verdict_at(report, numbers):
    """The exact verdict, None where there is no equilibrium."""
    try:
        return report.verdict(numbers).verdict
    except ValuesError:
        return None


def assert_claims(report, chart, draw, sample=50):
    """The exact verdict is the one claimed, at points of some boxes; at() says the same."""
    proved = np.flatnonzero(chart.code)
    for n in draw.sample(proved.tolist(), min(sample, len(proved))):
        claim = CODES.get(int(chart.code[n]))
        for point in points(draw, chart.low[n], chart.high[n]):
            named = dict(zip(chart.axes, point))
            found = verdict_at(report, dict(chart.fixed) | named)
            assert found in (claim, None), (named, claim)
            if claim:
                assert found is None or chart.at(**named) is claim
            else:
                with pytest.raises(ValuesError, match="no equilibrium"):
                    chart.at(**named)


@pytest.mark.parametrize("name",
                         [pytest.param(name, marks=[pytest.mark.slow]
                                       * (name in ("logarithm", "exponential"))) for name in NAMES])
def test_claims_agree_with_the_exact_verdict(reports, name):
    """Stable, unstable and absent boxes of charts, for U unspecified, polynomial, with a pole,
    transcendental, and for no U.
    """
    report, region = reports[name]
    assert name in NAMES and set(NAMES) == set(reports)
    chart = certified_chart(report, region, resolution="1/16", limit=30_000)
    assert_claims(report, chart, random.Random(name))
    assert chart.measure["undecided"] < Fraction(1, 2)


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
def test_a_box_that_touches_a_square_factor_is_not_claimed(reports, name, box, there, beside):
    """Where the number that is squared is 0, the verdict is another one.

    (π3 + l)² > 0 and -a² < 0 decide elsewhere only.
    """
    report = reports[name][0]
    low, high = ({n: v[side] if isinstance(v, tuple) else v for n, v in box.items()} for side in (0, 1))
    assert (report.verdict(low).verdict, report.verdict(high).verdict) == (there, beside)
    decision = certify_box(report, box, depth=6)
    assert decision.verdict is UNDECIDED and 0 < decision.measure["undecided"] < Fraction(1, 16)
    assert decision.chart.code[(decision.chart.low == decision.chart.low.min(axis=0)).all(axis=1)] == [0]


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
    assert decision.stable.size
    assert decision.unstable.size


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


def test_the_heavy_gyrostat_is_charted(heavy):
    """Undecided on less than 10⁻³ of the square abs(l), abs(π3) ≤ 4.

    Unstable on 7/16 of it, between the lines l + π3 = ±2.
    """
    chart = certified_chart(heavy, HEAVY)
    assert chart.complete and chart.measure["undecided"] < Fraction(1, 1000)
    assert (
        chart.measure["unstable"] <= Fraction(7, 16) <= chart.measure["unstable"] + chart.measure["undecided"]
    )
    assert chart.measure["no equilibrium"] == 0
    assert_claims(heavy, chart, random.Random(2))


@pytest.mark.parametrize("name", NAMES)
def test_boxes_tile_the_region(reports, name):
    """Shares sum to 1, every point lies in a box, and a point that is on no edge lies in one only."""
    report, region = reports[name]
    chart = certified_chart(report, region, resolution="1/8")
    assert sum(chart.measure.values()) == 1 and set(chart.measure) == set(BOX_KINDS)
    draw = random.Random(name)
    low, high = chart.low.min(axis=0), chart.high.max(axis=0)
    for axis, ends in enumerate(region[n] for n in chart.axes):
        for end, exact in zip((low, high), ends):
            # rounded outward, by one float
            assert math.isclose(end[axis], float(exact), rel_tol=1e-15)
    volume = sum(math.prod(Fraction(y) - Fraction(x) for x, y in zip(a, b))
                 for a, b in zip(chart.low.tolist(), chart.high.tolist()))
    assert volume == math.prod(Fraction(y) - Fraction(x) for x, y in zip(low.tolist(), high.tolist()))
    for _ in range(100):
        point = [draw.uniform(x, y) for x, y in zip(low, high)]
        assert ((chart.low <= point) & (point <= chart.high)).all(axis=1).any()
        assert ((chart.low < point) & (point < chart.high)).all(axis=1).sum() <= 1


@pytest.mark.parametrize("name", ["E1", "quartic", "exponential", "free body"])
def test_half_the_resolution_is_half_the_undecided_share(reports, name):
    """The undecided boxes lie along the boundary, of dimension one less."""
    report, region = reports[name]
    region = {n: (v if n in list(region)[-2:] or not isinstance(v, tuple) else sum(map(Fraction, v)) / 2 + 1)
              for n, v in region.items()}
    shares = [certified_chart(report, region, resolution=Fraction(1, n)).measure["undecided"]
              for n in (128, 256, 512)]
    # the limit is 1/2
    assert all(0.35 < later / earlier < 0.65 for earlier, later in zip(shares, shares[1:]))


def test_no_side_is_finer_than_the_resolution(heavy):
    """Sides are at least the share asked for of the region's, and that of undecided boxes is reached."""
    # 1/128 is the dyadic share below it
    chart = certified_chart(heavy, HEAVY, resolution="1/100")
    widths = (chart.high - chart.low) / 8
    assert widths.min() == 2.0**-7 and (widths[chart.code == 0] == 2.0**-7).all()
    assert len(certified_chart(heavy, HEAVY, resolution=1).code) == 1
    flat = certified_chart(heavy, {**HEAVY, "pi3_0": (0, Fraction(1, 64))}, resolution="1/100")
    assert (flat.high - flat.low)[:, 0].min() == 8 / 128                    # though l matters more throughout


def test_the_limit_on_boxes_holds(heavy):
    """Refinement stops before there are too many boxes, and the chart says so."""
    for limit in (1, 10, 1000):
        chart = certified_chart(heavy, HEAVY, limit=limit)
        assert len(chart.code) <= limit and not chart.complete and sum(chart.measure.values()) == 1
        decision = certify_box(heavy, HEAVY, limit=limit)
        assert len(decision.chart.code) <= limit and decision.verdict is UNDECIDED
    assert certified_chart(heavy, HEAVY, resolution="1/16").complete


def test_what_does_not_matter_is_not_split(e1):
    """I3 does not enter the verdict at E1, so no box is halved along it.

    Nor a box on which the margin is 0 throughout.
    """
    chart = certified_chart(e1, {"I1": 1, "I3": (1, 2), "l": 0, "dU": 1, "pi3_0": (0, 4)}, resolution="1/64")
    assert chart.axes == ("I3", "pi3_0") and (chart.low[:, 0] == 1).all() and (chart.high[:, 0] == 2).all()
    assert len(certify_box(e1, {"I1": (1, 2), "l": 1, "pi3_0": -1, "dU": 0}).chart.code) == 1


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

    Nothing to bisect for.
    """
    report = gs.analyze(gs.upright(asymmetric))
    box = {"I1": 1, "I2": "11/10", "I3": 1, "m0": 1, "m1": 0, "l": (3, "31/10"), "pi3_0": ("1/10", "1/5")}
    assert report.verdict({**box, "l": 3, "pi3_0": "1/10"}).verdict is UNDECIDED
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
    assert decision.stable.shape == (1, 0, 2)
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


def test_decisions_say_what_is_proved(heavy):
    """Verdict, reason and parts of a box that is stable, unstable, both, or in part undecided."""
    box = {"I1": 1, "m0": 1, "l": 0}
    stable, unstable = (
        certify_box(heavy, {**box, "pi3_0": (3, 4)}),
        certify_box(heavy, {**box, "pi3_0": ("-1/2", 1)}),
    )
    both, part = certify_box(heavy,
                             {**box, "pi3_0": (1, 4)}), certify_box(heavy, {**box, "pi3_0": (2, 3)}, depth=5)
    assert [d.verdict for d in (stable, unstable, both, part)] == [STABLE, UNSTABLE, UNDECIDED, UNDECIDED]
    assert stable.stable.tolist() == [[[3, 4]]]
    assert unstable.unstable.tolist() == [[[-0.5, 1]]]
    assert not stable.undecided.size
    assert "sufficient condition" in stable.reason
    assert "fail" in unstable.reason
    assert "another part unstable" in both.reason
    assert part.undecided.tolist() == [[[2, 2 + 2**-5]]] and "1 of 6 parts" in part.reason
    assert repr(part.chart) == "CertifiedChart(pi3_0: 6 boxes; stable 0.96875, undecided 0.03125)"


def test_where_there_is_no_equilibrium(e1, e3, reports):
    """Boxes with abs(k3) ≥ 1, I1 ≤ 0 or the argument of a logarithm negative are of a kind of their own.

    A whole box of them is an error.
    """
    chart = certified_chart(e3, {"I1": 1, "I3": 1, "l": 2, "omega": 1, "d2U": 1, "k3": (-4, 4)},
                            resolution="1/8")
    assert chart.measure["no equilibrium"] == Fraction(3, 4) and chart.at(k3="1/2") is STABLE
    with pytest.raises(ValuesError, match="there is no equilibrium at k3 = 2"):
        chart.at(k3=2)
    nowhere = certified_chart(e3, {"I1": (-1, 1), "I3": 1, "l": 2, "omega": 1, "d2U": 1, "k3": (2, 4)})
    # nothing to bisect for
    assert nowhere.measure["no equilibrium"] == 1 and len(nowhere.code) == 1
    decision = certify_box(e3, {"I1": 1, "I3": 1, "l": 2, "omega": 1, "d2U": 1, "k3": (0, 2)})
    assert decision.verdict is STABLE and decision.measure["no equilibrium"] == Fraction(1, 2)
    report, region = reports["logarithm at E1"]
    assert certified_chart(report, {**region, "a": (0, 4)}, resolution="1/4").measure[
        "no equilibrium"
    ] == Fraction(1, 4)
    for box in ({"k3": (1, 2)}, {"k3": (1.5, 2), "I3": (1, 2)}, {"k3": (0, 2), "I1": (-2, 0)},
                {"k3": 2, "l": (1, 2)},
                {"k3": 0, "l": (0, 1), "I1": -1}):
        with pytest.raises(ValuesError, match="choose"):
            certify_box(e3, {"I1": 1, "I3": 1, "l": 1, "omega": 1, "d2U": 1, **box})
    assert certified_chart(e1, {"I1": (-1, 1), "l": 0, "pi3_0": 3, "dU": 0}, resolution="1/2").measure[
        "no equilibrium"
    ] == Fraction(1, 2)


@pytest.mark.parametrize("box, message", [
    ({"I1": 1, "m0": 1, "l": 0}, "E1 needs pi3_0: give a number or a pair"),
    ({**HEAVY, "omega": 1}, "E1 has no parameter omega"),
    ({**HEAVY, "l": (2, 1)}, r"l = \(2, 1\) is empty"),
    ({**HEAVY, "l": (1, 2, 3)}, "has 3 entries"),
    ({**HEAVY, "l": (0, math.inf)}, "l = inf is not finite"),
    ({**HEAVY, "l": (math.nan, 1)}, "l = nan is not finite"),
    ({**HEAVY, "l": (0, 10**400)}, "beyond the range"),
    ({**HEAVY, "l": ("x", 1)}, "give a number"),
    ({**HEAVY, "I1": 0}, "I1 is at most 0"),
    ({**HEAVY, "I1": (-1, 0)}, "I1 is at most 0"),
])
def test_boxes_that_are_refused(heavy, box, message):
    """Names missing or unknown, intervals empty or not finite, moments not positive."""
    for verb in (certify_box, certified_chart):
        with pytest.raises(ValuesError, match=message):
            verb(heavy, box)


def test_families_that_are_refused(heavy, reports):
    """The eliminated name, a relation that is not eliminated, a pole on the whole box, a report of another
    kind.
    """
    report, region = reports["quartic"]
    with pytest.raises(ValuesError, match="l follows from the other names on E3, l = .*: omit it"):
        certify_box(report, {**region, "l": 1})
    kept = gs.equilibrium(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(exp(a * k3) + a * k3)),
                          gs.inclined(
        gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())).point,
                          relations=((gs.symbol("dU"), 0), (gs.symbol("omega"), 0)))
    with pytest.raises(ScopeError, match="eliminate a name"):
        certify_box(gs.analyze(kept), {})
    pole = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(1 / (k3 - a)))))
    with pytest.raises(ValuesError, match="not finite anywhere"):
        certify_box(pole, {"I1": 1, "l": (0, 1), "pi3_0": 1, "a": 1})
    b, c, d, spin = map(gs.symbol, ("b", "c", "d", "pi3_0"))
    empty = gs.equilibrium(heavy.equilibrium.system, (0, 0, spin, 0, 0, 1),
                           domain=((a + b) * c - a * c - b * c * d,))
    with pytest.raises(ValuesError, match="holds nowhere"):
        certify_box(gs.analyze(empty), {**HEAVY, "a": (0, 1), "b": (0, 1), "c": (0, 1), "d": 1})
    with pytest.raises(ArgumentError):
        certify_box(heavy.equilibrium, HEAVY)


def test_charts_that_are_refused(heavy):
    """No name varies; a resolution that is no share; look-ups beside the chart."""
    with pytest.raises(ValuesError, match="no name varies"):
        certified_chart(heavy, {**HEAVY, "l": 0, "pi3_0": 1})
    for wrong in (0, 2, -1):
        with pytest.raises(ValuesError, match=r"is not in \(0, 1\]"):
            certified_chart(heavy, HEAVY, resolution=wrong)
    chart = certified_chart(heavy, HEAVY, resolution="1/4")
    with pytest.raises(ValuesError, match="outside the chart"):
        chart.at(l=5, pi3_0=0)
    for point in ({"l": 1}, {"l": 1, "pi3_0": 1, "I1": 1}):
        with pytest.raises(ValuesError, match="for each axis and for nothing else"):
            chart.at(**point)


def test_progress_is_reported(heavy):
    """One call for each level; the last says that all is done."""
    calls = []
    certified_chart(heavy, HEAVY, resolution="1/16", progress=lambda done, total: calls.append((done, total)))
    assert [done for done, _ in calls] == list(range(1, 10)) and {total for _, total in calls} == {9}
