"""Releases a satellite in the frame of its orbit, turned from where it points at the Earth."""
from collections.abc import Sequence
from typing import Any

from sympy import Expr, ImmutableMatrix

from ...algebra.text.numbers import exact_expression
from ...arguments import checked, several
from ...errors import ScopeError, ValuesError
from ..classical.attitude import elementary
from ..scenes.kind import Kind
from ..scenes.system import System
from .circular_orbit import axes_of, resting_at


@checked
def release(scene: System, angles: Sequence[Any], pointing: Sequence[int] = (1, 2, 3)) -> tuple[Expr, ...]:
    """Return the state of a satellite that is turned by some angles and at rest in the frame of its orbit.

    Parameters
    ----------
    scene : System
        of assemble(body, circular_orbit())
    angles : sequence of three numbers, texts or Expr
        roll, pitch and yaw [rad], or "5 deg": from the axes t, n, r of the orbit the body is turned by yaw
        about r, then by pitch about its axis of pitch, then by roll about its axis of roll
    pointing : sequence of three int
        the body axes along t, n and r if the angles are 0, as for earth_pointing

    Returns
    -------
    tuple of Expr
        π = ω0 I n, n, r, shape (9,), for motion

    Raises
    ------
    ScopeError
        the scene is in no orbit
    ValuesError
        there are not three angles
    EquilibriumError
        the axes are not three

    References
    ----------
    The 3-2-1 sequence: Hughes, Spacecraft Attitude Dynamics (1986), chapter 2.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((60, 70, 35), (0, 0, 0))
    >>> scene = gs.assemble(body, gs.circular_orbit(1))
    >>> gs.release(scene, ("90 deg", 0, 0))
    (0, 0, -35, 0, 0, -1, 0, 1, 0)
    """
    if scene.kind is not Kind.ORBIT:
        raise ScopeError("release is for a satellite in orbit, and this scene is in none: use "
                         "assemble(body, circular_orbit())")
    if len(angles) != 3:
        raise ValuesError(f"{len(angles)} angles are given: give those of roll, pitch and yaw")
    names = "angle of roll", "angle of pitch", "angle of yaw"
    roll, pitch, yaw = (exact_expression(x, name) for x, name in zip(angles, names))
    axes = ImmutableMatrix(axes_of(*several(pointing, "pointing", 3)))
    turned = elementary("z", yaw) * elementary("y", pitch) * elementary("x", roll) * axes
    return resting_at(scene, turned.row(1).T, turned.row(2).T)
