"""The impulses of a torque, and the tilts, that are too small to lift a motion over a barrier."""
import math
from collections.abc import Sequence
from typing import Any

from flint import arb
from sympy import Expr, Matrix, oo

from ....algebra.enclosures.balls import ball
from ....algebra.enclosures.precision import own_precision
from ....algebra.reals.exact import evaluate, sign_of_constant
from ....algebra.text.numbers import exact_expression
from ....errors import ScopeError, ValuesError
from ....mechanics.scenes.principal_axes import principal_axes
from ...relative_equilibrium import RelativeEquilibrium
from ..in_balls import BITS, form, in_balls, rows_in_balls
from ..tilts import TiltWell

Matrix3 = list[list[arb]]


def kick_below(rotation: RelativeEquilibrium, barrier: arb, direction: Sequence[Any] | None, across: bool
               ) -> float:
    """Return the impulse √(2 B/(u·I⁻¹u)) along u, or the least of all; of those across k if that is asked.

    Raises
    ------
    ValuesError
        the direction is none, or not across k
    """
    body = rotation.scene.body
    with own_precision(BITS):
        inverse = rows_in_balls(body.inverse)
        if direction is not None:
            stiffness = _along(rotation, direction, inverse, across)
        elif across:
            k = in_balls(rotation.directions[0])
            trace = sum((inverse[i][i] for i in range(3)), arb(0)) - form(inverse, k)
            product = form(rows_in_balls(body.tensor), k) / ball(body.tensor.det(), BITS)
            stiffness = (trace + abs(trace**2 - 4 * product).upper().sqrt()) / 2
        else:
            return any_kick_below(rotation, barrier)
        return below((2 * barrier / stiffness).sqrt())


def any_kick_below(rotation: RelativeEquilibrium, rise: arb) -> float:
    """Return the impulse √(2 B/(u·I⁻¹u)) along the axis of least moment, on which it is least."""
    with own_precision(BITS):
        return below((2 * rise * principal_moments(rotation)[0]).sqrt())


def tilt_below(rotation: RelativeEquilibrium, barrier: arb) -> float:
    """Return an angle in degrees below which a turn of a satellite at rest raises V by less than a barrier.

    Along a turn by θ the slope of V is 0 at first, and its second derivative at most K: V rises by K θ²/2 at
    most. With the difference D of the greatest and the least moment, K = (2 + √5) D ω0² + ω0 abs(l), as
    ½ x·Ax of a unit vector that turns has a second derivative of at most (1/2 + √5/4) D. Without a rotor V
    rises by 2 D ω0² sin²θ at most.
    """
    body, rate = rotation.scene.body, ball(rotation.rates["omega0"], BITS)
    with own_precision(BITS):
        least_moment, _, greatest = principal_moments(rotation)
        spread = greatest - least_moment
        rotor = [ball(x, BITS) for x in body.gyrostatic_momentum]
        length = sum((x * x for x in rotor), arb(0)).sqrt()
        angle = (2 * barrier / ((2 + arb(5).sqrt()) * spread * rate**2 + abs(rate) * length)).sqrt()
        share = barrier / (2 * spread * rate**2)
        if not any(body.gyrostatic_momentum) and share < 1:
            exact = share.sqrt().asin()
            angle = exact if exact > angle else angle
        return min(below(angle * 180 / arb.pi()), 180.0)


def principal_moments(rotation: RelativeEquilibrium) -> list[arb]:
    """Return the principal moments in any axes, the least first."""
    body, _ = principal_axes(rotation.scene.body)
    return sorted(in_balls(body.moments), key=lambda x: float(x.mid()))


def about_the_nodes(well: TiltWell, direction: Sequence[Any] | None, level: bool) -> float:
    """Return the impulse about the line of nodes, the one that keeps C1 and the spin of a body of revolution.

    Raises
    ------
    ScopeError
        another direction is given, or other kicks are meant
    """
    if not level:
        raise ScopeError("a kick along k changes C1, and the well with it: ask for those across k, "
                         "level=True")
    if direction is not None:
        raise ScopeError("a body of revolution keeps C1 and its spin in kicks about the line of nodes alone: "
                         "leave the direction out")
    kick = well.kick
    assert kick is not None
    return math.inf if kick == oo else below(ball(kick, BITS))


def given_direction(direction: Sequence[Any]) -> list[Expr]:
    """Return the components of a direction as exact numbers, or refuse it."""
    exact = [exact_expression(x, "direction") for x in direction]
    if len(exact) != 3 or not any(exact):
        raise ValuesError(f"direction = {tuple(direction)} is none: give three numbers that are not all 0")
    return exact


def _along(rotation: RelativeEquilibrium, direction: Sequence[Any], inverse: Matrix3, across: bool) -> arb:
    exact = given_direction(direction)
    if across and sign_of_constant(evaluate(Matrix(exact).dot(Matrix(rotation.directions[0])), {})):
        raise ValuesError("this kick is not across k, and changes C1: leave the direction out")
    u = [ball(x, BITS) for x in exact]
    return form(inverse, u) / sum((x * x for x in u), arb(0))


def below(number: arb) -> float:
    """A double that is not above a ball."""
    return math.nextafter(math.nextafter(float(number.mid()) - float(number.rad()), 0), 0)
