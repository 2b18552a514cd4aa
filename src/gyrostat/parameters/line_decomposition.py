"""Cuts a parameter's line where a verdict may change: a one-dimensional cylindrical decomposition.

All other parameters are numbers; the verdict is proved between the cuts and at them.
"""
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache, partial
from itertools import pairwise

from sympy import Expr, Mul, Symbol, oo

from ..algebra.enclosures.balls import ball
from ..algebra.reals.exact import Point, evaluate, is_identically_zero, proved_sign, sign_of_constant
from ..algebra.reals.number_matrices import square_roots
from ..algebra.rings.polynomials import Ring
from ..algebra.solving.roots import between, inside, real_roots
from ..errors import ScopeError
from ..mechanics.families.orbital_precession import moving_axis
from ..stability.decision import Decision, Verdict, undecided
from ..stability.normal_forms.d4_along_family import cuts_in_windows, motion_in_field
from ..stability.report.report import Report
from .sets import EXCLUDED, INCLUDED, Interval

# an open interval or a point, and whether it is stable there; None: not proved
Cell = tuple[Expr, Expr, bool | None]


def cut(report: Report, x: Symbol, numbers: Point, low: Expr | None, high: Expr | None,
        also: Sequence[Expr] = (), damped: bool = False, doubt: bool = False) -> list[Cell]:
    """Return the cells between and at the roots of everything whose sign matters, with damping or without.

    At an end at which the second variation is degenerate, what damping does is left undecided if numbers with
    more than a square root are in it, since the modes that grow take minutes to count. If a sign is not
    proved, a ScopeError is raised, or, if doubt is admitted, the cell is undecided.
    """
    criteria = (report.necessary, report.sufficient, *((report.damped,) if damped else ()))
    conditions = [c for criterion in criteria for a in criterion.alternatives for c in a]
    margins, determinant = [e for c in conditions for e in (c.margin, *c.degenerate)], report.determinant[0]
    if report.closed:                                      # what the names stand for
        margins, determinant = report.closed.margins, report.closed.determinant
    expressions = [*margins, *report.equilibrium.existence(), *also]
    placed = [e.xreplace(numbers) for e in expressions]
    everywhere = not report.sufficient.alternatives or any(map(is_identically_zero, placed))
    if everywhere and report.between:                      # it is on the boundary whatever x is
        placed += [e.xreplace(numbers) for e in report.between.ladder()]
    elif everywhere and is_identically_zero(determinant.xreplace(numbers)):
        raise ScopeError(f"the second variation is degenerate for every {x}: ask for verdicts at given "
                         "numbers")
    polynomials = [f for e in placed if x in e.free_symbols for f in _numerators(e, x)]
    ends = real_roots(Mul(*polynomials), x, low, high) or []
    bounds: list[Expr] = [-oo if low is None else low, *ends, oo if high is None else high]
    def decided(value: Expr) -> Decision | None:
        at = Point({**numbers, x: value})
        roots = square_roots(at.values()) if damped else set()
        if (roots is None or len(roots) > 1) and sign_of_constant(evaluate(determinant, at)) == 0:
            return undecided("the second variation is degenerate")
        try:
            return _decision(report, x, numbers, value, damped)
        except ScopeError:
            if not doubt:
                raise
            return undecided("a sign is not proved")

    return list(_cells(decided, bounds, cache(partial(_in_window, report, x, numbers, low, high))))


def _cells(decided: Callable[[Expr], Decision | None], bounds: Sequence[Expr],
           windows: Callable[[], list[Expr] | None] | None = None) -> Iterator[Cell]:
    """Yield the cells between bounds, one for each, and at the bounds; windows are cut further.

    What holds at one point between two bounds holds everywhere between them, except in windows.
    """
    for n, (a, b) in enumerate(pairwise(bounds)):
        if n:
            yield a, a, _stable(decided(a))
        decision = decided(between(a, b))
        if windows is None or decision is None or not decision.pointwise:
            yield a, b, _stable(decision)
        elif (cuts := windows()) is None:
            yield a, b, None
        else:
            yield from _cells(decided, [a, *inside(cuts, a, b), b])


def _in_window(report: Report, x: Symbol, numbers: Point, low: Expr | None,
               high: Expr | None) -> list[Expr] | None:
    """Return where a window may end or be resonant, or D4 is 0; None if that is not known.

    Between these values Arnold's condition holds everywhere in a window, or nowhere.
    """
    eq = report.equilibrium
    if eq.system.coupled:                                  # a symmetric satellite: its axis moves like a top
        axis = moving_axis(eq, lambda e: evaluate(e, numbers))
        return None if axis is None else cuts_in_windows(motion_in_field(axis, numbers), x, low, high)
    try:
        motion = motion_in_field(eq, numbers)
    except ScopeError:
        return None
    return cuts_in_windows(motion, x, low, high)


def _numerators(expression: Expr, x: Symbol) -> list[Expr]:
    """Return numerator and denominator, as far as they contain x."""
    ring = Ring([expression])
    parts = [ring.expression(ring.reduce(part)) for part in ring.fraction(expression)]
    return [part for part in parts if x in part.free_symbols]


def stable_at(report: Report, x: Symbol, value: Expr, numbers: Point, damped: bool = False) -> bool | None:
    """Tell whether the equilibrium exists at a value and is stable there; None if neither is proved."""
    return _stable(_decision(report, x, numbers, value, damped))


def _stable(decision: Decision | None) -> bool | None:
    """Return what a decision says; a decision None says that nothing exists."""
    if decision is None:
        return False
    return None if decision.verdict is Verdict.UNDECIDED else decision.verdict is Verdict.STABLE


def _decision(report: Report, x: Symbol, numbers: Point, value: Expr,
              damped: bool = False) -> Decision | None:
    """Return the decision at a value; None if the equilibrium does not exist there."""
    at = Point({**numbers, x: value})
    values = [evaluate(e, at) for e in report.equilibrium.existence()]
    if any(not ball(value, 64).is_finite() or proved_sign(value) != 1 for value in values):
        return None
    decision = report.verdict({s.name: number for s, number in at.items()}, damped)
    if any(sign_of_constant(margin) is None for _, margin in decision.margins):
        raise ScopeError(f"at {x} = {value} nothing is proved: {decision.reason}")
    return decision


def joined(cells: Sequence[Cell], wanted: bool | None = True) -> tuple[Interval, ...]:
    """Return cells that touch and are all stable, or all of another kind, as one interval each."""
    found: list[Interval] = []
    for low, high, stable in cells:
        if stable is not wanted:
            continue
        point = low == high
        last = found[-1] if found else None
        if last and last.high == low and (point or last.high_if):
            found[-1] = replace(last, high=high, high_if=INCLUDED if point else EXCLUDED)
        else:
            found.append(Interval(low, high, *([INCLUDED] * 2 if point else [EXCLUDED] * 2)))
    return tuple(found)


def joined_apart(cells: Sequence[Cell], turns: Sequence[Expr]) -> list[Interval]:
    """Return joined cells, but separated where the name turns.

    A turn belongs to both sides if it is stable.
    """
    runs: list[list[Cell]] = [[]]
    for cell in cells:
        runs[-1].append(cell)
        if cell[0] == cell[1] and cell[0] in turns:
            runs.append([cell])
    return [interval for run in runs for interval in joined(run)]
