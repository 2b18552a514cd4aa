"""The Lagrangian of a gyrostat in a field, in Euler's angles: momenta and the effective potential."""
from sympy import Expr, ImmutableMatrix, Rational, cos, sin

from ...arguments import checked
from ...errors import ScopeError
from ...notation import components, symbol
from ..scenes.body import Gyrostat
from ..scenes.coupled import in_one_direction
from ..scenes.potential import Potential
from .attitude import ANGLES, RATES, angular_velocity, direction, nodes


@checked
def angular_momentum(body: Gyrostat, convention: str = "zxz") -> ImmutableMatrix:
    """Return M = I ω + l in body components, in the angles and their rates.

    Parameters
    ----------
    body : Gyrostat
    convention : "zxz" or "zyz"
        of Euler's angles, as in rotation

    Returns
    -------
    ImmutableMatrix, shape (3, 1)
        [M L²/T]

    Raises
    ------
    ScopeError
        another convention

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.mechanics.angular_momentum(gs.symmetric_gyrostat())[2]
    I3*(phi_dot*cos(theta) + psi_dot) + l
    """
    return ImmutableMatrix([moment * rate + rotor for moment, rate, rotor in zip(
        body.moments, angular_velocity(convention), body.gyrostatic_momentum)])


@checked
def lagrangian(body: Gyrostat, potential: Potential | None = None, convention: str = "zxz") -> Expr:
    """Return the Lagrangian L = ½ ω·Iω + l·ω − U(k), in the angles and their rates.

    Parameters
    ----------
    body : Gyrostat
    potential : Potential or None
        U(k) of the scene; default: the body is free
    convention : "zxz" or "zyz"
        of Euler's angles, as in rotation

    Returns
    -------
    Expr
        [M L²/T²]

    Raises
    ------
    ScopeError
        another convention; two directions, or a coupling

    References
    ----------
    Goldstein, Classical Mechanics, §5.7 (l = 0); the rotor adds l·ω, whose derivative is its momentum.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body, field = gs.symmetric_gyrostat(), gs.uniform_field()
    >>> L = gs.mechanics.lagrangian(body, field)
    >>> for term in L.as_ordered_terms():
    ...     print(term)
    I1*phi_dot**2*sin(theta)**2/2
    I1*theta_dot**2/2
    I3*(phi_dot*cos(theta) + psi_dot)**2/2
    l*(phi_dot*cos(theta) + psi_dot)
    -m0*cos(theta)
    """
    in_one_direction(potential, "the Lagrangian")
    omega = angular_velocity(convention)
    kinetic = Rational(1, 2) * sum(moment * rate**2 for moment, rate in zip(body.moments, omega))
    I1, I2, I3 = body.moments
    if I1 == I2:                                       # ω1² + ω2² is θ̇² + φ̇² sin²θ in either convention
        theta, phi_dot, theta_dot = ANGLES[1], RATES[0], RATES[1]
        square = phi_dot**2 * sin(theta) ** 2 + theta_dot**2
        kinetic = (Rational(1, 2) * I1 * square).expand() + Rational(1, 2) * I3 * omega[2] ** 2
    rotor = sum(part * rate for part, rate in zip(body.gyrostatic_momentum, omega))
    k = dict(zip(components("k"), direction(convention)))
    return kinetic + rotor - (potential.expression.subs(k) if potential else 0)


@checked
def momenta(body: Gyrostat, convention: str = "zxz") -> tuple[Expr, Expr, Expr]:
    """Return the momenta (p_φ, p_θ, p_ψ) = ∂L/∂(φ̇, θ̇, ψ̇).

    p_φ = M·k is the Casimir C1 of e(3)*, conserved in every field U(k); p_ψ = M3 = π3 + l3 is an integral if
    the body is one of revolution in U(k3).

    Parameters
    ----------
    body : Gyrostat
    convention : "zxz" or "zyz"
        of Euler's angles

    Returns
    -------
    tuple of Expr, shape (3,)
        [M L²/T]

    Raises
    ------
    ScopeError
        an unknown convention

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.mechanics.momenta(gs.symmetric_gyrostat())[2]
    I3*(phi_dot*cos(theta) + psi_dot) + l
    """
    p_phi, p_theta, p_psi = nodes(convention).T * angular_momentum(body, convention)
    return p_phi, p_theta, p_psi


@checked
def effective_potential(body: Gyrostat, potential: Potential) -> Expr:
    """Return the effective potential V(θ) of a body of revolution in U(k3).

    It gives ½ I1 θ̇² + V = energy, in the momenta p_phi = C1 and p_psi = π3 + l (Routh's reduction):

    V = (p_φ − p_ψ cos θ)² / (2 I1 sin² θ) + (p_ψ − l)² / (2 I3) + U(cos θ)

    Parameters
    ----------
    body : Gyrostat
        of revolution
    potential : Potential
        U(k3)

    Returns
    -------
    Expr
        in theta, p_phi and p_psi [M L²/T²]

    Raises
    ------
    ScopeError
        the body is not of revolution, or U is not U(k3)

    References
    ----------
    Goldstein, Classical Mechanics, §5.7 (l = 0).

    Examples
    --------
    >>> import gyrostat as gs
    >>> body, field = gs.symmetric_gyrostat(), gs.uniform_field()
    >>> V = gs.mechanics.effective_potential(body, field)
    >>> for term in V.as_ordered_terms():
    ...     print(term)
    m0*cos(theta)
    (-l + p_psi)**2/(2*I3)
    (p_phi - p_psi*cos(theta))**2/(2*I1*sin(theta)**2)
    """
    in_one_direction(potential, "the effective potential")
    if not body.is_of_revolution() or not potential.axial:
        raise ScopeError("θ moves by itself only for a body of revolution in U(k3); here inertia = "
                         f"{body.moments}, "
                         f"U = {potential.expression}: use lagrangian")
    (I1, _, I3), l, theta = body.moments, body.gyrostatic_momentum[2], ANGLES[1]
    p_phi, p_psi = symbol("p_phi"), symbol("p_psi")
    turning = (p_phi - p_psi * cos(theta)) ** 2 / (2 * I1 * sin(theta) ** 2)
    return turning + (p_psi - l) ** 2 / (2 * I3) + potential.expression.subs(symbol("k3"), cos(theta))
