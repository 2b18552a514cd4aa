"""Trace, determinant, p and q of a permanent rotation in any direction, by names that are defined in turn.

Written out in the names of the scene they would be too long: each name stands for a vector or a matrix of the
amended potential (AmendedForm).
"""
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from flint import fmpq
from sympy import Expr, Matrix, Rational, S, Symbol

from ..._cached import cached_property
from ...algebra.reals.exact import Point, compiled, evaluate
from ...algebra.rings.matrices import cross
from ...algebra.rings.polynomials import Ring, lowest_terms
from ...mechanics.equilibrium.derivation_ring import rows_at_point
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium, Relation
from ...mechanics.scenes.system import System, names_of_scene
from ...notation import symbol
from ...registry import Letters
from ..notion import Notion
from .amended_form import AmendedForm, dot, of_forms, reduced_inertia, second_variation, with_multiplier
from .conditions import Condition, Criterion
from .numbers_asked import names_in

UPPER = [(i, j) for i in range(3) for j in range(i, 3)]


class Named:
    """The names in which the conditions are written; others, if the scene has one of them already.

    Parameters
    ----------
    scene : System
    """

    def __init__(self, scene: System):
        letters = Letters(s.name for s in names_of_scene(scene))
        self.J, self.G, self.trace, self.determinant, self.p, self.q = (
            symbol(letters.of(name)) for name in ("J", "G", "t", "s", "p", "q"))
        self.discriminant = self.p**2 - 4 * self.q
        self.v = tuple(symbol(letters.of(f"v{n}")) for n in (1, 2, 3))
        self.K, self.A = ([[symbol(letters.of(f"{name}{min(i, j)}{max(i, j)}")) for j in (1, 2, 3)]
                           for i in (1, 2, 3)] for name in "KA")


@dataclass(frozen=True)
class ClosedForm:
    """What decides a permanent rotation in any direction k, by names that are defined in turn.

    Parameters
    ----------
    equilibrium : Equilibrium
        of a family in k1, k2, k3
    """

    equilibrium: Equilibrium

    @cached_property
    def named(self) -> Named:
        """The names in which the conditions are written."""
        return Named(self.equilibrium.system)

    @cached_property
    def definitions(self) -> tuple[Relation, ...]:
        """Each name with its definition, by names of the family and those before it.

        Derived in docs/explanation/derivations/amended-potential.md, sections 3 and 4.
        """
        inertia, rotor, hessian, k, omega, mu = self.forms
        along = [dot(row, k) for row in inertia]
        v = [2 * omega * a + l for a, l in zip(along, rotor)]
        own = self.named
        second = second_variation(inertia, mu, hessian, own.v, own.J, omega)
        reduced = reduced_inertia(inertia, along, own.J)
        tensor = Matrix(inertia)
        form = of_forms(own.K, own.A, own.G, k, own.J / tensor.det())
        return ((own.J, dot(k, along)), *zip(own.v, v), *((own.K[i][j], second[i][j]) for i, j in UPPER),
                *((own.A[i][j], reduced[i][j]) for i, j in UPPER),
                (own.G, dot(own.v, along) / own.J - omega * tensor.trace()), (own.trace, form.trace.expand()),
                (own.determinant, form.determinant.expand()), (own.p, form.p),
                (own.q, own.J * own.determinant / tensor.det()))

    def criterion(self, notion: Notion) -> Criterion:
        """Return the spectral, formal or secular criterion in these names."""
        own = self.named
        wanted: tuple[tuple[Expr, str], ...] = (own.trace, "t"), (own.determinant, "s")
        if notion == Notion.SPECTRAL:
            wanted = (own.p, "p"), (own.q, "q"), (own.discriminant, "p² − 4q")
        at = self.equilibrium.at
        return Criterion(notion, (tuple(Condition(margin, notion != Notion.SPECTRAL, name, (), at)
                                        for margin, name in wanted),))

    @cached_property
    def required(self) -> tuple[str, ...]:
        """The names that a verdict needs."""
        eq = self.equilibrium
        return names_in([*self._flat, *eq.existence(), *eq.constraints, *eq.point[3:]])

    def at(self, numbers: Point) -> AmendedForm:
        """Return the four numbers at a point, exactly, without inserting the definitions into each other."""
        rational = [_rational(e, numbers) for e in self._flat]
        if None in rational:
            return with_multiplier(*_shaped([evaluate(e, numbers) for e in self._flat]))
        found = with_multiplier(*_shaped(rational))
        return AmendedForm(*(Rational(int(x.p), int(x.q)) for x in found))

    def values(self, number: Callable[[Expr], Any]) -> dict[Symbol, Any]:
        """Return t, s, p and q by name, if number gives expressions of the family in an arithmetic."""
        found, own = with_multiplier(*_shaped([number(e) for e in self._flat])), self.named
        return dict(zip((own.trace, own.determinant, own.p, own.q), found))

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
        rates = body.inverse * Matrix(eq.point[:3])
        axis = next(n for n, x in enumerate(k) if x != 0)
        omega = lowest_terms(eq.insert(rates[axis] / k[axis]))
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
        return [*flat, omega, mu]


closed_form = once(ClosedForm)                             # derived once for each family


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


def _rational(expression: Expr, numbers: Point) -> fmpq | None:
    """Return the value of a fraction of polynomials at rational numbers; None for anything else."""
    if expression.is_Symbol:
        return numbers.rational.get(expression)
    if expression is S.Zero:
        return fmpq(0)
    fraction = compiled(expression)
    point = None if fraction is None else numbers.rational_at(fraction[0])
    if fraction is None or point is None:
        return None
    _, top, bottom = fraction
    return top(*point) if bottom is None else top(*point) / bottom(*point)
