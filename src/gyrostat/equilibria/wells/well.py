"""The well of a stable relative equilibrium: its lowest pass, and the kicks that stay below it."""
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from flint import arb
from sympy import Expr, Poly, oo

from ..._cached import cached_property
from ..._display import Shown
from ..._lazy import loaded
from ...algebra.enclosures.balls import ball
from ...algebra.reals.exact import evaluate
from ...errors import ScopeError
from ...mechanics.families.circular_orbit import by_gradient_alone
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.potential import DIRECTIONS
from ...mechanics.scenes.principal_axes import principal_axes
from ..relative_equilibrium import RelativeEquilibrium
from .in_balls import BITS
from .kicks import about_the_nodes, below, kick_below, tilt_below
from .merge_tree import Outcome
from .tilts import TiltWell
from .within import kick_within

if TYPE_CHECKING:
    from .frame import Frame

LEAVES = "a kick along k changes C1, and the well with it: ask for those across k, level=True"
SPHERE = "a kick changes the momentum sphere of a free body, and the well with it: ask for its barrier"


@dataclass(frozen=True, repr=False)
class Well(Shown):
    """The well of the energy round a relative equilibrium, on its level.

    A motion that starts inside, with less energy than the pass, stays inside for ever. On its level are the
    motions with the same C1 = M·k, of a free body with the same abs(M); of a satellite all motions.

    Parameters
    ----------
    rotation : RelativeEquilibrium
    points : sequence of RelativeEquilibrium
        all of its level
    heights : sequence of arb
        V of each above that of the rotation, in balls [M L²/T²]
    found : Outcome
        what the well meets first
    reason : str
        why there is no barrier, or why it is only a bound; "" else
    """

    rotation: RelativeEquilibrium
    points: Sequence[RelativeEquilibrium] = ()
    heights: Sequence[arb] = ()
    found: Outcome = Outcome()
    reason: str = ""
    line: TiltWell | None = None

    @cached_property
    def barrier(self) -> Expr | None:
        """The height of the lowest equilibrium that the well touches, exact; None if there is no answer."""
        if self.line is not None:
            return self.line.barrier
        return self._above(self.found.passes[0]) if self.found.passes else None

    @cached_property
    def escape(self) -> Expr | None:
        """The least height from which another minimum is reached, exact; oo if there is none."""
        if self.line is not None:
            return self.line.escape
        if self.found.escape is not None:
            return self._above(self.found.escape)
        return None if self.found.stopped is not None or not self.found.passes else oo

    @property
    def barrier_double(self) -> float | None:
        """The barrier as a double, without the exact number being written out [M L²/T²]."""
        if self.line is not None:
            return None if self.line.barrier is None else float(self.line.barrier)
        return float(self.heights[self.found.passes[0]].mid()) if self.found.passes else None

    @property
    def escape_double(self) -> float | None:
        """The escape as a double; infinity if there is no other minimum [M L²/T²]."""
        if self.line is not None:
            return None if self.line.escape is None else float(self.line.escape)
        if self.found.escape is not None:
            return float(self.heights[self.found.escape].mid())
        return None if self.escape is None else math.inf

    @property
    def bound(self) -> float | None:
        """What the barrier is at least, if it is not known [M L²/T²]."""
        stopped = self.found.stopped
        return None if self.found.passes or stopped is None else float(self.heights[stopped].lower())

    @property
    def kind(self) -> str:
        """Of the pass: "well", "round" (the well closes round a summit), "summit"; "" if there is none.

        Of a body of revolution it may be a "shelf", an inflection.
        """
        if self.line is not None:
            return self.line.passes[0].kind if self.line.passes else ""
        return self.found.kind

    @property
    def passes(self) -> tuple[RelativeEquilibrium, ...]:
        """The equilibria of the height of the barrier that the well touches."""
        return tuple(self.points[n] for n in self.found.passes)

    @property
    def beyond(self) -> tuple[RelativeEquilibrium, ...]:
        """The stable equilibria that are reached at the height of the escape."""
        return tuple(self.points[n] for n in self.found.beyond)

    @cached_property
    def frame(self) -> "Frame":
        """The well in the frame that turns with a rotation of a body in a field, which bounds every kick."""
        found: Frame = loaded("equilibria.wells.frame:frame_of")(self.rotation)
        return found

    def kick(self, direction: Sequence[Any] | None = None, level: bool = False) -> float:
        """Return the impulse of a torque below which the motion stays in the well, rounded down.

        In a field a kick along k changes C1, and the well with it. What is returned without level is then
        that of the frame: below it k stays over the well of the frame for ever. That is not to say that the
        motion comes back: other places to rest may lie inside, on other levels of C1.

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
        if kind is Kind.FREE:
            raise ScopeError(SPHERE)
        if kind is not Kind.ORBIT and not level:
            raise ScopeError(LEAVES)
        if self.line is not None:
            return about_the_nodes(self.line, direction)
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

    @cached_property
    def damped(self) -> bool | None:
        """Whether every motion inside comes back under internal damping; None if that is not known.

        It is, by LaSalle's theorem, if no motion with a constant rate in the body but the equilibria is
        possible: in a uniform field, in an orbit with three different moments and no other torque, and of a
        free body about its axis of least energy. A maximum of the energy is left.
        """
        scene = self.rotation.scene
        if not self.found.passes:
            return None
        if scene.kind is Kind.FREE:
            return self.rotation.form.index == 0
        if scene.kind is Kind.ORBIT:
            distinct = len({*principal_axes(scene.body)[0].moments}) == 3
            return True if distinct and by_gradient_alone(scene) else None
        assert scene.potential is not None
        return True if Poly(scene.potential.expression, *DIRECTIONS).total_degree() == 1 else None

    def value(self, e: RelativeEquilibrium) -> Expr:
        """Return V at an equilibrium: the energy, round a maximum its negative [M L²/T²]."""
        turned = self.rotation.scene.kind is Kind.FREE and self.rotation.form.index != 0
        return -e.energy if turned else e.energy

    def _above(self, n: int) -> Expr:
        return evaluate(self.value(self.points[n]) - self.value(self.rotation), {})
