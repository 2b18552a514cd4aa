"""The steps from an equilibrium to its conditions, each by itself; `analyze` takes them all.

The bracket gives the tangent space of the coadjoint orbit (`orbit_tangent`), on which the field is linearised
(`linearize`): its eigenvalues are the `spectral_criterion`, which is necessary. The symplectic slice
(`symplectic_slice`) is what is left of the tangent space if the integrals are fixed and their flows are
divided out. The Hamiltonian with the Casimirs (`multipliers`) has a Hessian (`augmented_hessian`); on the
slice it is the `second_variation`, and that it is definite is the `formal_criterion`, which is sufficient.
Without the integrals, which damping does not keep, it is the `secular_variation`, with the
`secular_criterion`; a dual spinner with dampers has the `energy_sink_criterion`. A criterion is reduced to
`independent` conditions. What is computed in balls has its own precision (`own_precision`).
"""
from .algebra.enclosures.precision import own_precision
from .mechanics.equilibrium.coadjoint_orbit import orbit_tangent, symplectic_slice
from .stability.criteria.conditions import independent
from .stability.criteria.energy_casimir import (
    SecondVariation,
    augmented_hessian,
    multipliers,
    second_variation,
    secular_variation,
)
from .stability.criteria.linearization import Linearization, linearize
from .stability.criteria.three_criteria import formal_criterion, secular_criterion, spectral_criterion
from .stability.damping.energy_sink import energy_sink_criterion

__all__ = ["augmented_hessian", "energy_sink_criterion", "formal_criterion", "independent", "Linearization",
           "linearize", "multipliers", "orbit_tangent", "own_precision", "second_variation",
           "SecondVariation", "secular_criterion", "secular_variation", "spectral_criterion",
           "symplectic_slice"]
