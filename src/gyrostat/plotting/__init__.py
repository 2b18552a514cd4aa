"""Pictures: each function draws on Matplotlib axes and returns them.

Stable, unstable and undecided look the same in all of them (`looks`), and above each is what it is of
(`headings`); `paper.mplstyle` is a style for print. Each has its file: `momentum_sphere` (its curves:
`energy_levels`), `nutation` and `cones` on a `globe`, `effective_potential`, `bifurcations`, `rotor_set`,
`staude_cone` and `staude_plane` (`along_arcs`), `amended_potential`, `energy_momentum`, `eigenvalues`,
`charts`, `librations` of a satellite, its `attitudes` and its `smelt_plane`; motions of `solids` as an
`animation` or `interactive`; exact `numbers` become floats in one place.
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
