"""A condition solved for one parameter in closed form: linear, quadratic, or quadratic in its square, with the cases of the others."""
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice

from sympy import Expr, Mul, Pow, S, Symbol, oo, sqrt

from .algebra import Ring, by_degree
from .boundary import Boundary
from .conditions import Condition
from .errors import ScopeError
from .families import affine
from .intervals import EXCLUDED, INCLUDED, Case, Interval, Ladder, Part
from .notation import symbol
from .signs import Signs

RUNGS = 3                                              # of the ladder of an unspecified U
Relations = tuple[tuple[Expr, str], ...]


def solve_condition(condition: Condition, name: str, boundary: Boundary | None = None, domain: Sequence[Expr] = ()) -> Part:
    """The exact set of one parameter where a strict condition holds, and of its ends those that the boundary criterion calls stable.

    Parameters
    ----------
    condition : Condition
    name : str                     it enters the margin by degree at most 2, or quadratically by its square
    boundary : Boundary or None    decides the ends, where the margin vanishes; None: they are left out
    domain : sequence of Expr      positive, without the name

    Returns
    -------
    Part                           with the cases of the other parameters

    Raises
    ------
    ScopeError                     the margin is of another form: give numbers (stabilising_set)

    Source
    ------
    The quadratic formula; the ends, Boundary.

    Examples
    --------
    >>> from gyrostat import analyze, assemble, symmetric_gyrostat, uniform_field, upright
    >>> report = analyze(upright(assemble(symmetric_gyrostat(), uniform_field())))
    >>> for case in solve_condition(report.sufficient.alternatives[0][0], "l", report.boundary).cases:
    ...     print(case.when, [(i.low, i.low_if, i.high, i.high_if) for i in case.intervals])
    ((m0, '<'),) [(-oo, (), oo, ())]
    ((m0, '='),) [(-oo, (), -pi3_0, ()), (-pi3_0, (), oo, ())]
    ((m0, '>'),) [(-oo, (), -2*sqrt(I1)*sqrt(m0) - pi3_0, (1,)), (2*sqrt(I1)*sqrt(m0) - pi3_0, (1,), oo, ())]
    """
    x = symbol(name)
    if condition.degenerate:
        raise ScopeError(f"{condition.margin} > 0 fails too where {', '.join(map(str, condition.degenerate))} = 0: give numbers")
    coefficients = _coefficients(condition.margin, x)
    start = _Context(x, boundary, tuple(e for e in domain if x not in e.free_symbols))
    if x.is_positive and len(coefficients) > 2:
        raise ScopeError(f"{condition.margin} is not linear in {name}, which is positive: give numbers for the other names")
    if len(coefficients) == 5 and coefficients[1] == coefficients[3] == 0:
        cases = _biquadratic(start, *coefficients[::-2])
    elif len(coefficients) <= 3:
        cases = _quadratic(start, *[S.Zero] * (3 - len(coefficients)), *coefficients[::-1])
    else:
        raise ScopeError(f"{condition.margin} has degree {len(coefficients) - 1} in {name}: give numbers for the other names, then its "
                         "roots are those of a polynomial")
    return Part("stable", condition.margin, tuple(cases))


