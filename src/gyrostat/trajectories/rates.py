"""The period of a motion, the angles gained in it and the mean rates, in doubles or in digits."""
from typing import Any

import mpmath
import numpy as np
from flint import arb

from .route import Route
from .states_in_digits import bits_of, in_digits


def period(route: Route, digits: int | None) -> Any:
    """Of the nutation, or of the momentum in a free body [T]; None where there is none."""
    if digits is None:
        return route.period
    found = route.exact_period(bits_of(digits))
    return None if found is None else in_digits(found, digits)


def gained(route: Route, digits: int | None) -> tuple[Any, Any]:
    """The angles of precession and spin, in a period, or in a unit of time where there is none."""
    if digits is None:
        return route.precession, route.spin
    precession, spin = (in_digits(x, digits) if isinstance(x, arb) else x
                        for x in route.exact_angles(bits_of(digits)))
    return precession, spin


def rate(angle: Any, route: Route, digits: int | None) -> Any:
    """An angle gained, by the time in which it is."""
    if angle is None or not route.period:
        return angle
    if digits is None:
        return angle / route.period
    with mpmath.workdps(digits):
        return angle / period(route, digits)


def frequencies(route: Route, angles: tuple[Any, Any]) -> dict[str, float]:
    """2π/period, and the mean rates of the angles gained [1/T], as far as they exist."""
    cycle = route.period
    rates = {name: float(angle) / (cycle or 1.0)
             for name, angle in zip(("precession", "spin"), angles) if angle is not None}
    return ({"nutation": 2 * np.pi / cycle} if cycle else {}) | rates
