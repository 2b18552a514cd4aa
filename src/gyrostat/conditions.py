"""Margins, conditions and criteria: the spectral and the formal test as inequalities, reduced to what is independent."""
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from flint import fmpq_mpoly
from sympy import Expr

from .algebra import Ring
from .energy_casimir import SecondVariation
from .equilibria import Equilibrium
from .linearization import Linearization
from .notation import Typeset
from .signs import Signs


@dataclass(frozen=True)
class Condition(Typeset):
    """margin > 0, or margin ≥ 0: one inequality in normal form.

    Parameters
    ----------
    margin : Expr              primitive integer polynomial; positive is good
    strict : bool              > or ≥
    source : str               what it came from
    degenerate : tuple         even factors taken out of the margin: where one vanishes the sign is 0
    at : Expr                  the k3 at which derivatives of U are taken: 1, -1 or k3
    """

    margin: Expr
    strict: bool
    source: str
    degenerate: tuple[Expr, ...]
    at: Expr


@dataclass(frozen=True)
class Criterion(Typeset):
    """A disjunction of conjunctions of conditions, and the notion of stability it is about.

    Parameters
    ----------
    notion : str               "spectral" or "formal"
    alternatives : tuple       of tuples of Condition; () never holds, ((),) always
    modulo : tuple of Expr     integrals whose flow is divided out
    """

    notion: str
    alternatives: tuple[tuple[Condition, ...], ...]
    modulo: tuple[Expr, ...] = ()


@dataclass(frozen=True)
class _Item:
    """A condition while it is worked on: polynomials of one ring."""

    margin: fmpq_mpoly
    degenerate: tuple[fmpq_mpoly, ...]
    strict: bool
    source: str


def spectral_criterion(linearization: Linearization) -> Criterion:
    """Necessary for stability: no eigenvalue has a positive real part.

    λ⁴ + pλ² + q: p ≥ 0, q ≥ 0, p² − 4q ≥ 0, each as it is; λ² + q: q ≥ 0.

    Source
    ------
    Vera & Viguera (2003), §5.

    Examples
    --------
    >>> from gyrostat import assemble, axial_potential, linearize, symmetric_gyrostat, upright
    >>> p, q, discriminant = spectral_criterion(linearize(upright(assemble(symmetric_gyrostat(), axial_potential())))).alternatives[0]
    >>> discriminant.margin, discriminant.degenerate
    (-4*I1*dU + l**2 + 2*l*pi3_0 + pi3_0**2, (2*I1*pi3_0 - I3*l - I3*pi3_0,))
    """
    eq, values = linearization.equilibrium, linearization.coefficients
    ring = Ring([*values, *eq.domain])
    fractions = [ring.fraction(value) for value in values]
    named = dict(zip(("q",) if len(values) == 1 else ("p", "q"), fractions))
    if len(values) == 2:
        (p, a), (q, b) = fractions
        named["p² − 4q"] = p**2 * b - 4 * q * a**2, a**2 * b
    signs = Signs(ring, eq.domain)
    items = [_Item(*signs.split(*fraction), False, name) for name, fraction in named.items()]
    return Criterion("spectral", (tuple(_condition(ring, item, eq) for item in items),))


