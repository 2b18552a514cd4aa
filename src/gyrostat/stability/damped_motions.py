"""Which linear motions internal damping reaches, and how many of them grow: exactly, at numbers."""
from collections.abc import Sequence
from typing import NamedTuple

from sympy import Expr, ImmutableMatrix, Matrix, S

from ..algebra.exact import Point, evaluate
from ..algebra.number_matrices import NotProvedError, exact, form_on, kernel, negative_squares, rank
from ..mechanics.circular_orbit import in_orbit
from ..mechanics.derivation import rows_at_point
from ..mechanics.equilibria import Equilibrium
from ..mechanics.orbit import orbit_tangent
from ..mechanics.standard import placed
from .energy_casimir import restricted
from .linearization import linearize


class Growing(NamedTuple):
    """Whether linear motions grow, None where that is not decided, and how many, None where not counted."""

    grows: bool | None
    modes: int | None


def growing_at(eq: Equilibrium, numbers: Point) -> Growing:
    """Whether linear motions grow under internal damping at numbers, some of which it may not reach.

    Damping reaches a motion unless the rate δω stays constant in the body: a viscous sphere then turns with
    it. These motions make the subspace N, the largest that J maps into itself and on which δω̇ = C J x is 0.
    The energy has the second variation Q, with the Casimirs; what is orthogonal to N in Q is mapped into
    itself too, because Q(Jx, y) = −Q(x, Jy) for x in N. There damping reaches every motion but those of N,
    and as many grow as Q has negative squares there (Kelvin, Tait, Chetaev); on N motions go on as without
    damping. Where Q is degenerate J is 0, and all is said of the quotient. And det(J − D) has the sign of
    det Q for every damping D: if Q is regular and has an odd number of negative squares, a real eigenvalue is
    positive.

    Parameters
    ----------
    eq : Equilibrium
    numbers : Point

    Returns
    -------
    Growing
        True where Q has a negative square across N, or an odd number of them, in all or on N; counted where
        N is not isotropic in part and Q is semidefinite on it

    References
    ----------
    Derived from Kelvin & Tait, Treatise on Natural Philosophy (1879), §345, and Chetaev, The Stability of
    Motion (1961): the part that is reached is a system by itself.
    """
    try:
        return _counted(placed(eq, numbers), numbers)
    except NotProvedError:
        return Growing(None, None)


def _counted(eq: Equilibrium, numbers: Point) -> Growing:
    def at_numbers(rows: Sequence[Sequence[Expr]]) -> Matrix:
        return Matrix(ImmutableMatrix(rows).applyfunc(lambda x: evaluate(eq.insert(x), numbers)))

    tangent = orbit_tangent(eq)
    Q = at_numbers(restricted(eq, (tangent, ()), eq.system.space.casimirs).matrix.tolist())
    J = at_numbers(linearize(eq).matrix.tolist())
    rate = at_numbers(_rate(eq)) * at_numbers(tangent.tolist())
    rows = [rate * J]
    while len(rows) < J.rows:
        rows.append((rows[-1] * J).applyfunc(exact))
    unreached = kernel(Matrix.vstack(*rows))              # N; the kernel of Q lies in it
    on, beyond = form_on(Q, unreached), form_on(Q, kernel((Q * unreached).T))
    degenerate = Q.rows - rank(Q)
    splits = on.rows - rank(on) == degenerate              # else N is isotropic in part
    negative, kept = negative_squares(beyond), negative_squares(on)
    if negative:
        return Growing(True, negative if splits and kept in (0, rank(on)) else None)
    odd = not degenerate and negative_squares(Q) % 2
    gyroscopic = splits and kept % 2 and rank(form_on(Q * J, unreached)) == rank(on)
    return Growing(True if odd or gyroscopic else None, None)


def _rate(eq: Equilibrium) -> list[list[Expr]]:
    """δω by the coordinates: of ∂h/∂π, and in an orbit of I⁻¹π, for the directions turn with the frame."""
    rows = rows_at_point(eq, eq.system.energy_hessian)[:3]
    return [[*row[:3], *([S.Zero] * (len(row) - 3))] for row in rows] if in_orbit(eq.system) else rows
