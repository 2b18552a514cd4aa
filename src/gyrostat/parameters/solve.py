"""Solves a condition for one parameter in closed form, with the cases of the others.

The condition is linear, quadratic, or quadratic in the square of the parameter.
"""
from collections.abc import Iterator, Sequence

from sympy import Expr, S, Symbol, oo, sqrt

from ..algebra.rings.polynomials import Ring, by_degree
from ..algebra.text.numbers import exact_expression
from ..arguments import checked
from ..errors import ScopeError
from ..notation import symbol
from ..stability.criteria.conditions import Condition
from ..stability.deciders import Ends
from .cases import Closed, Context
from .sets import EXCLUDED, INCLUDED, Case, Interval, Ladder, SolvedCondition

CLOSED = Closed()


@checked
def solve_condition(condition: Condition, name: str, boundary: Ends | None = None,
                    domain: Sequence[Expr] = ()) -> SolvedCondition:
    """Return the exact set of one parameter where a strict condition holds.

    Those of its ends belong to it that the boundary criterion calls stable.

    Parameters
    ----------
    condition : Condition
    name : str
        it enters the margin by degree at most 2, or quadratically by its square
    boundary : Boundary, MomentumSphere, CLOSED or None
        decides the ends, where the margin vanishes; CLOSED: all belong to it; default: none
    domain : sequence of Expr
        positive, without the name

    Returns
    -------
    SolvedCondition
        with the cases of the other parameters

    Raises
    ------
    ScopeError
        the margin is of another form: give numbers (stabilizing_set)

    References
    ----------
    The quadratic formula; for the ends, Boundary.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    >>> report = gs.analyze(gs.upright(top))
    >>> condition = report.sufficient.alternatives[0][0]
    >>> solved = gs.solve_condition(condition, "l", report.boundary)
    >>> for case in solved.cases:
    ...     print(case.when)
    ...     for i in case.intervals:
    ...         print("   ", i.low, i.low_if, i.high, i.high_if)
    ((m0, '<'),)
        -oo () oo ()
    ((m0, '='),)
        -oo () -pi3_0 ()
        -pi3_0 () oo ()
    ((m0, '>'),)
        -oo () -2*sqrt(I1)*sqrt(m0) - pi3_0 (1,)
        2*sqrt(I1)*sqrt(m0) - pi3_0 (1,) oo ()
    """
    x, domain = symbol(name), [exact_expression(e, name) for e in domain]
    if condition.degenerate:
        raise ScopeError(f"{condition.margin} > 0 also fails if "
                         f"{', '.join(map(str, condition.degenerate))} = 0, and is not solved in closed "
                         "form: give numbers")
    coefficients = _coefficients(condition.margin, x)
    start = Context(x, boundary, tuple(e for e in domain if x not in e.free_symbols))
    if x.is_positive and len(coefficients) > 2:
        raise ScopeError(f"{condition.margin} is not linear in {name}, which is positive: give numbers for "
                         "the other names")
    if len(coefficients) == 5 and coefficients[1] == coefficients[3] == 0:
        cases = _biquadratic(start, *coefficients[::-2])
    elif len(coefficients) <= 3:
        cases = _quadratic(start, *[S.Zero] * (3 - len(coefficients)), *coefficients[::-1])
    else:
        raise ScopeError(f"{condition.margin} has degree {len(coefficients) - 1} in {name}, and is solved in "
                         "closed form up to degree 2, or without odd powers up to degree 4: give "
                         "numbers for the other names")
    return SolvedCondition("stable", condition.margin, tuple(cases), condition.at)


def _coefficients(margin: Expr, x: Symbol) -> list[Expr]:
    """Return the coefficients of x⁰, x¹ and so on."""
    ring = Ring([margin, x])
    if any(x in g.free_symbols for g in ring.generators if g != x):
        raise ScopeError(f"{margin} is not polynomial in {x}: give numbers for the other names")
    top, place = ring.fraction(margin)[0], ring.generators.index(x)
    return [ring.expression(c) for c in by_degree(top, place, top.degrees()[place])]


