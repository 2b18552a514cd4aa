"""Turns results beyond reports into sentences and displays.

They are sets of a parameter, branches, bifurcations and the reduced motion.
"""
from collections.abc import Callable
from functools import singledispatch
from typing import Any

from sympy import Expr, Pow, S, oo, sqrt

from ..._lazy import loaded
from ...algebra.rings.readable import readable
from ...algebra.rings.subexpressions import occurring
from ...equilibria.continuation.bifurcation_kinds import KINDS
from ...equilibria.continuation.mark import Mark
from ...equilibria.continuation.meeting_equations import Bifurcation
from ...equilibria.curves.amended_potential import AmendedPotential, CriticalPoint
from ...equilibria.curves.arc import Arc
from ...equilibria.curves.staude import StaudeCone
from ...equilibria.relative_equilibrium import RelativeEquilibrium
from ...mechanics.equilibrium.reduction import Reduction
from ...notation import symbol
from ...parameters.sets import EXCLUDED, INCLUDED, Interval, Ladder, Solution, SolvedCondition
from ...parameters.wheel_speeds import WheelSpeeds
from ...registry import Letters
from ...stability.criteria.linearization import rational_root
from ...stability.normal_forms.d4_along_family import Window
from ...stability.normal_forms.normal_form import NormalForm
from ...stability.theorems.boundary import Boundary
from ...stability.theorems.drift import Drift
from ..blocks import Block, Display, equations, joined, sentence
from ..letters import letter, letters_in, letters_of
from ..numbers import in_sentence, tidy
from .boundary import ladder, rung_display, squared_rate
from .critical_points import (
    amended_potential,
    critical_point,
    relative_equilibrium,
)
from .drift import drift_displays
from .inequalities import existence
from .normal_form import form_blocks, window_blocks
from .staude import arc_blocks, cone_blocks
from .wheel_speeds import speeds_blocks

# operations under a root, more of which are given a name
LONG = 8
_RELATION = {"<": "<", ">": ">", "=": "=", "!=": "≠"}


@singledispatch
def result_blocks(obj: Any) -> list[Block]:
    """Make the blocks of one result."""
    if (home := LATER.get(type(obj).__module__)) is None:
        raise TypeError(f"{type(obj).__name__} is no result")
    return loaded(home)(obj)


@result_blocks.register
def _solution(solution: Solution) -> list[Block]:
    premises = [p for p in solution.parts if p.meaning == "exists"
                and symbol(solution.name) not in p.margin.free_symbols]
    blocks: list[Block] = []
    if premises:
        blocks += [sentence("It exists if:"), *(existence(p.margin, p.at) for p in premises)]
    for meaning, title in _TITLES.items():
        parts = [p for p in solution.parts if p.meaning == meaning and p not in premises]
        if len(parts) == 1:
            blocks += _part(parts[0], solution.name, title)
            continue
        if parts:
            blocks.append(sentence(f"{title} all of these hold:" if meaning == "necessary"
                                   else f"{title} if all of these hold:"))
        for n, part in enumerate(parts, 1):
            blocks += _part(part, solution.name, f"({n})")
    if any(p.meaning == "sufficient" for p in solution.parts):
        blocks.append(sentence("Elsewhere these conditions do not decide; a verdict at given numbers may."))
    return blocks


_TITLES = {"exists": "It exists", "stable": "Stable", "sufficient": "Stable by the second variation",
           "necessary": "Unstable unless",
           "undecided": "Nothing is proved for"}


def _part(part: SolvedCondition, name: str, title: str) -> list[Block]:
    """Write one line for each case."""
    x = symbol(name)
    blocks: list[Block] = []
    names: dict[Expr, Expr] = {}
    letters = letters_in([part.margin, x])
    for case in part.cases:
        when = joined(" and ", [(readable(e), f" {_RELATION[relation]} 0") for e, relation in case.when])
        parts = (f"{title} for ", *when) if when else (title,)
        shown = [_abbreviated(p, names, letters) for p in (*parts, ": ", *_set(case.intervals, x), ".")]
        blocks.append(sentence(*shown, at=part.at))
    if names:
        blocks += [sentence("There:"), *(Display(name, tidy(e), part.at) for e, name in names.items())]
    return blocks


def _abbreviated(value: Any, names: dict[Expr, Expr], letters: Letters) -> Any:
    """Write a part of a sentence with names R1, R2, … for long radicands, inner roots first."""
    if not isinstance(value, Expr):
        return value
    done: dict[Expr, Expr] = {}
    roots = [p for p in occurring(value, Pow) if p.exp == S.Half]
    for root in sorted(roots, key=lambda p: p.count_ops()):
        if root.base.count_ops() > LONG:
            name = symbol(letters.of(f"R{len(names) + 1}"))
            done[root] = sqrt(names.setdefault(root.base.xreplace(done), name))
    return value.xreplace(done)


