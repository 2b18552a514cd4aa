"""The well of a stable relative equilibrium: its lowest pass, and the kicks that stay below it."""
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sympy import oo

from ..._cached import cached_property
from ...algebra.enclosures.balls import ball
from ...errors import ScopeError
from ...mechanics.families.circular_orbit import by_gradient_alone
from ...mechanics.scenes.kind import Kind
from ..relative_equilibrium import RelativeEquilibrium
from .basin import Basin
from .contained import contained
from .damped import comes_back
from .disturbances.kicks import about_the_nodes, below, kick_below, tilt_below
from .disturbances.motors import held_after
from .disturbances.spin_kicks import spin_kick
from .disturbances.within import kick_within
from .frame import Frame, frame_of
from .in_balls import BITS
from .joining import Tree, tree
from .tilts import TiltWell, tilt_well

TILTS = "the tilt alone moves; ask for its barrier, or for an angle"


@dataclass(frozen=True, repr=False)
class Well(Basin):
    """The well of the energy round a relative equilibrium, on its level.

    A motion that starts inside, with less energy than the pass, stays inside for ever. On its level are the
    motions with the same C1 = M·k, of a free body with the same abs(M); of a satellite all motions.
    """

    @cached_property
    def frame(self) -> Frame:
        """The well in the frame that turns with a rotation of a body in a field, which bounds every kick."""
        return frame_of(self.rotation)

    @cached_property
    def under_damping(self) -> TiltWell | None:
        """The well of a body of revolution under internal damping, which keeps C1 alone; None of others."""
        return None if self.line is None else tilt_well(self.rotation, damped=True)

    def kick(self, direction: Sequence[Any] | None = None, level: bool = False) -> float:
        """Return the impulse of a torque below which the motion stays in the well, rounded down.

        In a field a kick along k changes C1, and the well with it. What is returned without level is then
        that of the frame: below it k stays over the well of the frame for ever. That is not to say that the
        motion comes back: other places to rest may lie inside, on other levels of C1. A free body stays in
        the well of the sphere of M that it is kicked to, about the same axis.

        Parameters
        ----------
        direction : sequence of number, shape (3,), optional
            of the impulse, in the axes of the body; left out: the weakest of all
        level : bool
            of kicks across k, which keep C1; those of a satellite have no level

        Returns
        -------
        float
            [M L²/T]

        Raises
        ------
        ScopeError
            there is no barrier, or no bound for such kicks
        ValuesError
            the direction is none, or not across k

        References
        ----------
        A kick Δ adds Δ·I⁻¹Δ/2 to the energy at rest.
        """
        kind = self.rotation.scene.kind
        if kind is Kind.FIELD and not level and self.line is None:
            return self.frame.kick(direction)
        if self.barrier_double is None:
            raise ScopeError(f"no kick is known to be small enough: {self.reason}")
        if self.line is not None:
            return about_the_nodes(self.line, direction, level)
        if kind is Kind.FREE:
            return spin_kick(self.rotation, direction)
        return kick_below(self.rotation, self.heights[self.found.passes[0]], direction, kind is Kind.FIELD)

    def within(self, degrees: Any, level: bool = False) -> float:
        """Return the impulse below which the axis that was vertical stays within an angle, rounded down.

        It is there without a pass, too, and may be greater than a kick that stays in the well: it bounds the
        angle, and does not say that the motion comes back.

        Parameters
        ----------
        degrees : number or str
            between 0 and 180
        level : bool
            of kicks that keep C1; of a body of revolution there are no others

        Returns
        -------
        float
            [M L²/T]

        Raises
        ------
        ScopeError
            no such bound is known, or none is proved
        """
        if self.line is not None:
            kick = self.line.kick_within(degrees)
            return math.inf if kick == oo else below(ball(kick, BITS))
        if self.rotation.scene.kind is not Kind.FIELD:
            raise ScopeError("an angle is bounded of a body in a field; ask for the kick, or for the tilt")
        return kick_within(self.rotation, degrees, level)

    def tilt(self) -> float:
        """Return the angle below which a satellite may be turned, at rest in its orbit, and stays.

        Returns
        -------
        float
            degrees, about whatever axis, rounded down

        Raises
        ------
        ScopeError
            there is no barrier, or it is no satellite in the gravity gradient alone
        """
        if not self.found.passes or not by_gradient_alone(self.rotation.scene):
            raise ScopeError("a tilt is bounded of a satellite at rest in its orbit, in the gravity gradient "
                             "alone" + (f"; {self.reason}" if self.reason else ""))
        return tilt_below(self.rotation, self.heights[self.found.passes[0]])

    def contains(self, state: Sequence[Any]) -> bool | None:
        """Tell whether a motion that starts in a state is held in the well.

        Asked is the next state of the level, as one of doubles is none of it exactly: directions are divided
        by their lengths, and in a field π is moved along k.

        Parameters
        ----------
        state : sequence of number or str
            in the coordinates of the scene: π, and k, or n and r

        Returns
        -------
        bool or None
            False if its energy is that of the pass or more, or if it is in another well; None if a path down
            from it is not proved

        Raises
        ------
        ScopeError
            there is no barrier, or it is that of a body of revolution
        ValuesError
            the state is none of the level
        """
        if self.paths is None or not self.found.passes:
            raise ScopeError(f"no state is known to be inside: {TILTS if self.line else self.reason}")
        return contained(self.rotation, self.paths, self.paths.values[self.found.passes[0]], state)

    def spun_up(self, change: Sequence[Any]) -> RelativeEquilibrium | None:
        """Return where the motion is held after a motor has changed the rotors' momentum at once.

        Parameters
        ----------
        change : sequence of number, shape (3,)
            that is added to l, in the axes of the body [M L²/T]; M = π + l is kept

        Returns
        -------
        RelativeEquilibrium or None
            the equilibrium with the new rotors whose well holds the motion; None if none is proved to

        Raises
        ------
        ScopeError
            it is a body of revolution, or its level has no list of equilibria
        ValuesError
            the change is not three numbers
        """
        return held_after(self.rotation, change)

    @cached_property
    def tree(self) -> Tree:
        """How all wells of its level become one; empty for a body of revolution, whose tilt alone moves."""
        if self.paths is None:
            return Tree((), TILTS if self.line else self.reason)
        return tree(self.rotation, self.paths, self.value)

    @cached_property
    def damped(self) -> bool | None:
        """Whether every motion inside comes back under internal damping; None if that is not known."""
        return comes_back(self.rotation) if self.found.passes else None
