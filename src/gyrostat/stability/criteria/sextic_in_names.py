"""The coefficients a, b, c of the sextic of a body at rest in the frame of two directions, by names.

They are defined by the entries of K and g (OrientationForm). Where the discriminant of the sextic is long,
conditions are written in these names: written out it has thousands of terms.
"""
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Expr, ImmutableMatrix, S, Symbol

from ..._cached import cached_property
from ...algebra.rings.matrices import adjugate, blocks, characteristic, cross
from ...algebra.rings.polynomials import Ring, cancel
from ...mechanics.equilibrium.derivation_ring import positive
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium, Relation
from ...notation import symbol
from ..notion import Notion
from .amended_form import UPPER, dot
from .conditions import Condition, Criterion, all_positive, independent
from .defined_names import SHORT, Chosen, DefinedNames
from .orientation_form import OrientationForm, minors_of_stiffness, orientation_form
from .sextic import cubic_discriminant, factors_in_squares

LAMBDA = symbol("lamda")
Rows = Sequence[Sequence[Any]]


class Named:
    """The names in which the conditions of a body at rest are written; what is 0 has none."""

    def __init__(self, eq: Equilibrium, form: OrientationForm):
        names = Chosen(eq)
        self.coefficients = names.of(*"abc")
        self.determinant = self.coefficients[-1]
        K = names.symmetric("K")
        self.K = [[K[i][j] if form.stiffness[i, j] else S.Zero for j in range(3)] for i in range(3)]
        self.g = [name if x else S.Zero for name, x in zip(names.of("g1", "g2", "g3"), form.gyroscopic)]


@dataclass(frozen=True)
class SexticInNames(DefinedNames):
    """What decides a body at rest in the frame of two directions, by names that are defined in turn.

    Parameters
    ----------
    equilibrium : Equilibrium
        without integrals
    """

    _carried = ("named",)

    @cached_property
    def named(self) -> Named:
        """The names in which the conditions are written."""
        return Named(self.equilibrium, orientation_form(self.equilibrium))

    @cached_property
    def definitions(self) -> tuple[Relation, ...]:
        """Each name with its definition, by names of the family and those before it.

        Derived in docs/explanation/derivations/satellite.md, sections 1 to 4.
        """
        form, own = orientation_form(self.equilibrium), self.named
        entries = [(own.K[i][j], form.stiffness[i, j]) for i, j in UPPER]
        pairs = [(name, x) for name, x in (*entries, *zip(own.g, form.gyroscopic)) if x]
        return (*pairs, *zip(own.coefficients, coefficients(own.K, own.g, form.inertia.tolist())))

    @property
    def margins(self) -> list[Expr]:
        """The margins of all conditions in the names of the family: a, b, c, Δ and the minors of K."""
        form = orientation_form(self.equilibrium)
        a, b, c = form.coefficients
        return [a, b, c, cubic_discriminant(a, b, c), *(x for _, _, x in minors_of_stiffness(form.stiffness))]

    @property
    def determinant(self) -> Expr:
        """The determinant of K in the names of the family."""
        return orientation_form(self.equilibrium).stiffness.det(method="berkowitz")

    @property
    def polynomial(self) -> Expr:
        """The characteristic polynomial λ⁶ + a λ⁴ + b λ² + c."""
        a, b, c = self.named.coefficients
        return LAMBDA**6 + a * LAMBDA**4 + b * LAMBDA**2 + c

    @property
    def blocks(self) -> list[tuple[Expr, ...]]:
        """The elementary symmetric functions of the eigenvalues of each block of K, by its entries."""
        K = self.named.K
        return [characteristic([[K[i][j] for j in block] for i in block]) for block in blocks(K)]

    def criterion(self, notion: Notion) -> Criterion:
        """Return the spectral criterion by a, b, c; the formal or secular one by K, written out if short."""
        eq, own = self.equilibrium, self.named
        if notion == Notion.SPECTRAL:
            margins = *own.coefficients, cubic_discriminant(*own.coefficients)
            return Criterion(notion, (tuple(Condition(margin, False, name, (), eq.at)
                                            for margin, name in zip(margins, "abcΔ")),))
        if self._short:
            minors = minors_of_stiffness(orientation_form(eq).stiffness)
            named = [(name, eq.insert(minor)) for name, _, minor in minors]
            return independent(all_positive(notion, named, eq, (*eq.domain, *positive(eq))), eq)
        return Criterion(notion, (tuple(Condition(minor, True, name, (), eq.at)
                                        for name, _, minor in minors_of_stiffness(ImmutableMatrix(own.K))),))

    @cached_property
    def _short(self) -> bool:
        """Whether every minor of K has at most SHORT terms."""
        minors = [x for _, _, x in minors_of_stiffness(orientation_form(self.equilibrium).stiffness)]
        return all(_terms(minor) <= SHORT for minor in minors)

    @cached_property
    def _flat(self) -> list[Expr]:
        form, insert = orientation_form(self.equilibrium), self.equilibrium.insert
        matrices = (form.stiffness[i, j] for i, j in UPPER), (form.inertia[i, j] for i, j in UPPER)
        return list(map(insert, (*matrices[0], *form.gyroscopic, *matrices[1])))

    def _computed(self, flat: Sequence[Any]) -> Iterator[tuple[Symbol, Any]]:
        own, K, g, inertia = self.named, _symmetric(flat[:6]), flat[6:9], _symmetric(flat[9:])
        yield from ((own.K[i][j], K[i][j]) for i, j in UPPER if own.K[i][j])
        yield from zip(own.coefficients, coefficients(K, g, inertia))


def coefficients(K: Rows, g: Sequence[Any], inertia: Rows) -> tuple[Any, Any, Any]:
    """Return a, b, c of λ⁶ + a λ⁴ + b λ² + c = det(λ² I + λ hat(g) + K)/det I, in any arithmetic."""
    whole, minors = dot(inertia[0], cross(inertia[1], inertia[2])), adjugate(K)

    def product(one: Rows, other: Rows) -> Any:
        return dot([dot(*rows) for rows in zip(one, other)], (1, 1, 1))

    def at(form: Rows) -> Any:
        return dot(g, [dot(row, g) for row in form])

    return ((product(adjugate(inertia), K) + at(inertia)) / whole, (product(minors, inertia) + at(K)) / whole,
            dot(K[0], minors[0]) / whole)


@once
def in_names(eq: Equilibrium) -> SexticInNames | None:
    """Return the names in which conditions are written; None if they are written out.

    They are in names if the sextic has no factor over the rationals, and a, b, c or its discriminant has more
    than SHORT terms. Factors have shorter conditions.
    """
    if eq.system.linear_integrals:
        return None
    (first, *others), *more = factors_in_squares(orientation_form(eq).coefficients)
    if more or all(_terms(x / first) <= SHORT for x in others) and _terms(
            cubic_discriminant(*(x / first for x in others))) <= SHORT:
        return None
    return SexticInNames(eq)


def _terms(expression: Expr) -> int:
    """Return the number of terms of the numerator in lowest terms."""
    ring = Ring([expression])
    top, bottom = ring.fraction(expression)
    return len(cancel(ring.reduce(top), bottom)[0])


def _symmetric(upper: Sequence[Any]) -> Rows:
    """Return the rows of a symmetric matrix from its entries with i ≤ j."""
    a, b, c, d, e, f = upper
    return (a, b, c), (b, d, e), (c, e, f)