def formal_criterion(variation: SecondVariation) -> Criterion:
    """Sufficient for stability: the second variation is definite, of either sign, for some value of the free multiplier.

    The leading principal minors decide; a free multiplier enters one margin, quadratically, and is eliminated:
    a ν² + b ν + c takes a positive value iff a > 0 or b² > 4ac.

    Source
    ------
    Holm, Marsden, Ratiu & Weinstein (1985); elimination: the maximum of a quadratic.

    Examples
    --------
    >>> from gyrostat import assemble, axial_potential, second_variation, symmetric_gyrostat, upright
    >>> variation = second_variation(upright(assemble(symmetric_gyrostat(), axial_potential())))
    >>> formal_criterion(variation).alternatives[0][0].margin
    -4*I1*dU + l**2 + 2*l*pi3_0 + pi3_0**2
    """
    eq = variation.equilibrium
    ring = Ring([*variation.minors, *eq.domain])
    signs = Signs(ring, eq.domain)
    minors = [ring.fraction(minor) for minor in variation.minors]
    alternatives: list[list[_Item]] = []
    for s in (1, -1):
        items = [_Item(*signs.split(s**n * top, bottom), True, f"minor {n}") for n, (top, bottom) in enumerate(minors, 1)]
        conjunction = _simplify(items, signs)
        if conjunction is not None:
            for nu in (g for g in variation.free if g in ring.gens):
                alternatives += _eliminate(conjunction, nu, signs)
            alternatives += [] if any(g in ring.gens for g in variation.free) else [conjunction]
    merged = _merge([a for a in (_simplify(a, signs) for a in alternatives) if a is not None], signs)
    return Criterion("formal", tuple(tuple(_condition(ring, item, eq) for item in a) for a in merged), variation.modulo)


def independent(criterion: Criterion, eq: Equilibrium) -> Criterion:
    """The same criterion without the conditions that follow from the others, given U and the relations inserted."""
    conditions = [c for alternative in criterion.alternatives for c in alternative]
    for values, domain in ((lambda e: e, eq.domain), (eq.insert, eq.existence())):
        ring = Ring([*(values(e) for c in conditions for e in (c.margin, *c.degenerate)), *domain])
        signs = Signs(ring, domain)
        alternatives = []
        for alternative in criterion.alternatives:
            items = _simplify([_inserted(ring, signs, c, values) for c in alternative], signs)
            if items is not None:
                alternatives.append(items)
        kept = tuple(tuple(_condition(ring, item, eq) for item in a) for a in _merge(alternatives, signs))
        criterion = replace(criterion, alternatives=kept)
        conditions = [c for alternative in kept for c in alternative]
    return criterion


def _inserted(ring: Ring, signs: Signs, condition: Condition, values: Any) -> _Item:
    margin, even = signs.split(*ring.fraction(values(condition.margin)))
    for factor in condition.degenerate:
        odd, more = signs.split(*ring.fraction(values(factor)))
        even += more if odd.is_constant() and odd else (*more, odd)
    return _Item(margin, even, condition.strict, condition.source)


def _condition(ring: Ring, item: _Item, eq: Equilibrium) -> Condition:
    return Condition(ring.expression(item.margin), item.strict, item.source, tuple(map(ring.expression, item.degenerate)), eq.at)


def _simplify(items: Sequence[_Item], signs: Signs) -> list[_Item] | None:
    """An equivalent conjunction without what is always true or implied; None if it can never hold."""
    left = list(items)
    while True:
        found = _decided(left, signs)
        if found is None:
            return None
        reduced = _divided(found, signs)
        reduced = _without_implied(reduced, signs)
        if reduced == left:
            return reduced
        left = reduced


def _decided(items: Iterable[_Item], signs: Signs) -> list[_Item] | None:
    """Without conditions that always hold; None if one never does."""
    left: list[_Item] = []
    for item in items:
        sign = signs.of(item.margin)
        if sign is None or sign > 0 and item.strict and item.degenerate or sign < 0 and not item.strict and item.degenerate:
            if item not in left:
                left.append(item)
        elif sign < 0 or sign == 0 and item.strict:
            return None
    return left


def _divided(items: list[_Item], signs: Signs) -> list[_Item]:
    """Strict margins divided by those that are known to be positive with them."""
    result = list(items)
    for i, item in enumerate(result):
        for other in result[:i] + result[i + 1:]:
            if not (item.strict and other.strict) or other.margin.is_constant():
                continue
            quotient, rest = divmod(item.margin, other.margin)
            margin = quotient if not rest else item.margin
            item = replace(item, margin=margin, degenerate=tuple(e for e in item.degenerate if divmod(other.margin, e)[1]))
        result[i] = item
    return result


