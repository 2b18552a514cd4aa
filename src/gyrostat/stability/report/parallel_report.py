"""The report of an equilibrium where two directions are parallel: a singular orbit."""
from dataclasses import replace

from sympy import Expr, ImmutableMatrix

from ..._cached import cached_property
from ...algebra.reals.exact import Point
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.parallel_directions import parallel_directions
from ...mechanics.equilibrium.relations import residual_of
from ...mechanics.equilibrium.standard_axes import placed
from ...mechanics.scenes.coupled import CoupledPotential
from ..criteria.conditions import Criterion, all_positive, independent
from ..criteria.energy_casimir import SecondVariation
from ..criteria.linearization import Linearization
from ..criteria.numbers_asked import names_needed
from ..criteria.orientation_form import stiffness_with
from ..criteria.three_criteria import minors_of_stiffness
from ..criteria.truth import holds
from ..damping.secular import Secular
from ..decision import Decision, Rung, settled, undecided
from ..notion import Notion
from .report import Report

ALL = "stable against all motions, those too in which the directions do not stay parallel"
AT_REST = f"the directions are parallel, the body is at rest, and its energy has a strict minimum: {ALL}"
TURNS = f"the directions are parallel, and h − ω·π, an integral, has a strict minimum: {ALL}"
OTHERS = "against motions in which the directions do not stay parallel nothing is proved"


class ParallelReport(Report):
    """Of an equilibrium with parallel directions, by that of the motions in which they stay parallel.

    Its matrices are those of parallel_directions(eq), and so is what is necessary. At rest K across the
    directions decides more: where it is positive definite the energy of a and b = c a has a strict minimum
    for abs(a) held, whatever M·a. The length of b − c a is constant, and while it is small the energy is that
    of b = c a but for as little: the equilibrium is stable against all motions, under internal damping too.
    A body of revolution that turns about its axis, or any ball, conserves ω·π, and h − ω·π stands for the
    energy: K is that of a body at rest with the coupling β − ω. Damping does not conserve it.

    References
    ----------
    Leonard & Marsden, Physica D 105 (1997) 130-162, for the singular orbits; derived.

    Examples
    --------
    >>> import gyrostat as gs
    >>> vehicle = gs.underwater_vehicle(weight=(0, 0, gs.symbol("m0")))
    >>> rising = gs.analyze(gs.steady_motion(vehicle, (0, 0, gs.symbol("p0")), (0, 0, 1)))
    >>> print(rising.sufficient)
    mass₂ mass₃ m₀ > p₀² (mass₂ − mass₃) and mass₁ mass₃ m₀ > p₀² (mass₁ − mass₃)
    """

    @cached_property
    def along(self) -> Report:
        """Of the motions in which the directions stay parallel."""
        return Report(parallel_directions(self.equilibrium))

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
        """K is positive definite across the directions: at rest, or where ω·π is conserved."""
        eq, beta = self.equilibrium, coupling_at_rest(self.equilibrium)
        if beta is None:
            return Criterion(Notion.FORMAL, ())
        return independent(least_across(eq, beta, Notion.FORMAL), eq)

    @property
    def casimirs_only(self) -> Criterion:
        """The same: of the integrals none is used."""
        return self.sufficient

    @cached_property
    def secular(self) -> Secular:
        """What internal damping makes of it."""
        return ParallelSecular(self.equilibrium)

    def decide(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """As Report.decide: against all motions."""
        if holds(self.sufficient, numbers, margins):
            return settled(True, AT_REST if at_rest(self.equilibrium) else TURNS, Rung.SECOND_VARIATION)
        if self.equilibrium != (here := placed(self.equilibrium, numbers)):
            found = ParallelReport(here).decide(Point({}), {})
            return replace(found, reason=f"at these numbers {found.reason}")
        found = self.along.decide(numbers, margins)
        if found.stable:
            return undecided(f"where the directions stay parallel it is stable; {OTHERS}")
        return replace(found, modulo=())


class ParallelSecular(Secular):
    """Under internal damping: what is lost where the directions stay parallel is lost."""

    @cached_property
    def along(self) -> Secular:
        """In the motions in which the directions stay parallel."""
        return Report(parallel_directions(self.equilibrium)).secular

    @property
    def variation(self) -> SecondVariation:
        """In the motions in which the directions stay parallel."""
        return self.along.variation

    @cached_property
    def compared(self) -> tuple[str, ...]:
        """Names in both criteria, this and that of the motions in which the directions stay parallel."""
        return names_needed(self.equilibrium, (self.criterion, self.along.criterion))

    @property
    def exceptions(self) -> tuple[tuple[Expr, ...], ...]:
        """Everywhere: the criterion is not necessary."""
        return ((),)

    @cached_property
    def criterion(self) -> Criterion:
        """At rest, K is positive definite across the directions."""
        eq = self.equilibrium
        if not at_rest(eq):
            return Criterion(Notion.SECULAR, ())
        return independent(least_across(eq, _coupling(eq), Notion.SECULAR), eq)

    def decide(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """As Secular.decide."""
        if holds(self.criterion, numbers, margins):
            return settled(True, AT_REST, Rung.SECOND_VARIATION, Notion.SECULAR, growing=0)
        if self.equilibrium != (here := placed(self.equilibrium, numbers)):
            return ParallelSecular(here).decide(Point({}), {})
        found = self.along.decide(numbers, margins)
        if found.stable:
            return undecided(f"where the directions stay parallel, {found.reason}; {OTHERS}")
        return replace(found, modulo=())


def at_rest(eq: Equilibrium) -> bool:
    """Whether the body does not turn: ∂h/∂π = 0."""
    return not any(residual_of(eq.at_point(x), eq.insert) for x in eq.system.energy_gradient.flat()[:3])


def coupling_at_rest(eq: Equilibrium) -> ImmutableMatrix | None:
    """β with which the body is at rest: its own, or β − ω where ω·π is conserved; else None."""
    if at_rest(eq):
        return _coupling(eq)
    scene, rate = eq.system, ImmutableMatrix(eq.system.energy_gradient.flat()[:3]).applyfunc(eq.at_point)
    axes = [ImmutableMatrix(scene.space.gradient(F).flat()[:3]) for F in scene.linear_integrals]
    if len(axes) == 3 or axes and not any(residual_of(x, eq.insert) for x in rate.cross(axes[0])):
        return _coupling(eq) - rate
    return None


def _coupling(eq: Equilibrium) -> ImmutableMatrix:
    potential = eq.system.potential
    assert isinstance(potential, CoupledPotential)
    return ImmutableMatrix(potential.drift)


def least_across(eq: Equilibrium, beta: ImmutableMatrix, notion: Notion) -> Criterion:
    """K with a coupling β is positive definite across the directions.

    Along an axis of the body by leading minors, else by t and s, trace and determinant across.
    """
    K = stiffness_with(eq, beta)
    a = eq.point[3:6] if any(eq.point[3:6]) else eq.point[6:]
    across = [i for i in range(3) if a[i] == 0]
    minors = [("t", K.trace()), ("s", K.adjugate().trace())]
    if len(across) == 2:
        minors = [(name, minor) for name, _, minor in minors_of_stiffness(K.extract(across, across))]
    return all_positive(notion, minors, eq, eq.domain)
