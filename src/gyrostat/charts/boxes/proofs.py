"""Proves on boxes of parameters that a sufficient condition holds, or a necessary one fails.

It also proves that no equilibrium exists there. What is left open says along which axis to bisect.
"""
import operator
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import reduce
from itertools import chain
from typing import Any

import numpy as np
from sympy import Expr

from ...algebra.enclosures.floats import Array
from ...algebra.reals.exact import evaluate
from ...algebra.solving.margins import Signs
from ...notation import symbol
from ...stability.criteria.conditions import Condition, Criterion
from ...stability.criteria.truth import Relation, condition_truth, truth
from ...stability.report.report import Report
from ..codes import INVALID, STABLE, UNDECIDED, UNSTABLE
from ..signs.three_valued import answered, every, some
from .box_enclosures import derivative, enclosure, sharpened
from .intervals import Enclosure
from .regions import Region

Bounds = dict[Expr, Enclosure]


def _compared(bounds: Enclosure, relation: Relation) -> Array:
    """Return whether a relation to 0 is proved or disproved at every point of a box."""
    if relation in (operator.ne, operator.eq):
        apart = bounds.apart
        never = np.zeros_like(apart)
        return answered(apart, never) if relation is operator.ne else answered(never, apart)
    return answered(relation(bounds.low, 0), ~relation(bounds.high, 0))


