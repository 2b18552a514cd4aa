"""Euler angles: rotation from the body to space, angular velocity, and the rates of the angles.

The rotation is R = Rz(φ) Rₓ(θ) Rz(ψ) ("zxz") or Rz(φ) R_y(θ) Rz(ψ) ("zyz"), with x_space = R x_body. In body
axes hat(ω) = Rᵀ Ṙ, and the direction of the field is k = Rᵀ e_z, the k of the bracket: k̇ = k × ω.
"""
from collections.abc import Sequence
from functools import cache

from sympy import Expr, ImmutableMatrix, cos, sin

from ...algebra.rings.polynomials import Ring
from ...algebra.text.numbers import exact_expression
from ...arguments import checked, several
from ...errors import ScopeError
from ...notation import symbol

ANGLES = tuple(map(symbol, ("phi", "theta", "psi")))
RATES = tuple(map(symbol, ("phi_dot", "theta_dot", "psi_dot")))
CONVENTIONS = ("zxz", "zyz")


def elementary(axis: str, angle: Expr) -> ImmutableMatrix:
    """Return the rotation by an angle about the axis x, y or z."""
    c, s = cos(angle), sin(angle)
    return ImmutableMatrix({"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
                            "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis])


@checked
@cache
def rotation(convention: str = "zxz") -> ImmutableMatrix:
    """Return the rotation R in the angles phi, theta, psi, from body to space axes.

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
        raise ScopeError(f"convention = {convention!r} is not known: give {' or '.join(CONVENTIONS)}")
    factors = [elementary(axis, angle) for axis, angle in zip(convention, ANGLES)]
    return ImmutableMatrix(factors[0] * factors[1] * factors[2])


@cache
def nodes(convention: str = "zxz") -> ImmutableMatrix:
    """Return the axes of φ̇, θ̇ and ψ̇ in body components, as columns: ω = nodes · (φ̇, θ̇, ψ̇).

    Each column is read from hat(ω) = Rᵀ ∂R/∂angle.

    Examples
    --------
    >>> nodes("zyz").col(1).T
    Matrix([[sin(psi), cos(psi), 0]])
    """
    R = rotation(convention)
    hats = [(R.T * R.diff(angle)).applyfunc(reduced) for angle in ANGLES]
    return ImmutableMatrix([[h[2, 1] for h in hats], [h[0, 2] for h in hats], [h[1, 0] for h in hats]])


@checked
def angular_velocity(convention: str = "zxz") -> ImmutableMatrix:
    """Return ω in body components, in the angles and their rates phi_dot, theta_dot, psi_dot.

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


def direction(convention: str = "zxz") -> ImmutableMatrix:
    """Return k = Rᵀ e_z in body components, shape (3, 1)."""
    return rotation(convention).row(2).T


@checked
def angle_rates(omega: Sequence[Expr] | ImmutableMatrix, convention: str = "zxz") -> tuple[Expr, ...]:
    """Return (φ̇, θ̇, ψ̇) for an angular velocity in body components, if sin θ ≠ 0.

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
    ArgumentError
        there are not three components
    ScopeError
        another convention

    References
    ----------
    Landau & Lifshitz, Mechanics, §35.

    Examples
    --------
    >>> import gyrostat as gs
    >>> omega = [gs.symbol(f"omega{i}") for i in (1, 2, 3)]
    >>> gs.mechanics.angle_rates(omega)[1]
    omega1*cos(psi) - omega2*sin(psi)
    """
    components = several(omega, "the angular velocity", 3)
    given = ImmutableMatrix([exact_expression(x, f"omega{i}") for i, x in enumerate(components, 1)])
    axes = nodes(convention)
    return tuple(map(reduced, axes.adjugate() * given / reduced(axes.det())))


def reduced(expression: Expr) -> Expr:
    """Return the expression in lowest terms, reduced by sin² + cos² = 1."""
    ring = Ring([expression])
    top, bottom = ring.fraction(expression)
    return ring.quotient(top, ring.reduce(bottom))
