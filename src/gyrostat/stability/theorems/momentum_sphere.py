"""Decides a free body between the two criteria, by its energy on the momentum sphere to fourth order."""
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from sympy import Expr, ImmutableMatrix, Matrix, S, Symbol, eye

from ..._cached import cached_property
from ...algebra.reals.exact import evaluate, sign, sign_of_constant
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.body import Gyrostat
from ...mechanics.scenes.kind import Kind
from ..decision import Decision, Rung, settled, undecided

DRIFTS = "the rotation lies on a circle of rotations, and those beside the circle drift along it"
TO_FOURTH_ORDER = "to fourth order the energy is an extremum on the momentum sphere"
BY_DISTANCE = ("the energy on the momentum sphere depends on the distance from the axis alone: it is an "
               "extremum, or constant")
NO_EXTREMUM = ("where rotations meet, the energy is no extremum on the momentum sphere: motions of the same "
               "energy leave")


class Extremum(NamedTuple):
    """The kind of critical point that the energy has on the momentum sphere, and why.

    Parameters
    ----------
    sign : int or None
        1 for a minimum, −1 for a maximum, 0 for neither; None if that is not proved
    why : str
        the reason in a sentence
    """

    sign: int | None
    why: str

    @property
    def decision(self) -> Decision:
        """The decision: stable if the energy has an extremum."""
        if self.sign is None:
            return undecided(self.why)
        return settled(self.sign != 0, self.why, Rung.FOURTH_ORDER)


def extremum(body: Gyrostat, M: Sequence[Expr], nu: Expr) -> Extremum:
    """Tell whether the energy of a free gyrostat has an extremum at a degenerate rotation.

    The energy is taken on the momentum sphere. With D = I⁻¹ − ν, Δ = M·adj(D) M = 0 there. It is an extremum
    in two cases. First, adj(D) M = 0 and tr adj(D) > 0: in principal axes Mᵢ = 0 = dᵢ and dⱼ dₖ > 0, and
    three rotations meet. Second, adj(D) = 0: about the axis of a body of revolution that carries l. It is
    none anywhere else (folds, umbilics).

    Parameters
    ----------
    body : Gyrostat
        at given numbers
    M : sequence of Expr, shape (3,)
        exact numbers [M L²/T]
    nu : Expr
        ω = ν M [1/(M L²)]

    Returns
    -------
    Extremum

    References
    ----------
    Derived in docs/explanation/derivations/boundaries.md, section 6: where three rotations meet,
    h − h₀ = e t²/2 + d_j d_k y⁴/(8 abs(M)² e) + …, e = (d_k M_j² + d_j M_k²)/abs(M)².
    """
    D, momentum = body.inverse - nu * eye(3), Matrix(M)
    adjugate = D.adjugate()
    signs = [sign(x, {}) for x in (*adjugate, *(adjugate * momentum), adjugate.trace(), D.trace())]
    minors, moved, product, trace = signs[:9], signs[9:12], signs[12], signs[13]
    if not any(minors):
        along = sign(momentum.dot(Matrix(body.gyrostatic_momentum)), {})
        return Extremum(None if None in minors else along, BY_DISTANCE)
    if None in signs:
        return Extremum(None, "a sign is not proved")
    if not any(moved) and product == 1:                    # dⱼ and dₖ have one sign, that of the trace
        return Extremum(trace, TO_FOURTH_ORDER)
    return Extremum(0, NO_EXTREMUM)


def extremum_at(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Extremum:
    """Return the kind of critical point at an equilibrium of a free gyrostat, M ≠ 0, at exact numbers."""
    body = eq.system.body.changed(lambda x: evaluate(eq.insert(x), numbers))
    pi = Matrix([evaluate(eq.insert(x), numbers) for x in eq.point])
    M = [evaluate(p + l, {}) for p, l in zip(pi, body.gyrostatic_momentum)]
    axis = next(n for n in range(3) if sign_of_constant(M[n]))
    return extremum(body, M, (body.inverse * pi)[axis] / M[axis])


@dataclass(frozen=True)
class MomentumSphere:
    """The energy of a free body on abs(M) = R near its rotation about a principal axis a that carries l.

    With M = (x, y, √(R² − x² − y²)) along the axes b, c, a, and f = R − I ω for the moments of b and c,

    h = h₀ + f_b x²/(2 I_b R) + f_c y²/(2 I_c R) + l (x² + y²)²/(8 I_a R³) + …,

    from the expansion of (√(R² − x² − y²) − l)²/(2 I_a) with I_a ω = R − l. If one f is 0, the fourth order
    decides along its axis: if l and the other f have one sign, h has an extremum, and the rotation is stable;
    if they have two, it is unstable; if l = 0, it lies on a circle of equilibria, beside which others drift:
    unstable. If both f are 0, h depends on x² + y² alone, or is constant: stable.

    Parameters
    ----------
    equilibrium : Equilibrium
    axis : int
        0, 1 or 2

    References
    ----------
    Derived in docs/explanation/derivations/boundaries.md, section 6; the quadratic part, Hughes, Spacecraft
    Attitude Dynamics (1986), chapter 6.
    """

    equilibrium: Equilibrium
    axis: int

    @cached_property
    def falls(self) -> tuple[Expr, Expr]:
        """The coefficients f_b and f_c [M L²/T]."""
        eq, body = self.equilibrium, self.equilibrium.system.body
        total = eq.point[self.axis] + body.gyrostatic_momentum[self.axis]
        b, c = (eq.insert(total - moment * eq.point[self.axis] / body.moments[self.axis])
                for n, moment in enumerate(body.moments) if n != self.axis)
        return b, c

    @cached_property
    def rotor(self) -> Expr:
        """The l along the axis."""
        return self.equilibrium.insert(self.equilibrium.system.body.gyrostatic_momentum[self.axis])

    def ladder(self, limit: int | None = None) -> Iterator[Expr]:
        """Yield what decides if f_b f_c = 0: it is stable if the first that is not 0 is positive."""
        either = sum(self.falls)                           # the one that is not 0
        yield from (self.rotor * either, -(either**2), S.One)

    def expressions(self) -> tuple[Expr, ...]:
        """Return f_b, f_c and the rotor, whose signs decide."""
        return *self.falls, self.rotor

    def decide(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> Decision:
        """Return the decision at numbers with f_b f_c = 0."""
        values = {e: evaluate(e, numbers) for e in (*self.falls, self.rotor)}
        first, second, rotor = (sign_of_constant(values[e]) for e in (*self.falls, self.rotor))
        margins.update(values)
        if first is None or second is None or rotor is None:
            return undecided("a margin has no proved sign")
        if first == second == 0:
            return settled(True, BY_DISTANCE, Rung.FOURTH_ORDER)
        if rotor == 0:
            return settled(False, DRIFTS, Rung.DRIFT)
        if rotor * (first or second) > 0:
            return settled(True, TO_FOURTH_ORDER, Rung.FOURTH_ORDER)
        return settled(False, "to fourth order the energy is no extremum on the momentum sphere: motions of "
                       "the same energy leave", Rung.FOURTH_ORDER)


def sphere_of(eq: Equilibrium) -> MomentumSphere | None:
    """Return the sphere of a free body that rotates about a principal axis with l along it, else None."""
    if eq.system.kind is not Kind.FREE or isinstance(eq.system.body.inertia, ImmutableMatrix):
        return None
    axes = [n for n, (pi, l) in enumerate(zip(eq.point, eq.system.body.gyrostatic_momentum)) if pi != 0
            or l != 0]
    return MomentumSphere(eq, axes[0]) if len(axes) == 1 else None