def _quadratic(context: Context, a: Expr, b: Expr, c: Expr) -> Iterator[Case]:
    for sign, known in context.signs(a):
        if sign == 0:
            yield from _linear(known, b, c)
            continue
        for real, k in known.signs(b**2 - 4 * a * c):
            if real < 0:
                yield k.everywhere() if sign > 0 else k.case()
                continue
            ends = k.over(-b, S.Zero, 2 * a)
            if real == 0:
                yield k.beyond(ends, ends) if sign > 0 else k.case(*_point(ends, k.ladder(ends)))
                continue
            root = k.root(b**2 - 4 * a * c)
            low, high = k.over(-b, -sign * root, 2 * a), k.over(-b, sign * root, 2 * a)
            if sign > 0:
                yield k.beyond(low, high)
            else:
                yield k.case(Interval(low, high, k.ladder(low), k.ladder(high)))


def _linear(context: Context, b: Expr, c: Expr) -> Iterator[Case]:
    for sign, known in context.signs(b):
        if sign == 0:
            for constant, k in known.signs(c):
                ladder = k.ladder(k.x) if constant == 0 else INCLUDED if constant > 0 else EXCLUDED
                for rung, deeper in _first_of(k, ladder):
                    yield deeper.everywhere() if rung else deeper.case()
            continue
        end = known.over(-c, S.Zero, b)
        positions = known.signs(end) if known.x.is_positive else [(1, known)]
        for position, k in positions:
            if position > 0:
                yield k.case(Interval(end, oo, k.ladder(end), EXCLUDED) if sign > 0
                             else Interval(-oo, end, EXCLUDED, k.ladder(end)))
            else:
                yield k.everywhere() if sign > 0 else k.case()


def _first_of(context: Context, ladder: Ladder) -> Iterator[tuple[bool, Context]]:
    """Yield case by case whether the first of the ladder that is not 0 is positive."""
    if not ladder:
        yield False, context
        return
    for sign, known in context.signs(ladder[0]):
        if sign:
            yield sign > 0, known
        else:
            yield from _first_of(known, ladder[1:])


def _biquadratic(context: Context, a: Expr, b: Expr, c: Expr) -> Iterator[Case]:
    """Solve a x⁴ + b x² + c > 0 with a > 0 and c ≥ 0, by y = x²."""
    for constant, inner in context.signs(c):
        for slope, k in inner.signs(b):
            if constant < 0 or [sign for sign, _ in k.signs(a)] != [1]:
                raise ScopeError(f"{a}*x**4 + {b}*x**2 + {c} has a coefficient that may be negative: give "
                                 "numbers for the other names")
            if slope >= 0:                                 # no root y > 0
                yield k.everywhere() if constant else k.beyond(S.Zero, S.Zero)
            elif not constant:
                end = sqrt(k.over(-b, S.Zero, a))
                yield k.case(Interval(-oo, -end, EXCLUDED, k.ladder(-end)), *_point(S.Zero, k.ladder(S.Zero)),
                             Interval(end, oo, k.ladder(end), EXCLUDED))
            else:
                yield from _two_squares(k, a, b, c)


def _two_squares(context: Context, a: Expr, b: Expr, c: Expr) -> Iterator[Case]:
    """Solve it for b < 0 < c: both roots y are positive, if they are real."""
    for real, k in context.signs(b**2 - 4 * a * c):
        if real < 0:
            yield k.everywhere()
            continue
        root = k.root(b**2 - 4 * a * c) if real else S.Zero
        inner, outer = (sqrt(k.over(-b, s * root, 2 * a)) for s in (-1, 1))
        middle = Interval(-inner, inner, k.ladder(-inner), k.ladder(inner))
        yield k.case(Interval(-oo, -outer, EXCLUDED, k.ladder(-outer)), middle,
                     Interval(outer, oo, k.ladder(outer), EXCLUDED))


def _point(end: Expr, ladder: Ladder) -> list[Interval]:
    return [Interval(end, end, ladder, ladder)] if ladder else []