def _set(intervals: tuple[Interval, ...], x: Expr) -> tuple[Any, ...]:
    """Write a union of intervals in words and formulas."""
    if not intervals:
        return "no ", x
    lowest = S.Zero if x.is_positive else -oo
    ends = [(end, rungs) for i in intervals for end, rungs in ((i.low, i.low_if), (i.high, i.high_if))
            if end not in (lowest, oo)]
    shared = ends[0][1] if ends and all(rungs == ends[0][1] for _, rungs in ends) else None
    if not ends:
        return "every ", x
    first, second = intervals[0], intervals[-1]
    touching = (len(intervals) == 2 and first.high == second.low and shared is not None
                and not any(i.tilt for i in intervals))
    if touching and shared == INCLUDED:
        return "every ", x
    if touching:
        parts: tuple[Any, ...] = (x, " ≠ ", in_sentence(first.high))
    else:
        parts = joined(" or ", [_interval(i, x, lowest) for i in intervals])
    if shared in (EXCLUDED, INCLUDED):
        return parts
    several = len({end for end, _ in ends}) > 1
    if shared is not None and several:
        return (*parts, *_too(("the ends",), shared))
    for end, rungs in dict(ends).items():
        if rungs is not None:
            parts += _too((x, " = ", in_sentence(end)), rungs)
    return parts


def _too(ends: tuple[Any, ...], rungs: Ladder) -> tuple[Any, ...]:
    """Say when ends belong to the set, if there is anything to say."""
    if rungs == INCLUDED or all((-rung).is_nonnegative for rung in rungs):
        return ()
    return ("; ", *ends, " too if ", *_included(rungs))


def _interval(i: Interval, x: Expr, lowest: Expr) -> tuple[Any, ...]:
    parts: tuple[Any, ...]
    if i.low == i.high:
        parts = (x, " = ", in_sentence(i.low))
    elif i.high == oo and i.low != lowest and not i.tilt:
        parts = (x, " ≥ " if i.low_if == INCLUDED else " > ", in_sentence(i.low))
    else:
        parts = (x,)
        if i.low != lowest:
            parts = (in_sentence(i.low), " ≤ " if i.low_if == INCLUDED else " < ", *parts)
        if i.high != oo:
            parts = (*parts, " ≤ " if i.high_if == INCLUDED else " < ", in_sentence(i.high))
    if i.tilt:
        low, high = map(in_sentence, i.tilt)
        parts = (*parts, " (", symbol("k3"), " from ", low, " to ", high, ")")
    return parts


def _included(rungs: Ladder) -> tuple[Any, ...]:
    """Say when an end belongs to the set: if the first rung that is not 0 is positive."""
    clauses: list[tuple[Any, ...]] = []
    for n, rung in enumerate(rungs):
        if (-rung).is_nonnegative:                         # it cannot be positive
            continue
        clause: list[tuple[Any, ...]] = [(_vanishing(before), " = 0") for before in rungs[:n]]
        if rung != 1:
            clause.append((readable(rung), " > 0"))
        clauses.append(joined(" and ", clause))
    return joined(", or ", clauses)


def _vanishing(rung: Expr) -> Expr:
    """Give what is 0 if the rung is: the root of a negative square."""
    return readable(rational_root(-rung) or rung if (-rung).is_nonnegative else rung)


@result_blocks.register
def _bifurcation(b: Bifurcation) -> list[Block]:
    return [sentence(f"{b.kind} ({KINDS[b.kind]}):"),
            *(Display(readable(e), S.Zero, b.at) for e in b.equations)]


@result_blocks.register
def _mark(point: Mark) -> list[Block]:
    free = symbol(point.name)
    where = ((free, point.value), (symbol("k3"), point.k3), (letter(letters_in([free]), "nu"), point.nu))
    places = [(name, in_sentence(value)) for name, value in where if value is not None]
    counts = f", from {point.numbers[0]} to {point.numbers[1]} attitudes" if point.numbers else ""
    return [sentence(f"{point.kind} at ", *equations(places), counts)]


@result_blocks.register
def _boundary(boundary: Boundary) -> list[Block]:
    letters = letters_of(boundary.equilibrium.system)
    return [rung_display(rung, letters) for rung in ladder(boundary)[0]]


@result_blocks.register
def _reduction(motion: Reduction) -> list[Block]:
    return [Display(squared_rate(motion.system), motion.square())]


_OF_TYPE: dict[type, Callable[[Any], list[Block]]] = {
    RelativeEquilibrium: relative_equilibrium, AmendedPotential: amended_potential,
    CriticalPoint: critical_point, NormalForm: form_blocks, StaudeCone: cone_blocks, Arc: arc_blocks,
    Drift: drift_displays, Window: window_blocks, WheelSpeeds: speeds_blocks}
for _type, _blocks in _OF_TYPE.items():
    result_blocks.register(_type, _blocks)

RESULTS = (*_OF_TYPE, Solution, Bifurcation, Mark, Boundary, Reduction)
# by the module of its class what writes a result that a page does without
LATER = {"gyrostat.equilibria.wells.well": "printing.results.well:blocks_without_units",
         "gyrostat.equilibria.wells.frame": "printing.results.well:frame_blocks"}


def is_result(obj: Any) -> bool:
    """Tell whether there are blocks of an object."""
    return isinstance(obj, RESULTS) or type(obj).__module__ in LATER
