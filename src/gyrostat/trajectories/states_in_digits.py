"""States at times in doubles, or in as many digits as are asked for, from enclosures that know them."""
from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np
from flint import arb
from sympy import Expr

from ..algebra.enclosures.balls import ball
from ..algebra.enclosures.floats import Array, doubles
from ..algebra.enclosures.precision import own_precision
from ..algebra.text.numbers import exact_number, shown
from ..errors import AccuracyError
from .periods import nearest
from .route import Route


def bits_of(digits: int) -> int:
    """Return the bits for so many decimal digits."""
    return int(3.33 * digits) + 8


def in_digits(x: arb, digits: int) -> mpmath.mpf:
    """Return the middle of an enclosure to so many digits."""
    mantissa, exponent = map(int, x.mid().man_exp())
    return mpmath.mpf((mantissa, exponent), dps=digits)


def states_in_doubles(route: Route, start: Sequence[Expr], t: Any) -> Array:
    """Return the states at times of any shape; at the time 0 as it was given."""
    times = doubles(t, "the times")
    states = route.state(times)
    if not times.all():
        states[times == 0] = [nearest(x) for x in start]
    return states


def states_in_digits(route: Route, start: Sequence[Expr], t: Any, digits: int) -> Array:
    """Return the states at exact times of any shape, of mpmath.mpf; at the time 0 as it was given.

    Raises
    ------
    AccuracyError
        a state is not known to so many digits
    """
    times = np.asarray(t, dtype=object)
    found = np.empty((*times.shape, len(start)), dtype=object)
    for place in np.ndindex(times.shape):
        moment, bits = exact_number(times[place], "t"), bits_of(digits)
        if moment == 0:
            state = [ball(x, bits) for x in start]
        else:
            state = route.ball_state(ball(moment, 2 * bits), bits)
            if not _known(state, digits):
                raise AccuracyError(f"at t = {shown(moment)} the state is not known to {digits} digits: so "
                                    "late, ask for more")
        found[place] = [in_digits(x, digits) for x in state]
    return found


def _known(state: Sequence[arb], digits: int) -> bool:
    """Tell whether every number is enclosed to so many digits of the largest, or of 1."""
    with own_precision(64):
        allowed = max([abs(x) for x in state] + [arb(1)], key=arb.mid) * arb(10) ** -digits
        return all(x.is_finite() and x.rad() <= allowed for x in state)
