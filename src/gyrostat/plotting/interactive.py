"""The body turning, in a view that the reader turns: a figure of Plotly for a notebook or a page."""
from typing import Any

import numpy as np

from ..algebra.floats import Array
from ..errors import optional
from ..trajectories import Motion
from .animation import attitudes
from .looks import BLUE
from .solids import Face, solid


def view_motion(motion: Motion, times: Any) -> Any:
    """The body at the given times as a figure of Plotly, with a slider.

    The path of one of its axes on the unit sphere is shown too. Drag to turn it. The body is that of
    animate_top. It needs the extra interactive.

    Parameters
    ----------
    motion : Motion
        of gyrostat.trajectories.motion
    times : array, shape (n,)
        one frame for each; a hundred, say [T]

    Returns
    -------
    plotly.graph_objects.Figure
        shown by a notebook; .write_html("motion.html") makes a page of it

    Raises
    ------
    ArgumentError
        this is no motion
    ValuesError
        the times are so far apart that the path between them is lost
    MissingExtraError
        pip install "gyrostat[interactive]"

    Examples
    --------
    >>> import gyrostat as gs
    >>> box = gs.trajectories.motion(gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, 0))), ("1/100", 2, 0))
    >>> figure = gs.plotting.view_motion(box, [0, 1, 2])  # doctest: +SKIP
    """
    go = optional("plotly.graph_objects", "interactive")
    turns, path, fine = attitudes(motion, times)
    faces = solid(motion.scene)
    frames = [go.Frame(name=f"{t:.4g}", data=[_body(go, faces, R), _path(go, path[:fine * n + 1])],
                       traces=[1, 2])
              for n, (t, R) in enumerate(zip(times, turns))]
    figure = go.Figure(data=[_sphere(go), *frames[0].data], frames=frames)
    still: dict[str, Any] = {"visible": False, "range": [-1.1, 1.1]}
    at_once = {"mode": "immediate", "frame": {"duration": 0, "redraw": True}, "transition": {"duration": 0}}
    running = {"fromcurrent": True, "frame": {"duration": 40, "redraw": True}, "transition": {"duration": 0}}
    figure.update_layout(
        scene={"xaxis": still, "yaxis": still, "zaxis": still, "aspectmode": "cube"}, showlegend=False,
        margin=dict.fromkeys("lrtb", 0),
        updatemenus=[{"type": "buttons", "y": 0, "x": 0, "buttons": [
            {"label": "play", "method": "animate", "args": [None, running]},
            {"label": "stop", "method": "animate", "args": [[None], at_once]}]}],
        sliders=[{"x": 0.12, "len": 0.85, "currentvalue": {"prefix": "t = "}, "steps": [
            {"label": frame.name, "method": "animate", "args": [[frame.name], at_once]}
            for frame in frames]}])
    return figure


def _body(go: Any, faces: list[Face], R: Array) -> Any:
    """The faces as triangles that share their first corner."""
    corners = np.concatenate([polygon @ R.T for polygon, _ in faces])
    firsts = np.cumsum([0] + [len(polygon) for polygon, _ in faces])
    triangles = np.array([(first, first + n, first + n + 1)
                          for first, (polygon, _) in zip(firsts, faces) for n in range(1, len(polygon) - 1)])
    colors = [color for polygon, color in faces for _ in range(len(polygon) - 2)]
    return go.Mesh3d(**dict(zip("xyz", corners.T)), **dict(zip("ijk", triangles.T)), facecolor=colors,
                     flatshading=True, hoverinfo="skip")


def _path(go: Any, path: Array) -> Any:
    return go.Scatter3d(**dict(zip("xyz", path.T)), mode="lines", line={"color": BLUE, "width": 5},
                        hoverinfo="skip")


def _sphere(go: Any) -> Any:
    height, turn = np.meshgrid(np.linspace(-1, 1, 41), np.linspace(0, 2 * np.pi, 61))
    wide = np.sqrt(1 - height**2)
    return go.Surface(x=wide * np.cos(turn), y=wide * np.sin(turn), z=height, opacity=0.15, showscale=False,
                      colorscale=[[0, "#9fb4c9"], [1, "#9fb4c9"]], hoverinfo="skip")
