"""Pictures: each function draws on Matplotlib axes and returns them.

Each picture has a file: of a free body `momentum_sphere` (its curves: `energy_levels`), `cones` and
`rotor_set`; of a top `nutation`, `effective_potential` and `energy_momentum`; of any body in a field
`staude_cone` and `staude_plane` (`along_arcs`) and `amended_potential`; of a satellite `attitudes`,
`librations` and the `smelt_plane`. Along a parameter there are `bifurcations` and `eigenvalues`, over ranges
of two `charts` (`chart_curves`). A body of `solids` turns in an `animation`, or is turned by the reader
(`interactive`). Verdicts look the same in all of them (`looks`); `headings` say what is drawn, a `globe` is a
sphere seen from one side, `scene_numbers` makes floats of exact numbers, `paper.mplstyle` is a style for
print.
"""
from .amended_potential import draw_amended_potential
from .animation import animate_top, save_animation
from .attitudes import draw_attitudes
from .bifurcations import draw_bifurcation_diagram
from .charts import caption, draw_chart
from .cones import draw_cones
from .effective_potential import draw_effective_potential
from .eigenvalues import draw_eigenvalues
from .energy_momentum import draw_energy_momentum
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
           "draw_rotor_set", "draw_smelt_plane", "draw_staude_cone", "draw_staude_plane", "save_animation",
           "view_motion"]
