"""What a report proves on boxes of parameters.

A sufficient condition holds, a necessary one fails, or nothing exists.
"""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import Expr

from ..algebra.exact import evaluate
from ..algebra.margins import Signs
from ..notation import symbol
from ..stability.conditions import Condition, Criterion
from ..stability.report import Report
from .intervals import Array, Enclosure, derivative, enclosure, sharpened
from .regions import Region

STABLE, UNDECIDED, UNSTABLE, ABSENT = 1, 0, -1, -2


@dataclass(frozen=True)
class Sign:
    """What decides a condition.

    A margin and even factors, by their places among the expressions that are enclosed.
    """

    margin: int
    degenerate: tuple[int, ...]
    strict: bool = True

    def holds(self, bounds: Sequence[Enclosure]) -> Array:
        """Where the condition is proved at every point of the box."""
        if not self.strict:
            return bounds[self.margin].low >= 0
        return np.logical_and.reduce([bounds[self.margin].low > 0,
                                      *(_apart(bounds[n]) for n in self.degenerate)])

    def fails(self, bounds: Sequence[Enclosure]) -> Array:
        """Where the condition is disproved at every point of the box."""
        if self.strict:
            return bounds[self.margin].high <= 0
        return np.logical_and.reduce([bounds[self.margin].high < 0,
                                      *(_apart(bounds[n]) for n in self.degenerate)])


def _apart(bounds: Enclosure) -> Array:
    """Where 0 is excluded."""
    return (bounds.low > 0) | (bounds.high < 0)