@dataclass(frozen=True)
class _Context:
    """What is known where a case is worked out."""

    x: Symbol
    boundary: Boundary | None
    domain: tuple[Expr, ...]
    when: Relations = ()
    inserted: tuple[tuple[Symbol, Expr], ...] = ()

    def signs(self, expression: Expr) -> Iterator[tuple[int, "_Context"]]:
        """Each sign the expression may have, with what is known then."""
        value = self.insert(expression)
        ring = Ring([value, *self.domain])
        known = Signs(ring, self.domain)
        margin, even = known.split(*ring.fraction(value))
        sign = known.of(margin)
        if sign is not None and not even:
            yield sign, self
            return
        plain, factors = ring.expression(margin), Mul(*map(ring.expression, even))
        if sign is not None:                               # of one sign, or 0 where an even factor is
            yield 0, self._vanishing(factors)
            yield sign, self._with((factors, "!="), factors**2)
            return
        whole = plain * factors**2
        yield -1, self._with((whole, "<"), -whole)
        yield 0, self._vanishing(plain * factors)
        yield 1, self._with((whole, ">"), whole)

    def _with(self, relation: tuple[Expr, str], positive: Expr) -> "_Context":
        expression, compared = relation
        if expression.could_extract_minus_sign():
            relation = -expression, {"<": ">", ">": "<"}.get(compared, compared)
        return replace(self, domain=(*self.domain, positive), when=(*self.when, relation))

    def insert(self, expression: Expr) -> Expr:
        for name, value in self.inserted:
            expression = expression.xreplace({name: value})
        return expression

    def _vanishing(self, expression: Expr) -> "_Context":
        """Where an expression is 0, solved for a parameter it is affine in, if there is one."""
        when = (*self.when, (-expression if expression.could_extract_minus_sign() else expression, "="))
        for s in sorted(expression.free_symbols - {self.x}, key=lambda s: (bool(s.is_positive), s.name)):
            if not (solved := affine(expression, s)):
                continue
            ring = Ring([*solved, *self.domain])
            known = Signs(ring, self.domain)
            value, slope = (ring.fraction(e) for e in solved)
            if known.nonzero(slope[0]) and (not s.is_positive or known.of(value[0]) == 1 == known.of(value[1])):
                domain = tuple(e.xreplace({s: solved[0]}) for e in self.domain)
                inserted = (*self.inserted, (s, solved[0]))
                return replace(self, when=when, domain=tuple(e for e in domain if e.free_symbols), inserted=inserted)
        return replace(self, when=when)

    def ladder(self, end: Expr) -> Ladder:
        """When the end belongs to the set: the rungs of the boundary there, as far as their signs are not known."""
        if self.boundary is None:
            return EXCLUDED
        rungs: list[Expr] = []
        highest = RUNGS if self.boundary.last is None else None
        for rung in islice(self.boundary.rungs(), highest):
            value = Mul(rung.condition.margin, *(e**2 for e in rung.condition.degenerate))
            value = self.insert((-(value**2) if rung.escapes else value).xreplace({self.x: end}))
            ring = Ring([value, *self.domain])
            known = Signs(ring, self.domain)
            margin, even = known.split(*ring.fraction(value))
            if margin and not even and (sign := known.of(margin)):
                rungs.append(S.One * sign)
                break
            if margin:
                rungs.append(Mul(ring.expression(margin), *(ring.expression(e) ** 2 for e in even)))
        while rungs and rungs[-1] == -1:
            rungs.pop()
        return tuple(rungs)

    def case(self, *intervals: Interval) -> Case:
        lower = S.Zero if self.x.is_positive else -oo
        return Case(self.when, tuple(replace(i, low=lower) if i.low == -oo else i for i in intervals))

    def everywhere(self) -> Case:
        return self.case(Interval(-oo, oo))

    def beyond(self, low: Expr, high: Expr) -> Case:
        """Outside low ≤ x ≤ high, and the ends where they are decided so."""
        return self.case(Interval(-oo, low, EXCLUDED, self.ladder(low)), Interval(high, oo, self.ladder(high), EXCLUDED))

    def root(self, expression: Expr) -> Expr:
        """√ of what is positive, with the squares that are known to be positive taken out."""
        value = self.insert(expression)
        ring = Ring([value, *self.domain])
        known = Signs(ring, self.domain)
        outside, inside = S.One, S.One
        for polynomial, side in zip(ring.fraction(value), (1, -1)):
            content, factors = polynomial.factor()
            inside *= ring.expression(ring.one * content) ** side
            for factor, n in factors:
                out = int(n) // 2 if known.of(factor) == 1 else 0
                outside *= Pow(ring.expression(factor), side * out)
                inside *= Pow(ring.expression(factor), side * (int(n) - 2 * out))
        return outside * sqrt(inside)


def _coefficients(margin: Expr, x: Symbol) -> list[Expr]:
    """Coefficients of x⁰, x¹, …"""
    ring = Ring([margin, x])
    if any(x in g.free_symbols for g in ring.generators if g != x):
        raise ScopeError(f"{margin} is not polynomial in {x}: give numbers for the other names")
    top, place = ring.fraction(margin)[0], ring.generators.index(x)
    return [ring.expression(c) for c in by_degree(top, place, top.degrees()[place])]


