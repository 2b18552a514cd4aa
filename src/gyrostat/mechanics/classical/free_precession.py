"""The precession of a free body of revolution: its rates, its tilt and its two cones."""
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Expr, acos, sqrt

from ...algebra.text.numbers import exact_expression
from ...arguments import checked
from ...errors import BodyError, ScopeError
from ..scenes.body import Gyrostat


@dataclass(frozen=True)
class FreePrecession:
    """The motion of a free body of revolution: regular precession.

    In space ω and the axis e3 turn about M; seen from the body, ω and M turn about e3: ω = (ω0 cos Ω t, −ω0
    sin Ω t, ω3) from a suitable origin of time, with Ω = (I1 − I3) ω3/I1.

    Parameters
    ----------
    body_rate : Expr
        Ω: in the body, ω and M turn about e3 at −Ω = −ψ̇ [1/T]
    precession : Expr
        φ̇ = abs(M)/I1: in space, ω and e3 turn about M [1/T]
    spin : Expr
        ψ̇ = Ω, the rate about e3 relative to the turning plane of M, ω, e3 [1/T]
    tilt : Expr
        angle θ between M and e3
    body_cone : Expr
        half-angle between ω and e3
    space_cone : Expr
        half-angle between ω and M

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.mechanics.free_precession((2, 1), 1, 2).space_cone.evalf(6)
    0.321751
    """

    body_rate: Expr
    precession: Expr
    spin: Expr
    tilt: Expr
    body_cone: Expr
    space_cone: Expr


@checked
def free_precession(inertia: Sequence[Any], transverse: Any, axial: Any) -> FreePrecession:
    """Return the rates and the cones of a free rigid body of revolution.

    Parameters
    ----------
    inertia : (I1, I3)
        transverse and axial moment [M L²]
    transverse : Expr
        ω0 = √(ω1² + ω2²) [1/T]
    axial : Expr
        ω3 [1/T]

    Returns
    -------
    FreePrecession

    Raises
    ------
    BodyError
        there are not two moments, or one is not positive
    ScopeError
        both rates are 0

    References
    ----------
    Taylor, Classical Mechanics (2005), §10.8; Landau & Lifshitz, Mechanics, §33.

    Examples
    --------
    >>> import gyrostat as gs
    >>> motion = gs.mechanics.free_precession((1, 2), 3, 3)
    >>> motion.body_rate, motion.precession, motion.body_cone
    (-3, 3*sqrt(5), pi/4)
    """
    if len(inertia) != 2:
        raise BodyError(f"inertia has {len(inertia)} entries: give the transverse and the axial moment, "
                        "(I1, I3)")
    I1, I3 = (exact_expression(i, "inertia") for i in inertia)
    Gyrostat((I1, I1, I3), (0, 0, 0))                      # positive, or refused
    across, along = exact_expression(transverse, "transverse rate"), exact_expression(axial, "axial rate")
    if across == along == 0:
        raise ScopeError("transverse = axial = 0: the body is at rest and has no precession; give a rate "
                         "that is not 0")
    rate = (I1 - I3) * along / I1
    M, omega = sqrt((I1 * across) ** 2 + (I3 * along) ** 2), sqrt(across**2 + along**2)
    return FreePrecession(rate, M / I1, rate, acos(I3 * along / M), acos(along / omega),
                          acos((I1 * across**2 + I3 * along**2) / (M * omega)))
