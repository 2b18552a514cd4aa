"""Lie-Poisson gyrostat stability analyser: from the bracket to the stability inequalities.

A scene is a body and a field, `assemble`d into a Lie-Poisson system; its equilibria (`upright`, `hanging`,
`inclined`, …, or all by `relative_equilibria`) are analysed (`analyze`) into conditions and verdicts, and
those solved for parameters (`stabilizing_set`). Beyond that: `gyrostat.charts`, verdicts over ranges of
parameters; `gyrostat.trajectories`, motions; `gyrostat.mechanics`, the classical formulas;
`gyrostat.plotting`, pictures; `gyrostat.published`, printed formulas checked. What these need is loaded when
they are used.
"""
from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import errors
from .algebra.precision import own_precision
from .cli import start as _start  # noqa: F401 (what Ctrl-C does while the rest is loaded)
from .mechanics.body import Gyrostat, symmetric_gyrostat
from .mechanics.claimed import equilibrium
from .mechanics.equilibria import Equilibrium
from .mechanics.fields import ideal_fluid, newtonian_field, uniform_field
from .mechanics.liepoisson import LiePoisson, lie_poisson
from .mechanics.orbit import orbit_tangent, symplectic_slice
from .mechanics.potential import Potential
from .mechanics.potentials import axial_potential, general_potential
from .mechanics.principal import principal_rotation
from .mechanics.reduction import reduce
from .mechanics.system import System, assemble
from .mechanics.tilted import inclined, static_tilt
from .mechanics.vertical import hanging, upright
from .notation import NOTATION, Shown, symbol
from .stability.analysis import analyze
from .stability.conditions import Condition, Criterion, formal_criterion, independent, spectral_criterion
from .stability.energy_casimir import SecondVariation, augmented_hessian, multipliers, second_variation
from .stability.linearization import Linearization, linearize
from .stability.report import Decision, Report, Verdict
from .version import __version__

if TYPE_CHECKING:
    from . import charts, mechanics, plotting, published, trajectories
    from .printing.article import to_latex
    from .stability.bifurcations import Bifurcation, bifurcations
    from .stability.branch import Branch
    from .stability.continuation import Continuation, continuation
    from .stability.meetings import BifurcationPoint, bifurcation_points
    from .stability.permanent_rotations import PermanentRotation
    from .stability.relative_equilibria import relative_equilibria
    from .stability.sets import Case, Interval, Solution, SolvedCondition
    from .stability.solve import solve_condition
    from .stability.spectra import Spectrum, spectrum
    from .stability.stabilizing import stabilizing_set

# loaded when something is shown
Shown.formula = lambda shown: import_module("gyrostat.printing.latex").formula(shown)
Shown.plain = lambda shown: import_module("gyrostat.printing.text").plain(shown)

_NAMESPACES = ("charts", "mechanics", "plotting", "published", "trajectories")
_LATER = {
    "Branch": "stability.branch", "relative_equilibria": "stability.relative_equilibria",
    "Bifurcation": "stability.bifurcations", "bifurcations": "stability.bifurcations",
    "BifurcationPoint": "stability.meetings", "bifurcation_points": "stability.meetings",
    "Continuation": "stability.continuation", "continuation": "stability.continuation",
    "Spectrum": "stability.spectra", "spectrum": "stability.spectra", "Solution": "stability.sets",
    "SolvedCondition": "stability.sets", "Case": "stability.sets", "Interval": "stability.sets",
    "PermanentRotation": "stability.permanent_rotations", "solve_condition": "stability.solve",
    "stabilizing_set": "stability.stabilizing", "to_latex": "printing.article",
}

__all__ = [
    "__version__", "analyze", "assemble", "augmented_hessian", "axial_potential", "Bifurcation",
    "bifurcation_points", "BifurcationPoint", "bifurcations", "Branch", "Case", "charts", "Condition",
    "Continuation", "continuation", "Criterion", "Decision", "Equilibrium", "equilibrium", "errors",
    "formal_criterion", "general_potential", "Gyrostat", "hanging", "ideal_fluid", "inclined",
    "independent", "Interval", "lie_poisson", "LiePoisson", "Linearization", "linearize", "mechanics",
    "multipliers", "newtonian_field", "NOTATION", "orbit_tangent", "own_precision", "PermanentRotation",
    "plotting", "Potential", "principal_rotation", "published", "reduce", "relative_equilibria", "Report",
    "second_variation", "SecondVariation", "Solution", "SolvedCondition", "solve_condition",
    "spectral_criterion", "Spectrum", "spectrum", "stabilizing_set", "static_tilt", "symbol",
    "symmetric_gyrostat", "symplectic_slice", "System", "to_latex", "trajectories", "uniform_field",
    "upright", "Verdict",
]


def __getattr__(name: str) -> Any:
    """What is loaded when it is used for the first time."""
    if name in _NAMESPACES:
        return import_module(f".{name}", __name__)
    if name in _LATER:
        return getattr(import_module(f".{_LATER[name]}", __name__), name)
    raise AttributeError(f"gyrostat has no {name}: dir(gyrostat) lists what there is")


def __dir__() -> list[str]:
    return __all__
