"""Roll, pitch and yaw of a satellite against the frame of its orbit, by the 3-2-1 sequence."""
from collections.abc import Sequence

import numpy as np

from ..algebra.enclosures.floats import Array, doubles
from ..arguments import checked, several
from ..errors import ValuesError
from ..mechanics.families.circular_orbit import axes_of


@checked
def roll_pitch_yaw(turns: Array, pointing: Sequence[int] = (1, 2, 3)) -> Array:
    """Return the angles of a satellite against the axes t, n, r of its orbit.

    From those the body is turned by yaw about r, then by pitch about its axis of pitch, then by roll about
    its axis of roll. Pitch is between −π/2 and π/2; at both ends roll is 0.

    Parameters
    ----------
    turns : array, shape (..., 3, 3)
        Motion.attitude: from the body to the axes r, t, n
    pointing : sequence of three int
        the body axes along t, n and r if the angles are 0, as for earth_pointing; default (1, 2, 3)

    Returns
    -------
    array, shape (..., 3)
        roll, pitch and yaw [rad]

    Raises
    ------
    EquilibriumError
        the axes are not three
    ValuesError
        the rotations have another shape

    References
    ----------
    The 3-2-1 sequence: Hughes, Spacecraft Attitude Dynamics (1986), chapter 2.

    Examples
    --------
    >>> import gyrostat as gs
    >>> body = gs.Gyrostat((60, 70, 35), (0, 0, 0))
    >>> scene = gs.assemble(body, gs.circular_orbit(1))
    >>> released = gs.release(scene, ("5 deg", 0, 0))
    >>> moving = gs.trajectories.motion(scene, released)
    >>> turns = moving.attitude([0.0, 1.0])
    >>> gs.trajectories.roll_pitch_yaw(turns).round(4)
    array([[ 0.0873,  0.    ,  0.    ],
           [ 0.0062, -0.0018, -0.0209]])
    """
    if (found := doubles(turns, "the rotations")).shape[-2:] != (3, 3):
        raise ValuesError(f"the rotations have the shape {found.shape}: give (..., 3, 3)")
    turned = found[..., [1, 2, 0], :] @ np.array(axes_of(*several(pointing, "pointing", 3)), dtype=float).T
    across = np.hypot(turned[..., 2, 1], turned[..., 2, 2])
    roll = np.where(across == 0, 0.0, np.arctan2(turned[..., 2, 1], turned[..., 2, 2]))
    yaw = np.where(across == 0, np.arctan2(-turned[..., 0, 1], turned[..., 1, 1]),
                   np.arctan2(turned[..., 1, 0], turned[..., 0, 0]))
    return np.stack([roll, np.arctan2(-turned[..., 2, 0], across), yaw], axis=-1) + 0.0     # no −0
