"""Rigid bodies with rotors in fields: what moves, and where it can stay.

A body and its field become a Lie-Poisson system with its equations of motion and its integrals (`scenes`). An
`equilibrium` is a point, or a family of points, that is checked to satisfy them; its coadjoint orbit has a
tangent space, and in it the symplectic slice. `families` makes the equilibria that have names: E1, E2, E3,
permanent rotations, satellites at rest in their orbit. `classical` has what textbooks derive beside this:
Euler's angles, the Lagrangian, free bodies and their precession.
"""
from typing import TYPE_CHECKING

from .._lazy import later

if TYPE_CHECKING:
    from .classical.attitude import angle_rates, angular_velocity, rotation
    from .classical.free_body import momentum_limits, polhode_period, torque_equations
    from .classical.free_precession import FreePrecession, free_precession
    from .classical.lagrangian import angular_momentum, effective_potential, lagrangian, momenta
    from .equilibrium.reduced_series import expansion
    from .equilibrium.reduction import Reduction, reduce
    from .scenes.kind import Kind
    from .scenes.principal_axes import principal_axes

__all__ = ["angle_rates", "angular_momentum", "angular_velocity",
           "effective_potential", "expansion", "free_precession", "FreePrecession", "Kind", "lagrangian",
           "momenta", "momentum_limits", "polhode_period", "principal_axes", "reduce", "Reduction",
           "rotation", "torque_equations"]

__getattr__, __dir__ = later(__name__, {
    "classical.attitude": "angle_rates angular_velocity rotation",
    "scenes.principal_axes": "principal_axes", "scenes.kind": "Kind",
    "classical.free_body": "momentum_limits polhode_period torque_equations",
    "classical.lagrangian": "angular_momentum effective_potential lagrangian momenta",
    "classical.free_precession": "FreePrecession free_precession", "equilibrium.reduced_series": "expansion",
    "equilibrium.reduction": "Reduction reduce",
})
