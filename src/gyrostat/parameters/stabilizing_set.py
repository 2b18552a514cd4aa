"""Finds the values of one parameter that stabilise an equilibrium: in closed form, or exactly at numbers."""
import contextlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from sympy import Expr, S, Symbol, oo

from ..algebra.reals.exact import Point, evaluate, is_identically_zero, sign
from ..algebra.rings.polynomials import Ring
from ..algebra.solving.roots import real_roots
from ..algebra.text.numbers import exact_number, shown
from ..arguments import checked
from ..errors import ScopeError, ValuesError
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..mechanics.equilibrium.unit_vectors import in_any_direction
from ..mechanics.families.tilted import inclined
from ..notation import jet, symbol
from ..stability.criteria.conditions import Condition
from ..stability.criteria.numbers_asked import left_open, refuse_any_direction, unknown
from ..stability.report.analysis import analyze
from ..stability.report.report import Report
from .line_decomposition import cut, joined, stable_at
from .sets import EXCLUDED, INCLUDED, Case, Interval, Solution, SolvedCondition
from .solve import CLOSED, solve_condition
from .stable_tilts import along_tilts


@checked
def stabilizing_set(report: Report, name: str, values: Mapping[str, Any] | None = None) -> Solution:
    """Return the exact set of one parameter for which an equilibrium exists and is stable.

    Boundary points are in it as the boundary criterion says. If nothing decides between the necessary and the
    sufficient condition, as for an asymmetric body in a field, the set is given as far as it is proved: parts
    that are sufficient, parts that are necessary, values that are undecided (SolvedCondition.meaning).

    Without numbers, or with some, it is solved in closed form, with the cases of the other names. With a
    number for every other name it is a union of intervals, whose ends are exact numbers. On E3 with the name
    eliminated (inclined(scene, eliminate=name)) and k3 left free, there is one interval for each family of
    tilts on which the name is monotone, k3 at its ends in Interval.tilt; with the eliminated name given too,
    the set consists of the points that the relation leaves.

    Parameters
    ----------
    report : Report
    name : str
    values : mapping of name to number

    Returns
    -------
    Solution

    Raises
    ------
    ScopeError
        the form is not one that is solved: give numbers for the other names; or U is not rational in k3
    ValuesError
        a name is unknown, or a number is not admissible

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> given = {"I1": 1, "m0": 1, "pi3_0": 5}
    >>> solution = gs.stabilizing_set(report, "l", given)
    >>> (interval, other) = solution.parts[0].cases[0].intervals
    >>> interval.high, interval.high_if, other.low
    (-7, (1,), -3)
    """
    numbers = Point({symbol(n): exact_number(x, n) for n, x in (values or {}).items()})
    eq, known = report.equilibrium, {*report.parameters, *report.required}
    refuse_any_direction(eq)
    if eq.system.potential is not None:
        eq.system.potential.check_size(numbers)
    if foreign := sorted({name, *(s.name for s in numbers)} - known):
        raise ValuesError(unknown(foreign[0], sorted(known), eq.label))
    if symbol(name) in numbers:
        raise ValuesError(f"{name} is solved for and given: leave out one of the two")
    left = [n for n in left_open(report.required, numbers) if n != name]
    tied = [n for n in eq.eliminated if n == name or symbol(n) in numbers]
    if tied and len(eq.eliminated) > 1:
        raise ScopeError(f"{eq.label} expresses {', '.join(eq.eliminated)} by the other names: leave out "
                         f"{', '.join(tied)}, and solve for one of the others")
    if tied == [name] and "k3" in left:                    # its relation needs all other names
        relation = dict(eq.relations)[symbol(name)]
        left = sorted({*left, *left_open((s.name for s in relation.free_symbols), numbers)})
    if tied == [name] and left == ["k3"]:
        return Solution(name, (along_tilts(report, name, numbers),))
    if tied:
        if left:
            needed = ", ".join(n for n in left if n != "k3" or tied != [name])
            leave = ""
            if tied != [name]:
                leave = f", or leave out {tied[0]}"
            elif "k3" in left:
                leave = "; k3 may stay open"
            raise ScopeError(f"{eq.label} ties {tied[0]} to the other names: {name} is not solved "
                             f"for while {', '.join(left)} are open; give "
                             f"{'a number' if ',' not in needed else 'numbers'} for {needed}{leave}")
        if (parts := _where_tied(report, symbol(tied[0]), name, numbers)) is not None:
            return Solution(name, parts)
    if left:
        return Solution(name, _in_symbols(report, name, numbers))
    try:
        return Solution(name, _in_numbers(report, name, numbers))
    except ScopeError as failed:                           # a transcendental number or U: in closed form
        with contextlib.suppress(ScopeError):
            return Solution(name, _in_symbols(report, name, numbers))
        raise failed from None


