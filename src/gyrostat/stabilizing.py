"""Which values of one parameter stabilise an equilibrium: in closed form, or exactly at numbers for all the others."""
import contextlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from sympy import Expr, Mul, Rational, S, Symbol, oo

from .algebra import Ring
from .conditions import Condition
from .equilibria import Equilibrium
from .errors import ScopeError, ValuesError
from .exact import Point, ball, evaluate, sign, sign_of_constant
from .expressions import exact_number, shown
from .families import inclined
from .intervals import EXCLUDED, INCLUDED, Case, Interval, Part, Solution
from .notation import jet, symbol
from .roots import real_roots
from .solve import solve_condition
from .sphere import sphere_of
from .stability import Report, Verdict, analyze
from .values import unknown


def stabilizing_set(report: Report, name: str, values: Mapping[str, Any] | None = None) -> Solution:
    """The exact set of one parameter for which an equilibrium exists and is stable, boundary points as the boundary criterion says.

    Without numbers, or with some: in closed form, with the cases of the other names. With a number for every other name: a union of
    intervals, whose ends are exact numbers. On E3 with the name eliminated (inclined(scene, eliminate=name)) and k3 left free: one
    interval for each family of tilts on which the name is monotone, k3 at its ends in Interval.tilt.

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
    ScopeError       the form is not one that is solved: give numbers for the other names; or U is not rational in k3
    ValuesError      a name is unknown, or a number is not admissible

    Examples
    --------
    >>> from gyrostat import analyze, assemble, symmetric_gyrostat, uniform_field, upright
    >>> report = analyze(upright(assemble(symmetric_gyrostat(), uniform_field())))
    >>> ((interval, other),) = (c.intervals for c in stabilizing_set(report, "l", {"I1": 1, "m0": 1, "pi3_0": 5}).parts[0].cases)
    >>> interval.high, interval.high_if, other.low
    (-7, (1,), -3)
    """
    numbers = Point({symbol(n): exact_number(x, n) for n, x in (values or {}).items()})
    eq, known = report.equilibrium, {*report.parameters, *report.required}
    if foreign := sorted({name, *(s.name for s in numbers)} - known):
        raise ValuesError(unknown(foreign[0], sorted(known), eq.label))
    if symbol(name) in numbers:
        raise ValuesError(f"{name} is solved for and given: leave out one of the two")
    left = [n for n in report.required if symbol(n) not in numbers and n != name]
    if eq.eliminated == name and left == ["k3"]:
        return Solution(name, (_along_tilts(report, name, numbers),))
    if eq.eliminated and (eq.eliminated == name or symbol(eq.eliminated) in numbers):
        if left:
            leave = f", or leave out {eq.eliminated}" if eq.eliminated != name else ""
            raise ScopeError(f"{eq.label} ties {eq.eliminated} to the other names: {name} is not solved for while {', '.join(left)} are "
                             f"open; give numbers for them{leave}")
        if (part := _where_tied(report, name, numbers)) is not None:
            return Solution(name, (part,))
    if not left and (report.boundary is None or report.boundary.last):     # a transcendental U is solved in closed form, or not at all
        with contextlib.suppress(ScopeError):              # a transcendental number, too
            cells = _cells(report, symbol(name), numbers, S.Zero if symbol(name).is_positive else None, None)
            return Solution(name, (Part("stable", S.One, (Case((), _joined(cells)),), eq.at),))
    return Solution(name, _in_symbols(report, name, numbers))


def _where_tied(report: Report, name: str, numbers: Point) -> Part | None:
    """The values that the relation of a family leaves, the eliminated name being given or solved for; None where it leaves all."""
    eq, x = report.equilibrium, symbol(name)
    relation = dict(eq.relations)[symbol(str(eq.eliminated))]
    if eq.eliminated == name:
        values = [evaluate(relation, numbers)]
    else:
        given = relation.xreplace(numbers) - numbers[symbol(str(eq.eliminated))]
        found = real_roots(given, x, S.Zero if x.is_positive else None)
        if found is None:
            return None
        values = found
    stable = [value for value in values if value.is_finite and _stable(report, x, value, numbers)]
    return Part("stable", S.One, (Case((), tuple(Interval(v, v, INCLUDED, INCLUDED) for v in stable)),), eq.at)