def _without_implied(items: list[_Item], signs: Signs) -> list[_Item]:
    """Drop X where c X = S + T Y with c, T > 0, S a square: it follows from Y; where S = 0 it restores Y."""
    for x in items:
        for y in items:
            if x is y or x.degenerate or x.strict != y.strict:
                continue
            square = _remainder(x.margin, y.margin, signs)
            if square is None or any(divmod(square, e)[1] for e in y.degenerate):
                continue
            return [replace(y, degenerate=()) if item is y else item for item in items if item is not x]
    return items


def _remainder(x: fmpq_mpoly, y: fmpq_mpoly, signs: Signs) -> fmpq_mpoly | None:
    """S ≥ 0 in c x = S + T y with c > 0 and T > 0, if division in one of the variables finds it."""
    for index, degree in enumerate(y.degrees()):
        if degree != 1:
            continue
        slope = y.derivative(index)
        rest = y - slope * y.context().gen(index)
        n = int(x.degrees()[index])
        sign = signs.of(slope) or 0
        if sign**n == 0:
            continue
        powers = _by_degree(x, index, n)
        on_zero = sum((c * (-rest) ** k * slope ** (n - k) for k, c in enumerate(powers)), signs.ring.zero) * sign**n
        quotient, left = divmod(x * slope**n * sign**n - on_zero, y)
        if not left and signs.of(quotient) == 1 and signs.nonnegative(on_zero):
            return on_zero
    return None


def _by_degree(polynomial: fmpq_mpoly, index: int, degree: int) -> list[fmpq_mpoly]:
    """Coefficients of the powers 0 … degree of one generator."""
    parts: list[dict[tuple[int, ...], Any]] = [{} for _ in range(degree + 1)]
    for exponents, coefficient in polynomial.to_dict().items():
        parts[exponents[index]][exponents[:index] + (0,) + exponents[index + 1:]] = coefficient
    return [polynomial.context().from_dict(part) for part in parts]


def _eliminate(items: list[_Item], nu: Expr, signs: Signs) -> list[list[_Item]]:
    """∃ν: a ν² + b ν + c > 0, as alternatives without ν; where ν enters otherwise, ν = 0 (the Casimirs alone)."""
    index = signs.ring.generators.index(nu)
    with_nu = [item for item in items if any(p.degrees()[index] for p in (item.margin, *item.degenerate))]
    others = [item for item in items if item not in with_nu]
    if not with_nu:
        return [others]
    if len(with_nu) == 1 and not with_nu[0].degenerate and (n := int(with_nu[0].margin.degrees()[index])) <= 2:
        c, b, a = (*_by_degree(with_nu[0].margin, index, n), *[signs.ring.zero] * (2 - n))
        discriminant = _Item(*signs.split(b**2 - 4 * a * c, signs.ring.one), True, with_nu[0].source)
        opens = _Item(*signs.split(a, signs.ring.one), True, with_nu[0].source)
        return [[*others, opens], [*others, discriminant]]
    at_zero = [replace(i, margin=_by_degree(i.margin, index, int(i.margin.degrees()[index]))[0]) for i in with_nu]
    return [[*others, *at_zero]] if not any(i.degenerate for i in with_nu) else []


def _merge(alternatives: list[list[_Item]], signs: Signs) -> list[list[_Item]]:
    """X > 0 or X < 0, beside conditions that make X ≠ 0, is no condition; equal alternatives are one."""
    for n, one in enumerate(alternatives):
        for other in alternatives[n + 1:]:
            extra = [item for item in one if item not in other]
            opposite = [item for item in other if item not in one]
            rest = [item for item in one if item in other]
            if not extra and not opposite or (len(extra) == len(opposite) == 1 and extra[0].margin == -opposite[0].margin
                                              and _nonzero_with(extra[0], rest, signs)):
                return _merge([rest, *(a for a in alternatives if a is not one and a is not other)], signs)
    return alternatives


def _nonzero_with(item: _Item, rest: list[_Item], signs: Signs) -> bool:
    return not item.degenerate and all(
        signs.nonzero(factor) or any(not divmod(r.margin, factor)[1] for r in rest if r.strict) for factor, _ in item.margin.factor()[1])


