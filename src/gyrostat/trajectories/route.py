"""The interface of what computes a motion: a top, one turned, a free gyrostat, or an integration."""
from typing import Any, Protocol

from flint import arb

from ..algebra.enclosures.floats import Array


class Route(Protocol):
    """The interface of what computes a motion, in doubles at any times, and in balls if it can.

    It is implemented by AxialMotion, TurnedMotion, FreeMotion and Integration.
    """

    enclosed: bool
    """Whether states are known in balls, to any number of digits; if not, the last three members refuse."""

    @property
    def name(self) -> str:
        """The name of the kind of motion, or of how it is computed."""

    @property
    def recognised(self) -> str:
        """What the scene is, if it is a body of revolution in U(k3) in other axes; else ""."""

    @property
    def axis(self) -> Any:
        """The axis of a body of revolution, three numbers; for any other body e3."""

    @property
    def period(self) -> float | None:
        """The period of the nutation, or of the momentum in a free body [T]; None if nothing is periodic."""

    @property
    def precession(self) -> float | None:
        """The angle gained about the vertical in a period, or in a unit of time if there is none."""

    @property
    def spin(self) -> float | None:
        """The angle gained about the axis of a body of revolution in that time; None for any other body."""

    @property
    def limits(self) -> tuple[float, float] | None:
        """The lowest and highest component of k along the axis of a body of revolution in a field."""

    @property
    def nodes(self) -> int:
        """The number of values of the integrands that were taken, or of steps of an integration."""

    @property
    def error(self) -> float:
        """The error of a state in doubles, estimated."""

    def state(self, t: Array) -> Array:
        """Return the state at times of any shape, shape (..., n)."""

    def attitude(self, t: Array) -> Array:
        """Return R from body to space at times of any shape, shape (..., 3, 3)."""

    def ball_state(self, t: arb, bits: int) -> list[arb]:
        """Return the state at a time, to about so many bits."""

    def exact_period(self, bits: int) -> arb | None:
        """Return the period to so many bits."""

    def exact_angles(self, bits: int) -> tuple[arb | float | None, arb | None]:
        """Return what precession and spin say, to so many bits; for a free gyrostat in doubles."""
