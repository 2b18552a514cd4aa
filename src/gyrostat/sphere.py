"""What decides between the two criteria for a free body about a principal axis: the energy on the momentum sphere, to fourth order."""
from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, Symbol

from .equilibria import Equilibrium
from .exact import evaluate, sign_of_constant


@dataclass(frozen=True)
class Sphere:
    """The energy of a free body on |M| = R near its rotation about a principal axis a that carries l.

    With M = (x, y, √(R² − x² − y²)) along the axes b, c, a, h = h₀ + f_b x²/(2 I_b R) + f_c y²/(2 I_c R) + l (x² + y²)²/(8 I_a R³) + …,
    f = R − I ω. Where one f is 0, the fourth order decides along its axis: an extremum, hence stable, where l and the other f have one
    sign; l = 0: a circle of equilibria, which drift: unstable. Where both are 0, h depends on x² + y² alone, or is constant: stable.

    Parameters
    ----------
    equilibrium : Equilibrium
    axis : int                       0, 1 or 2

    Source
    ------
    Derived; the quadratic part, Hughes, Spacecraft Attitude Dynamics (1986), chapter 6.
    """

    equilibrium: Equilibrium
    axis: int

    def decide(self, numbers: Mapping[Symbol, Expr], margins: dict[Expr, Expr]) -> tuple[bool | None, str]:
        """Whether the rotation is stable at numbers where f_b f_c = 0, None if a sign is not proved; and why."""
        eq, body = self.equilibrium, self.equilibrium.system.body
        pi, l, own = eq.point[self.axis], body.gyrostatic_momentum[self.axis], body.inertia[self.axis]
        falls = [eq.insert(pi + l - moment * pi / own) for n, moment in enumerate(body.inertia) if n != self.axis]
        values = {e: evaluate(e, numbers) for e in (*falls, eq.insert(l))}
        first, second, rotor = (sign_of_constant(values[e]) for e in (*falls, eq.insert(l)))
        margins.update(values)
        if first is None or second is None or rotor is None:
            return None, "a margin has no proved sign"
        if first == second == 0:
            return True, "the energy on the momentum sphere depends on the distance from the axis alone: it is an extremum, or constant"
        if rotor == 0:
            return False, "the rotation lies on a circle of rotations, and those beside the circle drift along it"
        if rotor * (first or second) > 0:
            return True, "to fourth order the energy is an extremum on the momentum sphere"
        return False, "to fourth order the energy is no extremum on the momentum sphere: motions of the same energy leave"


def sphere_of(eq: Equilibrium) -> Sphere | None:
    """The sphere of a free body that rotates about a principal axis with l along it, None for anything else."""
    if eq.system.potential is not None:
        return None
    axes = [n for n, (pi, l) in enumerate(zip(eq.point, eq.system.body.gyrostatic_momentum)) if pi != 0 or l != 0]
    return Sphere(eq, axes[0]) if len(axes) == 1 else None
