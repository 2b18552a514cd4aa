"""Free bodies: Euler's equations with a torque, limits of the motion, polhode period by Gauss's AGM."""
from collections.abc import Sequence
from typing import Any

import mpmath
from sympy import Expr, Float, ImmutableMatrix, Max, Min, oo

from ...algebra.enclosures.precision import ONE_AT_A_TIME
from ...algebra.reals.exact import proved_sign
from ...algebra.solving.roots import in_order
from ...algebra.text.numbers import exact_expression, exact_number
from ...arguments import checked
from ...errors import BodyError, ScopeError, ValuesError, brief
from ...notation import components
from ..scenes.body import Gyrostat

MOST_DIGITS = 10_000


@checked
def torque_equations(body: Gyrostat, torque: Sequence[Any] = ("tau1", "tau2", "tau3")) -> ImmutableMatrix:
    """Return π̇ = M × ω + τ, Euler's equations with an external torque in body components.

    They are in general no Hamiltonian system: no stability is claimed for them.

    Parameters
    ----------
    body : Gyrostat
    torque : sequence of three
        expressions [M L²/T²], or texts of such; default: tau1, tau2, tau3

    Returns
    -------
    ImmutableMatrix, shape (3, 1)
        in pi1, pi2, pi3 and the torque

    Raises
    ------
    BodyError
        the torque has not three components

    References
    ----------
    Landau & Lifshitz, Mechanics, §36.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
    >>> gs.mechanics.torque_equations(body)[2].factor()
    (I1*I2*tau3 + I1*pi1*pi2 - I2*pi1*pi2)/(I1*I2)
    """
    if len(torque) != 3:
        raise BodyError(f"the torque has {len(torque)} components: give three, along the axes of the body")
    tau = ImmutableMatrix([exact_expression(t, "torque") for t in torque])
    pi = ImmutableMatrix(components("pi"))
    omega = body.inverse * pi
    return (pi + ImmutableMatrix(body.gyrostatic_momentum)).cross(omega) + tau


@checked
def momentum_limits(body: Gyrostat, energy: Any) -> tuple[Expr, Expr]:
    """Return the least and the largest abs(M)² of a free body at an energy.

    Between them the sphere abs(M)² = const meets the ellipsoid Σ Mᵢ²/Iᵢ = 2E. They are 2 E I for the smallest
    and the largest moment, reached by the rotations about those axes.

    Parameters
    ----------
    body : Gyrostat
        without a rotor
    energy : Expr or number
        E [M L²/T²]

    Returns
    -------
    (Expr, Expr)
        [M² L⁴/T²]

    Raises
    ------
    ScopeError
        the body has a rotor
    ValuesError
        the energy is negative

    References
    ----------
    Landau & Lifshitz, Mechanics, §37.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((1, 2, 3), (0, 0, 0))
    >>> gs.mechanics.momentum_limits(body, 5)
    (10, 30)
    """
    if any(body.gyrostatic_momentum):
        raise ScopeError(f"the body has a rotor, l = {body.gyrostatic_momentum}, and the ellipsoid of its "
                         "energy is centred at M = 0 only without one: give gyrostatic_momentum=(0, 0, 0)")
    twice = 2 * exact_expression(energy, "energy")
    if twice.is_negative:
        raise ValuesError(f"energy = {twice / 2} is negative, and no kinetic energy is: give 0 or more")
    return twice * Min(*body.moments), twice * Max(*body.moments)


@checked
def polhode_period(inertia: Sequence[Any], momentum: Sequence[Any], digits: int = 15) -> Expr:
    """Return the period of M in the body, for a free rigid body; infinite on the separatrix.

    With I1 < I2 < I3 and M² > 2 E I2 it is T = 4 K(κ) √(I1 I2 I3 / ((I3 − I2)(M² − 2 E I1))), where κ² = (I2
    − I1)(2 E I3 − M²) / ((I3 − I2)(M² − 2 E I1)). With M² < 2 E I2 the axes 1 and 3 are exchanged.

    Parameters
    ----------
    inertia : three positive numbers
    momentum : three numbers
        M at any time [M L²/T]
    digits : int
        of the result

    Returns
    -------
    Expr
        Float, or oo on the separatrix [T]

    Raises
    ------
    ScopeError
        two moments are equal (free_precession), or M rests on an axis
    ValuesError
        an entry is not an exact number

    References
    ----------
    Landau & Lifshitz, Mechanics, (37.11)-(37.12).

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.mechanics.polhode_period((1, 2, 3), ("0.3", "0.2", "0.9"))
    22.8986475506197
    """
    if len(inertia) != 3 or len(momentum) != 3 or not isinstance(digits, int) or not (
            1 <= digits <= MOST_DIGITS):
        raise ValuesError(f"inertia = {brief(inertia)}, momentum = {brief(momentum)}, "
                          f"digits = {brief(digits)}: give three moments, three components of M and a "
                          f"number of digits from 1 to {MOST_DIGITS}")
    moments = [exact_number(i, "inertia") for i in inertia]
    M = [exact_number(m, "momentum") for m in momentum]
    Gyrostat(moments, (0, 0, 0))                           # positive, or refused
    order = in_order(moments)
    (I1, M1), (I2, M2), (I3, M3) = sorted(zip(moments, M), key=lambda pair: order.index(pair[0]))
    if 0 in (proved_sign(I2 - I1), proved_sign(I3 - I2)):
        raise ScopeError(f"inertia = {tuple(moments)} has two equal moments: use free_precession")
    if sum(proved_sign(m) != 0 for m in M) < 2:
        raise ScopeError(f"momentum = {tuple(M)} lies on a principal axis, where it rests: give at least "
                         "two components")
    # (I3 − I2)(M² − 2 E I1), without cancellation
    above = (I3 - I2) * ((1 - I1 / I2) * M2**2 + (1 - I1 / I3) * M3**2)
    below = (I2 - I1) * ((I3 / I1 - 1) * M1**2 + (I3 / I2 - 1) * M2**2)      # (I2 − I1)(2 E I3 − M²)
    # above − below = (I3 − I1)(M² − 2 E I2), whose sign tells about which axis M goes round
    gap = (I3 - I1) * ((1 - I2 / I3) * M3**2 - (I2 / I1 - 1) * M1**2)
    if (side := proved_sign(gap)) == 0:
        return oo
    lead = above if side == 1 else below
    # K(κ) = π / (2 agm(1, κ′)), κ′² = 1 − κ² = |gap| / lead
    with ONE_AT_A_TIME, mpmath.workdps(digits + 10):
        complement, scale = (mpmath.sqrt(mpmath.mpf(x.evalf(digits + 10)._mpf_))
                             for x in (side * gap / lead, I1 * I2 * I3 / lead))
        return Float(2 * mpmath.pi / mpmath.agm(1, complement) * scale, digits)
