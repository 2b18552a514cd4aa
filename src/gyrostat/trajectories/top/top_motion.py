"""The motion of a body of revolution in U(k3) in doubles, at any time.

k3 moves by elliptic functions, the two angles by series.
"""
from typing import Any

from flint import arb

from ..._cached import cached_property
from ...algebra.enclosures.floats import Array
from ...algebra.enclosures.precision import own_precision
from ..equidistant import filled
from ..periods import double
from .level import Level, enclosed, known
from .precession import precession
from .precession_in_doubles import Doubles


class AxialMotion:
    """A body of revolution in U(k3) from a state on, a route of gyrostat.trajectories.motion.

    Parameters
    ----------
    level : Level
    bits : int
        bits of the states in balls; 53 for doubles
    """

    enclosed, recognised, axis = True, "", (0.0, 0.0, 1.0)

    def __init__(self, level: Level, bits: int = 53):
        self.exact = precession(level, bits)
        self._given = level, bits

    def __reduce__(self) -> tuple[Any, ...]:
        return AxialMotion, self._given                    # python-flint's balls are not pickled

    @cached_property
    def _doubles(self) -> Doubles:
        return Doubles(self.exact)

    def state(self, t: Array) -> Array:
        """Return (π, k) at times of any shape, shape (..., 6)."""
        return filled(self._doubles.state, t, (6,))

    def attitude(self, t: Array) -> Array:
        """Return R from body to space, shape (..., 3, 3)."""
        return filled(self._doubles.attitude, t, (3, 3))

    def ball_state(self, t: arb, _: int) -> list[arb]:
        """Return (π, k) at a time, to as many bits as the motion was built for."""
        return self.exact.state(t)

    def exact_period(self, _: int) -> arb | None:
        """Return the period of the nutation, as exact as the motion was built."""
        return self.exact.gains[0]

    def exact_angles(self, _: int) -> tuple[arb, arb]:
        """Return what precession and spin say, as exact as the motion was built."""
        return self.exact.gains[1:]

    @property
    def period(self) -> float | None:
        """The period of the nutation [T]; None at rest and on a separatrix."""
        return None if self.exact.gains[0] is None else double(self.exact.gains[0])

    @property
    def precession(self) -> float:
        """The angle that φ gains in a period, or its rate."""
        return double(self.exact.gains[1])

    @property
    def spin(self) -> float:
        """The angle that ψ gains in a period, or its rate."""
        return double(self.exact.gains[2])

    @cached_property
    def name(self) -> str:
        """The name of the kind of motion, or of how it is computed."""
        parts, level = self.exact.integrands, self.exact.integrands.level
        if parts.path is None:
            point = dict(zip(level.scene.space.coordinates, level.state))
            rests = all(known(rate.xreplace(point)) == 0 for rate in level.scene.vector_field())
            return "equilibrium" if rests else "steady precession"
        roots = parts.path.roots
        if any(roots.double):
            return "separatrix"
        return "elliptic" if roots.leading is not None and not parts.path.rest else "quadrature"

    @property
    def limits(self) -> tuple[float, float]:
        """The lowest and highest k3."""
        return double(self.exact.integrands.lower), double(self.exact.integrands.upper)

    @property
    def nodes(self) -> int:
        """The number of values of the integrands that were taken."""
        return self.exact.integrals.nodes

    @cached_property
    def error(self) -> float:
        """The error of a state in doubles, estimated: the rounding of what turns within a period."""
        parts = self.exact.integrands
        with own_precision(self.exact.precision):
            across = [abs(double(parts.profile.kinetic(end))) ** 0.5 for end in (parts.lower, parts.upper)]
            largest = max(across + [abs(double(enclosed(x))) for x in parts.level.numbers[3:]])
        fastest = max(across + [abs(double(x)) for x in parts.momenta]) / double(parts.I1)
        return 2.0**-52 * (4 + (self.period or 0.0) * fastest) * max(1.0, largest)
