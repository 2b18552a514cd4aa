"""The equations of motion in the coordinates and the jet of U, and their derivatives."""
from collections.abc import Callable, Sequence
from functools import lru_cache

from sympy import Add, Expr, ImmutableMatrix, Mul, Symbol

from ...algebra.rings.matrices import applied, solved
from ...algebra.rings.polynomials import Ring, derivatives
from ...notation import components, jet
from .body import Gyrostat
from .lie_poisson import LiePoisson
from .potential import Potential


# the jet is the same for every U: what is derived in it is derived once for a body
@lru_cache(maxsize=64)
def jet_field(space: LiePoisson, energy_gradient: tuple[Expr, ...]) -> ImmutableMatrix:
    """Return B ∇h, with one coefficient for each product of coordinates."""
    return ImmutableMatrix([_collected(component, space.coordinates)
                            for component in applied(space.tensor.tolist(), energy_gradient)])


@lru_cache(maxsize=64)
def jet_jacobian(field: ImmutableMatrix, coordinates: tuple[Symbol, ...],
                 following: tuple[tuple[Symbol, tuple[Expr, ...]], ...]) -> ImmutableMatrix:
    """Return the derivative of the field along the coordinates, dU differentiated to d2U.

    Each symbol of the jet comes with the symbols that follow it.
    """
    rows = []
    for rate in field.flat():
        row = derivatives(rate, (*coordinates, *(d for d, _ in following)))
        for (_, inner), outer in zip(following, row[len(coordinates):]):
            row[3:6] = [entry + outer * slope for entry, slope in zip(row[3:6], inner)]
        rows.append(row[:len(coordinates)])
    return ImmutableMatrix(rows)


def gradient_at(gradient: Sequence[Expr], body: Gyrostat | None,
                place: Callable[[Expr], Expr]) -> tuple[Expr, ...]:
    """Return ∇h at a point; if a body is given, its rates first, with Iω = π.

    A tensor with products of inertia has a long inverse, and ω is short: the system is solved at the point.

    Parameters
    ----------
    gradient : sequence of Expr
        ∇h
    body : Gyrostat or None
        None if the rates are not I⁻¹π, because of a coupling
    place : callable
        inserts the point into an expression

    Returns
    -------
    tuple of Expr
    """
    if body is None or not isinstance(body.inertia, ImmutableMatrix):
        return tuple(map(place, gradient))
    tensor = [list(map(place, row)) for row in body.inertia.tolist()]
    return *solved(tensor, list(map(place, components("pi")))), *map(place, gradient[3:])


def field_at(space: LiePoisson, gradient: Sequence[Expr], place: Callable[[Expr], Expr]
             ) -> list[tuple[Symbol, Expr]]:
    """Return each coordinate with its rate at a point, B ∇h, by ∇h there."""
    tensor = [list(map(place, row)) for row in space.tensor.tolist()]
    return list(zip(space.coordinates, applied(tensor, gradient)))


def inserted(potential: Potential, rates: Sequence[Expr]) -> list[Expr]:
    """Return rates in the jet of U with what its symbols stand for."""
    values = {d: potential.value(d) for d in set().union(*(r.free_symbols for r in rates)) if jet(d.name)}
    return [rate.xreplace(values) for rate in rates]


def _collected(component: Expr, coordinates: tuple[Symbol, ...]) -> Expr:
    """Return the component with one coefficient for each product of coordinates, (I1 − I3)/(I1 I3) π2 π3."""
    ring = Ring([component])
    top, bottom = ring.fraction(component)
    return Add(*(Mul(ring.quotient(coefficient, bottom), ring.monomial(kind))
                 for kind, coefficient in ring.coefficients(top, set(coordinates)).items()))