def _in_symbols(report: Report, name: str, numbers: Point) -> tuple[Part, ...]:
    """Existence and stability, each solved in closed form."""
    if numbers:
        report = inserted(report, {s.name: number for s, number in numbers.items()})
    eq = report.equilibrium
    tilted = eq.eliminated == "k3" and "omega" in report.parameters and analyze(inclined(eq.system))
    sufficient = tilted.sufficient if tilted and () in tilted.sufficient.alternatives else report.sufficient     # always, in terms of k3
    if len(sufficient.alternatives) != 1:
        raise ScopeError(f"{report.equilibrium.label} has {len(report.sufficient.alternatives)} alternatives for stability: give numbers")
    x, existence = symbol(name), eq.existence()
    fixed = [e for e in existence if x not in e.free_symbols and e.free_symbols]
    parts = [Part("exists", e, (Case(((e, ">"),), (Interval(-oo, oo),)),), eq.at) for e in fixed]
    parts += [replace(solve_condition(_plain(e, eq), name, None, fixed), meaning="exists") for e in existence if x in e.free_symbols]
    if not sufficient.alternatives[0]:
        parts.append(Part("stable", S.One, (Case((), (Interval(S.Zero if x.is_positive else -oo, oo),)),), eq.at))
    ends = report.boundary or sphere_of(eq)
    solved = (solve_condition(c, name, ends, fixed) for c in sufficient.alternatives[0])
    return *parts, *(_where_existing(part, x, existence) for part in solved)


def _where_existing(part: Part, x: Symbol, existence: Sequence[Expr]) -> Part:
    """Without the ends at which the equilibrium does not exist."""
    def outside(end: Expr) -> bool:
        return any(e.xreplace({x: end}) == 0 for e in existence if x in e.free_symbols)

    cases = []
    for case in part.cases:
        ends = (replace(i, low_if=EXCLUDED if outside(i.low) else i.low_if, high_if=EXCLUDED if outside(i.high) else i.high_if)
                for i in case.intervals)
        cases.append(replace(case, intervals=tuple(i for i in ends if i.low != i.high or i.low_if)))
    return replace(part, cases=tuple(cases))


def inserted(report: Report, numbers: Mapping[str, Expr]) -> Report:
    """The report with numbers in place of some of its names."""
    eq = report.equilibrium
    if jets := [name for name in numbers if jet(name)]:
        raise ValuesError(f"{jets[0]} is a derivative of U: give U itself, or ask for a verdict")
    if eq.eliminated in numbers:
        raise ValuesError(f"{eq.label} expresses {eq.eliminated} by the other names, {dict(eq.relations)[symbol(eq.eliminated)]}: "
                          f"leave out {eq.eliminated}")
    pairs = tuple((symbol(name), number) for name, number in numbers.items() if name in report.parameters)
    return analyze(_existing(replace(eq, relations=(*eq.relations, *pairs))))


def _existing(eq: Equilibrium) -> Equilibrium:
    for domain, value in zip(eq.domain, eq.existence()):
        if not value.free_symbols and sign_of_constant(value) != 1:
            raise ValuesError(f"{eq.label} exists only where {domain} > 0, here it is {shown(value)}: choose other numbers")
    return eq


def _plain(expression: Expr, eq: Equilibrium) -> Condition:
    ring = Ring([expression])
    top, bottom = ring.fraction(expression)
    return Condition(ring.expression(top * bottom), True, "existence", (), eq.at)


Cell = tuple[Expr, Expr, bool]                             # an open interval or a point, and whether it is stable there


def _cells(report: Report, x: Symbol, numbers: Point, low: Expr | None, high: Expr | None, also: Sequence[Expr] = ()) -> list[Cell]:
    """Between and at the roots of everything whose sign matters."""
    conditions = [c for criterion in (report.necessary, report.sufficient) for a in criterion.alternatives for c in a]
    expressions = [*(e for c in conditions for e in (c.margin, *c.degenerate)), *report.equilibrium.existence(), *also]
    placed = [e.xreplace(numbers) for e in expressions]
    polynomials = [f for e in placed if x in e.free_symbols for f in _numerators(e, x)]
    ends = real_roots(Mul(*polynomials), x, low, high) or []
    bounds: list[Expr] = [-oo if low is None else low, *ends, oo if high is None else high]
    cells: list[Cell] = []
    for n, (a, b) in enumerate(zip(bounds, bounds[1:])):
        if n:
            cells.append((a, a, _stable(report, x, a, numbers)))
        cells.append((a, b, _stable(report, x, _between(a, b), numbers)))
    return cells


