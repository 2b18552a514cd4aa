"""Reduces conjunctions of polynomial inequalities: drops what follows, and eliminates one multiplier.

X > 0 follows from Y > 0 if X = S + T Y with T > 0 and S ≥ 0; each such identity is kept as a proof. An
example is worked out in docs/explanation/derivations/conditions.md, section 7.
"""
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from flint import fmpq_mpoly
from sympy import Expr, S

from ...algebra.reals.exact import sign_of_constant
from ...algebra.rings.polynomials import Ring, by_degree
from ...algebra.solving.margins import Signs


@dataclass(frozen=True)
class Item:
    """A condition while it is worked on: margin > 0 if it is strict, else margin ≥ 0.

    The sign of the margin counts as 0 if a factor in degenerate, one of even power, vanishes.
    """

    margin: fmpq_mpoly
    degenerate: tuple[fmpq_mpoly, ...]
    strict: bool
    source: str
    implies: tuple["Implied", ...] = field(default=(), compare=False)


@dataclass(frozen=True)
class Implied:
    """The proof, margin = square + factor · by with factor > 0, that a condition follows from by.

    The source names the condition that follows.
    """

    source: str
    margin: Any
    square: Any
    factor: Any
    by: Any


def reduced(items: Sequence[Item], signs: Signs) -> list[Item] | None:
    """Return an equivalent conjunction without what is always true or implied; None if it can never hold."""
    left = list(items)
    while True:
        found = _decided(left, signs)
        if found is None:
            return None
        shorter = _without_implied(_divided(found, signs), signs)
        if shorter == left:
            return shorter
        left = shorter


def _decided(items: Iterable[Item], signs: Signs) -> list[Item] | None:
    """Return the items without those that always hold; None if one never does."""
    left: list[Item] = []
    for item in items:
        sign = signs.of(item.margin)
        # an even factor may make a strict condition with a positive margin fail, or a non-strict one hold
        if sign is None or item.degenerate and (sign > 0) == item.strict and sign:
            if item not in left:
                left.append(item)
        elif sign < 0 or sign == 0 and item.strict:
            return None
    return left


def _divided(items: list[Item], signs: Signs) -> list[Item]:
    """Divide strict margins by others that are positive with them, and keep each even factor once."""
    result = list(items)
    for i, item in enumerate(result):
        for other in result[:i] + result[i + 1:]:
            if not (item.strict and other.strict) or other.margin.is_constant():
                continue
            quotient, rest = divmod(item.margin, other.margin)
            margin = quotient if not rest else item.margin
            item = replace(item, margin=margin,
                           degenerate=tuple(e for e in item.degenerate if divmod(other.margin, e)[1]))
        result[i] = _once(item, result[:i]) if item.strict else item
    return result


def _once(item: Item, before: Sequence[Item]) -> Item:
    """Return the item without even factors that are not 0 if its margin, or one before it, is positive."""
    known = [e for other in before if other.strict for e in other.degenerate]
    left: list[fmpq_mpoly] = []
    for e in item.degenerate:
        if divmod(item.margin, e)[1] and e not in known and e not in left:
            left.append(e)
    return replace(item, degenerate=tuple(left))


def _without_implied(items: list[Item], signs: Signs) -> list[Item]:
    """Drop X if X = S + T Y with T > 0 and S a square, or X is a square of Y: it follows from Y.

    Among strict ones S may also be a positive multiple of a third: I2 − I3 = (I1 − I3) + (I2 − I1). A
    non-strict Y also holds where an even factor e of it vanishes. If e divides S, then X and Y together are
    Y's margin ≥ 0 alone: where e = 0, X has the sign of the margin.
    """
    for x in items:
        for y in items:
            if x is y or x.degenerate or x.strict != y.strict:
                continue
            if x.strict and _is_square(x.margin, y.margin, signs.ring):
                return [item for item in items if item is not x]
            others = [z.margin for z in items if x.strict and z.strict and z not in (x, y)
                      and not z.degenerate]
            parts = _parts(x.margin, y.margin, signs, others)
            if parts is None or not y.strict and any(divmod(parts[0], e)[1] for e in y.degenerate):
                continue
            proof = Implied(x.source, x.margin, *parts, y.margin)
            plain = replace(y, degenerate=y.degenerate if y.strict else (),
                            implies=(*y.implies, proof, *x.implies))
            return [plain if item is y else item for item in items if item is not x]
    return items


