"""The amended potential: what a permanent rotation on a level of C1 is a critical point of."""
from sympy import Expr, Matrix

from ..errors import ScopeError, require
from ..notation import symbol
from .potential import DIRECTIONS
from .system import System


def amended_potential(scene: System) -> Expr:
    """U_c(k) = U + (C1 − l·k)²/(2 k·Ik) on abs(k) = 1, C1 = M·k.

    Its critical points are the permanent rotations ω = omega k with omega = (C1 − l·k)/(k·Ik). At a minimum
    one is stable, at a saddle unstable; at a maximum only gyroscopic forces can hold it. Where none is
    degenerate, minima − saddles + maxima = 2. All of them at given numbers: relative_equilibria.

    Parameters
    ----------
    scene : System
        with a field

    Returns
    -------
    Expr
        in k1, k2, k3 and C1 [M L²/T²]

    Raises
    ------
    ScopeError
        the scene has no field

    References
    ----------
    Simo, Lewis & Marsden, Arch. Rational Mech. Anal. 115 (1991) 15-59.

    Examples
    --------
    >>> import gyrostat as gs
    >>> moments = tuple(map(gs.symbol, ("I1", "I2", "I3")))
    >>> scene = gs.assemble(gs.Gyrostat(moments, (0, 0, gs.symbol("l"))), gs.uniform_field())
    >>> gs.mechanics.amended_potential(scene)
    k3*m0 + (C1 - k3*l)**2/(2*I1*k1**2 + 2*I2*k2**2 + 2*I3*k3**2)
    """
    require(scene, System, "the scene")
    if scene.potential is None:
        raise ScopeError("the scene has no field, and the vertical no meaning: its rotations are those on a "
                         "sphere of M; give a potential, or use relative_equilibria with M")
    k, body = Matrix(DIRECTIONS), scene.body
    twist = symbol("C1") - k.dot(Matrix(body.gyrostatic_momentum))
    return scene.potential.expression + twist**2 / (2 * k.dot(body.tensor * k).expand())
