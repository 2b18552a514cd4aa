"""Certified verdicts on boxes of parameters, by branch and bound with interval arithmetic.

Each claim is proved for every point of a closed box at which the equilibrium exists.
"""
import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from ...algebra.enclosures.floats import Array
from ...algebra.reals.exact import sign_of_constant
from ...algebra.text.numbers import exact_number, shown
from ...arguments import checked
from ...errors import ValuesError
from ...stability.decision import Judged, Verdict
from ...stability.report.report import Report
from ..codes import CODE_OF, INVALID, STABLE, UNDECIDED, UNSTABLE
from ..progress import Told, telling
from .paving import CertifiedChart, covered
from .proofs import Proof
from .regions import region_of

DEEPEST = 1100                                             # bisections after which two floats are neighbours


@dataclass(frozen=True, eq=False)
class BoxDecision(Judged):
    """What is proved about a box of parameters.

    Parameters
    ----------
    verdict : Verdict
        STABLE or UNSTABLE if that is proved at every point of the box at which the equilibrium exists
    reason : str
        what is proved, or on how many parts nothing is
    chart : CertifiedChart
        the parts of the box, and what is proved about each

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> box = {"I1": 1, "m0": 1, "l": 0, "pi3_0": (3, 4)}
    >>> decision = gs.charts.certify_box(report, box)
    >>> decision.verdict.name, decision.measure["stable"]
    ('STABLE', Fraction(1, 1))
    """

    verdict: Verdict
    reason: str
    chart: CertifiedChart

    @property
    def measure(self) -> dict[str, Fraction]:
        """The share of the box by kind, exact."""
        return self.chart.measure

    @property
    def stable_parts(self) -> Array:
        """The parts that are proved stable, shape (parts, axes, 2)."""
        return self._parts(STABLE)

    @property
    def unstable_parts(self) -> Array:
        """The parts that are proved unstable, shape (parts, axes, 2)."""
        return self._parts(UNSTABLE)

    @property
    def undecided_parts(self) -> Array:
        """The parts that the proof does not cover, shape (parts, axes, 2)."""
        return self._parts(UNDECIDED)

    def _parts(self, code: int) -> Array:
        return np.stack([self.chart.low, self.chart.high], axis=-1)[self.chart.code == code]


@checked
def certify_box(report: Report, box: Mapping[str, Any], *, depth: int = 24,
                limit: int = 200_000) -> BoxDecision:
    """Return a verdict on all points of a box, by branch and bound with interval arithmetic.

    Parameters
    ----------
    report : Report
    box : mapping of name to number or (low, high)
        numbers as Report.verdict takes them, with the dimensions of the notation table
    depth : int
        the most bisections of one part; default 24
    limit : int
        the most parts; default 200000

    Returns
    -------
    BoxDecision
        a box that is one point is decided as Report.verdict does, equality included

    Raises
    ------
    ValuesError
        names are missing or unknown, an interval is empty or not finite, or no point of the box is an
        equilibrium
    ScopeError
        the relation of the family was not eliminated

    References
    ----------
    Interval arithmetic: Moore, Kearfott & Cloud, Introduction to Interval Analysis (2009), chapters 5 and 6.

    Examples
    --------
    >>> import gyrostat as gs
    >>> from fractions import Fraction
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> box = {"I1": (1, "1.1"), "m0": 1, "l": (2, 3), "pi3_0": (1, 2)}
    >>> gs.charts.certify_box(report, box).verdict.name
    'STABLE'
    >>> box = {"I1": 1, "m0": 1, "l": 0, "pi3_0": (0, 4)}
    >>> across = gs.charts.certify_box(report, box)
    >>> across.measure["undecided"] < Fraction(1, 10**6)
    True
    """
    region = region_of(report, box)
    if not region.axes:
        decision = report.verdict({s.name: number for s, number in region.fixed.items()})
        chart = CertifiedChart((), region.fixed_numbers, np.empty((1, 0)), np.empty((1, 0)),
                               np.array([CODE_OF[decision.verdict]], np.int8), True)
        return BoxDecision(decision.verdict, decision.reason, chart)
    chart = covered(Proof(report, region), region, DEEPEST, depth, limit, None)
    found = set(chart.code.tolist()) - {INVALID}
    if not found:
        raise ValuesError(f"{report.equilibrium.label} exists at no point of the box: choose a box in "
                          "which its domain is positive")
    left, parts = int((chart.code == UNDECIDED).sum()), len(chart.code)
    verdict, reason = Verdict.UNDECIDED, f"nothing is proved on {left} of {parts} parts of the box"
    if found == {STABLE}:
        verdict, reason = Verdict.STABLE, "a sufficient condition is proved on every part of the box"
    elif found == {UNSTABLE}:
        verdict, reason = Verdict.UNSTABLE, "a necessary condition is proved to fail on every part of the box"
    elif found >= {STABLE, UNSTABLE}:
        reason = "a part of the box is proved stable and another part unstable"
    return BoxDecision(verdict, reason, chart)


@checked
def certified_chart(report: Report, region: Mapping[str, Any], *, resolution: Any = Fraction(1, 8192),
                    limit: int = 1_000_000, progress: Told | bool | None = None) -> CertifiedChart:
    """Return a region paved by boxes, each with a proved verdict; undecided ones lie along the boundary.

    Parameters
    ----------
    report : Report
    region : mapping of name to number or (low, high)
        one pair at least
    resolution : number
        a side is halved until it is at most this share of the region's; default 1/8192
    limit : int
        the most boxes; default 1000000
    progress : callable, False or None
        called with the levels of bisection done and all of them; by default a bar is drawn on a terminal

    Returns
    -------
    CertifiedChart

    Raises
    ------
    ValuesError, ScopeError
        as in certify_box; and if no name varies, or a resolution is not in (0, 1]

    References
    ----------
    Paving by interval analysis: Jaulin & Walter, Automatica 29 (1993) 1053-1064.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> region = {"I1": 1, "m0": 1, "l": (-4, 4), "pi3_0": (-4, 4)}
    >>> chart = gs.charts.certified_chart(report, region, resolution="1/64")
    >>> chart.at(l=1, pi3_0=2).name, chart.at(l=1, pi3_0=-2).name
    ('STABLE', 'UNSTABLE')
    >>> chart.at(l=1, pi3_0=1).name
    'UNDECIDED'
    """
    share = exact_number(resolution, "resolution")
    if sign_of_constant(share) != 1 or sign_of_constant(1 - share) == -1:
        raise ValuesError(f"resolution = {shown(share)} is not in (0, 1]: give the smallest side as a "
                          "share of the region's, as 1/1024")
    read = region_of(report, region)
    if not read.axes:
        raise ValuesError("no name varies: give a pair (low, high) for one name at least, or ask "
                          "report.verdict for the point")
    levels = max(0, math.ceil(-math.log2(max(float(share), 2.0**-DEEPEST))))
    with telling(progress, "boxes") as tell:
        return covered(Proof(report, read, separate=True), read, levels, levels * len(read.axes), limit, tell)