def _quadratic(context: _Context, a: Expr, b: Expr, c: Expr) -> Iterator[Case]:
    for sign, known in context.signs(a):
        if sign == 0:
            yield from _linear(known, b, c)
            continue
        for real, k in known.signs(b**2 - 4 * a * c):
            if real < 0:
                yield k.everywhere() if sign > 0 else k.case()
                continue
            ends = _over(k, -b, S.Zero, 2 * a)
            if real == 0:
                at_end = k.ladder(ends)
                yield k.beyond(ends, ends) if sign > 0 else k.case(*[Interval(ends, ends, at_end, at_end)] if at_end else [])
                continue
            root = k.root(b**2 - 4 * a * c)
            low, high = _over(k, -b, -sign * root, 2 * a), _over(k, -b, sign * root, 2 * a)
            yield k.beyond(low, high) if sign > 0 else k.case(Interval(low, high, k.ladder(low), k.ladder(high)))


def _linear(context: _Context, b: Expr, c: Expr) -> Iterator[Case]:
    for sign, known in context.signs(b):
        if sign == 0:
            for constant, k in known.signs(c):
                ladder = k.ladder(k.x) if constant == 0 else INCLUDED if constant > 0 else EXCLUDED
                for rung, deeper in _first_of(k, ladder):
                    yield deeper.everywhere() if rung else deeper.case()
            continue
        end = _over(known, -c, S.Zero, b)
        positions = known.signs(end) if known.x.is_positive else [(1, known)]
        for position, k in positions:
            if position > 0:
                yield k.case(Interval(end, oo, k.ladder(end), EXCLUDED) if sign > 0 else Interval(-oo, end, EXCLUDED, k.ladder(end)))
            else:
                yield k.everywhere() if sign > 0 else k.case()


def _first_of(context: _Context, ladder: Ladder) -> Iterator[tuple[bool, _Context]]:
    """Whether the first of the ladder that is not 0 is positive, case by case."""
    if not ladder:
        yield False, context
        return
    for sign, known in context.signs(ladder[0]):
        if sign:
            yield sign > 0, known
        else:
            yield from _first_of(known, ladder[1:])


def _biquadratic(context: _Context, a: Expr, b: Expr, c: Expr) -> Iterator[Case]:
    """a x⁴ + b x² + c > 0 with a > 0 and c ≥ 0, by y = x²."""
    for constant, inner in context.signs(c):
        for slope, k in inner.signs(b):
            if constant < 0 or [sign for sign, _ in k.signs(a)] != [1]:
                raise ScopeError(f"{a}*x**4 + {b}*x**2 + {c} has a coefficient that may be negative: give numbers for the other names")
            if slope >= 0:                                 # no root y > 0
                yield k.everywhere() if constant else k.beyond(S.Zero, S.Zero)
            elif not constant:
                end = sqrt(_over(k, -b, S.Zero, a))
                yield k.case(Interval(-oo, -end, EXCLUDED, k.ladder(-end)), *_point(S.Zero, k.ladder(S.Zero)),
                             Interval(end, oo, k.ladder(end), EXCLUDED))
            else:
                yield from _two_squares(k, a, b, c)


def _two_squares(context: _Context, a: Expr, b: Expr, c: Expr) -> Iterator[Case]:
    """b < 0 < c: both roots y are positive, where they are real."""
    for real, k in context.signs(b**2 - 4 * a * c):
        if real < 0:
            yield k.everywhere()
            continue
        root = k.root(b**2 - 4 * a * c) if real else S.Zero
        inner, outer = (sqrt(_over(k, -b, s * root, 2 * a)) for s in (-1, 1))
        middle = Interval(-inner, inner, k.ladder(-inner), k.ladder(inner))
        yield k.case(Interval(-oo, -outer, EXCLUDED, k.ladder(-outer)), middle, Interval(outer, oo, k.ladder(outer), EXCLUDED))


def _point(end: Expr, ladder: Ladder) -> list[Interval]:
    return [Interval(end, end, ladder, ladder)] if ladder else []


def _over(context: _Context, plain: Expr, root: Expr, bottom: Expr) -> Expr:
    """(plain + root)/bottom, each part in lowest terms."""
    parts = []
    for top in (plain, root):
        value = context.insert(top) / context.insert(bottom)
        ring = Ring([value])
        parts.append(ring.quotient(*ring.fraction(value)))
    return parts[0] + parts[1]
