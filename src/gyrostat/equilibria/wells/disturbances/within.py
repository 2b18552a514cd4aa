"""Kicks that keep a permanent rotation within an angle, with or without a pass: V on circles, in balls."""
import math
from collections.abc import Callable, Sequence
from typing import Any

from flint import arb
from sympy import Expr, Poly, PolynomialError, pi

from ....algebra.enclosures.balls import ball
from ....algebra.enclosures.precision import own_precision
from ....algebra.text.numbers import exact_expression
from ....algebra.text.quantities import has_unit, quantity, text_of
from ....algebra.text.units import ANGLE
from ....errors import ScopeError, ValuesError
from ....mechanics.scenes.kind import Kind
from ....mechanics.scenes.potential import DIRECTIONS
from ...relative_equilibrium import RelativeEquilibrium
from ..in_balls import BITS, dot, form, in_balls, rows_in_balls
from .circles import Circle, least
from .kicks import any_kick_below, kick_below

ANGLES = 24                                            # of circles that are tried


def rise_within(rotation: RelativeEquilibrium, degrees: Expr | float | str, level: bool = False) -> arb:
    """Return how much V rises at least where k first comes to an angle from that of the rotation.

    A motion that starts over k0 with less than that above V(k0) keeps k within the angle for ever. V is
    U − ω² k·Ik/2 − ω l·k in the frame that turns with the rotation, and the energy there is V and
    (π − ω I k)·I⁻¹(π − ω I k)/2, whatever C1 is. On the level of C1 it is U + (C1 − l·k)²/(2 k·Ik). The least
    of V on a circle is proved in balls, and the greatest of these over smaller angles, at the same or less
    of which k has to pass, is taken of 24 of them.

    Parameters
    ----------
    rotation : RelativeEquilibrium
        a permanent rotation in a field that is polynomial in k
    degrees : Expr, number or str
        above 0, below 180; a text may have a unit
    level : bool
        of motions on the level of C1, else of all

    Returns
    -------
    arb
        encloses the rise [M L²/T²]; negative where no motion is held within the angle

    Raises
    ------
    ScopeError
        the scene is no body in such a field
    ValuesError
        the angle is not between 0 and 180°

    References
    ----------
    The energy in the turning frame is H − ω C1: Simo, Lewis & Marsden, Arch. Rational Mech. Anal. 115 (1991)
    15-59.

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), U)
    >>> rotation = gs.relative_equilibria(scene, {"C1": "5/2"})[0]
    >>> round(float(rise_within(rotation, 10, level=True).mid()), 15)
    0.019215146693009
    """
    whole = _angle(degrees)
    with own_precision(BITS):
        V = _potential(rotation, level)
        k0 = in_balls(rotation.directions[0])
        full = ball(whole, BITS)
        circles = [Circle.round(k0, full * n / ANGLES) for n in range(1, ANGLES + 1)]
        highest = max((_least_on(V, circle) for circle in circles), key=lambda low: float(low.lower().mid()))
        return highest - V(k0)


def _least_on(V: Callable[[Sequence[Any]], Any], circle: Circle) -> arb:
    return least(lambda phi: V(circle.at(phi)))


def kick_within(rotation: RelativeEquilibrium, degrees: Expr | float | str, level: bool = False) -> float:
    """Return the impulse of a torque below which k stays within an angle for ever, rounded down.

    Parameters
    ----------
    rotation : RelativeEquilibrium
    degrees : Expr, number or str
    level : bool
        of kicks across k, which keep C1; else of any

    Returns
    -------
    float
        [M L²/T]

    Raises
    ------
    ScopeError
        no kick, however small, is known to keep it within the angle; else as rise_within

    Examples
    --------
    >>> import gyrostat as gs
    >>> U = gs.general_potential(lambda k1, k2, k3: k1 + k2 + k3)
    >>> scene = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), U)
    >>> rotation = gs.relative_equilibria(scene, {"C1": "5/2"})[0]
    >>> [round(kick_within(rotation, "10 deg", level), 12) for level in (True, False)]
    [0.206108123742, 0.089311697732]
    """
    rise = rise_within(rotation, degrees, level)
    if not rise > 0:
        reason = f"no kick is known to keep it within {degrees}: V is no lower there than on circles round it"
        raise ScopeError(reason + ("" if level else "; ask for kicks that keep C1, level=True"))
    return kick_below(rotation, rise, None, True) if level else any_kick_below(rotation, rise)


def _angle(degrees: Any) -> Expr:
    given = text_of(degrees)
    if has_unit(given):
        angle, dimension = quantity(given)
        if dimension != ANGLE:
            raise ValuesError(f"{given} is no angle: give one in deg or rad")
    else:
        angle = exact_expression(given, "degrees") * pi / 180
    if not (angle.is_number and 0 < angle < pi):
        raise ValuesError(f"{degrees} is no angle of a cone: choose one above 0°, below 180°")
    return angle


def _potential(rotation: RelativeEquilibrium, level: bool) -> Callable[[Sequence[Any]], Any]:
    """Return V as a function of k, of balls or of power series."""
    scene = rotation.scene
    if scene.kind is not Kind.FIELD or scene.potential is None:
        raise ScopeError(f"the angle of k is asked of a body in a field, not of {scene.kind.value}")
    U, tensor = _polynomial(scene.potential.expression), rows_in_balls(scene.body.tensor)
    l, k0, M = map(in_balls, (scene.body.gyrostatic_momentum, rotation.directions[0], rotation.momentum))
    if level:
        C1 = dot(M, k0)
        return lambda k: U(k) + (C1 - dot(l, k)) * (C1 - dot(l, k)) / (2 * form(tensor, k))
    omega = ball(rotation.rates["omega"], BITS)
    return lambda k: U(k) - omega**2 / 2 * form(tensor, k) - omega * dot(l, k)


def _polynomial(expression: Expr) -> Callable[[Sequence[Any]], Any]:
    try:
        poly = Poly(expression, *DIRECTIONS)
    except PolynomialError:
        raise ScopeError("the potential is no polynomial in k1, k2, k3: no angle is proved") from None
    terms = [(powers, ball(c, BITS)) for powers, c in poly.terms()]

    def value(k: Sequence[Any]) -> Any:
        total = k[0] * 0
        for powers, c in terms:
            total += math.prod((x for x, n in zip(k, powers) for _ in range(n)), start=c)
        return total

    return value
