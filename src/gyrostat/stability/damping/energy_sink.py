"""The energy-sink condition of a dual spinner with damping in both bodies, to first order in weak dampers."""
from typing import Any

from sympy import Add, S

from ...algebra.reals.exact import proved_sign
from ...algebra.text.numbers import exact_expression
from ...arguments import checked
from ...errors import ScopeError, ValuesError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...mechanics.scenes.rotors import Rotor
from ..criteria.conditions import Criterion, all_positive
from ..notion import Notion
from ..theorems.momentum_sphere import sphere_of


@checked
def energy_sink_criterion(eq: Equilibrium, rotor: Rotor, *, platform_damping: Any,
                          rotor_damping: Any) -> Criterion:
    """Return the condition that a dual spinner keeps its axis with weak dampers in platform and rotor.

    It is P (c_p (P − A Ω_p) + c_r (P − A Ω_r)) > 0, with M = P along the axis, the transverse moment A, and
    the rates Ω_p and Ω_r of the two in space. It is Ė_p/(λ₀ − Ω_p) + Ė_r/(λ₀ − Ω_r) < 0 about the nutation λ₀
    = P/A > 0, with the powers Ė = −c (λ₀ − Ω)². It is of first order in the dampers, hence no verdict. It is
    proved for viscous spheres of any size: if both terms have one sign, it holds, or fails, whatever the
    dampers.

    Parameters
    ----------
    eq : Equilibrium
        of principal_rotation, about the axis of the rotor; the whole a body of revolution about it
    rotor : Rotor
        the one that the body has, and of revolution, as a wheel is; its rate in space is ω + rate, or
        momentum/axial if it turns freely
    platform_damping, rotor_damping : Expr, number or text
        c_p and c_r, not negative and not both 0: a damper takes the power c ε² if its body wobbles at the
        rate ε against what is in it; what counts is their ratio [M L²/T]

    Returns
    -------
    Criterion
        of the notion "energy sink"

    Raises
    ------
    ScopeError
        not a rotation about the one axis of the rotor, or the transverse moments differ
    ValuesError
        a coefficient of damping is negative, or both are 0

    References
    ----------
    Landon & Stewart, J. Spacecraft 1 (1964); Likins, J. Spacecraft 4 (1967); derived in
    docs/explanation/derivations/damping.md, section 7.

    Examples
    --------
    >>> import gyrostat as gs
    >>> wheel = gs.Rotor((0, 0, 1), "40 kg m^2", rate="60 rpm")
    >>> moments = ["1000 kg m^2", "1000 kg m^2", "200 kg m^2"]
    >>> body = gs.gyrostat_with_rotors(moments, [wheel], lumped=True)
    >>> despun = gs.equilibrium(gs.assemble(body), (0, 0, 0))
    >>> dampers = {"platform_damping": gs.symbol("c_p"),
    ...            "rotor_damping": gs.symbol("c_r")}
    >>> print(gs.derivation.energy_sink_criterion(despun, wheel, **dampers))
    c_p > 24 c_r
    """
    damping = [exact_expression(c, name) for name, c in (("platform_damping", platform_damping),
                                                         ("rotor_damping", rotor_damping))]
    known = [c for c in damping if not c.free_symbols]
    if any(proved_sign(c) == -1 for c in known) or not any(damping):
        raise ValuesError(f"platform_damping = {platform_damping}, rotor_damping = {rotor_damping}: damping "
                          "takes power: give numbers that are not negative, and not both 0")
    sphere, body = sphere_of(eq), eq.system.body
    if sphere is None or body.gyrostatic_momentum != rotor.gyrostatic_momentum:
        raise ScopeError("the energy-sink condition is for a free body with this one rotor, turning about "
                         "its axis: assemble gyrostat_with_rotors(inertia, [rotor], …), and take "
                         "principal_rotation about that axis")
    n = sphere.axis
    transverse = body.moments[n - 1]
    if transverse != body.moments[n - 2]:
        raise ScopeError(f"the transverse moments are {transverse} and {body.moments[n - 2]}, and the "
                         "energy-sink condition is for a body of revolution: give two equal moments")
    rate, momentum = eq.point[n] / body.moments[n], eq.point[n] + body.gyrostatic_momentum[n]
    if rotor.momentum is None:
        turning = rate + rotor.axis[n] * (rotor.rate or S.Zero)
    else:
        turning = rotor.axis[n] * rotor.momentum / rotor.axial
    margin = eq.insert(momentum * Add(*(c * (momentum - transverse * x)
                                        for c, x in zip(damping, (rate, turning)))))
    positive = (x for x in (*damping, rotor.axial) if x.free_symbols)
    return all_positive(Notion.ENERGY_SINK, [("energy sink", margin)], eq, (*eq.domain, *positive))
