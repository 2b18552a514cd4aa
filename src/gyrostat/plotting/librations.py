"""Draws roll, pitch and yaw of a satellite over its orbits."""
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array, row
from ..arguments import checked
from ..errors import ScopeError
from ..mechanics.families.circular_orbit import orbital_rate
from ..mechanics.scenes.kind import Kind
from ..trajectories import Motion, roll_pitch_yaw
from .captions import headed
from .headings import of_motion
from .legends import named
from .looks import BLUE, DARK, INK, axes_of

STYLES: dict[str, dict[str, Any]] = {"roll": {"color": DARK, "linestyle": (0, (4, 2))},
                                     "pitch": {"color": INK["undecided"], "linestyle": ":"},
                                     "yaw": {"color": BLUE, "linestyle": "-"}}
JUMP = 120                                             # degrees from one time to the next


@checked
def draw_librations(motion: Motion, times: Any, ax: Any = None, *, pointing: Sequence[int] = (1, 2, 3),
                    **kwargs: Any) -> Any:
    """Draw roll, pitch and yaw of a satellite, in degrees, over its orbits.

    A curve is broken where its angle jumps: at ±180°, and if pitch is ±90°.

    Parameters
    ----------
    motion : Motion
        of gyrostat.trajectories.motion, of a satellite in orbit
    times : array, shape (n,)
        increasing, close enough for a smooth curve [T]
    ax : axes
        new ones where they are left out
    pointing : sequence of three int
        the body axes along t, n and r where the angles are 0
    **kwargs : Any
        of the curves: of Axes.plot

    Returns
    -------
    axes

    Raises
    ------
    ArgumentError
        no motion is given, or axes of three dimensions
    ScopeError
        the motion is that of no satellite in orbit
    MissingExtraError
        pip install "gyrostat[plot]"

    Examples
    --------
    >>> import gyrostat as gs
    >>> import numpy as np
    >>> from matplotlib.figure import Figure
    >>> body = gs.Gyrostat((60, 70, 35), (0, 0, 0))
    >>> scene = gs.assemble(body, gs.circular_orbit(1))
    >>> moving = gs.trajectories.motion(scene, gs.release(scene, ("5 deg", 0, 0)))
    >>> ax = gs.plotting.draw_librations(
    ...     moving, np.linspace(0, 12, 100), Figure().subplots())
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['roll', 'pitch', 'yaw']
    >>> ax.get_xlabel(), ax.get_ylabel()
    ('orbits', 'angle [°]')
    """
    if motion.scene.kind is not Kind.ORBIT:
        raise ScopeError("librations are those of a satellite in orbit: assemble(body, circular_orbit())")
    times = row(times, "the times")
    ax = axes_of(ax)
    orbits = float(orbital_rate(motion.scene)) * times / (2 * np.pi)
    for values, style in zip(np.degrees(roll_pitch_yaw(motion.attitude(times), pointing)).T, STYLES.values()):
        ax.plot(*_broken(orbits, values), **{"linewidth": 1.3, **style, **kwargs})
    ax.set(xlabel="orbits", ylabel="angle [°]")
    ax.margins(x=0)
    headed(ax, "Roll, pitch and yaw of a satellite over its orbits", of_motion(motion),
           [named({**style, **kwargs}, name) for name, style in STYLES.items()])
    return ax


def _broken(x: Array, y: Array) -> tuple[Array, Array]:
    """Return a curve with a gap where its values jump: at ±180°, and if pitch is ±90°."""
    jumps = np.flatnonzero(abs(np.diff(y)) > JUMP) + 1
    return np.insert(x, jumps, np.nan), np.insert(y, jumps, np.nan)