class Proof:
    """The criteria of a report with fixed numbers inserted, ready for boxes of the names that vary.

    Parameters
    ----------
    report : Report
    region : Region
    separate : bool
        whether a box with a decided verdict is bisected, too, to tell where the equilibrium exists
    """

    def __init__(self, report: Report, region: Region, separate: bool = False):
        report = report.written_out
        self.names = [symbol(name) for name in region.axes]
        self.positive = [place for place, name in enumerate(self.names) if name.is_positive]
        self.separate = separate
        self._fixed = region.fixed
        domain = [evaluate(e, region.fixed) for e in report.equilibrium.existence()]
        self.existence = [self._normal(Condition(e, True, "", (), report.equilibrium.at), ())
                          for e in report.equilibrium.existence()]
        self.sufficient = self._criterion(report.sufficient, domain)
        self.necessary = self._criterion(report.necessary, domain)
        conditions = [*self.existence, *chain.from_iterable(chain(self.sufficient.alternatives,
                                                                  self.necessary.alternatives))]
        self.expressions = tuple(dict.fromkeys(e for c in conditions for e in (c.margin, *c.degenerate)))

    def _criterion(self, criterion: Criterion, domain: Sequence[Expr]) -> Criterion:
        return replace(criterion, alternatives=tuple(
            tuple(self._normal(condition, domain) for condition in alternative)
            for alternative in criterion.alternatives))

    def _normal(self, condition: Condition, domain: Sequence[Expr]) -> Condition:
        """Return a condition in normal form once more, with the fixed numbers inserted.

        What is positive in the region, and squares, are taken out of its margin.
        """
        margin, *even = (evaluate(e, self._fixed) for e in (condition.margin, *condition.degenerate))
        top, squares = Signs.over([margin, *even], domain).normal_form(margin)
        return replace(condition, margin=top, degenerate=(*even, *squares))

    def judge(self, low: Array, high: Array) -> tuple[Array, Array]:
        """Return a code for each box, and how much each axis contributes to what is open there.

        The contribution is 0 if no bisection will help.

        Parameters
        ----------
        low, high : array, shape (boxes, axes)

        Returns
        -------
        int8 array, shape (boxes,), and array, shape (boxes, axes)
        """
        with np.errstate(all="ignore"):
            box = self._box(low, high)
            bounds = {e: self._whole(enclosure(e, box), len(low)) for e in self.expressions}
            code = self._codes(bounds, high)
            partly = self._partly(bounds, low, high)
            influence = np.zeros(low.shape)
            left = np.flatnonzero((code == UNDECIDED) | partly.any(axis=0))
            if len(left):
                bounds = {e: Enclosure(b.low[left], b.high[left]) for e, b in bounds.items()}
                found = self._judge_sharply(bounds, low[left], high[left], partly[:, left])
                code[left], influence[left] = found
        return code, influence

    def _partly(self, bounds: Bounds, low: Array, high: Array) -> Array:
        """Return where a condition of existence holds in a part of the box only, shape (conditions, boxes).

        It is a choice of what to bisect, not a proof: a margin that is negative only by rounding does not
        count.
        """
        if not self.separate:
            return np.zeros((0, len(low)), bool)
        margins = [bounds[condition.margin] for condition in self.existence]
        sides = [(low[:, place], high[:, place]) for place in self.positive]
        return np.array([(a < -1e-9 * b) & (b > 0) for a, b in [*((m.low, m.high) for m in margins),
                                                                *sides]]).reshape(-1, len(low))

    def _judge_sharply(self, bounds: Bounds, low: Array, high: Array, partly: Array) -> tuple[Array, Array]:
        """Return what judge does, if the natural enclosures leave something open.

        What matters is enclosed again, by its slopes.
        """
        influence = np.zeros(low.shape)
        if len(partly):
            influence[:, self.positive] = partly[len(self.existence):].T
        undecided, divided = self._codes(bounds, high) == UNDECIDED, partly.any(axis=0)
        domain = {condition.margin for condition in self.existence}
        for expression, natural in bounds.items():
            open_ = undecided | divided if expression in domain else undecided
            rows = np.flatnonzero(open_ & ~natural.apart)
            if not len(rows) or not expression.free_symbols:
                continue
            box = self._box(low[rows], high[rows])
            slopes = {name: self._whole(enclosure(derivative(expression, name), box), len(rows))
                      for name in self.names if name in expression.free_symbols}
            sharp = sharpened(expression, Enclosure(natural.low[rows], natural.high[rows]), box, slopes)
            natural.low[rows], natural.high[rows] = sharp.low, sharp.high
            parts = np.where(sharp.apart[:, None], 0, self._contributions(slopes, high[rows] - low[rows]))
            influence[rows] = np.maximum(influence[rows], parts)
        code = self._codes(bounds, high)
        influence[(code == INVALID) | (code != UNDECIDED) & ~divided] = 0
        return code, influence

    def _contributions(self, slopes: Mapping[Any, Enclosure], widths: Array) -> Array:
        """Return abs(slope) × width, relative to the largest, and 1 where it is not bounded.

        It is a choice, not a proof: rounding does not matter.
        """
        parts = np.zeros(widths.shape)
        for place, name in enumerate(self.names):
            if name in slopes:
                parts[:, place] = np.maximum(-slopes[name].low, slopes[name].high) * widths[:, place]
        parts = np.nan_to_num(parts, nan=np.inf, posinf=np.inf)
        top = parts.max(axis=1, keepdims=True)
        return np.where(top == np.inf, parts == np.inf, np.where(top > 0, parts / top, 0))

    def _codes(self, bounds: Bounds, high: Array) -> Array:
        def compare(expression: Expr, relation: Relation) -> Array:
            return _compared(bounds[expression], relation)

        stable = truth(self.sufficient, compare, every, some) > 0
        unstable = truth(self.necessary, compare, every, some) < 0
        none = [*(high[:, place] <= 0 for place in self.positive),
                *(condition_truth(condition, compare, every, some) < 0 for condition in self.existence)]
        code = np.where(stable, STABLE, np.where(unstable, UNSTABLE, UNDECIDED))
        absent = reduce(np.logical_or, none, np.zeros(len(high), bool))
        return np.where(absent, INVALID, code).astype(np.int8)

    def _box(self, low: Array, high: Array) -> dict[Any, Enclosure]:
        return {name: Enclosure(low[:, place], high[:, place]) for place, name in enumerate(self.names)}

    @staticmethod
    def _whole(bounds: Enclosure, boxes: int) -> Enclosure:
        """Return an entry for each box, also for what does not vary."""
        return Enclosure(np.broadcast_to(bounds.low, boxes), np.broadcast_to(bounds.high, boxes))
