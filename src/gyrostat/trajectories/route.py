"""Route: what a model of motion answers; that of a top, one turned, a free gyrostat, one integrated."""
from typing import Any, Protocol

from flint import arb

from ..algebra.enclosures.floats import Array


class Route(Protocol):
    """What computes a motion, in doubles at any times, and in balls where it can.

    Implemented by AxialMotion, TurnedMotion, FreeMotion and Integration.
    """

    enclosed: bool
    """Whether states are known in balls, to any number of digits; if not, the last three members refuse."""

    @property
    def name(self) -> str:
        """What kind of motion it is, or how it is computed."""

    @property
    def recognised(self) -> str:
        """What the scene is, where it is not entered as a body of revolution in U(k3) but is one; else ""."""

    @property
    def axis(self) -> Any:
        """Of a body of revolution, three numbers; else e3."""

    @property
    def period(self) -> float | None:
        """Of the nutation, or of the momentum in a free body [T]; None where nothing is periodic."""

    @property
    def precession(self) -> float | None:
        """The angle gained about the vertical in a period, or in a unit of time where there is none."""

    @property
    def spin(self) -> float | None:
        """The same about the axis of a body of revolution; None of any other."""

    @property
    def limits(self) -> tuple[float, float] | None:
        """Lowest and highest component of k along the axis of a body of revolution in a field."""

    @property
    def nodes(self) -> int:
        """Values of the integrands that were taken, or steps of an integration."""

    @property
    def error(self) -> float:
        """Of a state in doubles, estimated."""

    def state(self, t: Array) -> Array:
        """The state at times of any shape, shape (..., n)."""

    def attitude(self, t: Array) -> Array:
        """R from body to space at times of any shape, shape (..., 3, 3)."""

    def ball_state(self, t: arb, bits: int) -> list[arb]:
        """The state at a time, to about so many bits."""

    def exact_period(self, bits: int) -> arb | None:
        """The period to so many bits."""

    def exact_angles(self, bits: int) -> tuple[arb | float | None, arb | None]:
        """What precession and spin say, to so many bits; that of a free gyrostat in doubles."""
