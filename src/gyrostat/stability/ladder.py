"""The ladder of criteria and theorems that decides an equilibrium at exact numbers."""
from dataclasses import dataclass, replace

from sympy import Expr

from .._cached import cached_property
from ..algebra.reals.exact import Point
from ..mechanics.equilibrium.derived_once import once
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..mechanics.equilibrium.standard_axes import placed, seen_at
from ..notation import symbol
from .criteria.truth import holds
from .decision import Decider, Decision, Rung, settled, undecided
from .report.derived_parts import Derived
from .theorems.degenerate import Elementary
from .theorems.drift import Drift, drifts_along
from .theorems.given_integrals import decide_by_integrals

DEFINITE = "the second variation is definite on the symplectic slice"
GROWS = "an eigenvalue has a positive real part"


@dataclass(frozen=True, repr=False)
class Ladder(Derived):
    """What decides an equilibrium: its two criteria, then the theorems for what they leave open.

    A scene that has more symmetry at the numbers is decided as such, and so is one that another scene
    decides. What the other scene divides out is carried over where it is a symmetry of this one; where it is
    none, the other scene is asked about the point itself.
    """

    def decide(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """The decision at exact numbers that are checked; verdict checks them.

        Parameters
        ----------
        numbers : Point
        margins : dict of Expr to Expr
            those that are used are entered, with their values

        Returns
        -------
        Decision
        """
        modulo = self.sufficient.modulo
        sufficient = holds(self.sufficient, numbers, margins)
        if sufficient:
            return self._definite(numbers)
        necessary = holds(self.necessary, numbers, margins)
        if necessary is False:
            return settled(False, GROWS, Rung.SPECTRUM, "spectral", modulo=modulo)
        if known := seen_at(self.equilibrium, numbers):
            standard = kept(known.equilibrium)
            if missing := ", ".join(name for name in standard.compared if symbol(name) not in numbers):
                return undecided(known.worded(f"give {missing} to decide"))
            found = standard.decide(numbers, margins)
            return replace(found, reason=known.worded(found.reason), modulo=found.modulo and known.modulo)
        if None in (sufficient, necessary):
            return undecided("a margin has no proved sign")
        decider: Decider | None = self.between
        found = decider.decide(numbers, margins) if decider else self._elementary.decide(numbers)
        if self.recognised:
            found = replace(found, reason=self.recognised.worded(found.reason))
        return replace(found, modulo=modulo) if modulo and not found.modulo else found

    def decide_point(self, numbers: Point, margins: dict[Expr, Expr]) -> Decision:
        """The decision on the point itself, not modulo the flow of an integral.

        Parameters
        ----------
        numbers : Point
        margins : dict of Expr to Expr
            as in decide

        Returns
        -------
        Decision
        """
        found = self.decide(numbers, margins)
        if not found.modulo or not found.stable:
            return replace(found, modulo=())
        margins.clear()
        known = self.recognised or seen_at(self.equilibrium, numbers)
        if known:
            drift = Drift(known.equilibrium).decide(numbers, margins)
            return replace(drift, reason=known.worded(drift.reason))
        if self.boundary:
            return self.drift.decide(numbers, margins)
        return drifts_along(placed(self.equilibrium, numbers), found)

    @cached_property
    def _stable(self) -> Decision:
        return settled(True, DEFINITE, Rung.SECOND_VARIATION, modulo=self.sufficient.modulo)

    def _definite(self, numbers: Point) -> Decision:
        """Where the sufficient criterion holds: with the Casimirs, or with integrals that are given."""
        if not self.equilibrium.system.given_integrals or holds(self.casimirs_only, numbers, {}):
            return self._stable
        certified = decide_by_integrals(self.equilibrium, numbers)
        return replace(certified, pointwise=False) if certified.stable else self._stable

    @cached_property
    def _elementary(self) -> Elementary:
        return Elementary(self.equilibrium, self.linearization, lambda eq: kept(eq).decide(Point({}), {}),
                          lambda eq: kept(eq).decide_point(Point({}), {}))


@once
def kept(eq: Equilibrium) -> Ladder:
    """The ladder of an equilibrium in other axes, or of another scene that decides for it, derived once."""
    return Ladder(eq)
