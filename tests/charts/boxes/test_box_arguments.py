"""What a box may be: names, intervals, families that are refused, and what a decision says."""
import math

import pytest
from charts.claimed_boxes import HEAVY
from sympy import exp

import gyrostat as gs
from gyrostat.charts.boxes.certified_boxes import certified_chart, certify_box
from gyrostat.errors import ArgumentError, ScopeError, ValuesError
from gyrostat.stability.decision import Verdict

k3, m0, a = gs.symbol("k3"), gs.symbol("m0"), gs.symbol("a")
STABLE, UNSTABLE, UNDECIDED = Verdict.STABLE, Verdict.UNSTABLE, Verdict.UNDECIDED


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
    assert stable.stable_parts.tolist() == [[[3, 4]]]
    assert unstable.unstable_parts.tolist() == [[[-0.5, 1]]]
    assert not stable.undecided_parts.size
    assert "sufficient condition" in stable.reason
    assert "fail" in unstable.reason
    assert "another part unstable" in both.reason
    assert part.undecided_parts.tolist() == [[[2, 2 + 2**-5]]] and "1 of 6 parts" in part.reason
    assert repr(part.chart) == "CertifiedChart(pi3_0: 6 boxes; stable 0.96875, undecided 0.03125)"


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


def test_families_that_are_refused(heavy, regions):
    """The eliminated name, a relation that is not eliminated, a pole on the whole box, a report of another
    kind.
    """
    report, region = regions["quartic"]
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
