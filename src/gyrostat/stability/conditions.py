"""Margins, conditions and criteria.

The spectral and the formal test as inequalities, reduced to what is independent.
"""
from collections.abc import Callable
from dataclasses import dataclass, field, replace

from sympy import Expr, S, Symbol

from ..algebra.margins import Signs
from ..algebra.polynomials import Ring
from ..kept import cached_property
from ..mechanics.derivation import signs_over
from ..mechanics.equilibria import Equilibrium
from ..notation import Stored, jet
from ..shown import Shown
from .energy_casimir import SecondVariation
from .implication import Implied, Item, eliminate, merge, reduced
from .linearization import Linearization


@dataclass(frozen=True)
class Condition(Shown, Stored):
    """margin > 0, or margin ≥ 0: one inequality in normal form.

    Parameters
    ----------
    margin : Expr
        primitive integer polynomial; positive is good
    strict : bool
        > or ≥
    source : str
        what it came from
    degenerate : tuple
        even factors taken out of the margin: where one vanishes the sign is 0
    at : Expr
        the k3 at which derivatives of U are taken: 1, -1 or k3
    implies : tuple
        conditions dropped because they follow from this one, each with the identity that proves it

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> ((condition,),) = gs.analyze(gs.upright(top)).sufficient.alternatives
    >>> condition.margin, condition.strict
    (-4*I1*dU + l**2 + 2*l*pi3_0 + pi3_0**2, True)
    """

    margin: Expr
    strict: bool
    source: str
    degenerate: tuple[Expr, ...]
    at: Expr
    implies: tuple[Implied, ...] = field(default=(), compare=False)

    @cached_property
    def symbols(self) -> frozenset[Symbol]:
        """What the sign depends on."""
        return frozenset(s for e in (self.margin, *self.degenerate) for s in e.free_symbols)


@dataclass(frozen=True)
class Criterion(Shown, Stored):
    """A disjunction of conjunctions of conditions, and the notion of stability it is about.

    Parameters
    ----------
    notion : str
        "spectral" or "formal"
    alternatives : tuple
        of tuples of Condition; () never holds, ((),) always
    modulo : tuple of Expr
        integrals whose flow is divided out

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> criterion = gs.analyze(gs.upright(top)).sufficient
    >>> criterion.notion, len(criterion.alternatives), criterion.modulo
    ('formal', 1, ())
    """

    notion: str
    alternatives: tuple[tuple[Condition, ...], ...]
    modulo: tuple[Expr, ...] = ()


def spectral_criterion(linearization: Linearization) -> Criterion:
    """Necessary for stability: no eigenvalue has a positive real part.

    λ⁴ + pλ² + q: p ≥ 0, q ≥ 0, p² − 4q ≥ 0, each as it is; λ² + q: q ≥ 0.

    Parameters
    ----------
    linearization : Linearization

    Returns
    -------
    Criterion
        of the notion "spectral", with one alternative

    Raises
    ------
    ScopeError
        the polynomial has another degree

    References
    ----------
    Vera & Viguera (2003), §5.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> ((p, q, discriminant),) = gs.spectral_criterion(gs.linearize(gs.upright(top))).alternatives
    >>> discriminant.margin, discriminant.degenerate
    (-4*I1*dU + l**2 + 2*l*pi3_0 + pi3_0**2, (2*I1*pi3_0 - I3*l - I3*pi3_0,))
    """
    eq, values = linearization.equilibrium, linearization.frequency_coefficients
    signs = signs_over(eq, values)
    ring = signs.ring
    fractions = [ring.fraction(value) for value in values]
    items = [Item(*signs.split(*fraction), False, name)
             for fraction, name in zip(fractions, "q" if len(values) == 1 else "pq")]
    if len(values) == 2:
        (p, a), (q, b) = fractions
        factors = items[0].margin, *items[0].degenerate
        # q = 0: the discriminant is p²
        square = ring.one, tuple(e for e in factors if not e.is_constant())
        discriminant = signs.split(p**2 * b - 4 * q * a**2, a**2 * b) if items[1].margin else square
        items.append(Item(*discriminant, False, "p² − 4q"))
    return Criterion("spectral", (tuple(_condition(ring, item, eq) for item in items),))


