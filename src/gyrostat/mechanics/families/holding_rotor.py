"""The rotor that holds a satellite Earth-pointing, whatever its products of inertia."""
from sympy import Expr, ImmutableMatrix

from ...algebra.reals.exact import is_identically_zero
from ...algebra.rings.polynomials import lowest_terms
from ...algebra.text.numbers import shown
from ...arguments import checked
from ...errors import EquilibriumError, ScopeError, brief
from ..scenes.body import Gyrostat
from ..scenes.coupled import CoupledPotential
from ..scenes.system import assemble
from .circular_orbit import axes_of, by_gradient_alone, orbital_rate


@checked
def earth_pointing_gyrostat(body: Gyrostat, orbit: CoupledPotential, roll: int = 1, pitch: int = 2,
                            yaw: int = 3) -> Gyrostat:
    """Return the body with the rotor that holds it at rest in the frame of its circular orbit.

    That rotor has l·t = −ω0 t·I n and l·r = −4 ω0 r·I n; l·n is free, and that of the body is kept. It needs
    t·I r = 0: no rotor holds the torque of the gravity gradient about n, 3 ω0² t·I r.

    Parameters
    ----------
    body : Gyrostat
    orbit : CoupledPotential
        circular_orbit()
    roll, pitch, yaw : int
        as in earth_pointing

    Returns
    -------
    Gyrostat

    Raises
    ------
    ScopeError
        it is no orbit, or another field acts there, or a rotor is free
    EquilibriumError
        the axes are not three; or t·I r is not 0

    References
    ----------
    Derived; Hughes, Spacecraft Attitude Dynamics (1986), chapter 9.

    Examples
    --------
    >>> import gyrostat as gs
    >>> orbit = gs.circular_orbit(1)
    >>> tensor = [["3/2", "1/10", 0], ["1/10", 2, "1/20"], [0, "1/20", 1]]
    >>> held = gs.earth_pointing_gyrostat(gs.Gyrostat(tensor, (0, 0, 0)), orbit)
    >>> held.gyrostatic_momentum
    (-1/10, 0, -1/5)
    >>> pointing = gs.earth_pointing(gs.assemble(held, orbit))
    >>> gs.analyze(pointing).verdict({}).verdict.name
    'STABLE'
    """
    scene = assemble(body, orbit)
    if not by_gradient_alone(scene):
        raise ScopeError("earth_pointing_gyrostat is for a satellite in the gravity gradient of a "
                         "circular orbit, without another field and without a free rotor: give "
                         "circular_orbit()")
    t, n, r = map(ImmutableMatrix, axes_of(roll, pitch, yaw))
    I, rate = body.tensor, orbital_rate(scene)
    product = t.dot(I * r)
    if is_identically_zero(product) is not True:
        apart = lowest_terms(t.dot(I * t) - r.dot(I * r))
        raise EquilibriumError(
            f"t·Ir = {_told(product)}, the product of inertia of roll and yaw: the gravity gradient turns "
            "it about the normal, and no rotor balances it. Turn the body about the normal, t towards r "
            f"by φ, tan 2φ = 2 t·Ir/(t·It − r·Ir) = {_told(2 * product)} over {_told(apart)}")
    kept = n.dot(ImmutableMatrix(body.gyrostatic_momentum))
    rotor = -rate * t.dot(I * n) * t + kept * n - 4 * rate * r.dot(I * n) * r
    return Gyrostat(body.inertia, list(map(lowest_terms, rotor)))


def _told(value: Expr) -> str:
    return brief(shown(value, 12))[1:-1]