def _numerators(expression: Expr, x: Symbol) -> list[Expr]:
    """Numerator and denominator, as far as they contain x."""
    ring = Ring([expression])
    parts = [ring.expression(ring.reduce(part)) for part in ring.fraction(expression)]
    return [part for part in parts if x in part.free_symbols]


def _stable(report: Report, x: Symbol, value: Expr, numbers: Point) -> bool:
    at = Point({**numbers, x: value})
    if any(sign_of_constant(evaluate(e, at)) != 1 for e in report.equilibrium.existence()):
        return False
    decision = report.verdict({s.name: number for s, number in at.items()})
    if decision.verdict is Verdict.UNDECIDED:
        raise ScopeError(f"at {x} = {value} nothing is proved: {decision.reason}")
    return decision.verdict is Verdict.STABLE


def _between(a: Expr, b: Expr) -> Rational:
    """A rational number between two exact ones, a short one."""
    if a == -oo and b == oo:
        return S.Zero
    if a == -oo or b == oo:
        edge = ball(b, 64).lower().floor() - 1 if a == -oo else ball(a, 64).upper().ceil() + 1
        return Rational(int(edge.unique_fmpz()))
    precision = 64
    while not (low := ball(a, precision).upper()) < ball(b, precision).lower():
        precision *= 2
    bits = 0
    while True:                                            # the first dyadic number that lies between
        bits += 1
        candidate = Rational(int((low * 2**bits).floor().unique_fmpz()) + 1, 2**bits)
        if sign_of_constant(candidate - a) == 1 and sign_of_constant(b - candidate) == 1:
            return candidate


def _joined(cells: Sequence[Cell]) -> tuple[Interval, ...]:
    """Stable cells that touch, as one interval."""
    found: list[Interval] = []
    for low, high, stable in cells:
        if not stable:
            continue
        point = low == high
        last = found[-1] if found else None
        if last and last.high == low and (point or last.high_if):
            found[-1] = replace(last, high=high, high_if=INCLUDED if point else EXCLUDED)
        else:
            found.append(Interval(low, high, *([INCLUDED] * 2 if point else [EXCLUDED] * 2)))
    return tuple(found)


def _along_tilts(report: Report, name: str, numbers: Point) -> Part:
    """The stable tilts, and the name along each run of them on which it is monotone."""
    k3 = symbol("k3")
    value = dict(report.equilibrium.relations)[symbol(name)].xreplace(numbers)
    turning = value.diff(k3)
    cells = _cells(report, k3, numbers, S.NegativeOne, S.One, [turning] if turning.free_symbols else [])
    if turning == 0:
        raise ScopeError(f"{name} is the same for every tilt: {value}; ask at that value for all equilibria (relative_equilibria)")
    intervals = []
    for run in _joined_between(cells, [low for low, high, _ in cells if low == high and _vanishes(turning, k3, low)]):
        grows = sign(turning, {k3: _between(run.low, run.high)}) == 1 if run.low != run.high else True
        ends = [(_limit(value, k3, k, side if grows else -side), included, k)
                for k, included, side in ((run.low, run.low_if, -1), (run.high, run.high_if, 1))]
        if not grows:
            ends.reverse()
        (a, a_if, ka), (b, b_if, kb) = ends
        intervals.append(Interval(a, b, a_if, b_if, (ka, kb)))
    return Part("stable", S.One, (Case((), tuple(intervals)),), report.equilibrium.at)


def _limit(value: Expr, x: Symbol, end: Expr, side: int) -> Expr:
    """The value at an end of a run, infinite where it has a pole."""
    there = evaluate(value, {x: end})
    return there if there.is_finite else side * oo


def _vanishes(expression: Expr, x: Symbol, value: Expr) -> bool:
    return sign(expression, {x: value}) == 0


def _joined_between(cells: Sequence[Cell], turns: Sequence[Expr]) -> list[Interval]:
    """As _joined, but separated where the name turns; a turn belongs to both sides if it is stable."""
    runs: list[list[Cell]] = [[]]
    for cell in cells:
        runs[-1].append(cell)
        if cell[0] == cell[1] and cell[0] in turns:
            runs.append([cell])
    return [interval for run in runs for interval in _joined(run)]
