"""Names what a scene is made of: moments or the tensor, the rotor, and the rate of an orbit."""
from sympy import Expr

from ...notation import symbol
from ..scenes.kind import Kind
from ..scenes.system import System
from .circular_orbit import orbital_rate

MOMENTS, TENSOR, ROTOR = ("I1", "I2", "I3"), ("I11", "I22", "I33", "I23", "I31", "I12"), ("l1", "l2", "l3")


def named_entries(scene: System) -> dict[str, Expr]:
    """Return the entries of a scene by their names.

    Of a body of revolution in U(k3) I2 is left out. The rotor is l if it is along axis 3.

    Examples
    --------
    >>> import gyrostat as gs
    >>> named_entries(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), gs.circular_orbit("1/2")))
    {'I1': 1, 'I2': 2, 'I3': 3, 'omega0': 1/2, 'l': 1}
    """
    body = scene.body
    entries = dict(zip(MOMENTS if len(body.entries) == 3 else TENSOR, body.entries))
    if scene.kind is Kind.REVOLUTION:
        del entries["I2"]
    if scene.kind is Kind.ORBIT:
        entries["omega0"] = orbital_rate(scene)
    *across, along = body.gyrostatic_momentum
    alone = not any(across) and along != symbol("l3")
    return entries | ({"l": along} if alone else dict(zip(ROTOR, body.gyrostatic_momentum)))
