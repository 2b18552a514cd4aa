"""The report of an equilibrium where two directions are parallel: a singular orbit."""
from dataclasses import replace

from sympy import Expr

from ..algebra.exact import Point
from ..kept import cached_property
from ..mechanics.equilibria import Equilibrium
from ..mechanics.parallel import parallel
from ..mechanics.relations import residual_of
from .conditions import Criterion
from .decision import Finding, settled
from .energy_casimir import SecondVariation
from .linearization import Linearization
from .report import Report
from .secular import Secular
from .truth import holds

MINIMUM = ("the directions are parallel and the body is at rest: with a multiple of the Casimirs the energy "
           "has a minimum against all motions, those too in which the directions do not stay parallel")
OTHERS = "against motions in which the directions do not stay parallel nothing is proved"


class ParallelReport(Report):
    """Of an equilibrium with parallel directions, by that of the motions in which they stay parallel.

    Its matrices are those of parallel_directions(eq); so is what is necessary. At rest their second variation
    with the Casimirs decides more. The angle c of the directions is c = b − r a, and a multiple of |c|² is a
    combination of the Casimirs a·a, a·b, b·b: added to the energy it makes the second variation positive on all
    of the kernel of their differentials, if it is so where c = 0 (Finsler). Then the equilibrium is stable, and
    under internal damping too.

    Examples
    --------
    >>> import gyrostat as gs
    >>> vehicle = gs.underwater_vehicle(weight=(0, 0, gs.symbol("m0")))
    >>> rising = gs.analyze(gs.steady_motion(vehicle, (0, 0, gs.symbol("p0")), (0, 0, 1)))
    >>> print(rising.sufficient)
    mass₁ mass₃ m₀ > p₀² (mass₁ − mass₃) and mass₂ mass₃ m₀ > p₀² (mass₂ − mass₃)
    """

    @cached_property
    def along(self) -> Report:
        """Of the motions in which the directions stay parallel."""
        found = parallel(self.equilibrium)
        assert found is not None
        return Report(found)

    @property
    def linearization(self) -> Linearization:
        """In the motions in which the directions stay parallel."""
        return self.along.linearization

    @property
    def second_variation(self) -> SecondVariation:
        """In the motions in which the directions stay parallel."""
        return self.along.second_variation

    @cached_property
    def necessary(self) -> Criterion:
        """Spectral, in the motions in which the directions stay parallel."""
        return replace(self.along.necessary, modulo=())

    @cached_property
    def sufficient(self) -> Criterion:
        """At rest: the second variation with the Casimirs is positive definite, the directions parallel."""
        return replace(self.damped, notion="formal")

    @property
    def casimirs_only(self) -> Criterion:
        """The same: of the integrals none is used."""
        return self.sufficient

    @cached_property
    def secular(self) -> Secular:
        """What internal damping makes of it."""
        return ParallelSecular(self.along.equilibrium)

    def _decided(self, numbers: Point, margins: dict[Expr, Expr]) -> tuple[Finding, tuple[Expr, ...]]:
        if holds(self.sufficient, numbers, margins):
            return settled(True, MINIMUM), ()
        found, _ = self.along._decided(numbers, margins)
        if found.stable:
            return settled(None, f"where the directions stay parallel it is stable; {OTHERS}"), ()
        return found, ()


class ParallelSecular(Secular):
    """Under internal damping: at rest as in the motions in which the directions stay parallel."""

    @property
    def along(self) -> Secular:
        """In the motions in which the directions stay parallel."""
        return Report(self.equilibrium).secular

    @cached_property
    def criterion(self) -> Criterion:
        """Theirs where the body is at rest; else there is none."""
        theirs = self.along.criterion
        if theirs.modulo or not at_rest(self.equilibrium):
            return Criterion("secular", ())
        return theirs

    def decide(self, numbers: Point, margins: dict[Expr, Expr]
               ) -> tuple[bool | None, str, int | None, tuple[Expr, ...]]:
        """As Secular.decide."""
        if holds(self.criterion, numbers, margins):
            return True, MINIMUM, 0, ()
        stable, why, growing, _ = self.along.decide(numbers, margins)
        if stable:
            return None, f"where the directions stay parallel, {why}; {OTHERS}", None, ()
        return stable, why, growing, ()


def at_rest(eq: Equilibrium) -> bool:
    """Whether the body does not turn: ∂h/∂π = 0."""
    return not any(residual_of(eq.at_point(x), eq.insert) for x in eq.system.energy_gradient.flat()[:3])