def formal_criterion(variation: SecondVariation) -> Criterion:
    """Sufficient for stability: the second variation is definite.

    Of either sign, for some value of the free multiplier. The leading principal minors decide; a free
    multiplier enters one margin, quadratically, and is eliminated: a ν² + b ν + c takes a positive value
    iff a > 0 or b² > 4ac.

    Parameters
    ----------
    variation : SecondVariation

    Returns
    -------
    Criterion
        of the notion "formal", modulo what the variation is

    References
    ----------
    Holm, Marsden, Ratiu & Weinstein (1985); elimination: the maximum of a quadratic.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> variation = gs.second_variation(gs.upright(top))
    >>> gs.formal_criterion(variation).alternatives[0][0].margin
    -4*I1*dU + l**2 + 2*l*pi3_0 + pi3_0**2
    """
    eq = variation.equilibrium
    # one multiplier is eliminated, any value of the others may be chosen
    others = dict.fromkeys(variation.free[1:], S.Zero)
    given = [minor.xreplace(others) for minor in variation.minors]
    signs = signs_over(eq, given)
    ring = signs.ring
    minors = [ring.fraction(minor) for minor in given]
    alternatives: list[list[Item]] = []
    for s in (1, -1):
        items = [Item(*signs.split(s**n * top, bottom), True, f"minor {n}")
                 for n, (top, bottom) in enumerate(minors, 1)]
        conjunction = reduced(items, signs)
        if conjunction is not None:
            free = [nu for nu in variation.free if nu in ring.gens]
            alternatives += eliminate(conjunction, free[0], signs) if free else [conjunction]
    merged = merge([a for a in (reduced(a, signs) for a in alternatives) if a is not None], signs)
    return Criterion("formal", tuple(tuple(_condition(ring, item, eq) for item in a) for a in merged),
                     variation.modulo)


def independent(criterion: Criterion, eq: Equilibrium) -> Criterion:
    """The same criterion without the conditions that follow from the others.

    What follows is proved with U and the relations of the equilibrium inserted.

    Parameters
    ----------
    criterion : Criterion
    eq : Equilibrium

    Returns
    -------
    Criterion
        with what was dropped, and why, in Condition.implies

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> eq = gs.upright(top)
    >>> criterion = gs.spectral_criterion(gs.linearize(eq))
    >>> len(criterion.alternatives[0]), len(gs.independent(criterion, eq).alternatives[0])
    (3, 1)
    """
    first = _independent(criterion, eq, lambda e: e, signs_over(eq, _expressions(criterion)))
    if not _inserts(eq) and len(criterion.alternatives) <= 1:
        return first                                     # one conjunction, reduced to the end
    signs = Signs.over(map(eq.insert, _expressions(first)), eq.existence())
    return _independent(first, eq, eq.insert, signs)


def _inserts(eq: Equilibrium) -> bool:
    """Whether a given U or an eliminated parameter is inserted at the equilibrium."""
    potential = eq.system.potential
    return bool(potential and potential.given) or any(not jet(name.name) for name, _ in eq.relations)


def _expressions(criterion: Criterion) -> list[Expr]:
    return [e for a in criterion.alternatives for c in a for e in (c.margin, *c.degenerate)]


def _independent(criterion: Criterion, eq: Equilibrium, values: Callable[[Expr], Expr],
                 signs: Signs) -> Criterion:
    alternatives = [items for a in criterion.alternatives
                    if (items := reduced([_inserted(signs, c, values) for c in a], signs)) is not None]
    return replace(criterion, alternatives=tuple(tuple(_condition(signs.ring, item, eq) for item in a)
                                                 for a in merge(alternatives, signs)))


def _inserted(signs: Signs, condition: Condition, values: Callable[[Expr], Expr]) -> Item:
    margin, even = signs.margin(values(condition.margin))
    for factor in condition.degenerate:
        odd, more = signs.margin(values(factor))
        even += more if odd.is_constant() and odd else (*more, odd)
    proofs = tuple(Implied(p.source, *map(values, (p.margin, p.square, p.factor, p.by)))
                   for p in condition.implies)
    return Item(margin, even, condition.strict, condition.source, proofs)


def _condition(ring: Ring, item: Item, eq: Equilibrium) -> Condition:
    proofs = tuple(Implied(p.source, *(e if isinstance(e, Expr) else ring.expression(e)
                                       for e in (p.margin, p.square, p.factor, p.by)))
                   for p in item.implies)
    return Condition(ring.expression(item.margin), item.strict, item.source,
                     tuple(map(ring.expression, item.degenerate)), eq.at, proofs)
