"""Distinguishes cases of the other parameters while a condition is solved for one.

A case knows what is positive in it, and which ends belong to the set.
"""
from collections.abc import Iterator
from dataclasses import dataclass, replace

from sympy import Expr, Mul, Pow, S, Symbol, oo, sqrt

from ..algebra.rings.polynomials import lowest_terms
from ..algebra.solving.margins import Signs
from ..mechanics.equilibrium.relations import affine
from ..stability.deciders import Ends
from .sets import EXCLUDED, INCLUDED, Case, Interval, Ladder

RUNGS = 3                                              # of the ladder of an unspecified U
Relations = tuple[tuple[Expr, str], ...]


class Closed:
    """The ends of a condition that is not strict: every end belongs to the set."""

    def ladder(self, limit: int | None = None) -> Ladder:
        """Return the ladder whose first rung is positive."""
        return INCLUDED


@dataclass(frozen=True)
class Context:
    """What is known in the case that is worked out."""

    x: Symbol
    boundary: Ends | None
    domain: tuple[Expr, ...]
    when: Relations = ()
    inserted: tuple[tuple[Symbol, Expr], ...] = ()

    def signs(self, expression: Expr) -> Iterator[tuple[int, "Context"]]:
        """Yield each sign the expression may have, with what is known then."""
        value = self.insert(expression)
        known = Signs.over([value], self.domain)
        margin, even = known.margin(value)
        sign = known.of(margin)
        if sign is not None and not even:
            yield sign, self
            return
        plain, factors = known.ring.expression(margin), Mul(*map(known.ring.expression, even))
        if sign is not None:                               # of one sign, but 0 where an even factor is 0
            yield 0, self._vanishing(factors)
            yield sign, self._with((factors, "!="), factors**2)
            return
        whole = plain * factors**2
        yield -1, self._with((whole, "<"), -whole)
        yield 0, self._vanishing(plain * factors)
        yield 1, self._with((whole, ">"), whole)

    def _with(self, relation: tuple[Expr, str], positive: Expr) -> "Context":
        expression, compared = relation
        if expression.could_extract_minus_sign():
            relation = -expression, {"<": ">", ">": "<"}.get(compared, compared)
        return replace(self, domain=(*self.domain, positive), when=(*self.when, relation))

    def insert(self, expression: Expr) -> Expr:
        for name, value in self.inserted:
            expression = expression.xreplace({name: value})
        return expression

    def _vanishing(self, expression: Expr) -> "Context":
        """Return the case in which an expression is 0, solved for a parameter if it is affine in one."""
        when = (*self.when, (-expression if expression.could_extract_minus_sign() else expression, "="))
        for s in sorted(expression.free_symbols - {self.x}, key=lambda s: (bool(s.is_positive), s.name)):
            if not (solved := affine(expression, s)):
                continue
            known = Signs.over(solved, self.domain)
            value, slope = map(known.ring.fraction, solved)
            if known.nonzero(slope[0]) and (not s.is_positive
                                            or known.of(value[0]) == 1 == known.of(value[1])):
                domain = tuple(e.xreplace({s: solved[0]}) for e in self.domain)
                inserted = (*self.inserted, (s, solved[0]))
                return replace(self, when=when, domain=tuple(e for e in domain if e.free_symbols),
                               inserted=inserted)
        return replace(self, when=when)

    def ladder(self, end: Expr) -> Ladder:
        """Return when the end belongs to the set.

        These are the rungs of the boundary there, as far as their signs are not known.
        """
        if self.boundary is None:
            return EXCLUDED
        rungs: list[Expr] = []
        for rung in self.boundary.ladder(RUNGS):
            value = self.insert(rung.xreplace({self.x: end}))
            known = Signs.over([value], self.domain)
            margin, even = known.margin(value)
            if margin and not even and (sign := known.of(margin)):
                rungs.append(S.One * sign)
                break
            plain = known.ring.expression(margin)
            # a rung that repeats another adds nothing: it is 0 where that one is
            if margin and not any(plain in (r, -r) for r in rungs):
                rungs.append(Mul(plain, *(known.ring.expression(e) ** 2 for e in even)))
        while rungs and rungs[-1] == -1:
            rungs.pop()
        return tuple(rungs)

    def case(self, *intervals: Interval) -> Case:
        lower = S.Zero if self.x.is_positive else -oo
        return Case(self.when, tuple(replace(i, low=lower) if i.low == -oo else i for i in intervals))

    def everywhere(self) -> Case:
        return self.case(Interval(-oo, oo))

    def beyond(self, low: Expr, high: Expr) -> Case:
        """Return the case outside low ≤ x ≤ high, with the ends if they are decided so."""
        return self.case(Interval(-oo, low, EXCLUDED, self.ladder(low)),
                         Interval(high, oo, self.ladder(high), EXCLUDED))

    def root(self, expression: Expr) -> Expr:
        """Return √ of what is positive, with the squares that are known to be positive taken out."""
        value = self.insert(expression)
        known = Signs.over([value], self.domain)
        ring = known.ring
        outside, inside = S.One, S.One
        for polynomial, side in zip(ring.fraction(value), (1, -1)):
            content, factors = polynomial.factor()
            size = ring.expression(ring.one * abs(content))
            outside *= sqrt(size) ** side                  # inside, SymPy would distribute it over a sum
            inside *= 1 if content > 0 else -1
            for factor, n in factors:
                out = int(n) // 2 if known.of(factor) == 1 else 0
                outside *= Pow(ring.expression(factor), side * out)
                inside *= Pow(ring.expression(factor), side * (int(n) - 2 * out))
        return outside * sqrt(inside)

    def over(self, plain: Expr, root: Expr, bottom: Expr) -> Expr:
        """Return (plain + root)/bottom, each part in lowest terms."""
        below = self.insert(bottom)
        return lowest_terms(self.insert(plain) / below) + lowest_terms(self.insert(root) / below)
