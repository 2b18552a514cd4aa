"""Finds the values of a name along the stable tilts of E3, for each run on which it is monotone."""
from sympy import Expr, S, Symbol, oo

from ..algebra.reals.exact import Point, evaluate, is_identically_zero, sign
from ..algebra.solving.roots import between
from ..errors import ScopeError
from ..notation import symbol
from ..stability.report.report import Report
from .line_decomposition import cut, joined_apart
from .sets import Case, Interval, SolvedCondition


def along_tilts(report: Report, name: str, numbers: Point) -> SolvedCondition:
    """Return the stable tilts, and the name along each run of them on which it is monotone."""
    k3 = symbol("k3")
    value = dict(report.equilibrium.relations)[symbol(name)].xreplace(numbers)
    slope = value.diff(k3)
    cells = cut(report, k3, numbers, S.NegativeOne, S.One, [slope] if slope.free_symbols else [])
    if is_identically_zero(slope):
        raise ScopeError(f"{name} is the same for every tilt: {value}; ask at that value for all "
                         "equilibria (relative_equilibria)")
    if any(stable is None for *_, stable in cells):
        raise ScopeError(f"at some tilts nothing is proved, and {name} is not solved for along them: give "
                         "a number for k3")
    intervals = []
    for run in joined_apart(cells, [low for low, high, _ in cells if low == high
                                    and _vanishes(slope, k3, low)]):
        grows = sign(slope, {k3: between(run.low, run.high)}) == 1 if run.low != run.high else True
        ends = [(_limit(value, k3, k, side if grows else -side), included, k)
                for k, included, side in ((run.low, run.low_if, -1), (run.high, run.high_if, 1))]
        if not grows:
            ends.reverse()
        (a, a_if, ka), (b, b_if, kb) = ends
        intervals.append(Interval(a, b, a_if, b_if, (ka, kb)))
    return SolvedCondition("stable", S.One, (Case((), tuple(intervals)),), report.equilibrium.at)


def _limit(value: Expr, x: Symbol, end: Expr, side: int) -> Expr:
    """Return the value at an end of a run, infinite if it has a pole there."""
    there = evaluate(value, {x: end})
    return there if there.is_finite else side * oo


def _vanishes(expression: Expr, x: Symbol, value: Expr) -> bool:
    return sign(expression, {x: value}) == 0
