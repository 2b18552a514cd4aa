"""What decides for any body where the second variation is degenerate: elementary theorems, at numbers."""
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sympy import Expr, Symbol

from ..algebra.exact import sign
from ..kept import cached_property
from ..mechanics.equilibria import Equilibrium
from ..notation import symbol
from .amended import Amended
from .decision import Finding, settled
from .in_frame import decide_in_frame
from .integrals import decide_by_integrals
from .linearization import Linearization
from .local_motion import local_motion
from .sphere import extremum_at
from .torquefree import torque_free
from .values import names_in
from .windows import decide_window

DEGREE = 4                                                 # of U, where only its derivatives are given


@dataclass(frozen=True)
class Elementary:
    """Integrals that are given; the free body where no torque acts, else normal forms and amended potential.

    Parameters
    ----------
    equilibrium : Equilibrium
    linearization : Linearization
    free : callable
        whether another equilibrium is stable, of the free body or of the axis of a satellite, and why
    """

    equilibrium: Equilibrium
    linearization: Linearization
    free: Callable[[Equilibrium], Finding]

    @cached_property
    def _determinant(self) -> tuple[Expr, tuple[str, ...]]:
        """Of the linearised field, 0 where the second variation is degenerate; and the names in it."""
        determinant = self.equilibrium.insert(self.linearization.coefficients[-1])
        return determinant, names_in([determinant])

    def decide(self, numbers: Mapping[Symbol, Expr]) -> Finding:
        """Whether it is stable between the two criteria, None if that is not known; the notion, and why."""
        eq, (determinant, names) = self.equilibrium, self._determinant
        if missing := [name for name in names if symbol(name) not in numbers]:
            return settled(None, "the point lies between the two criteria; give "
                           f"{', '.join(missing)} to decide")
        if eq.system.coupled:
            return decide_in_frame(eq, numbers, sign(determinant, numbers) == 0, self.free)
        if eq.system.potential is None:
            found, why = extremum_at(eq, numbers)
            return settled(None if found is None else found != 0, why)
        by_integrals = decide_by_integrals(eq, numbers)
        if by_integrals.stable:
            return by_integrals
        beyond = self._without_integrals(numbers, sign(determinant, numbers) == 0)
        return beyond._replace(why=f"{by_integrals.why}; {beyond.why}") if by_integrals.why else beyond

    def _without_integrals(self, numbers: Mapping[Symbol, Expr], degenerate: bool) -> Finding:
        """What normal forms and the amended potential decide."""
        eq = self.equilibrium
        if not degenerate:
            return self._window(numbers)
        if torqueless := torque_free(eq, numbers):
            return settled(*torqueless.decide(self.free))
        return Amended(eq, numbers).decide(self._oscillates(numbers))

    def _oscillates(self, numbers: Mapping[Symbol, Expr]) -> bool:
        """Whether p > 0: beside the eigenvalue 0 there are imaginary ones."""
        p = self.equilibrium.insert(self.linearization.coefficients[0])
        return sign(p, numbers) == 1

    def _window(self, numbers: Mapping[Symbol, Expr]) -> Finding:
        """Where gyroscopic forces hold a maximum of the amended potential."""
        motion = local_motion(self.equilibrium, numbers, DEGREE)
        if isinstance(motion, list):
            return settled(None, "the amended potential has a maximum, held by gyroscopic forces; give "
                              f"{', '.join(motion)} to decide")
        return decide_window(motion)
