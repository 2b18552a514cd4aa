"""Euler angles: rotation from the body to space, angular velocity, and the Lagrangian of a gyrostat in a
field.

R = Rz(φ) Rₓ(θ) Rz(ψ) ("zxz") or Rz(φ) R_y(θ) Rz(ψ) ("zyz"), with x_space = R x_body; hat(ω) = Rᵀ Ṙ in body
    axes, and the
direction of the field is k = Rᵀ e_z, the same bracket's k: k̇ = k × ω.
"""
from collections.abc import Sequence
from functools import cache

from sympy import Expr, ImmutableMatrix, Rational, cos, sin

from ..algebra.polynomials import Ring
from ..errors import BodyError, ScopeError, require
from ..notation import symbol
from .body import Gyrostat
from .potential import Potential

ANGLES = tuple(map(symbol, ("phi", "theta", "psi")))
RATES = tuple(map(symbol, ("phi_dot", "theta_dot", "psi_dot")))
CONVENTIONS = ("zxz", "zyz")


def elementary(axis: str, angle: Expr) -> ImmutableMatrix:
    """Rotation by an angle about the axis x, y or z."""
    c, s = cos(angle), sin(angle)
    return ImmutableMatrix({"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
                            "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis])


@cache
def rotation(convention: str = "zxz") -> ImmutableMatrix:
    """R in the angles phi, theta, psi: from body to space axes.

    Parameters
    ----------
    convention : "zxz" or "zyz"
        axes of the three rotations, the second about the line of nodes

    Returns
    -------
    ImmutableMatrix, shape (3, 3)

    Raises
    ------
    ScopeError
        another convention

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.mechanics.rotation("zxz").row(2)
    Matrix([[sin(psi)*sin(theta), sin(theta)*cos(psi), cos(theta)]])
    """
    if convention not in CONVENTIONS:
        raise ScopeError(f"convention = {convention!r}: the Euler angles here are {' or '.join(CONVENTIONS)}")
    factors = [elementary(axis, angle) for axis, angle in zip(convention, ANGLES)]
    return ImmutableMatrix(factors[0] * factors[1] * factors[2])


@cache
def nodes(convention: str = "zxz") -> ImmutableMatrix:
    """Columns: the axes of φ̇, θ̇ and ψ̇ in body components, so that ω = nodes · (φ̇, θ̇, ψ̇).

    Each column is read from hat(ω) = Rᵀ ∂R/∂angle.

    Examples
    --------
    >>> nodes("zyz").col(1).T
    Matrix([[sin(psi), cos(psi), 0]])
    """
    R = rotation(convention)
    hats = [(R.T * R.diff(angle)).applyfunc(reduced) for angle in ANGLES]
    return ImmutableMatrix([[h[2, 1] for h in hats], [h[0, 2] for h in hats], [h[1, 0] for h in hats]])


def angular_velocity(convention: str = "zxz") -> ImmutableMatrix:
    """ω in body components, in the angles and their rates phi_dot, theta_dot, psi_dot.

    Parameters
    ----------
    convention : "zxz" or "zyz"
        of Euler's angles, as in rotation

    Returns
    -------
    ImmutableMatrix, shape (3, 1)
        [1/T]

    Raises
    ------
    ScopeError
        another convention

    References
    ----------
    Landau & Lifshitz, Mechanics, §35 (zxz); Taylor, Classical Mechanics (2005), §10.9 (zyz).

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.mechanics.angular_velocity("zxz")[2]
    phi_dot*cos(theta) + psi_dot
    """
    return nodes(convention) * ImmutableMatrix(RATES)


def angular_momentum(body: Gyrostat, convention: str = "zxz") -> ImmutableMatrix:
    """M = I ω + l in body components, in the angles and their rates.

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
    >>> gs.mechanics.angular_momentum(gs.Gyrostat((gs.symbol("I1"), gs.symbol("I1"), gs.symbol("I3")),
    ...                                           (0, 0, 0)))[2]
    I3*(phi_dot*cos(theta) + psi_dot)
    """
    require(body, Gyrostat, "the body")
    return ImmutableMatrix([moment * rate + rotor for moment, rate, rotor in zip(
        body.inertia, angular_velocity(convention), body.gyrostatic_momentum)])


def direction(convention: str = "zxz") -> ImmutableMatrix:
    """k = Rᵀ e_z in body components, shape (3, 1)."""
    return rotation(convention).row(2).T


def lagrangian(body: Gyrostat, potential: Potential | None = None, convention: str = "zxz") -> Expr:
    """L = ½ ω·Iω + l·ω − U(k), in the angles and their rates.

    Parameters
    ----------
    body : Gyrostat
    potential : Potential or None
        U(k) of the scene; None for the free body
    convention : "zxz" or "zyz"
        of Euler's angles, as in rotation

    Returns
    -------
    Expr
        [M L²/T²]

    Raises
    ------
    ScopeError
        another convention

    References
    ----------
    Goldstein, Classical Mechanics, §5.7 (l = 0); the rotor adds l·ω, whose derivative is its momentum.

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.mechanics.lagrangian(gs.Gyrostat((gs.symbol("I1"), gs.symbol("I1"), gs.symbol("I3")), (0, 0, 0)),
    ...                         gs.uniform_field())
    I1*phi_dot**2*sin(theta)**2/2 + I1*theta_dot**2/2 + I3*(phi_dot*cos(theta) + psi_dot)**2/2 - m0*cos(theta)
    """
    require(body, Gyrostat, "the body")
    omega = angular_velocity(convention)
    kinetic = Rational(1, 2) * sum(moment * rate**2 for moment, rate in zip(body.inertia, omega))
    if body.inertia[0] == body.inertia[1]:             # ω1² + ω2² is θ̇² + φ̇² sin²θ in either convention
        theta, phi_dot, theta_dot = ANGLES[1], RATES[0], RATES[1]
        square = phi_dot**2 * sin(theta) ** 2 + theta_dot**2
        kinetic = (Rational(1, 2) * body.inertia[0] * square).expand() + Rational(1, 2) * body.inertia[
            2
        ] * omega[2] ** 2
    rotor = sum(part * rate for part, rate in zip(body.gyrostatic_momentum, omega))
    k = dict(zip(map(symbol, ("k1", "k2", "k3")), direction(convention)))
    return kinetic + rotor - (potential.expression.subs(k) if potential else 0)


def momenta(body: Gyrostat, convention: str = "zxz") -> tuple[Expr, Expr, Expr]:
    """(p_φ, p_θ, p_ψ) = ∂L/∂(φ̇, θ̇, ψ̇).

    p_φ = M·k is the Casimir C1 of e(3)*, conserved in every field U(k); p_ψ = M3 = π3 + l3 is the integral
    of a body of revolution in U(k3).

    Parameters
    ----------
    body : Gyrostat
    convention : "zxz" or "zyz"
        of Euler's angles, as in rotation

    Returns
    -------
    tuple of Expr, shape (3,)
        [M L²/T]

    Raises
    ------
    ScopeError
        another convention

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.mechanics.momenta(gs.symmetric_gyrostat())[2]
    I3*(phi_dot*cos(theta) + psi_dot) + l
    """
    p_phi, p_theta, p_psi = nodes(convention).T * angular_momentum(body, convention)
    return p_phi, p_theta, p_psi


def effective_potential(body: Gyrostat, potential: Potential) -> Expr:
    """V(θ) of a body of revolution in U(k3).

    ½ I1 θ̇² + V = energy, in the momenta p_phi = C1 and p_psi = π3 + l.

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
    >>> gs.mechanics.effective_potential(gs.symmetric_gyrostat(), gs.uniform_field())
    m0*cos(theta) + (-l + p_psi)**2/(2*I3) + (p_phi - p_psi*cos(theta))**2/(2*I1*sin(theta)**2)
    """
    require(body, Gyrostat, "the body")
    require(potential, Potential, "the potential")
    if not body.is_of_revolution() or not potential.axial:
        raise ScopeError("θ moves by itself only for a body of revolution in U(k3); here inertia = "
                         f"{body.inertia}, "
                         f"U = {potential.expression}: use lagrangian")
    (I1, _, I3), l, theta = body.inertia, body.gyrostatic_momentum[2], ANGLES[1]
    p_phi, p_psi = symbol("p_phi"), symbol("p_psi")
    turning = (p_phi - p_psi * cos(theta)) ** 2 / (2 * I1 * sin(theta) ** 2)
    return turning + (p_psi - l) ** 2 / (2 * I3) + potential.expression.subs(symbol("k3"), cos(theta))


def angle_rates(omega: Sequence[Expr] | ImmutableMatrix, convention: str = "zxz") -> tuple[Expr, ...]:
    """(φ̇, θ̇, ψ̇) of an angular velocity in body components, where sin θ ≠ 0.

    Parameters
    ----------
    omega : sequence of Expr or ImmutableMatrix, shape (3,) or (3, 1)
        angular velocity in body components [1/T]
    convention : "zxz" or "zyz"
        of Euler's angles, as in rotation

    Returns
    -------
    tuple of Expr, shape (3,)
        in phi, theta, psi and the components [1/T]

    Raises
    ------
    BodyError
        there are not three components
    ScopeError
        another convention

    References
    ----------
    Landau & Lifshitz, Mechanics, §35.

    Examples
    --------
    >>> import gyrostat as gs
    >>> rates = gs.mechanics.angle_rates([gs.symbol(f"omega{i}") for i in (1, 2, 3)])
    >>> rates[1]
    omega1*cos(psi) - omega2*sin(psi)
    """
    axes, given = nodes(convention), ImmutableMatrix(omega)
    if given.shape != (3, 1):
        raise BodyError(f"the angular velocity has the shape {given.shape}: give three components, along "
                        "the axes of the body")
    return tuple(map(reduced, axes.adjugate() * given / reduced(axes.det())))


def reduced(expression: Expr) -> Expr:
    """In lowest terms, with sin² + cos² = 1."""
    ring = Ring([expression])
    top, bottom = ring.fraction(expression)
    return ring.quotient(top, ring.reduce(bottom))