def _is_square(x: fmpq_mpoly, y: fmpq_mpoly, ring: Ring) -> bool:
    """Tell whether x = c y² with a number c > 0, by what the numbers in the coefficients are.

    Factoring takes algebraic numbers for names, and does not see it.
    """
    if all(g.free_symbols for g in ring.generators):
        return False
    names = set().union(*(g.free_symbols for g in ring.generators))
    ours, squares = ({powers: ring.expression(c).expand()
                      for powers, c in ring.coefficients(p, names).items()}
                     for p in (x, ring.reduce(y * y)))
    first = max(squares)
    if first not in ours or sign_of_constant(ours[first] * squares[first]) != 1:
        return False
    return all(sign_of_constant((ours.get(powers, S.Zero) * squares[first] - ours[first]
                                 * squares.get(powers, S.Zero)).expand()) == 0
               for powers in {*ours, *squares})


def _parts(x: fmpq_mpoly, y: fmpq_mpoly, signs: Signs, positive: Sequence[fmpq_mpoly]
           ) -> tuple[fmpq_mpoly, fmpq_mpoly] | None:
    """Return S ≥ 0 and T > 0 with x = S + T y; a generator enters x and y affinely, and S not at all.

    S may also be one of those that are positive, times a positive number.
    """
    for index, (n, m) in enumerate(zip(x.degrees(), y.degrees())):
        if n == m == 1:
            quotient, rest = divmod(x.derivative(index), y.derivative(index))
            square = x - quotient * y
            if not rest and signs.of(quotient) == 1 and (
                    signs.nonnegative(square) or any(_multiple(square, z) for z in positive)):
                return square, quotient
    return None


def _multiple(x: fmpq_mpoly, y: fmpq_mpoly) -> bool:
    """Tell whether x is y times a positive number."""
    quotient, rest = divmod(x, y)
    return bool(not rest and quotient.is_constant() and quotient.leading_coefficient() > 0)


def eliminate(items: list[Item], nu: Expr, signs: Signs) -> list[list[Item]]:
    """Eliminate ν from a conjunction: ∃ν: a ν² + b ν + c > 0 iff a > 0 or b² > 4ac, unless a = b = 0.

    The maximum over ν is infinite if a > 0, and c − b²/(4a) if a < 0. The alternatives are without ν; if ν
    enters in another way, ν = 0 is tried.

    References
    ----------
    The maximum of a quadratic over ν: infinite if a > 0, else c − b²/(4a).
    """
    index = signs.ring.generators.index(nu)
    with_nu = [item for item in items if any(p.degrees()[index] for p in (item.margin, *item.degenerate))]
    others = [item for item in items if item not in with_nu]
    if not with_nu:
        return [others]
    one, n = with_nu[0], int(with_nu[0].margin.degrees()[index])
    if len(with_nu) == 1 and not one.degenerate and n <= 2:
        c, b, a = (*by_degree(one.margin, index, n), *[signs.ring.zero] * (2 - n))
        discriminant = Item(*signs.split(b**2 - 4 * a * c, signs.ring.one), True, one.source)
        opens = Item(*signs.split(a, signs.ring.one), True, one.source)
        return [[*others, opens], [*others, discriminant]]
    at_zero = [replace(i, margin=by_degree(i.margin, index, int(i.margin.degrees()[index]))[0])
               for i in with_nu]
    return [[*others, *at_zero]] if not any(i.degenerate for i in with_nu) else []


def merge(alternatives: list[list[Item]], signs: Signs) -> list[list[Item]]:
    """Merge alternatives: X > 0 or X < 0, beside conditions that make X ≠ 0, is no condition.

    Equal alternatives are one.
    """
    for n, one in enumerate(alternatives):
        for other in alternatives[n + 1:]:
            extra = [item for item in one if item not in other]
            opposite = [item for item in other if item not in one]
            rest = [item for item in one if item in other]
            if not extra and not opposite or (len(extra) == len(opposite) == 1
                                              and extra[0].margin == -opposite[0].margin
                                              and not opposite[0].degenerate
                                              and _nonzero_with(extra[0], rest, signs)):
                return merge([rest, *(a for a in alternatives if a is not one and a is not other)], signs)
    return alternatives


def _nonzero_with(item: Item, rest: list[Item], signs: Signs) -> bool:
    return not item.degenerate and all(
        signs.nonzero(factor) or any(not divmod(r.margin, factor)[1] for r in rest if r.strict)
        for factor, _ in item.margin.factor()[1])
