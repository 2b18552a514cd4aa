"""Solves the relation of a family for a name in which it is affine, and tells what is left of a relation."""
from collections.abc import Callable, Sequence

from sympy import Expr, S, Symbol

from ...algebra.reals.exact import is_identically_zero
from ...algebra.rings.polynomials import Ring, lowest_terms
from ...errors import EquilibriumError
from ...notation import symbol


def solved_for(relation: Expr, wanted: str | None, parameters: Sequence[Symbol],
               label: str) -> tuple[str | None, Expr | None, Expr]:
    """Return name, value and leading coefficient of a parameter in which the relation is affine.

    The value is None if there is no such parameter.
    """
    ordered = sorted(parameters, key=lambda s: (bool(s.is_positive), s.name))
    for name in [wanted] if wanted else ["dU", "l", "k3", *map(str, ordered)]:
        if solved := affine(relation, symbol(name)):
            return name, *solved
    if wanted:
        raise EquilibriumError(f"{label}: the relation {relation} = 0 is not affine in {wanted}: eliminate "
                               "another name, or none")
    return None, None, S.One


def affine(relation: Expr, x: Symbol) -> tuple[Expr, Expr] | None:
    """Return solution and leading coefficient of a x + b = 0; None if the relation has no such form."""
    ring = Ring([relation])
    top, _ = ring.fraction(relation)
    if x not in ring.gens or any(x in g.free_symbols for g in ring.generators if g != x):
        return None
    index = ring.generators.index(x)
    if top.degrees()[index] != 1:
        return None
    slope = top.derivative(index)
    rest = top - slope * ring.gens[x]
    return ring.quotient(-rest, slope), ring.expression(slope)


def residual_of(rate: Expr, insert: Callable[[Expr], Expr]) -> Expr | None:
    """Return the rate in lowest terms, with values inserted if needed; None if it is proved to vanish."""
    for expression in (rate, insert(rate)):
        if expression is S.Zero:
            return None
        residual = lowest_terms(expression)
        if residual == 0 or is_identically_zero(residual):
            return None
    return residual
