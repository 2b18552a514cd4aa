"""Fields that have names: uniform, Newtonian of any order by Legendre polynomials, ideal fluid."""
from numbers import Integral

from sympy import Rational, legendre

from ...errors import PotentialError, brief
from ...notation import symbol
from .entered_potential import axial_potential
from .potential import Potential

HIGHEST = 100                                              # order: higher ones take seconds to write down


def uniform_field() -> Potential:
    """Return the uniform field U = m0 k3 with m0 = m g z0.

    If z0 > 0, the centre of mass is above the support at k3 = 1. A body of revolution in this field is the
    Lagrange top.

    Returns
    -------
    Potential

    References
    ----------
    Vera & Viguera (2003), §1.

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.uniform_field().expression
    k3*m0
    """
    return newtonian_field(1)


def newtonian_field(order: int) -> Potential:
    """Return the attraction by a distant centre below, up to an order in 1/r.

    Order 1 is the uniform field, order 2 adds the gravity gradient:

    U⁽ᴺ⁾ = Σ (−1)ⁿ⁺¹ g Jₙ/rⁿ⁻¹ Pₙ(k3) over n = 1, …, N, with Legendre's Pₙ, up to a constant that makes U = 0
    at k3 = 0:
    U⁽¹⁾ = m0 k3,  U⁽²⁾ = U⁽¹⁾ + (m1/2) (I3 − I1) k3²,  U⁽³⁾ = U⁽²⁾ + (m1/3) (J3/r) P₃(k3), …

    The centre is at the distance r [L] from the fixed point, in the direction −k; g is its attraction there
    [L/T²]. J₁ = m z0 and J₂ = I1 − I3 enter through m0 = m g z0 [M L²/T²] and m1 = 3 g/r [1/T²]; from n = 3
    on, Jₙ = ∫ abs(x)ⁿ Pₙ(x3/abs(x)) dm [M Lⁿ] is a parameter, J3, J4, …, and the mass has to be distributed
    alike about axis 3: I1 = I2 is not enough. Each Jₙ vanishes for odd n if the body is its own mirror image
    in x3.

    Parameters
    ----------
    order : int
        N, from 1 to 100

    Returns
    -------
    Potential

    Raises
    ------
    PotentialError
        the order is not an integer from 1 to 100

    References
    ----------
    Vera & Viguera (2003), §1 and §3, for N = 1 and 2, §6 for the third.

    Examples
    --------
    >>> import gyrostat as gs
    >>> gs.newtonian_field(2).expression
    k3**2*m1*(-I1 + I3)/2 + k3*m0
    >>> second, third = gs.newtonian_field(2), gs.newtonian_field(3)
    >>> third.expression - second.expression
    J3*m1*(5*k3**3 - 3*k3)/(6*r)
    """
    if isinstance(order, bool) or not isinstance(order, Integral) or not 1 <= order <= HIGHEST:
        raise PotentialError(f"the Newtonian field has no order {brief(order)}: it counts the terms kept in "
                             "1/r, of which the first is the "
                             f"uniform field; give 1, 2, 3, …, {HIGHEST}")
    k3, m0, m1, r, I1, I3 = map(symbol, ("k3", "m0", "m1", "r", "I1", "I3"))
    if order == 1:
        return axial_potential(m0 * k3)
    U = m0 * k3 + m1 / 2 * (I3 - I1) * k3**2
    for n in range(3, int(order) + 1):
        content, polynomial = (legendre(n, k3) - legendre(n, 0)).primitive()
        U += (-1) ** (n + 1) * content / 3 * m1 * symbol(f"J{n}") / r ** (n - 2) * polynomial
    return Potential((k3,), U, revolution=True)


def ideal_fluid() -> Potential:
    """Return the field of a body of revolution in an ideal fluid at rest at infinity: Kirchhoff's equations.

    U = ½ p0² (1/mass3 − 1/mass1) k3², the energy ½ (p1² + p2²)/mass1 + ½ p3²/mass3 of the impulse p = p0 k,
    up to a constant.

    k is the direction of the impulse seen from the body, p0 > 0 its constant magnitude [M L/T]; mass1 across
    and mass3 along the axis, positive, are the mass of the body with the added mass of the fluid [M]. The
    moments I1, I3 contain the added ones. No weight acts (neutral buoyancy, centres of mass and of buoyancy
    at the origin), and no term of the energy couples p with π.

    Returns
    -------
    Potential

    References
    ----------
    Lamb, Hydrodynamics, 6th ed. (1932), §126; Leonard, Automatica 33 (1997) 331-346.

    Examples
    --------
    >>> import gyrostat as gs
    >>> print(gs.ideal_fluid())
    U = p₀² k₃² (1/mass₃ − 1/mass₁)/2
    """
    k3, p0, mass1, mass3 = map(symbol, ("k3", "p0", "mass1", "mass3"))
    return Potential((k3,), Rational(1, 2) * p0**2 * (1 / mass3 - 1 / mass1) * k3**2, revolution=True)
