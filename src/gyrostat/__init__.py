"""Lie-Poisson gyrostat stability analyser: from the bracket to the stability inequalities."""
from .body import Gyrostat, symmetric_gyrostat
from .conditions import Condition, Criterion, formal_criterion, independent, spectral_criterion
from .energy_casimir import SecondVariation, augmented_hessian, multipliers, second_variation
from .equilibria import Equilibrium, equilibrium, hanging, inclined, principal_rotation, static_tilt, upright
from .liepoisson import LiePoisson, lie_poisson
from .linearization import Linearization, linearize
from .notation import symbol
from .orbit import orbit_tangent, symplectic_slice
from .potential import Potential, axial_potential, general_potential, newtonian_field, uniform_field
from .system import System, assemble
from .stability import Decision, Report, Verdict, analyze
