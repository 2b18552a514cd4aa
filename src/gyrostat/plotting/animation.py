"""Animates the turning body along an exact motion, and writes the animation to a file."""
from errno import EIO
from functools import partial
from os import PathLike
from pathlib import Path
from subprocess import CalledProcessError
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array, row
from ..arguments import checked
from ..errors import ArgumentError, MissingExtraError, ValuesError, article, brief, optional
from ..printing.files import written
from ..trajectories import Motion
from .globe import FADED, parted, polygons, stage
from .headings import heading, of_motion
from .legends import legend, named
from .looks import BLUE, DARK, axes_of, label
from .nutation import WIDEST, close_enough, widest
from .solids import rigid, solid

FINE, FINEST = 8, 1024                                     # points of the path to a step
NO_BODY = "no rigid body has these moments of inertia"


@checked
def animate_top(motion: Motion, times: Any, ax: Any = None, **kwargs: Any) -> Any:
    """The body at the given times, one picture for each, with the path of one of its axes on the unit sphere.

    Each has its time.

    A body of revolution in a field is a top on its tip, with the path of e3. Any other body is a box with its
    moments of inertia, with the path of the axis that is next to M, or to the vertical, at the first of the
    times. Where no rigid body has the moments there is no box, and it says so. Keep what is returned:
    Matplotlib does not.

    Parameters
    ----------
    motion : Motion
        of gyrostat.trajectories.motion
    times : array, shape (n,)
        evenly spaced, for even motion [T]
    ax : axes of mplot3d
        new ones where they are left out
    **kwargs : Any
        of matplotlib.animation.FuncAnimation, interval = 40 ms, say

    Returns
    -------
    matplotlib.animation.FuncAnimation
        of save_animation; .to_jshtml() shows it in a notebook

    Raises
    ------
    ArgumentError
        this is no motion, or the axes are flat
    ValuesError
        the times are so far apart that the path between them is lost
    MissingExtraError
        pip install "gyrostat[plot]"

    Examples
    --------
    >>> import gyrostat as gs
    >>> import numpy as np
    >>> import tempfile
    >>> from matplotlib.figure import Figure
    >>> box = gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, 0)))
    >>> thrown = gs.trajectories.motion(box, ("1/100", 2, 0))
    >>> ax = Figure(figsize=(2, 2)).add_subplot(projection="3d")
    >>> times = np.linspace(0, 60, 4)
    >>> animation = gs.plotting.animate_top(thrown, times, ax, interval=50)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     gs.plotting.save_animation(animation, f"{folder}/box.gif")
    """
    turns, path, fine, axis = attitudes(motion, times)
    ax = axes_of(ax, three=True)
    from matplotlib.animation import FuncAnimation
    eye, faces = stage(ax, 1.0, [label("x"), label("y"), label("z")]), solid(motion.scene)
    body = polygons(ax, [polygon for polygon, _ in faces], facecolors=[color for _, color in faces],
                    edgecolors=DARK, linewidths=0.3,
                    zorder=2)
    if not rigid(motion.scene.body):
        ax.text2D(0.5, 0.02, NO_BODY, ha="center", fontsize="small", transform=ax.transAxes)
    style = {"color": BLUE, "linewidth": 1.4}
    clock, form = ax.text2D(0.03, 0.97, "", va="top", transform=ax.transAxes), _form(times)
    legend(ax, [named(style, f"path of {label(f'e{axis + 1}')}")],
           title=partial(heading, *of_motion(motion)))
    (back,), (front,) = ax.plot([], [], [], alpha=FADED, zorder=1,
                                **style), ax.plot([], [], [], zorder=3, **style)

    def show(n: int) -> tuple[Any, ...]:
        body.set_verts([polygon @ turns[n].T for polygon, _ in faces])
        for line, part in zip((front, back), parted(path[:fine * n + 1], eye)):
            line.set_data_3d(*part.T)
        clock.set_text(f"$t = {times[n]:{form}}$")
        return body, front, back, clock

    return FuncAnimation(ax.figure, show, frames=len(turns), **{"interval": 40, **kwargs})


def _form(times: Any) -> str:
    """Return a format with so many decimals that two different times are two texts."""
    steps = np.abs(np.diff(np.asarray(times, dtype=float)))
    least = steps[steps > 0].min(initial=np.inf)
    return f".{int(np.clip(np.ceil(-np.log10(least)), 0, 12))}f" if np.isfinite(least) else "g"


def attitudes(motion: Motion, times: Any) -> tuple[Array, Array, int, int]:
    """The rotations from the body to space, shape (n, 3, 3), the path of the axis that is followed, its
    points to a step, and which axis it is.
    """
    times = row(times, "the times")
    turns = motion.attitude(times)
    top = motion.scene.potential is not None and motion.scene.body.is_of_revolution()
    steps, axis, fine = np.arange(len(turns)), 2 if top else int(np.abs(turns[0, 2]).argmax()), FINE
    while True:
        path = motion.attitude(np.interp(np.linspace(0, steps[-1], fine * steps[-1] + 1), steps,
                                         times))[..., axis]
        if fine >= FINEST or widest(path) <= WIDEST / 4:
            return turns, close_enough(path), fine, axis
        fine *= 2


@checked
def save_animation(animation: Any, path: str | PathLike[str], fps: int = 25) -> None:
    """Write an animation: a .gif by Pillow, or an .mp4 by ffmpeg, if that program is installed.

    Parameters
    ----------
    animation : matplotlib.animation.Animation
        of animate_top
    path : str or Path
        that ends in .gif or .mp4
    fps : int
        pictures a second

    Raises
    ------
    ArgumentError
        it is no animation
    ValuesError
        another kind of file, or no number of pictures a second
    MissingExtraError
        ffmpeg is not there
    OSError
        the file cannot be written; what was there is still there

    Examples
    --------
    >>> import gyrostat as gs
    >>> import tempfile
    >>> from matplotlib.figure import Figure
    >>> box = gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, 0)))
    >>> thrown = gs.trajectories.motion(box, ("1/100", 2, 0))
    >>> ax = Figure(figsize=(1, 1)).add_subplot(projection="3d")
    >>> animation = gs.plotting.animate_top(thrown, [0, 1], ax)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     gs.plotting.save_animation(animation, f"{folder}/box.gif")
    """
    optional("matplotlib", "plot")
    from matplotlib.animation import FFMpegWriter, PillowWriter
    kind = Path(path).suffix.lower()
    if kind not in (".gif", ".mp4"):
        raise ValuesError(f"{path} is to be a {kind or 'nameless'} file: animations are written as .gif, "
                          "or as .mp4")
    if kind == ".mp4" and not FFMpegWriter.isAvailable():
        raise MissingExtraError(f"{path} needs the program ffmpeg, which is not on the search path: "
                                "install it, or write a .gif")
    if not callable(getattr(animation, "save", None)):
        raise ArgumentError(f"the animation is {article(type(animation))}: give that of animate_top")
    if not 0 < fps <= 1000:
        raise ValuesError(f"fps = {brief(fps)}: give 1 to 1000 frames a second")
    with written(path) as new:
        try:
            animation.save(new, writer=PillowWriter(fps=fps) if kind == ".gif" else FFMpegWriter(fps=fps))
        except CalledProcessError as error:                # what ffmpeg says goes to its own output
            raise OSError(EIO, f"ffmpeg ended with status {error.returncode}, is the disk full?",
                          str(path)) from None
