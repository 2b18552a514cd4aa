"""Draws the attitudes in which a satellite rests, on the sphere of directions in its body."""
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..arguments import checked
from ..equilibria.doubles import nearest
from ..equilibria.finders.orbit import orbit_forms
from ..equilibria.relative_equilibrium import RelativeEquilibrium
from ..errors import ScopeError
from ..mechanics.scenes.kind import Kind
from ..mechanics.scenes.system import System
from ..stability.decision import Verdict
from .captions import BEHIND, headed
from .globe import circle, curve_on, dots_on, numbers_on, stage
from .headings import of_scene
from .legends import named
from .looks import GREY, axes_of, label, marker, meaning

LENGTH = 0.22                                              # of the line along n


@checked
def draw_attitudes(scene: System, values: Mapping[str, Any] | None = None, ax: Any = None,
                   **kwargs: Any) -> Any:
    """Draw every attitude in which a gyrostat satellite rests, by its vertical in the body.

    From a dot at r, as it is seen from the body, a line goes along n, the normal of the orbit, to a marker
    that shows the verdict. The number of the marker is that in the list of relative_equilibria, and in the
    table of gyrostat decide. The attitudes with −r are on the other side. What is behind is faded.

    Parameters
    ----------
    scene : System
        of assemble(body, circular_orbit())
    values : mapping of name to number
        of the names in the scene
    ax : axes of mplot3d
        new ones where they are left out
    **kwargs : Any
        of the markers: of Axes3D.plot

    Returns
    -------
    axes of mplot3d

    Raises
    ------
    ArgumentError
        no scene is given, or flat axes
    ScopeError
        the scene is in no orbit
    ValuesError
        a name has no number
    MissingExtraError
        pip install "gyrostat[plot]"

    Examples
    --------
    >>> import gyrostat as gs
    >>> from matplotlib.figure import Figure
    >>> body = gs.Gyrostat((1, "5/4", "8/5"), ("3/10", "1/5", "1/10"))
    >>> satellite = gs.assemble(body, gs.circular_orbit(1))
    >>> sphere = Figure().add_subplot(projection="3d")
    >>> ax = gs.plotting.draw_attitudes(satellite, ax=sphere)
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['stable', 'unstable', '$n$ from $r$']
    """
    if scene.kind is not Kind.ORBIT:
        raise ScopeError("attitudes are those of a satellite in orbit: assemble(body, circular_orbit())")
    found = [(form, RelativeEquilibrium(form).decision) for form in orbit_forms(scene, values or {})]
    ax = axes_of(ax, three=True)
    eye = stage(ax, 1.0, [label(f"r{i}") for i in (1, 2, 3)])
    for axis in np.eye(3):
        curve_on(ax, circle(axis, 1.0), eye, color=GREY, linewidth=0.5)
    looks: dict[Verdict, dict[str, Any]] = {}
    for verdict in Verdict:
        some = [form for form, decision in found if decision.verdict is verdict]
        if not some:
            continue
        looks[verdict] = {**marker(verdict), **kwargs}
        r, n = (np.array(list(map(nearest, parts))) for parts in (
            [form.r for form in some], [form.n for form in some]))
        ends = np.stack([r, r + LENGTH * n, np.full_like(r, np.nan)], axis=1).reshape(-1, 3)
        curve_on(ax, ends, eye, color=looks[verdict]["color"], linewidth=1.1)
        dots_on(ax, r, eye, color=GREY, marker=".", linestyle="none", markersize=4)
        dots_on(ax, r + LENGTH * n, eye, **looks[verdict])
    along = [np.array(nearest(form.n)) for form, _ in found]
    numbers_on(ax, [(n, np.array(nearest(form.r)) + LENGTH * way)
                    for n, ((form, _), way) in enumerate(zip(found, along), 1)], eye, ways=along,
               others=[np.array(nearest(form.r)) for form, _ in found])
    decisions = [decision for _, decision in found]
    headed(ax, "Attitudes in which a satellite rests, by the vertical $r$ and the normal $n$ of its orbit in "
           "the body", of_scene(scene, values or {}),
           [*(named(look, meaning(verdict, decisions)) for verdict, look in looks.items()),
            named({"color": GREY, "linewidth": 1.1}, f"{label('n')} from {label('r')}")], after=BEHIND)
    return ax
