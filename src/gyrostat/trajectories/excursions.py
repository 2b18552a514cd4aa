"""Follows a motion from near an equilibrium, and tells how far it goes."""
import math
from collections.abc import Callable, Sequence

import numpy as np
from sympy import Expr

from ..algebra.enclosures.floats import Array
from ..errors import AccuracyError
from ..mechanics.equilibrium.equilibrium import Equilibrium
from ..stability.decision import Decision
from .motion import Motion

POINTS, LOOKS = 500, 4                                 # times of a motion; looks at its largest distance
# turns for which a motion without a period is followed; times of growth after an escape
TURNED, LATER = 20, 10
# the most steps for all motions of a confirmation, half a minute of either method; steps after which one
# knows how many a time takes
AFFORDED, TRIED = {"heyoka": 3_000_000, "DOP853": 200_000}, 100
# a growth that is slower, in units of the rate, cannot be waited for
SLOW = 1e-6


class Distance:
    """The distance of states from an equilibrium, modulo the rotations that the decision divides out."""

    def __init__(self, eq: Equilibrium, decision: Decision, point: Sequence[Expr]):
        self.point = np.array([float(x) for x in point]).reshape(-1, 3)
        axes = [np.array([float(x) for x in eq.system.space.gradient(integral)[:3]])
                for integral in decision.modulo[:1]]
        self.axes = [axis / np.linalg.norm(axis) for axis in axes]

    def __call__(self, states: Array) -> Array:
        vectors = states.reshape(len(states), -1, 3)
        for axis in self.axes:
            vectors = self.turned(vectors, axis)
        return np.sqrt(((vectors - self.point) ** 2).sum(axis=(1, 2)))

    def turned(self, vectors: Array, axis: Array) -> Array:
        """Return each state turned about the axis until it is closest.

        The difference is then taken without cancellation.
        """
        along = (vectors @ axis)[..., None] * axis
        across, side = vectors - along, np.cross(axis, vectors)
        cosine, sine = ((part * self.point).sum(axis=(1, 2)) for part in (across, side))
        angle = np.arctan2(sine, cosine)[:, None, None]
        return along + np.cos(angle) * across + np.sin(angle) * side


def excursion(moving: Motion, distance: Callable[[Array], Array], rate: float, growth: float,
               size: float, share: int) -> float:
    """Return the largest distance on the way.

    Over a period it is found with a closer and closer look at where the distance is largest.
    """
    if moving.period is None:
        # the linearised field does not move: any time is as good
        rate = rate or 1.0
        longest = TURNED * 2 * math.pi / rate
        if growth > SLOW * rate:
            longest = (math.log(1 / size) + LATER) / growth
        if moving.route in AFFORDED:
            _afford(moving, longest, AFFORDED[moving.route] // share)
        return float(distance(moving(np.linspace(0, longest, max(POINTS, int(8 * longest * rate))))).max())
    times, largest = np.linspace(0, float(moving.period), POINTS), []
    # close to an unstable boundary an escape is short beside the period
    for _ in range(LOOKS):
        far = distance(moving(times))
        largest.append(float(far.max()))
        middle = times[far.argmax()]
        times = np.linspace(middle - (times[1] - times[0]), middle + (times[1] - times[0]), POINTS // 10)
    return max(largest)


def _afford(moving: Motion, longest: float, steps: int) -> None:
    """Refuse a time that takes too many steps of an integration, as its first ones tell.

    Raises
    ------
    AccuracyError
        the time takes more steps
    """
    time = longest * 2.0**-60
    while time < longest and moving.nodes < TRIED:
        time *= 2
        moving(time)
    if moving.nodes * (longest / time) > steps:
        raise AccuracyError(f"until t = {longest:.3g} it takes about {moving.nodes * (longest / time):.0e} "
                            f"steps of {moving.route}, more than {steps}: it leaves too slowly, or turns too "
                            "fast on the way")
