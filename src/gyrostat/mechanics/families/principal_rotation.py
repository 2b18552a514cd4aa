"""Principal rotations: a free body about a principal axis that also carries l."""
from ...arguments import checked
from ...errors import EquilibriumError, ScopeError
from ...notation import symbol
from ..equilibrium.claimed_point import equilibrium
from ..equilibrium.equilibrium import Equilibrium
from ..scenes.system import System
from .named_families import PRINCIPAL


@checked
def principal_rotation(scene: System, axis: int) -> Equilibrium:
    """Return the rotation of a free body about a principal axis that also carries l, with M ≠ 0.

    Parameters
    ----------
    scene : System
        on so(3)*
    axis : int
        1, 2 or 3; the body rate about it is omega1_0, omega2_0 or omega3_0 [1/T]

    Returns
    -------
    Equilibrium

    Raises
    ------
    ScopeError
        the scene has a field
    EquilibriumError
        there is no such axis, it is not principal, or it does not carry l

    References
    ----------
    Hughes, Spacecraft Attitude Dynamics (1986), chapter 6.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
    >>> gs.principal_rotation(gs.assemble(body), 2).point
    (0, I2*omega2_0, 0)
    """
    if scene.potential is not None:
        raise ScopeError("principal_rotation is for a free body, the scene has a field: use upright, "
                         "hanging or inclined")
    if axis not in (1, 2, 3):
        raise EquilibriumError(f"axis = {axis!r} is not a principal axis: give 1, 2 or 3")
    point = list(scene.body.tensor[:, axis - 1] * symbol(f"omega{axis}_0"))
    total = point[axis - 1] + scene.body.gyrostatic_momentum[axis - 1]
    return equilibrium(scene, point, domain=(total**2,), label=PRINCIPAL[axis - 1].label)
