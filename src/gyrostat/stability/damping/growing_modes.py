"""Finds which linear motions internal damping reaches, and how many of them grow, exactly at numbers.

The method is the theorem of Kelvin, Tait and Chetaev on the part of the motion that the damping reaches.
"""
from typing import NamedTuple

from sympy import Expr, ImmutableMatrix, Matrix, S

from ...algebra.reals.exact import Point, evaluate
from ...algebra.reals.number_matrices import NotProvedError, exact, form_on, kernel, negative_squares, rank
from ...mechanics.equilibrium.coadjoint_orbit import orbit_tangent
from ...mechanics.equilibrium.derivation_ring import rows_at_point
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.standard_axes import placed
from ...mechanics.scenes.kind import Kind
from ..criteria.energy_casimir import restricted
from ..criteria.linearization import linearize


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
        tangent, Q, J, rate = (m.applyfunc(lambda x: evaluate(x, numbers)) for m in _matrices(eq))
        if any(x.is_finite is not True for m in (tangent, Q, J, rate) for x in m) or rank(tangent) < Q.rows:
            # the basis was chosen for the family, and is none at these numbers
            tangent, Q, J, rate = (m.applyfunc(lambda x: evaluate(x, numbers))
                                   for m in _matrices(placed(eq, numbers)))
        return _counted(Q, J, rate * tangent)
    except NotProvedError:
        return Growing(None, None)


@once
def _matrices(eq: Equilibrium) -> tuple[Matrix, ...]:
    """Return a basis of the tangent space of the orbit, Q and J in it, and δω by the coordinates."""
    tangent = orbit_tangent(eq)
    found = (tangent, restricted(eq, (tangent, ()), eq.system.space.casimirs).matrix, linearize(eq).matrix,
             ImmutableMatrix(_rate(eq)))
    return tuple(Matrix(m).applyfunc(eq.insert) for m in found)


def _counted(Q: Matrix, J: Matrix, rate: Matrix) -> Growing:
    """Return what grows, by the matrices in a basis of the tangent space."""
    rows = [rate * J]
    while len(rows) < J.rows:
        rows.append((rows[-1] * J).applyfunc(exact))
    # N is the unobservable subspace of C J, by Kalman's matrix; the kernel of Q lies in it
    unreached = kernel(Matrix.vstack(*rows))
    on, beyond = form_on(Q, unreached), form_on(Q, kernel((Q * unreached).T))
    degenerate = Q.rows - rank(Q)
    splits = on.rows - rank(on) == degenerate              # otherwise N is isotropic in part
    negative, kept = negative_squares(beyond), negative_squares(on)
    if negative:
        return Growing(True, negative if splits and kept in (0, rank(on)) else None)
    # undamped on N, a regular J with an odd number of negative squares has a positive eigenvalue
    odd = not degenerate and negative_squares(Q) % 2
    gyroscopic = splits and kept % 2 and rank(form_on(Q * J, unreached)) == rank(on)
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