def _in_numbers(report: Report, name: str, numbers: Point) -> tuple[SolvedCondition, ...]:
    """Return the set at numbers for all other names: the line of this one, cut where verdicts may change."""
    if report.boundary is not None and not report.boundary.last:
        raise ScopeError(f"U is not rational in k3, and {name} is not solved for in closed form: ask for a "
                         "verdict, or a chart")
    x, at = symbol(name), report.equilibrium.at
    cells = cut(report, x, numbers, S.Zero if x.is_positive else None, None)
    return _decided(joined(cells), joined(cells, None), at)


def _decided(stable: tuple[Interval, ...], undecided: tuple[Interval, ...],
             at: Expr) -> tuple[SolvedCondition, ...]:
    """Return what is stable, and, if there are any, the values for which nothing is proved."""
    parts = (SolvedCondition("stable", S.One, (Case((), stable),), at),
             SolvedCondition("undecided", S.One, (Case((), undecided),), at))
    return parts if undecided else parts[:1]


def _where_tied(report: Report, tied: Symbol, name: str,
                numbers: Point) -> tuple[SolvedCondition, ...] | None:
    """Return the values that the relation of a family leaves, the eliminated name given or solved for.

    None if it leaves all.
    """
    eq, x = report.equilibrium, symbol(name)
    relation = dict(eq.relations)[tied]
    if tied == x:
        values = [evaluate(relation, numbers)]
    else:
        given = relation.xreplace(numbers) - numbers[tied]
        found = real_roots(given, x, S.Zero if x.is_positive else None)
        if found is None:
            return None
        values = found
    stable = [(value, stable_at(report, x, value, numbers)) for value in values if value.is_finite]
    proved, open_ = (tuple(Interval(v, v, INCLUDED, INCLUDED) for v, known in stable if known is wanted)
                     for wanted in (True, None))
    return _decided(proved, open_, eq.at)


def _in_symbols(report: Report, name: str, numbers: Point) -> tuple[SolvedCondition, ...]:
    """Return existence and stability, each solved in closed form."""
    if numbers:
        report = inserted(report, {s.name: number for s, number in numbers.items()})
    report, eq = report.written_out, report.equilibrium
    tilted = "k3" in eq.eliminated and "omega" in report.parameters and analyze(inclined(eq.system))
    # E3 may be stable always, in terms of k3
    sufficient = tilted.sufficient if tilted and () in tilted.sufficient.alternatives else report.sufficient
    ends = report.between
    if len(sufficient.alternatives) > 1 or ends and not sufficient.alternatives:
        raise ScopeError(f"{eq.label} has {len(sufficient.alternatives)} alternatives for stability: give "
                         "numbers for the other names")
    x, existence = symbol(name), eq.existence()
    fixed = [e for e in existence if x not in e.free_symbols and e.free_symbols]
    parts = [SolvedCondition("exists", e, (Case(((e, ">"),), (Interval(-oo, oo),)),), eq.at) for e in fixed]
    parts += [replace(solve_condition(_plain(e, eq), name, None, fixed), meaning="exists")
              for e in existence if x in e.free_symbols]
    if not sufficient.alternatives:
        parts.append(SolvedCondition("sufficient", -S.One, (Case((), ()),), eq.at))
    elif not sufficient.alternatives[0]:
        everywhere = Interval(S.Zero if x.is_positive else -oo, oo)
        parts.append(SolvedCondition("stable", S.One, (Case((), (everywhere,)),), eq.at))
    else:
        solved = (solve_condition(c, name, ends, fixed) for c in sufficient.alternatives[0])
        parts += [replace(part, meaning="stable" if ends else "sufficient") for part in solved]
    if not ends and () not in sufficient.alternatives:
        parts += _necessary(report, name, fixed)
    return tuple(part if part.meaning == "exists" else _where_existing(part, x, existence) for part in parts)


