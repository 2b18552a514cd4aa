"""Rigid bodies with rotors in fields: what moves, and where it can stay.

A `body`, with its `rotors`, and a field (a `potential`, given as in `potentials`, with `hints` where it is
refused, named ones in `fields`; in two directions, or with a term linear in the momenta, `coupled`; of a
satellite, a `circular_orbit`, from which it is let go by `release`, with `orbital_precession` of a symmetric
one and `held_pointing` by a rotor; `vehicles` in a fluid are both at once) are a scene: the Lie-Poisson
bracket (`liepoisson`), which has every sign convention, and the Hamiltonian give the equations of motion
(`equations`) and the integrals (`system`; those given are proved in `integrals`, in names `of_body`).
`equilibria`, `claimed` ones too, are checked when they are built, and what is asked of them is derived
`once`; those with a name are `families`, each a `family` (`vertical`, `tilted`, `principal`,
`permanent_rotation`, about one of the `directions`; `steady` motions in two, which may be `parallel`),
`relations` tie the names in them. At each the coadjoint orbit has a tangent space, in it the symplectic slice
(`orbit`), all in one ring (`derivation`). A body of revolution has one degree of freedom (`reduction`),
expanded near an equilibrium (`reduced_series`), in fractional powers at a pole where U has them
(`near_pole`); which scene is one, about which axis, is proved (`spherical`, `recognition`, `standard`). A
tensor is turned into principal `axes`. Euler's angles are in `attitude`, the Lagrangian in them in
`lagrange`, the classical formulas in `freebody` and `precession`.
"""
from typing import TYPE_CHECKING

from .._lazy import later

if TYPE_CHECKING:
    from .classical.attitude import angle_rates, angular_velocity, rotation
    from .classical.free_body import momentum_limits, polhode_period, torque_equations
    from .classical.free_precession import FreePrecession, free_precession
    from .classical.lagrangian import angular_momentum, effective_potential, lagrangian, momenta
    from .equilibrium.reduced_series import expansion
    from .equilibrium.reduction import Reduction
    from .scenes.axes import principal_axes
    from .scenes.kind import Kind

__all__ = ["angle_rates", "angular_momentum", "angular_velocity",
           "effective_potential", "expansion", "free_precession", "FreePrecession", "Kind", "lagrangian",
           "momenta", "momentum_limits", "polhode_period", "principal_axes", "Reduction", "rotation",
           "torque_equations"]

__getattr__, __dir__ = later(__name__, {
    "classical.attitude": "angle_rates angular_velocity rotation",
    "scenes.axes": "principal_axes", "scenes.kind": "Kind",
    "classical.free_body": "momentum_limits polhode_period torque_equations",
    "classical.lagrangian": "angular_momentum effective_potential lagrangian momenta",
    "classical.free_precession": "FreePrecession free_precession", "equilibrium.reduced_series": "expansion",
    "equilibrium.reduction": "Reduction",
})
