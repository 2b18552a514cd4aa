"""Finds which linear motions internal damping reaches, and how many of them grow, exactly at numbers.

The method is the theorem of Kelvin, Tait and Chetaev on the part of the motion that the damping reaches.
"""
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

from sympy import Expr, S

from ...algebra.reals.exact import Point, evaluate
from ...algebra.reals.number_matrices import (
    NotProvedError,
    Numbers,
    form_on,
    kernel,
    matrices_of,
    negative_squares,
    product,
    rank,
    stacked,
)
from ...mechanics.equilibrium.coadjoint_orbit import orbit_tangent
from ...mechanics.equilibrium.derivation_ring import rows_at_point
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.standard_axes import placed
from ...mechanics.scenes.kind import Kind
from ..criteria.energy_casimir import restricted
from ..criteria.linearization import linearize

Rows: TypeAlias = Sequence[Sequence[Expr]]


class Growing(NamedTuple):
    """Whether linear motions grow, None if that is not decided, and how many, None if not counted."""

    grows: bool | None
    modes: int | None


def growing_at(eq: Equilibrium, numbers: Point) -> Growing:
    """Return whether linear motions grow under internal damping at numbers, some of which it may not reach.

    Damping reaches a motion unless the rate δω stays constant in the body: a viscous sphere then turns with
    it. Such motions make the subspace N, the largest one that J maps into itself and on which δω̇ = C J x is
    0.

    The energy has the second variation Q, with the Casimirs. What is orthogonal to N in Q is mapped into
    itself, too, because Q(Jx, y) = −Q(x, Jy) for x in N. There damping reaches every motion but those of N,
    and as many grow as Q has negative squares there (Kelvin, Tait, Chetaev); on N motions go on as without
    damping. On the kernel of Q J is 0, and all is said about the quotient by it.

    For every damping D, det(J − D) has the sign of det Q: if Q is regular and has an odd number of negative
    squares, a real eigenvalue is positive.

    Parameters
    ----------
    eq : Equilibrium
    numbers : Point
        exact

    Returns
    -------
    Growing
        True if Q has a negative square across N, or an odd number of them, in all or on N; counted if N is
        not isotropic in part and Q is semidefinite on it

    References
    ----------
    Derived from Kelvin & Tait, Treatise on Natural Philosophy (1879), §345, and Chetaev, The Stability of
    Motion (1961), in docs/explanation/derivations/damping.md, section 6.
    """
    try:
        found = _at(_matrices(eq), numbers)
        if found is None:                              # the basis of the family may be none here
            found = _at(_matrices(placed(eq, numbers)), numbers)
        return Growing(None, None) if found is None else _counted(*found)
    except NotProvedError:
        return Growing(None, None)


def _at(matrices: tuple[Rows, ...], numbers: Point) -> list[Numbers] | None:
    """Return Q, J and δω by the coordinates at numbers; None if the columns are no basis there."""
    values = [[[evaluate(x, numbers) for x in row] for row in rows] for rows in matrices]
    if any(x.is_finite is not True for rows in values for row in rows for x in row):
        return None
    tangent, Q, J, rate = matrices_of(*values)
    return [Q, J, product(rate, tangent)] if rank(tangent) == len(values[1]) else None


@once
def _matrices(eq: Equilibrium) -> tuple[Rows, ...]:
    """Return a basis of the tangent space of the orbit, Q and J in it, and δω by the coordinates, as rows."""
    tangent = orbit_tangent(eq)
    found = (tangent.tolist(), restricted(eq, (tangent, ()), eq.system.space.casimirs).matrix.tolist(),
             linearize(eq).matrix.tolist(), _rate(eq))
    return tuple([[eq.insert(x) for x in row] for row in rows] for rows in found)


def _counted(Q: Numbers, J: Numbers, rate: Numbers) -> Growing:
    """Return what grows, by the matrices in a basis of the tangent space."""
    size = len(J.tolist())
    rows = [product(rate, J)]
    while len(rows) < size:
        rows.append(product(rows[-1], J))
    # N is the unobservable subspace of C J, by Kalman's matrix; the kernel of Q lies in it
    unreached = kernel(stacked(rows))
    on, beyond = form_on(Q, unreached), form_on(Q, kernel(product(Q, unreached).transpose()))
    degenerate = size - rank(Q)
    splits = len(on.tolist()) - rank(on) == degenerate              # otherwise N is isotropic in part
    negative, kept = negative_squares(beyond), negative_squares(on)
    if negative:
        return Growing(True, negative if splits and kept in (0, rank(on)) else None)
    # undamped on N, a regular J with an odd number of negative squares has a positive eigenvalue
    odd = not degenerate and negative_squares(Q) % 2
    gyroscopic = splits and kept % 2 and rank(form_on(product(Q, J), unreached)) == rank(on)
    return Growing(True if odd or gyroscopic else None, None)


def _rate(eq: Equilibrium) -> list[list[Expr]]:
    """Return δω by the coordinates: the variation of ∂h/∂π.

    In an orbit it is that of the absolute rate I⁻¹π, because ∂h/∂π is the rate against the frame, which
    turns.
    """
    rows = rows_at_point(eq, eq.system.energy_hessian)[:3]
    if eq.system.kind is not Kind.ORBIT:
        return rows
    return [[*row[:3], *([S.Zero] * (len(row) - 3))] for row in rows]
