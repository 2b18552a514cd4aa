"""What decides for any body where the second variation is degenerate: elementary theorems, at numbers."""
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from sympy import Expr, Mul, Symbol

from ..._cached import cached_property
from ...algebra.reals.exact import sign
from ...algebra.solving.margins import Signs
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.kind import Kind
from ...notation import symbol
from ..criteria.linearization import Linearization
from ..criteria.numbers_asked import names_in, names_of_motion
from ..decision import Decision, undecided
from ..normal_forms.local_motion import local_motion
from ..normal_forms.windows import decide_window
from .amended_expansion import Amended
from .given_integrals import decide_by_integrals
from .momentum_sphere import extremum_at
from .no_torque import torque_free
from .two_directions import decide_in_frame, may_lie_on_curve, open_between

DEGREE = 4                                                 # of U, where only its derivatives are given


@dataclass(frozen=True)
class Elementary:
    """Integrals that are given; the free body where no torque acts, else normal forms and amended potential.

    Parameters
    ----------
    equilibrium : Equilibrium
    linearization : Linearization
    decided : callable
        the decision on an equilibrium of the free body
    point_decided : callable
        the decision on the axis of a satellite in the frame of its orbit, as a point: no turn of that frame
        is a symmetry of the satellite
    """

    equilibrium: Equilibrium
    linearization: Linearization
    decided: Callable[[Equilibrium], Decision]
    point_decided: Callable[[Equilibrium], Decision]

    @cached_property
    def _determinant(self) -> tuple[Expr, tuple[str, ...]]:
        """What vanishes where the second variation is degenerate, the determinant of the linearised field
        without factors that are positive; and the names in it.
        """
        determinant = self.equilibrium.insert(self.linearization.coefficients[-1])
        margin, even = Signs.over([determinant], self.equilibrium.existence()).normal_form(determinant)
        factors = (margin, *even)
        return Mul(*factors), names_in(factors)

    def decide(self, numbers: Mapping[Symbol, Expr]) -> Decision:
        """The decision between the two criteria."""
        eq, (determinant, names) = self.equilibrium, self._determinant
        missing = [name for name in names if symbol(name) not in numbers]
        degenerate = not missing and sign(determinant, numbers) == 0
        if not open_between(eq) or degenerate and may_lie_on_curve(eq):
            missing += [name for name in names_of_motion(eq) if symbol(name) not in numbers]
        if missing:
            return undecided("the point lies between the two criteria; give "
                             f"{', '.join(dict.fromkeys(missing))} to decide")
        if eq.system.coupled:
            return decide_in_frame(eq, numbers, degenerate, self.point_decided)
        if eq.system.kind is Kind.FREE:
            return extremum_at(eq, numbers).decision
        by_integrals = decide_by_integrals(eq, numbers)
        if by_integrals.stable:
            return by_integrals
        beyond = self._without_integrals(numbers, degenerate)
        if not by_integrals.reason:
            return beyond
        return replace(beyond, reason=f"{by_integrals.reason}; {beyond.reason}")

    def _without_integrals(self, numbers: Mapping[Symbol, Expr], degenerate: bool) -> Decision:
        """What normal forms and the amended potential decide."""
        eq = self.equilibrium
        if not degenerate:
            return self._window(numbers)
        if torqueless := torque_free(eq, numbers):
            return torqueless.decide(self.decided)
        return Amended(eq, numbers).decide(self._oscillates(numbers))

    def _oscillates(self, numbers: Mapping[Symbol, Expr]) -> bool:
        """Whether p > 0: beside the eigenvalue 0 there are imaginary ones."""
        p = self.equilibrium.insert(self.linearization.coefficients[0])
        return sign(p, numbers) == 1

    def _window(self, numbers: Mapping[Symbol, Expr]) -> Decision:
        """Where gyroscopic forces hold a maximum of the amended potential."""
        motion = local_motion(self.equilibrium, numbers, DEGREE)
        if isinstance(motion, list):
            return undecided("the amended potential has a maximum, held by gyroscopic forces; give "
                             f"{', '.join(motion)} to decide")
        return decide_window(motion)
