"""Trace, determinant, p and q of a permanent rotation off an axis, by names that are defined in turn.

Each name stands for a vector or a matrix of the amended potential (AmendedForm). In any direction, and
wherever the trace is long, conditions are written in these names: written out they would be too long to read.
"""
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Expr, Matrix, Symbol, sympify

from ..._cached import cached_property
from ...algebra.rings.matrices import cross
from ...algebra.rings.polynomials import Ring, cancel, lowest_terms
from ...mechanics.equilibrium.derivation_ring import rows_at_point
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium, Relation
from ...mechanics.equilibrium.standard_axes import seen
from ...mechanics.equilibrium.unit_vectors import in_any_direction
from ...notation import symbol
from ..notion import Notion
from .amended_form import (
    UPPER,
    AmendedForm,
    dot,
    of_forms,
    reduced_inertia,
    second_variation,
    with_multiplier,
)
from .conditions import Condition, Criterion
from .defined_names import SHORT, Chosen, DefinedNames

LAMBDA = symbol("lamda")


class Named:
    """The names in which the conditions of a rotation are written."""

    def __init__(self, eq: Equilibrium):
        names = Chosen(eq)
        self.J, self.G, self.trace, self.determinant, self.p, self.q = names.of(*"JGtspq")
        self.discriminant = self.p**2 - 4 * self.q
        self.v = names.of("v1", "v2", "v3")
        self.K, self.A = map(names.symmetric, "KA")


@dataclass(frozen=True)
class ClosedForm(DefinedNames):
    """What decides a permanent rotation of a body in a field, by names that are defined in turn.

    Parameters
    ----------
    equilibrium : Equilibrium
        without integrals; k is not along an axis of the body
    """

    _carried = "named", "forms"

    @cached_property
    def named(self) -> Named:
        """The names in which the conditions are written."""
        return Named(self.equilibrium)

    @cached_property
    def definitions(self) -> tuple[Relation, ...]:
        """Each name with its definition, by names of the family and those before it.

        Derived in docs/explanation/derivations/amended-potential.md, sections 3 and 4.
        """
        inertia, rotor, hessian, place, omega, mu = self.forms
        # components of k that are neither numbers nor names have the names k1, k2, k3
        names = self.equilibrium.system.space.coordinates[3:]
        k = [x if x.is_Atom else name for x, name in zip(place, names)]
        along = [dot(row, k) for row in inertia]
        v = [2 * omega * a + l for a, l in zip(along, rotor)]
        own = self.named
        second = second_variation(inertia, mu, hessian, own.v, own.J, omega)
        reduced = reduced_inertia(inertia, along, own.J)
        tensor = Matrix(inertia)
        form = of_forms(own.K, own.A, own.G, k, own.J / tensor.det())
        return (*((name, x) for name, x in zip(k, place) if name != x),
                (own.J, dot(k, along)), *zip(own.v, v), *((own.K[i][j], second[i][j]) for i, j in UPPER),
                *((own.A[i][j], reduced[i][j]) for i, j in UPPER),
                (own.G, dot(own.v, along) / own.J - omega * tensor.trace()), (own.trace, form.trace.expand()),
                (own.determinant, form.determinant.expand()), (own.p, form.p),
                (own.q, own.J * own.determinant / tensor.det()))

    @cached_property
    def invariants(self) -> AmendedForm:
        """The four expressions in the names of the family, neither expanded nor in lowest terms."""
        inertia, rotor, hessian, k, omega, mu = self.forms
        return with_multiplier(inertia, rotor, mu, hessian, k, omega)

    @property
    def margins(self) -> list[Expr]:
        """The margins of all conditions in the names of the family: t, s, p, q and p² − 4q."""
        form = self.invariants
        return [*form, form.p**2 - 4 * form.q]

    @property
    def determinant(self) -> Expr:
        """The determinant s in the names of the family."""
        return self.invariants.determinant

    @property
    def polynomial(self) -> Expr:
        """The characteristic polynomial λ⁴ + p λ² + q."""
        return LAMBDA**4 + self.named.p * LAMBDA**2 + self.named.q

    @property
    def blocks(self) -> list[tuple[Expr, ...]]:
        """The trace t and the determinant s of D²U_c across k."""
        return [(self.named.trace, self.named.determinant)]

    def criterion(self, notion: Notion) -> Criterion:
        """Return the spectral, formal or secular criterion in these names."""
        own = self.named
        wanted: tuple[tuple[Expr, str], ...] = (own.trace, "t"), (own.determinant, "s")
        if notion == Notion.SPECTRAL:
            wanted = (own.p, "p"), (own.q, "q"), (own.discriminant, "p² − 4q")
        at = self.equilibrium.at
        return Criterion(notion, (tuple(Condition(margin, notion != Notion.SPECTRAL, name, (), at)
                                        for margin, name in wanted),))

    def _computed(self, flat: Sequence[Any]) -> Iterator[tuple[Symbol, Any]]:
        own = self.named
        return zip((own.trace, own.determinant, own.p, own.q), with_multiplier(*_shaped(flat)))

    @cached_property
    def momentum_across(self) -> list[Expr]:
        """The product M × k, which is 0 if damping may not reach every motion."""
        inertia, rotor, _, k, omega, _ = self.forms
        return [*cross([omega * dot(row, k) + l for row, l in zip(inertia, rotor)], k)]

    @cached_property
    def forms(self) -> tuple[Any, ...]:
        """The data I, l, D²U, k, omega and μ on the family.

        If μ is a multiple of k·k, it is divided by it: both are the same on abs(k) = 1, and the quotient is
        shorter.
        """
        eq, body = self.equilibrium, self.equilibrium.system.body
        potential, k = eq.system.potential, eq.point[3:]
        assert potential is not None
        axis = next(n for n, x in enumerate(k) if x != 0)
        omega = lowest_terms(eq.insert(eq.energy_gradient[axis] / k[axis]))
        inertia = [[eq.insert(x) for x in row] for row in body.tensor.tolist()]
        rotor = [eq.insert(l) for l in body.gyrostatic_momentum]
        gradient = [eq.at_point(d) for d in potential.gradient()]
        hessian = [row[3:] for row in rows_at_point(eq, eq.system.energy_hessian)[3:]]
        momentum = [omega * dot(row, k) + l for row, l in zip(inertia, rotor)]
        mu = _on_sphere(omega * dot(k, momentum) - dot(k, gradient), lowest_terms(dot(k, k)))
        return inertia, rotor, hessian, k, omega, mu

    @cached_property
    def _flat(self) -> list[Expr]:
        inertia, rotor, hessian, k, omega, mu = self.forms
        flat = [x for form in (inertia, [rotor], hessian, [k]) for row in form for x in row]
        return [*map(sympify, flat), omega, mu]


