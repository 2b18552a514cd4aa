"""Paves a region by interval analysis (Jaulin & Walter): boxes by bisection, with what is proved."""
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from sympy import Expr

from ..._cached import cached_property
from ...algebra.enclosures.floats import Array
from ...algebra.text.numbers import exact_number
from ...errors import ValuesError
from ...stability.decision import Verdict
from ..codes import BOX_KINDS, INVALID, STABLE, UNSTABLE
from .intervals import rounded
from .proofs import Proof
from .regions import Region

BATCH = 8192                                            # boxes that are judged at a time


@dataclass(frozen=True, eq=False)
class CertifiedChart:
    """Closed boxes that cover a region without gap or overlap, each with what is proved about it.

    The ends of the region are rounded outward to float64. The boxes come from it by bisection at floats, so
    that neighbours share their edges exactly. Their codes are 1, every point of the box at which the
    equilibrium exists is stable; -1, every such point is unstable; -2, there is no such point; 0, nothing is
    proved.

    Parameters
    ----------
    axes : tuple of str
        the names that vary
    fixed : tuple of (str, Expr)
        the exact numbers of the others
    low, high : array, shape (boxes, axes)
        the edges of the boxes
    code : int8 array, shape (boxes,)
        the code of each box
    complete : bool
        False if the limit on boxes was reached before the resolution

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> region = {"I1": 1, "m0": 1, "l": 0, "pi3_0": (0, 4)}
    >>> chart = gs.charts.certified_chart(report, region, resolution="1/64")
    >>> chart.axes, chart.at(pi3_0=3).name, sum(chart.measure.values())
    (('pi3_0',), 'STABLE', Fraction(1, 1))
    """

    axes: tuple[str, ...]
    fixed: tuple[tuple[str, Expr], ...]
    low: Array
    high: Array
    code: Array
    complete: bool

    @cached_property
    def measure(self) -> dict[str, Fraction]:
        """The share of the region by kind, exact; the shares sum to 1."""
        volumes = np.ones(len(self.code), dtype=object)
        for low, high in zip(self.low.T, self.high.T):
            volumes = volumes * _exact_widths(low, high)
        total = int(volumes.sum())
        return {kind: Fraction(int(volumes[self.code == code].sum()), total)
                for kind, code in BOX_KINDS.items()}

    def at(self, **point: Any) -> Verdict:
        """Return what the boxes that contain a point prove about it.

        Parameters
        ----------
        **point : number
            one for each axis

        Returns
        -------
        Verdict

        Raises
        ------
        ValuesError
            a name is no axis, the point is outside the region, or there is proved to be no equilibrium
        """
        if set(point) != set(self.axes):
            raise ValuesError(f"the point has the names {', '.join(sorted(point)) or '(none)'}, the chart "
                              f"the axes {', '.join(self.axes)}: "
                              "give a number for each axis and for nothing else")
        inside = np.ones(len(self.code), dtype=bool)
        for name, low, high in zip(self.axes, self.low.T, self.high.T):
            below, above = rounded(exact_number(point[name], name))
            inside &= (low <= below) & (above <= high)
        codes = set(self.code[inside].tolist())
        if not codes:
            raise ValuesError(f"{_point(point)} is outside the chart: choose a point in the region")
        if INVALID in codes:
            raise ValuesError(f"there is no equilibrium at {_point(point)}: choose a point where it exists")
        if STABLE in codes:
            return Verdict.STABLE
        return Verdict.UNSTABLE if UNSTABLE in codes else Verdict.UNDECIDED

    def __repr__(self) -> str:
        shares = ", ".join(f"{kind} {float(share):.6g}" for kind, share in self.measure.items() if share)
        return f"CertifiedChart({', '.join(self.axes)}: {len(self.code)} boxes; {shares})"


def covered(proof: Proof, region: Region, deepest: int, bisections: int, limit: int,
           progress: Callable[[int, int], object] | None) -> CertifiedChart:
    """Return the chart of a region, bisected along the axis that matters most.

    Boxes are halved until nothing is open, or that axis is at its end.

    Parameters
    ----------
    proof : Proof
    region : Region
    deepest : int
        the most bisections along one axis
    bisections : int
        the most bisections of one box along all axes
    limit : int
        the most boxes
    progress : callable (done, total)
        called after each level

    Returns
    -------
    CertifiedChart
    """
    low, high = region.low[None], region.high[None]
    depth = np.zeros(low.shape, np.int16)
    done: list[tuple[Array, Array, Array]] = []
    count, level, complete = 0, 0, True
    while len(low):
        judged = [proof.judge(low[n:n + BATCH], high[n:n + BATCH]) for n in range(0, len(low), BATCH)]
        code, influence = (np.concatenate(parts) for parts in zip(*judged))
        axis, end, middle = _halving(low, high, depth, influence, deepest)
        end |= level >= bisections
        if complete and count + len(low) + int((~end).sum()) > limit:
            complete, end = False, np.ones(len(low), bool)
        done.append((low[end], high[end], code[end]))
        count += int(end.sum())
        low, high, depth = _halves(*(a[~end] for a in (low, high, depth, axis, middle)))
        level += 1
        if progress:
            progress(level if len(low) else bisections + 1, bisections + 1)
    low, high, code = (np.concatenate(parts) for parts in zip(*done))
    return CertifiedChart(region.axes, region.fixed_numbers, low, high, code, complete)


def _halving(low: Array, high: Array, depth: Array, influence: Array,
             deepest: int) -> tuple[Array, Array, Array]:
    """Return the axis to halve, whether there is nothing to halve, and the middle.

    The middle is a float between the ends, at any scale.
    """
    with np.errstate(over="ignore"):
        total = low + high
    middle = np.where(np.isfinite(total), total / 2, low / 2 + high / 2)
    # axes that matter equally are halved in turn, as each halving takes a little weight
    weight = np.where((low < middle) & (middle < high), influence * (1 - 1e-6 * depth), 0)
    axis = weight.argmax(axis=1)
    rows = np.arange(len(low))
    return axis, (weight[rows, axis] <= 0) | (depth[rows, axis] >= deepest), middle[rows, axis]


def _halves(low: Array, high: Array, depth: Array, axis: Array, middle: Array) -> tuple[Array, Array, Array]:
    rows = np.arange(len(low))
    depth[rows, axis] += 1
    inner_high, inner_low = high.copy(), low.copy()
    inner_high[rows, axis] = inner_low[rows, axis] = middle
    return np.concatenate([low, inner_low]), np.concatenate([inner_high,
                                                             high]), np.concatenate([depth, depth])


def _exact_widths(low: Array, high: Array) -> Array:
    """Return the widths of intervals as integers, in a unit of their own."""
    exponent = np.frexp(np.stack([low, high]))[1].min(where=np.stack([low, high]) != 0, initial=1100) - 53
    return _integers(high, exponent) - _integers(low, exponent)


def _integers(values: Array, exponent: int) -> Array:
    """Return values / 2^exponent, exact."""
    mantissa, power = np.frexp(values)
    shift = np.where(values == 0, 0, power - 53 - exponent)
    return (mantissa * 2.0**53).astype(np.int64).astype(object) << shift.astype(object)


def _point(point: Mapping[str, Any]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in point.items())