def _necessary(report: Report, name: str, fixed: Sequence[Expr]) -> Iterator[SolvedCondition]:
    """Yield the necessary conditions as far as they are solved for; one that is not says nothing."""
    if not report.necessary.alternatives:
        yield SolvedCondition("necessary", -S.One, (Case((), ()),), report.equilibrium.at)
    for condition in (c for a in report.necessary.alternatives[:1] for c in a):
        with contextlib.suppress(ScopeError):
            yield replace(solve_condition(condition, name, CLOSED, fixed), meaning="necessary")


def _where_existing(part: SolvedCondition, x: Symbol, existence: Sequence[Expr]) -> SolvedCondition:
    """Return the part without the ends at which the equilibrium does not exist."""
    def outside(end: Expr) -> bool:
        return any(is_identically_zero(e.xreplace({x: end}))
                   for e in existence if x in e.free_symbols and end.is_finite)

    cases = []
    for case in part.cases:
        ends = (replace(i, low_if=EXCLUDED if outside(i.low) else i.low_if,
                        high_if=EXCLUDED if outside(i.high) else i.high_if)
                for i in case.intervals)
        cases.append(replace(case, intervals=tuple(i for i in ends if i.low != i.high or i.low_if)))
    return replace(part, cases=tuple(cases))


def inserted(report: Report, numbers: Mapping[str, Expr]) -> Report:
    """Return the report with numbers in place of some of its names."""
    eq = report.equilibrium
    if in_any_direction(eq) and {"k1", "k2", "k3"} & numbers.keys():
        raise ValuesError(f"{eq.label} has the names k1, k2, k3 with |k| = 1: give a direction in place of "
                          "numbers for them, permanent_rotation(scene, direction), --direction K1,K2,K3")
    if jets := [name for name in numbers if jet(name)]:
        raise ValuesError(f"{jets[0]} is a derivative of U: give U itself, or ask for a verdict")
    if tied := [name for name in eq.eliminated if name in numbers]:
        raise ValuesError(f"{eq.label} expresses {tied[0]} by the other names, "
                          f"{dict(eq.relations)[symbol(tied[0])]}: leave out {tied[0]}")
    pairs = tuple((symbol(name), number) for name, number in numbers.items() if name in report.parameters)
    return analyze(_existing(replace(eq, relations=(*eq.relations, *pairs))))


def _existing(eq: Equilibrium) -> Equilibrium:
    for domain, value in zip(eq.domain, eq.existence()):
        if not value.free_symbols and (known := sign(value, {})) != 1:
            unknown = ", not proved to be positive" if known is None else ""
            raise ValuesError(f"{eq.label} exists only where {domain} > 0, here it is "
                              f"{shown(value)}{unknown}: choose other numbers")
    return eq


def _plain(expression: Expr, eq: Equilibrium) -> Condition:
    ring = Ring([expression])
    top, bottom = ring.fraction(expression)
    return Condition(ring.expression(top * bottom), True, "existence", (), eq.at)