class Proof:
    """The criteria of a report with the numbers that do not vary inserted, ready for boxes of those that do.

    Parameters
    ----------
    report : Report
    region : Region
    separate : bool
        bisect also to tell where the equilibrium exists, where the verdict is decided
    """

    def __init__(self, report: Report, region: Region, separate: bool = False):
        self.names = [symbol(name) for name in region.axes]
        self.positive = [place for place, name in enumerate(self.names) if name.is_positive]
        self.separate = separate
        self._fixed = region.fixed
        self._places: dict[Expr, int] = {}
        domain = [evaluate(e, region.fixed) for e in report.equilibrium.existence()]
        self.existence = [self._sign(e, (), True, ()) for e in domain]
        self.sufficient = self._criterion(report.sufficient, domain)
        self.necessary = self._criterion(report.necessary, domain)
        self.expressions = tuple(self._places)

    def _criterion(self, criterion: Criterion, domain: Sequence[Expr]) -> list[list[Sign]]:
        def condition(c: Condition) -> Sign:
            margin, *even = (evaluate(e, self._fixed) for e in (c.margin, *c.degenerate))
            return self._sign(margin, even, c.strict, domain)

        return [[condition(c) for c in alternative] for alternative in criterion.alternatives]

    def _sign(self, margin: Expr, even: Sequence[Expr], strict: bool, domain: Sequence[Expr]) -> Sign:
        """In normal form once more: what is positive in the region is left out, squares are taken out."""
        top, squares = Signs.over([margin, *even], domain).normal_form(margin)
        return Sign(self._place(top), tuple(map(self._place, (*even, *squares))), strict)

    def _place(self, expression: Expr) -> int:
        return self._places.setdefault(expression, len(self._places))

    def judge(self, low: Array, high: Array) -> tuple[Array, Array]:
        """A code for each box, and how much each axis contributes to what is open there.

        0 where no bisection will help.

        Parameters
        ----------
        low, high : array, shape (boxes, axes)

        Returns
        -------
        int8 array, shape (boxes,), and array, shape (boxes, axes)
        """
        with np.errstate(all="ignore"):
            box = self._box(low, high)
            bounds = [self._whole(enclosure(e, box), len(low)) for e in self.expressions]
            code = self._codes(bounds, high)
            partly = self._partly(bounds, low, high)
            influence = np.zeros(low.shape)
            left = np.flatnonzero((code == UNDECIDED) | partly.any(axis=0))
            if len(left):
                bounds = [Enclosure(b.low[left], b.high[left]) for b in bounds]
                code[left], influence[left] = self._judge_sharply(
                    bounds, low[left], high[left], partly[:, left]
                )
        return code, influence

    def _partly(self, bounds: Sequence[Enclosure], low: Array, high: Array) -> Array:
        """Where the equilibrium exists in a part of the box, shape (conditions, boxes).

        What separates it from the rest.

        A choice of what to bisect, not a proof: a margin that is negative only by rounding does not count.
        """
        if not self.separate:
            return np.zeros((0, len(low)), bool)
        margins = [bounds[sign.margin] for sign in self.existence]
        sides = [(low[:, place], high[:, place]) for place in self.positive]
        return np.array([(a < -1e-9 * b) & (b > 0) for a, b in [*((m.low, m.high) for m in margins),
                                                                *sides]]).reshape(-1, len(low))

    def _judge_sharply(self, bounds: list[Enclosure], low: Array, high: Array,
                       partly: Array) -> tuple[Array, Array]:
        """As judge, where the natural enclosures leave something open.

        What matters is enclosed again, by its slopes.
        """
        influence = np.zeros(low.shape)
        if len(partly):
            influence[:, self.positive] = partly[len(self.existence):].T
        undecided, divided = self._codes(bounds, high) == UNDECIDED, partly.any(axis=0)
        domain = {sign.margin for sign in self.existence}
        for n, expression in enumerate(self.expressions):
            rows = np.flatnonzero((undecided | divided if n in domain else undecided) & ~_apart(bounds[n]))
            if not len(rows) or not expression.free_symbols:
                continue
            box, natural = self._box(low[rows],
                                     high[rows]), Enclosure(bounds[n].low[rows], bounds[n].high[rows])
            slopes = {name: self._whole(enclosure(derivative(expression, name), box), len(rows))
                      for name in self.names if name in expression.free_symbols}
            sharp = sharpened(expression, natural, box, slopes)
            bounds[n].low[rows], bounds[n].high[rows] = sharp.low, sharp.high
            parts = np.where(_apart(sharp)[:, None], 0, self._contributions(slopes, high[rows] - low[rows]))
            influence[rows] = np.maximum(influence[rows], parts)
        code = self._codes(bounds, high)
        influence[(code == ABSENT) | (code != UNDECIDED) & ~divided] = 0
        return code, influence

    def _contributions(self, slopes: Mapping[Any, Enclosure], widths: Array) -> Array:
        """abs(slope) × width, relative to the largest.

        1 where it is not bounded. A choice, not a proof: rounding does not matter.
        """
        parts = np.zeros(widths.shape)
        for place, name in enumerate(self.names):
            if name in slopes:
                parts[:, place] = np.maximum(-slopes[name].low, slopes[name].high) * widths[:, place]
        parts = np.nan_to_num(parts, nan=np.inf, posinf=np.inf)
        top = parts.max(axis=1, keepdims=True)
        return np.where(top == np.inf, parts == np.inf, np.where(top > 0, parts / top, 0))

    def _codes(self, bounds: Sequence[Enclosure], high: Array) -> Array:
        nowhere, always = np.zeros(len(high), bool), np.ones(len(high), bool)
        hold = [np.logical_and.reduce([always, *(sign.holds(bounds) for sign in a)]) for a in self.sufficient]
        fail = [np.logical_or.reduce([nowhere, *(sign.fails(bounds) for sign in a)]) for a in self.necessary]
        none = [*(high[:, place] <= 0 for place in self.positive),
                *(sign.fails(bounds) for sign in self.existence)]
        stable, unstable = np.logical_or.reduce([nowhere, *hold]), np.logical_and.reduce([always, *fail])
        absent = np.logical_or.reduce([nowhere, *none])
        code = np.where(stable, STABLE, np.where(unstable, UNSTABLE, UNDECIDED))
        return np.where(absent, ABSENT, code).astype(np.int8)

    def _box(self, low: Array, high: Array) -> dict[Any, Enclosure]:
        return {name: Enclosure(low[:, place], high[:, place]) for place, name in enumerate(self.names)}

    @staticmethod
    def _whole(bounds: Enclosure, boxes: int) -> Enclosure:
        """An entry for each box, also of what does not vary."""
        return Enclosure(np.broadcast_to(bounds.low, boxes), np.broadcast_to(bounds.high, boxes))
