"""Draws pictures: each function draws on Matplotlib axes and returns them.

Each picture has a module. Free bodies have the `momentum_sphere` (its curves: `energy_levels`), the `cones`
and the `rotor_set`. A top has its `nutation`, its `effective_potential` and the diagram of `energy_momentum`.
Any body in a field has the `staude_cone` and the `staude_plane` (both from `along_arcs`) and the
`amended_potential`. Satellites have `attitudes`, `librations` and the `smelt_plane`. A stable motion has its
`filled_well`: a `basin` on a sphere, or a `well_of_tilts`. There are `bifurcations` and `eigenvalues` along
one parameter, and `charts` over two (their `cells` and `chart_curves`). A body of `solids` turns in an
`animation`, or the reader turns it (`interactive`). Verdicts have the same `looks`. `headings` say what is
drawn, `legends` what the looks mean, if there is no room `beside` the marks, and `captions` both for a paper.
Marks that nearly coincide are `nested`. A `globe` is a sphere seen from one side, `scene_numbers` makes exact
numbers of the values, and `paper.mplstyle` is a style for print.
"""
from typing import TYPE_CHECKING

from .._lazy import later as _later

if TYPE_CHECKING:
    from .amended_potential import draw_amended_potential
    from .animation import animate_top, save_animation
    from .attitudes import draw_attitudes
    from .bifurcations import draw_bifurcation_diagram
    from .captions import caption
    from .charts import draw_chart
    from .cones import draw_cones
    from .effective_potential import draw_effective_potential
    from .eigenvalues import draw_eigenvalues
    from .energy_momentum import draw_energy_momentum
    from .filled_well import draw_well
    from .interactive import view_motion
    from .librations import draw_librations
    from .momentum_sphere import draw_momentum_sphere
    from .nutation import draw_nutation
    from .rotor_set import draw_rotor_set
    from .smelt_plane import draw_smelt_plane
    from .staude_cone import draw_staude_cone
    from .staude_plane import draw_staude_plane

__all__ = ["animate_top", "caption", "draw_amended_potential", "draw_attitudes", "draw_bifurcation_diagram",
           "draw_chart", "draw_cones", "draw_effective_potential", "draw_eigenvalues",
           "draw_energy_momentum", "draw_librations", "draw_momentum_sphere", "draw_nutation",
           "draw_rotor_set", "draw_smelt_plane", "draw_staude_cone", "draw_staude_plane", "draw_well",
           "save_animation", "view_motion"]

__getattr__, __dir__ = _later(__name__, {
    "amended_potential": "draw_amended_potential", "animation": "animate_top save_animation",
    "attitudes": "draw_attitudes", "bifurcations": "draw_bifurcation_diagram", "captions": "caption",
    "charts": "draw_chart", "cones": "draw_cones", "effective_potential": "draw_effective_potential",
    "eigenvalues": "draw_eigenvalues", "energy_momentum": "draw_energy_momentum",
    "filled_well": "draw_well", "interactive": "view_motion", "librations": "draw_librations",
    "momentum_sphere": "draw_momentum_sphere", "nutation": "draw_nutation", "rotor_set": "draw_rotor_set",
    "smelt_plane": "draw_smelt_plane", "staude_cone": "draw_staude_cone",
    "staude_plane": "draw_staude_plane",
})
