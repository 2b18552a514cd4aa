"""Conditions and criteria: the tests of stability as polynomial inequalities, reduced to independent ones."""
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace

from sympy import Expr, Symbol

from ..._cached import cached_property
from ..._display import Shown
from ...algebra.rings.polynomials import Ring
from ...algebra.solving.margins import Signs
from ...arguments import checked
from ...mechanics.equilibrium.derivation_ring import signs_over
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...notation import Stored, jet
from ..notion import Notion
from .implication import Implied, Item, merge, reduced


@dataclass(frozen=True)
class Condition(Shown, Stored):
    """One inequality in normal form: margin > 0, or margin ≥ 0.

    Parameters
    ----------
    margin : Expr
        primitive integer polynomial; positive is good
    strict : bool
        whether it is >, not ≥
    source : str
        what it came from: p, q, p² − 4q, a minor, …
    degenerate : tuple
        even factors taken out of the margin: if one vanishes, the sign is 0
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
        """The symbols that the sign depends on."""
        return frozenset(s for e in (self.margin, *self.degenerate) for s in e.free_symbols)


@dataclass(frozen=True)
class Criterion(Shown, Stored):
    """A disjunction of conjunctions of conditions, and the notion of stability it is about.

    Parameters
    ----------
    notion : Notion
        SPECTRAL, FORMAL, SECULAR or ENERGY_SINK
    alternatives : tuple
        tuples of Condition, one of which has to hold; () never holds, ((),) always
    modulo : tuple of Expr
        integrals whose flow is divided out

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> criterion = gs.analyze(gs.upright(top)).sufficient
    >>> criterion.notion, len(criterion.alternatives), criterion.modulo
    (<Notion.FORMAL: 'formal'>, 1, ())
    """

    notion: Notion
    alternatives: tuple[tuple[Condition, ...], ...]
    modulo: tuple[Expr, ...] = ()

    @property
    def necessary(self) -> bool:
        """Whether there is no stability if it does not hold; else nothing is known then."""
        return self.notion in (Notion.SPECTRAL, Notion.ENERGY_SINK)

    @cached_property
    def only(self) -> Condition | None:
        """The condition whose margin decides alone; None if there are others, or even factors."""
        if len(self.alternatives) != 1 or len(self.alternatives[0]) != 1:
            return None
        (condition,), = self.alternatives
        return None if condition.degenerate else condition


@checked
def independent(criterion: Criterion, eq: Equilibrium) -> Criterion:
    """Return the same criterion without the conditions that follow from others.

    That they follow is proved with U and the relations of the equilibrium inserted.

    Parameters
    ----------
    criterion : Criterion
    eq : Equilibrium

    Returns
    -------
    Criterion
        with what was dropped, and why, in Condition.implies

    References
    ----------
    Derived: X > 0 follows from Y > 0 if X = S + T Y with T > 0 and S ≥ 0, an identity of polynomials. An
    example: docs/explanation/derivations/conditions.md, section 7.

    Examples
    --------
    >>> import gyrostat as gs
    >>> derivation = gs.derivation
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> eq = gs.upright(top)
    >>> linear = derivation.linearize(eq)
    >>> criterion = derivation.spectral_criterion(linear)
    >>> len(criterion.alternatives[0])
    3
    >>> len(derivation.independent(criterion, eq).alternatives[0])
    1
    """
    # first in the names of the family, where polynomials are short, then with U and relations inserted
    first = _independent(criterion, eq, lambda e: e, signs_over(eq, _expressions(criterion)))
    if not _inserts(eq) and len(criterion.alternatives) <= 1:
        return first                                     # one conjunction, reduced to the end
    signs = Signs.over(map(eq.insert, _expressions(first)), eq.existence())
    return _independent(first, eq, eq.insert, signs)


def all_positive(notion: Notion, named: Sequence[tuple[str, Expr]], eq: Equilibrium,
                 domain: Iterable[Expr]) -> Criterion:
    """Return the criterion that every expression, with the name of its source, is positive on a domain."""
    signs = Signs.over([e for _, e in named], domain)
    left = reduced([Item(*signs.margin(e), True, name) for name, e in named], signs)
    return Criterion(notion, () if left is None else (tuple(condition_of(signs.ring, item, eq)
                                                            for item in left),))


def sources(eq: Equilibrium, margins: Iterable[Expr], criteria: Iterable[Criterion]) -> tuple[str, ...]:
    """Return what each margin came from, "" for none; () if there are integrals."""
    if eq.system.linear_integrals:
        return ()
    named: dict[Expr, str] = {}
    for c in (c for criterion in criteria for alternative in criterion.alternatives for c in alternative):
        if named.get(c.margin) != "s":                     # s says more than q, which has the same margin
            named[c.margin] = c.source
    return tuple(named.get(margin, "") for margin in margins)


def _inserts(eq: Equilibrium) -> bool:
    """Tell whether a given U or an eliminated parameter is inserted at the equilibrium."""
    potential = eq.system.potential
    return bool(potential and potential.given) or any(not jet(name.name) for name, _ in eq.relations)


def _expressions(criterion: Criterion) -> list[Expr]:
    return [e for a in criterion.alternatives for c in a for e in (c.margin, *c.degenerate)]


def _independent(criterion: Criterion, eq: Equilibrium, values: Callable[[Expr], Expr],
                 signs: Signs) -> Criterion:
    alternatives = [items for a in criterion.alternatives
                    if (items := reduced([_inserted(signs, c, values) for c in a], signs)) is not None]
    return replace(criterion, alternatives=tuple(tuple(condition_of(signs.ring, item, eq) for item in a)
                                                 for a in merge(alternatives, signs)))


def _inserted(signs: Signs, condition: Condition, values: Callable[[Expr], Expr]) -> Item:
    margin, even = signs.margin(values(condition.margin))
    for factor in condition.degenerate:
        odd, more = signs.margin(values(factor))
        even += more if odd.is_constant() and odd else (*more, odd)
    proofs = tuple(Implied(p.source, *map(values, (p.margin, p.square, p.factor, p.by)))
                   for p in condition.implies)
    return Item(margin, even, condition.strict, condition.source, proofs)


def condition_of(ring: Ring, item: Item, eq: Equilibrium) -> Condition:
    """Return an item of a conjunction as a condition, in expressions."""
    proofs = tuple(Implied(p.source, *(e if isinstance(e, Expr) else ring.expression(e)
                                       for e in (p.margin, p.square, p.factor, p.by)))
                   for p in item.implies)
    return Condition(ring.expression(item.margin), item.strict, item.source,
                     tuple(map(ring.expression, item.degenerate)), eq.at, proofs)
