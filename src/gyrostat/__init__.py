"""Lie-Poisson gyrostat stability analyser: from the bracket to the stability inequalities."""
from importlib import import_module

from .cli import start as _start  # noqa: F401 (what Ctrl-C does while the rest is loaded)
from .mechanics.body import Gyrostat, symmetric_gyrostat
from .mechanics.equilibria import Equilibrium, equilibrium
from .mechanics.families import hanging, inclined, principal_rotation, static_tilt, upright
from .mechanics.fields import ideal_fluid, newtonian_field, uniform_field
from .mechanics.liepoisson import LiePoisson, lie_poisson
from .mechanics.orbit import orbit_tangent, symplectic_slice
from .mechanics.potential import Potential, axial_potential, general_potential
from .mechanics.system import System, assemble
from .notation import Shown, symbol
from .stability.conditions import Condition, Criterion, formal_criterion, independent, spectral_criterion
from .stability.energy_casimir import SecondVariation, augmented_hessian, multipliers, second_variation
from .stability.linearization import Linearization, linearize
from .stability.report import Decision, Report, Verdict, analyze
from .version import __version__

Shown.formula = lambda shown: import_module("gyrostat.printing.latex").formula(shown)       # loaded when something is shown
Shown.plain = lambda shown: import_module("gyrostat.printing.unicode").plain(shown)
__all__ = [
    "__version__",
    "analyze", "assemble", "augmented_hessian", "axial_potential", "Condition", "Criterion",
    "Decision", "Equilibrium", "equilibrium", "formal_criterion", "general_potential", "Gyrostat",
    "hanging", "ideal_fluid", "inclined", "independent", "lie_poisson", "LiePoisson", "Linearization",
    "linearize", "multipliers", "newtonian_field", "orbit_tangent", "Potential", "principal_rotation",
    "Report", "second_variation", "SecondVariation", "spectral_criterion", "static_tilt", "symbol",
    "symmetric_gyrostat", "symplectic_slice", "System", "uniform_field", "upright", "Verdict",
]
