"""Solves a relation for a name in which it is affine, inserts what names are, and refuses what is not 0."""
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from sympy import Expr, S, Symbol

from ...algebra.reals.exact import is_identically_zero
from ...algebra.rings.polynomials import Ring, lowest_terms
from ...errors import EquilibriumError, brief
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


def replaced(expression: Any, known: dict[Symbol, Expr], of: Callable[[Symbol], Expr]) -> Any:
    """Return an expression or matrix with what each of its symbols becomes, which is found once.

    Parameters
    ----------
    expression : Expr or ImmutableMatrix, any shape
    known : dict of Symbol to Expr
        what was found; it is added to
    of : callable
        tells what a symbol becomes

    Returns
    -------
    Expr or ImmutableMatrix, of the same shape
    """
    for name in (free := expression.free_symbols) - known.keys():
        known[name] = of(name)
    rule = {name: known[name] for name in free if known[name] is not name}
    return expression.xreplace(rule) if rule else expression


def refuse_rate(label: str, field: Sequence[tuple[Symbol, Expr]], insert: Callable[[Expr], Expr]) -> None:
    """Refuse a point at which a rate of the field does not vanish, or is not proved to."""
    ring = Ring(rate for _, rate in field)                 # one for all, as they have long parts in common
    left = [(f"d{coordinate}/dt = {brief(residual)}", is_identically_zero(residual))
            for coordinate, rate in field
            if ring.numerator(rate) and (residual := residual_of(rate, insert))]
    if wrong := [rate for rate, zero in left if zero is False]:
        raise EquilibriumError(f"{label} is not an equilibrium: {', '.join(wrong[:2])}. Check the "
                               "point, or in Python pass the relation that makes these vanish "
                               "as relations=((symbol, value),).")
    if left:
        raise EquilibriumError(f"{label} is not proved to be an equilibrium: whether "
                               f"{', '.join(rate for rate, _ in left)} is 0 is not decided. Write its "
                               "numbers with rationals and roots.")


def refuse_lengths(label: str, held: Iterable[tuple[Expr, Expr, Expr]],
                   insert: Callable[[Expr], Expr]) -> None:
    """Refuse directions if a Casimir, given with the value that the scene gives it, has another one there."""
    for casimir, value, there in held:
        if excess := residual_of(there - value, insert):
            unknown = " (not proved to be 0)" if is_identically_zero(excess) is None else ""
            raise EquilibriumError(f"{label} has {casimir} − {value} = {excess}{unknown}, not 0: correct the "
                                   "directions")