closed_form = once(ClosedForm)                             # derived once for each family


@once
def in_names(eq: Equilibrium) -> ClosedForm | None:
    """Return the closed form in whose names conditions are written; None if they are written out.

    They are written out if they are short, which is told before they are expanded: the trace t, the shortest
    of them, has at most SHORT terms in lowest terms. So they are if k is along an axis, or the second
    variation splits: its own minors are shorter.
    """
    if in_any_direction(eq):
        return closed_form(eq)
    if eq.system.integrals or seen(eq) or sum(x != 0 for x in eq.point[3:]) < 2:
        return None
    trace = closed_form(eq).invariants.trace
    top, bottom = Ring([trace]).fraction(trace)
    if len(cancel(top, bottom)[0]) <= SHORT or _splits(eq):
        return None
    return closed_form(eq)


def _splits(eq: Equilibrium) -> bool:
    """Tell whether the second variation on the orbit splits into several blocks in the axes of the body.

    It does if two axes span a plane of symmetry of I and of D²U that has k and l in it; or if the body is at
    rest, and l is along k.
    """
    inertia, rotor, hessian, k, omega, _ = closed_form(eq).forms
    across = ([k[n], rotor[n], *(form[n][m] for form in (inertia, hessian) for m in range(3) if m != n)]
              for n in range(3))
    return any(not any(map(lowest_terms, group)) for group in ([omega, *cross(rotor, k)], *across))


def _shaped(flat: Sequence[Any]) -> tuple[Any, ...]:
    """Return I, l, μ, D²U, k and omega from the list of all of them."""
    inertia, hessian = ([flat[n:n + 3] for n in range(start, start + 9, 3)] for start in (0, 12))
    return inertia, flat[9:12], flat[25], hessian, flat[21:24], flat[24]


def _on_sphere(expression: Expr, square: Expr) -> Expr:
    """Return the expression divided by k·k, if that divides it."""
    ring = Ring([expression, square])
    top, bottom = ring.fraction(expression)
    quotient, rest = divmod(top, ring.numerator(square))
    return lowest_terms(expression) if rest else ring.quotient(quotient, bottom)
