"""The report of an equilibrium with two parallel directions, whose coadjoint orbit is singular.

It decides by the motions in which the directions stay parallel, and by the stiffness K against all others.
"""
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
from ..criteria.orientation_form import minors_of_stiffness, stiffness_with
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
    """The report of an equilibrium with parallel directions, by the motions in which they stay parallel.

    Its matrices are those of parallel_directions(eq), and so is what is necessary. At rest K across the
    directions decides more: if it is positive definite, the energy of a and b = c a has a strict minimum for
    a fixed abs(a), whatever M·a. The length of b − c a is constant, and if it is small, the energy differs
    little from that with b = c a: the equilibrium is stable against all motions, under internal damping too.
    A body of revolution that turns about its axis, or any ball, conserves ω·π, and h − ω·π stands for the
    energy: K is that of a body at rest with the coupling β − ω. Damping does not conserve ω·π.

    References
    ----------
    Leonard & Marsden, Physica D 105 (1997) 130-162, for the singular orbits; derived.

    Examples
    --------
    >>> import gyrostat as gs
    >>> m0, p0 = gs.symbol("m0"), gs.symbol("p0")
    >>> vehicle = gs.underwater_vehicle(weight=(0, 0, m0))
    >>> rising = gs.steady_motion(vehicle, (0, 0, p0), (0, 0, 1))
    >>> for condition in gs.analyze(rising).sufficient.alternatives[0]:
    ...     print(condition)
    mass₂ mass₃ m₀ > p₀² (mass₂ − mass₃)
    mass₁ mass₃ m₀ > p₀² (mass₁ − mass₃)
    """

    @cached_property
    def along(self) -> Report:
        """The report of the motions in which the directions stay parallel."""
        return Report(parallel_directions(self.equilibrium))

    @property
    def linearization(self) -> Linearization:
        """The linearised field of the motions in which the directions stay parallel."""
        return self.along.linearization

    @property
    def second_variation(self) -> SecondVariation:
        """The second variation for the motions in which the directions stay parallel."""
        return self.along.second_variation

    @cached_property
    def necessary(self) -> Criterion:
        """The spectral criterion for the motions in which the directions stay parallel."""
        return replace(self.along.necessary, modulo=())

    @cached_property
    def sufficient(self) -> Criterion:
        """The criterion that K is positive definite across the directions.

        It is one at rest, or if ω·π is conserved; in any other motion it never holds.
        """
        eq, beta = self.equilibrium, coupling_at_rest(self.equilibrium)
        if beta is None:
            return Criterion(Notion.FORMAL, ())
        return independent(least_across(eq, beta, Notion.FORMAL), eq)

    @property
    def casimirs_only(self) -> Criterion:
        """The criterion with the Casimirs alone, which is sufficient: it uses no given integrals."""
        return self.sufficient

    @cached_property
    def secular(self) -> Secular:
        """What is decided under internal damping."""
        return ParallelSecular(self.equilibrium)

    def decide(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """Return the decision at exact numbers, against all motions."""
        if holds(self.sufficient, numbers, margins):
            return settled(True, AT_REST if at_rest(self.equilibrium) else TURNS, Rung.SECOND_VARIATION)
        if self.equilibrium != (here := placed(self.equilibrium, numbers)):
            found = ParallelReport(here).decide(Point({}), {})
            return replace(found, reason=f"at these numbers {found.reason}")
        # an unstable motion there is unstable among all; a stable one need not be
        found = self.along.decide(numbers, margins)
        if found.stable:
            return undecided(f"if the directions stay parallel, it is stable; {OTHERS}")
        return replace(found, modulo=())


class ParallelSecular(Secular):
    """What is decided under internal damping: if stability is lost with parallel directions, it is lost."""

    @cached_property
    def along(self) -> Secular:
        """What is decided under damping for the motions in which the directions stay parallel."""
        return Report(parallel_directions(self.equilibrium)).secular

    @property
    def variation(self) -> SecondVariation:
        """The second variation for the motions in which the directions stay parallel."""
        return self.along.variation

    @cached_property
    def compared(self) -> tuple[str, ...]:
        """The names in both criteria, this one and that of the motions with parallel directions."""
        return names_needed(self.equilibrium, (self.criterion, self.along.criterion))

    @property
    def exceptions(self) -> tuple[tuple[Expr, ...], ...]:
        """The exceptions are everywhere: the criterion is not necessary."""
        return ((),)

    @cached_property
    def criterion(self) -> Criterion:
        """The criterion that K is positive definite across the directions, at rest."""
        eq = self.equilibrium
        if not at_rest(eq):
            return Criterion(Notion.SECULAR, ())
        return independent(least_across(eq, _coupling(eq), Notion.SECULAR), eq)

    def decide(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """Return the decision under internal damping at exact numbers, against all motions."""
        if holds(self.criterion, numbers, margins):
            return settled(True, AT_REST, Rung.SECOND_VARIATION, Notion.SECULAR, growing=0)
        if self.equilibrium != (here := placed(self.equilibrium, numbers)):
            return ParallelSecular(here).decide(Point({}), {})
        found = self.along.decide(numbers, margins)
        if found.stable:
            return undecided(f"if the directions stay parallel, {found.reason}; {OTHERS}")
        return replace(found, modulo=())


def at_rest(eq: Equilibrium) -> bool:
    """Tell whether the body does not turn: ∂h/∂π = 0."""
    return not any(residual_of(eq.at_point(x), eq.insert) for x in eq.system.energy_gradient.flat()[:3])


def coupling_at_rest(eq: Equilibrium) -> ImmutableMatrix | None:
    """Return the β with which the body is at rest: its own, or β − ω if ω·π is conserved; else None."""
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
    """Return the criterion that K with a coupling β is positive definite across the directions.

    If they are along an axis of the body, it is by leading minors, else by t and s, trace and determinant
    across.
    """
    K = stiffness_with(eq, beta)
    a = eq.point[3:6] if any(eq.point[3:6]) else eq.point[6:]
    across = [i for i in range(3) if a[i] == 0]
    minors = [("t", K.trace()), ("s", K.adjugate().trace())]
    if len(across) == 2:
        minors = [(name, minor) for name, _, minor in minors_of_stiffness(K.extract(across, across))]
    return all_positive(notion, minors, eq, eq.domain)
