"""An equilibrium at numbers, as the ladder asks about it; each answer is found when it is asked."""
from dataclasses import dataclass, replace

from sympy import Expr

from .._cached import cached_property
from .._lazy import loaded
from ..algebra.reals.exact import Point, sign
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..mechanics.equilibrium.standard_axes import Seen, seen_at
from .criteria.numbers_asked import left_open, names_of_motion
from .criteria.truth import holds
from .decision import Decision
from .report.derived_parts import Derived

THEOREMS = "stability.theorems"


@dataclass(frozen=True)
class Standing:
    """The report of an equilibrium at numbers, with the answers that the rungs of the ladder ask for."""

    derived: Derived
    numbers: Point
    margins: dict[Expr, Expr]

    @property
    def eq(self) -> Equilibrium:
        """The equilibrium."""
        return self.derived.equilibrium

    @cached_property
    def at(self) -> Point:
        """The numbers, with those of the names in which the conditions are written."""
        closed = self.derived.closed
        return closed.with_names(self.numbers) if closed else self.numbers

    @cached_property
    def sufficient(self) -> bool | None:
        """Whether the second variation is definite; None if a margin has no proved sign."""
        return holds(self.derived.sufficient, self.at, self.margins)

    @cached_property
    def necessary(self) -> bool | None:
        """Whether no eigenvalue has a positive real part; None if a margin has no proved sign."""
        return holds(self.derived.necessary, self.at, self.margins)

    @cached_property
    def other(self) -> Seen | None:
        """The equilibrium of another scene that decides instead, if any."""
        return seen_at(self.eq, self.numbers)

    @cached_property
    def degenerate(self) -> bool:
        """Whether the second variation is proved to be degenerate."""
        determinant, names = self.derived.determinant
        return not left_open(names, self.numbers) and sign(determinant, self.at) == 0

    @cached_property
    def missing(self) -> str:
        """The names without a number that the theorems need."""
        eq, (_, names) = self.eq, self.derived.determinant
        if not self.derived.open_between or self.degenerate and self.derived.may_lie_on_curve:
            names += names_of_motion(eq)
        return ", ".join(dict.fromkeys(left_open(names, self.numbers)))

    @cached_property
    def by_integrals(self) -> Decision:
        """The decision by integrals that the user gives."""
        return loaded(f"{THEOREMS}.given_integrals:decide_by_integrals")(self.eq, self.numbers)

    def own(self, found: Decision) -> Decision:
        """Return a decision in the axes of the scene, modulo what the criteria divide out."""
        recognised, modulo = self.derived.recognised, self.derived.sufficient.modulo
        if recognised:
            found = replace(found, reason=recognised.worded(found.reason))
        return replace(found, modulo=modulo) if modulo and not found.modulo else found

    def after_integrals(self, found: Decision) -> Decision:
        """Return a decision with the reason why given integrals do not decide before its own."""
        why = self.by_integrals.reason if self.eq.system.given_integrals else ""
        return self.own(replace(found, reason=f"{why}; {found.reason}") if why else found)
