"""Shows the turning body in a view that the reader turns: a figure of Plotly for a notebook or a page."""
from typing import Any

import numpy as np

from ..algebra.enclosures.floats import Array
from ..arguments import checked
from ..errors import optional
from ..trajectories import Motion
from .animation import attitudes
from .looks import BLUE
from .solids import Face, solid

TO_COME = "#dde3ea"                                        # of the path


@checked
def view_motion(motion: Motion, times: Any) -> Any:
    """Return the body at the given times as a figure of Plotly, with a slider.

    The path of one of its axes on the unit sphere is shown too, what is to come in a faint colour. Drag to
    turn it. The body is that of animate_top. It needs the extra interactive.

    Parameters
    ----------
    motion : Motion
        of gyrostat.trajectories.motion
    times : array, shape (n,)
        one frame for each; a hundred, say [T]

    Returns
    -------
    plotly.graph_objects.Figure
        shown by a notebook; .write_html("motion.html") makes a page of it, which holds the 5 MB of Plotly's
        own program, or, with include_plotlyjs="cdn", fetches them

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
    >>> box = gs.assemble(gs.Gyrostat((1, 2, "5/2"), (0, 0, 0)))
    >>> thrown = gs.trajectories.motion(box, ("1/100", 2, 0))
    >>> figure = gs.plotting.view_motion(thrown, [0, 1, 2])  # doctest: +SKIP
    """
    go = optional("plotly.graph_objects", "interactive")
    turns, path, fine, _ = attitudes(motion, times)
    corners, triangles, colors = _triangles(solid(motion.scene))
    frames = [go.Frame(name=f"{t:.4g}", traces=[1, 2], data=[
        go.Mesh3d(**_xyz(corners @ R.T)), go.Scatter3d(line=_come_to(fine * n, len(path)))])
              for n, (t, R) in enumerate(zip(times, turns))]
    figure = go.Figure(data=[_sphere(go), _body(go, corners @ turns[0].T, triangles, colors),
                             _path(go, path)], frames=frames)
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


def _triangles(faces: list[Face]) -> tuple[Array, Array, list[str]]:
    """Return the corners, each once, the faces as triangles with one common corner, and their colours."""
    every = np.concatenate([polygon for polygon, _ in faces]).round(9)
    corners, places = np.unique(every, axis=0, return_inverse=True)
    firsts = np.cumsum([0] + [len(polygon) for polygon, _ in faces])
    triangles = np.array([(first, first + n, first + n + 1)
                          for first, (polygon, _) in zip(firsts, faces) for n in range(1, len(polygon) - 1)])
    colors = [color for polygon, color in faces for _ in range(len(polygon) - 2)]
    return corners, places.ravel()[triangles], colors


def _xyz(points: Array) -> dict[str, Array]:
    """Coordinates for Plotly, which are written as they are: four digits are less than a pixel."""
    return dict(zip("xyz", np.round(points.T, 4).astype(np.float32)))


def _body(go: Any, corners: Array, triangles: Array, colors: list[str]) -> Any:
    return go.Mesh3d(**_xyz(corners), **dict(zip("ijk", triangles.T)), facecolor=colors, flatshading=True,
                     hoverinfo="skip")


def _path(go: Any, path: Array) -> Any:
    """The path, once; how far it has come is told by the range of its colours."""
    return go.Scatter3d(**_xyz(path), mode="lines", hoverinfo="skip", line={
        "color": np.arange(len(path), dtype=np.float32), "width": 5, **_come_to(0, len(path)),
        "colorscale": [[0, BLUE], [0.5, BLUE], [0.5, TO_COME], [1, TO_COME]]})


def _come_to(place: int, length: int) -> dict[str, float]:
    """The range of colours in whose middle, where they change, the path has come to."""
    return {"cmin": place + 0.5 - length, "cmax": place + 0.5 + length}


def _sphere(go: Any) -> Any:
    height, turn = np.meshgrid(np.linspace(-1, 1, 41), np.linspace(0, 2 * np.pi, 61))
    wide = np.sqrt(1 - height**2)
    points = np.stack([wide * np.cos(turn), wide * np.sin(turn), height])
    return go.Surface(**dict(zip("xyz", np.round(points, 4).astype(np.float32))), opacity=0.15,
                      showscale=False, colorscale=[[0, "#9fb4c9"], [1, "#9fb4c9"]], hoverinfo="skip")
