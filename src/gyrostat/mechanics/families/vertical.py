"""Rotation about the vertical, k along the axis e3: upright E1 and hanging E2."""
from ...arguments import checked
from ...errors import EquilibriumError, ScopeError
from ...notation import symbol
from ..equilibrium.claimed_point import equilibrium
from ..equilibrium.equilibrium import Equilibrium
from ..scenes.coupled import in_one_direction
from ..scenes.system import System
from .family import Family
from .named_families import E1, E2


@checked
def upright(scene: System, spin: str = "pi3_0") -> Equilibrium:
    """Return E1: spinning about the upward vertical, k3 = 1.

    Parameters
    ----------
    scene : System
        on e(3)*
    spin : str
        "pi3_0", the momentum [M L²/T], or "omega3_0", the body rate [1/T], π3 = I3 ω3

    Returns
    -------
    Equilibrium

    Raises
    ------
    ScopeError
        the scene has no field
    EquilibriumError
        another spin; or the point is no equilibrium, in a field that is not axial

    References
    ----------
    Vera & Viguera (2003), §3.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> gs.upright(top).point
    (0, 0, pi3_0, 0, 0, 1)
    """
    return _vertical(E1, scene, spin)


@checked
def hanging(scene: System, spin: str = "pi3_0") -> Equilibrium:
    """Return E2: spinning about the downward vertical, k3 = -1.

    Parameters
    ----------
    scene : System
        on e(3)*
    spin : str
        "pi3_0" or "omega3_0", as of `upright`

    Returns
    -------
    Equilibrium

    Raises
    ------
    ScopeError
        a free body hangs nowhere: the scene has no field
    EquilibriumError
        another name of the spin; or the point is no equilibrium, in a field that is not axial

    References
    ----------
    Vera & Viguera (2003), §3.

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> gs.hanging(top).point
    (0, 0, pi3_0, 0, 0, -1)
    """
    return _vertical(E2, scene, spin)


def _vertical(family: Family, scene: System, spin: str) -> Equilibrium:
    in_one_direction(scene.potential, family.label)
    if scene.potential is None:
        raise ScopeError(f"{family.label} needs a field, the scene has none: use principal_rotation(scene, "
                         "3)")
    if spin not in ("pi3_0", "omega3_0"):
        raise EquilibriumError(f"spin = {spin!r} is not a parameter of {family.label}: use 'pi3_0' or "
                               "'omega3_0'")
    momentum = symbol(spin) if spin == "pi3_0" else scene.body.tensor[2, 2] * symbol(spin)
    return equilibrium(scene, (0, 0, momentum, 0, 0, family.pole), label=family.label)
