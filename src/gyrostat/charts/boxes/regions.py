"""Reads regions of parameters: intervals and exact numbers by name, checked against the family."""
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from sympy import Expr, S

from ...algebra.enclosures.balls import ball
from ...algebra.enclosures.floats import Array
from ...algebra.reals.exact import Point, evaluate, is_identically_zero, sign_of_constant
from ...algebra.text.numbers import exact_number, shown
from ...errors import ScopeError, ValuesError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...notation import symbol
from ...stability.criteria.numbers_asked import check_family
from ...stability.report.report import Report
from .intervals import rounded


@dataclass(frozen=True, eq=False)
class Region:
    """Intervals of the names that vary, their ends rounded outward, and exact numbers for the others.

    Parameters
    ----------
    axes : tuple of str
        the names that vary
    low, high : array, shape (axes,)
        the ends of their intervals
    fixed : Point
        the others
    """

    axes: tuple[str, ...]
    low: Array
    high: Array
    fixed: Point

    @property
    def fixed_numbers(self) -> tuple[tuple[str, Expr], ...]:
        """The exact numbers of the names that do not vary."""
        return tuple((s.name, number) for s, number in self.fixed.items())


def region_of(report: Report, given: Mapping[str, Any]) -> Region:
    """Return the region that numbers and pairs (low, high) describe, every one of them checked."""
    eq = report.equilibrium
    if eq.constraints:
        raise ScopeError(f"{eq.label} exists only where {eq.constraints[0]} = 0, on no box of its "
                         "parameters: eliminate a name that enters this relation affinely")
    names = [str(name) for name in given]
    check_family(eq, names, report.compared, report.parameters,
                 "give a number or a pair (low, high) for each")
    ends = {str(name): _ends(value, str(name)) for name, value in given.items()}
    fixed = Point({symbol(name): low for name, (low, high) in ends.items() if low == high})
    axes = tuple(name for name in ends if symbol(name) not in fixed)
    low, high = (np.array([rounded(ends[name][side])[side] for name in axes], dtype=float) for side in (0, 1))
    for name, a, b in zip(axes, low, high):
        if not np.isfinite([a, b]).all():
            raise ValuesError(f"the ends of {name} are beyond the range of float64: measure it in other "
                              "units")
    _check(eq, {symbol(name): high for name, (_, high) in ends.items()}, fixed)
    return Region(axes, low, high, fixed)


def _ends(value: Any, name: str) -> tuple[Expr, Expr]:
    """Return both ends as exact numbers; one number twice if nothing lies between."""
    pair = tuple(value) if isinstance(value, (tuple, list, np.ndarray)) else (value, value)
    if len(pair) != 2:
        raise ValuesError(f"{name} = {value} has {len(pair)} entries, an interval has two ends: give a "
                          "number or a pair (low, high)")
    low, high = (exact_number(end, name) for end in pair)
    for end in (low, high):
        if not ball(end, 64).is_finite():
            raise ValuesError(f"{name} = {end} cannot be enclosed: write it with rationals, roots, pi, "
                              "exp, log and the like")
    order = sign_of_constant(high - low)
    if order == -1:
        raise ValuesError(f"{name} = ({shown(low)}, {shown(high)}) is empty, its low end is above its high "
                          "one: exchange them")
    return (low, low) if order == 0 else (low, high)


def _check(eq: Equilibrium, greatest: Mapping[Any, Expr], fixed: Point) -> None:
    """Refuse a region in which the equilibrium exists nowhere, as far as its fixed numbers tell."""
    for name, number in greatest.items():
        if name.is_positive and sign_of_constant(number) in (0, -1):
            raise ValuesError(f"{name} is at most {shown(number)} in the region, but it must be positive: "
                              "choose other ends")
    for expression in eq.existence():
        value = evaluate(expression, fixed)
        if _undefined(value) or is_identically_zero(value) or _not_positive(value):
            raise ValuesError(f"{eq.label} exists only where {expression} > 0, which holds nowhere in the "
                              "region: choose another one")
    for expression in eq.field_values:
        if _undefined(evaluate(expression, fixed)):
            raise ValuesError(f"U or one of its derivatives, {expression}, is not finite anywhere in the "
                              "region: choose another one")


def _not_positive(value: Expr) -> bool:
    return not value.free_symbols and (sign_of_constant(value) == -1 or not ball(value, 64).is_finite())


def _undefined(value: Expr) -> bool:
    return bool(value.has(S.NaN, S.ComplexInfinity, S.Infinity, S.NegativeInfinity))
