"""What is derived for one equilibrium without numbers: the two matrices and their criteria.

With them come the names that a verdict needs, and what decides between the criteria.
"""
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from sympy import Expr, Mul

from ..._cached import cached_property
from ..._display import Shown
from ..._lazy import loaded
from ...algebra.solving.margins import Signs
from ...errors import require
from ...mechanics.equilibrium.derived_once import once
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.equilibrium.standard_axes import Seen, seen
from ...mechanics.scenes.kind import Kind
from ...notation import Stored, jet
from ..criteria.conditions import Criterion, independent
from ..criteria.energy_casimir import SecondVariation, second_variation
from ..criteria.linearization import Linearization, linearize
from ..criteria.numbers_asked import names_accepted, names_in, names_needed, names_of_motion
from ..criteria.three_criteria import formal_criterion, in_names, spectral_criterion
from ..damping.secular import Secular, secular_of
from ..deciders import Between
from ..decision import Decision, Rung, settled
from ..notion import Notion

if TYPE_CHECKING:
    from ..criteria.defined_names import DefinedNames
    from ..theorems.boundary import Boundary
    from ..theorems.drift import Drift


DEFINITE = "the second variation is definite on the symplectic slice"
GROWS = "an eigenvalue has a positive real part"


@dataclass(frozen=True, repr=False)
class Derived(Shown, Stored):
    """The parts of a report, each derived when it is first asked for.

    Parameters
    ----------
    equilibrium : Equilibrium
    expanded : bool
        whether conditions are written out however long they are; default False
    """

    equilibrium: Equilibrium
    expanded: bool = False
    _carried = ("closed", "necessary", "sufficient", "recognised", "compared", "required", "parameters",
                "secular")

    def __post_init__(self) -> None:
        require(self.equilibrium, Equilibrium, "the equilibrium")

    @cached_property
    def closed(self) -> "DefinedNames | None":
        """The names in which conditions are written if they are too long to be written out; else None."""
        return None if self.expanded else in_names(self.equilibrium)

    @cached_property
    def linearization(self) -> Linearization:
        """The field linearised on the tangent space of the coadjoint orbit."""
        return linearize(self.equilibrium)

    @cached_property
    def second_variation(self) -> SecondVariation:
        """The second variation of the energy, with the Casimirs and the integrals of the scene."""
        return second_variation(self.equilibrium)

    @cached_property
    def necessary(self) -> Criterion:
        """The spectral criterion, reduced to independent conditions.

        It is modulo the same flows as the sufficient one: along them the linearised field has the eigenvalue
        0, so a growing mode is not in their direction.
        """
        if self.closed:
            return self.closed.criterion(Notion.SPECTRAL)
        if self.recognised:
            return replace(kept_of(self.recognised.equilibrium).necessary, modulo=self.recognised.modulo)
        return replace(independent(spectral_criterion(self.linearization), self.equilibrium),
                       modulo=self.second_variation.modulo)

    @cached_property
    def sufficient(self) -> Criterion:
        """The formal criterion with the Casimirs and the integrals, reduced to independent conditions."""
        if self.closed:
            return self.closed.criterion(Notion.FORMAL)
        if self.recognised:
            return replace(kept_of(self.recognised.equilibrium).sufficient, modulo=self.recognised.modulo)
        found = formal_criterion(self.second_variation)
        scene = self.equilibrium.system
        # its elimination of α is for two degrees of freedom, and two directions have three
        if scene.given_integrals and not scene.coupled:
            criterion = loaded("stability.theorems.given_integrals:integral_criterion")
            more = criterion(self.linearization).alternatives
            found = replace(found, alternatives=(*found.alternatives, *more))
        return independent(found, self.equilibrium)

    @cached_property
    def casimirs_only(self) -> Criterion:
        """The formal criterion with the Casimirs alone, for comparison."""
        if not self.equilibrium.system.integrals:
            return self.sufficient
        return independent(formal_criterion(second_variation(self.equilibrium, integrals=False)),
                           self.equilibrium)

    @cached_property
    def damped(self) -> Criterion:
        """The secular criterion: what is stable, and stays so under internal damping.

        Unlike casimirs_only it asks for a minimum, not for a maximum, and it is modulo the flows of the
        integrals.
        """
        return self.secular.criterion

    @cached_property
    def secular(self) -> Secular:
        """The second variation under internal damping, and what it decides."""
        eq = self.equilibrium
        if not eq.system.coupled:
            return Secular(eq, expanded=True) if self.expanded else secular_of(eq)
        return loaded("stability.damping.secular_two_directions:SecularInFrame")(eq, self.expanded)

    @cached_property
    def boundary(self) -> "Boundary | None":
        """The reduced motion, which decides a body of revolution if necessary holds and sufficient does not.

        It is None for other scenes. If the axis of revolution is not the third one, it is that of the
        equilibrium in the standard scene.
        """
        eq = self.recognised.equilibrium if self.recognised else self.equilibrium
        if eq.system.kind is not Kind.REVOLUTION:
            return None
        return loaded("stability.theorems.boundary:boundary_of")(eq)

    @property
    def between(self) -> Between | None:
        """What decides between the two criteria: the boundary, or for a free body the momentum sphere."""
        if self.boundary or self.equilibrium.system.kind is not Kind.FREE:
            return self.boundary
        return loaded("stability.theorems.momentum_sphere:sphere_of")(self.equilibrium)

    @cached_property
    def recognised(self) -> Seen | None:
        """The equilibrium in the axes of a body of revolution that is not entered in them, else None."""
        return seen(self.equilibrium)

    @cached_property
    def drift(self) -> "Drift":
        """The relative equilibria near a tilted one, which move along its orbit under the spin."""
        eq = self.recognised.equilibrium if self.recognised else self.equilibrium
        return loaded("stability.theorems.drift:Drift")(eq)

    @cached_property
    def open_between(self) -> bool:
        """Whether nothing decides between the two criteria at any numbers, as may be with two directions."""
        return self.equilibrium.system.coupled and bool(
            loaded("stability.theorems.two_directions:open_between")(self.equilibrium))

    @cached_property
    def may_lie_on_curve(self) -> bool:
        """Whether it may lie on a closed curve of attitudes of a satellite."""
        return self.equilibrium.system.coupled and bool(
            loaded("stability.theorems.two_directions:may_lie_on_curve")(self.equilibrium))

    @cached_property
    def stable(self) -> Decision:
        """The decision if the second variation is definite."""
        return settled(True, DEFINITE, Rung.SECOND_VARIATION, modulo=self.sufficient.modulo)

    @cached_property
    def unstable(self) -> Decision:
        """The decision if an eigenvalue has a positive real part."""
        return settled(False, GROWS, Rung.SPECTRUM, Notion.SPECTRAL, modulo=self.sufficient.modulo)

    @cached_property
    def determinant(self) -> tuple[Expr, tuple[str, ...]]:
        """The determinant of the linearised field without factors that are positive, and the names in it.

        It vanishes if and only if the second variation on the orbit is degenerate.
        """
        if self.closed:
            return self.closed.named.determinant, self.closed.required
        determinant = self.equilibrium.insert(self.linearization.coefficients[-1])
        margin, even = Signs.over([determinant], self.equilibrium.existence()).normal_form(determinant)
        factors = (margin, *even)
        return Mul(*factors), names_in(factors)

    @cached_property
    def compared(self) -> tuple[str, ...]:
        """The names in the two criteria: without one of them there is no verdict."""
        if self.closed:
            return self.closed.required
        return names_needed(self.equilibrium, (self.necessary, self.sufficient))

    @cached_property
    def required(self) -> tuple[str, ...]:
        """The names with which every verdict is answered: those of criteria, and of what decides between.

        If U is unspecified, a boundary may need a derivative besides.
        """
        return tuple(sorted({*self.compared, *self._between_names()}))

    def _between_names(self) -> tuple[str, ...]:
        eq = self.equilibrium
        if () in self.sufficient.alternatives or self.open_between and not self.may_lie_on_curve:
            return ()
        if self.between is None:
            return names_of_motion(eq)
        return names_in(e for e in self.between.expressions() if not any(jet(s.name) for s in e.free_symbols))

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        """The names that a verdict accepts; if U is unspecified, every derivative dU, d2U, … besides."""
        return names_accepted(self.equilibrium, self.compared)


kept_of = once(Derived)                                    # derived once, for an equilibrium in standard axes
