"""Internal damping of a body at rest in the frame of two directions."""
from collections.abc import Mapping

from sympy import Expr, ImmutableMatrix, S, Symbol

from ..algebra.polynomials import lowest_terms
from ..kept import cached_property
from ..mechanics.circular_orbit import along_velocity, in_orbit
from .criteria import stiffness
from .orientation_form import rests_in_frame
from .secular import Growing, Secular, characteristic

OUT_OF_REACH = ("the damping does not reach every motion: the body may turn about an axis that is tilted "
                "against the normal of the orbit, its rate constant in its axes")
NOT_PROVED = "whether the damping reaches every motion is not proved of a field with a coupling β"
DEGENERATE = "the second variation is degenerate, and terms of higher degree decide"


class SecularInFrame(Secular):
    """The same where the directions are two: the second variation is K beside a positive form of the momenta.

    Damping by the three components of the absolute rate ω reaches every motion of a body in a frame that does
    not turn. In an orbit it does but where t·In = 0 and n·In = r·Ir.

    References
    ----------
    As Secular; the exception in orbit: Derived.
    """

    @cached_property
    def _coefficients(self) -> tuple[Expr, ...]:
        matrix = stiffness(self.variation)
        rows = (self.variation.matrix if matrix is None else matrix).tolist()
        return characteristic([[self.equilibrium.insert(entry) for entry in row] for row in rows])

    @cached_property
    def _torques(self) -> tuple[Expr, ...]:
        """What vanishes where the damping does not reach every motion."""
        eq = self.equilibrium
        if not rests_in_frame(eq):
            return ()                                      # whether it does is not known
        if not in_orbit(eq.system):
            return (S.One,)
        n, r = (ImmutableMatrix(eq.point[i:i + 3]) for i in (3, 6))
        tensor = eq.system.body.tensor
        found = ((tensor * n).dot(along_velocity(n, r)), n.dot(tensor * n) - r.dot(tensor * r))
        return tuple(e for x in found if (e := lowest_terms(eq.insert(x))) != 0)

    def _spins(self, numbers: Mapping[Symbol, Expr]) -> bool:
        return False

    @property
    def _rest(self) -> Expr:
        return S.One

    def _along(self, numbers: Mapping[Symbol, Expr]) -> Growing:
        return None, OUT_OF_REACH if rests_in_frame(self.equilibrium) else NOT_PROVED, None

    def _degenerate(self, numbers: Mapping[Symbol, Expr]) -> Growing:
        return None, DEGENERATE, None
