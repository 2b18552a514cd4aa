"""Charts of certified boxes: they tile the region, to the resolution, within the limit."""
import math
import random
from fractions import Fraction

import pytest
from charts.claimed_boxes import HEAVY, NAMES, assert_claims

import gyrostat as gs
from gyrostat.charts.boxes.certified_boxes import certified_chart, certify_box
from gyrostat.charts.codes import BOX_KINDS
from gyrostat.errors import ValuesError
from gyrostat.stability.decision import Verdict

k3, m0, a = gs.symbol("k3"), gs.symbol("m0"), gs.symbol("a")
STABLE, UNSTABLE, UNDECIDED = Verdict.STABLE, Verdict.UNSTABLE, Verdict.UNDECIDED


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_boxes_tile_the_region(regions, name):
    """Shares sum to 1, every point lies in a box, and a point that is on no edge lies in one only."""
    report, region = regions[name]
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


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ["E1", "quartic", "exponential", "free body"])
def test_half_the_resolution_is_half_the_undecided_share(regions, name):
    """The undecided boxes lie along the boundary, of dimension one less."""
    report, region = regions[name]
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


def test_where_there_is_no_equilibrium(e1, e3, regions):
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
    report, region = regions["logarithm at E1"]
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
