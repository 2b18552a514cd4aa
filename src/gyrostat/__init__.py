"""Lie-Poisson gyrostat stability analyser: from the bracket to the stability inequalities.

A scene is a body and a field, `assemble`d into a Lie-Poisson system; its equilibria (`upright`, `hanging`,
`inclined`, …, or all by `relative_equilibria`) are analysed (`analyze`) into conditions and verdicts, and
those solved for parameters (`stabilizing_set`). Beyond that: `gyrostat.charts`, verdicts over ranges of
parameters; `gyrostat.trajectories`, motions; `gyrostat.mechanics`, the classical formulas;
`gyrostat.plotting`, pictures; `gyrostat.published`, printed formulas checked. What these need is loaded when
they are used.
"""
from importlib import import_module
from typing import TYPE_CHECKING

from . import errors
from .cli import start as _start  # noqa: F401 (what Ctrl-C does while the rest is loaded)
from .later import later as _later
from .shown import Shown as _Shown
from .version import __version__

if TYPE_CHECKING:
    from . import charts, mechanics, plotting, published, trajectories
    from .algebra.precision import own_precision
    from .mechanics.body import Gyrostat, symmetric_gyrostat
    from .mechanics.circular_orbit import circular_orbit, earth_pointing
    from .mechanics.claimed import equilibrium
    from .mechanics.coupled import CoupledPotential, coupled_potential
    from .mechanics.directions import stereographic
    from .mechanics.equilibria import Equilibrium
    from .mechanics.fields import ideal_fluid, newtonian_field, uniform_field
    from .mechanics.held_pointing import earth_pointing_gyrostat
    from .mechanics.liepoisson import LiePoisson, lie_poisson
    from .mechanics.orbit import orbit_tangent, symplectic_slice
    from .mechanics.orbital_precession import orbital_precession
    from .mechanics.parallel import parallel_directions
    from .mechanics.permanent_rotation import permanent_rotation
    from .mechanics.potential import Potential
    from .mechanics.potentials import axial_potential, general_potential
    from .mechanics.principal import principal_rotation
    from .mechanics.reduction import reduce
    from .mechanics.release import release
    from .mechanics.rotors import Rotor, gyrostat_with_rotors
    from .mechanics.steady import steady_motion
    from .mechanics.system import System, assemble
    from .mechanics.tilted import inclined, static_tilt
    from .mechanics.vehicles import underwater_vehicle
    from .mechanics.vertical import hanging, upright
    from .notation import NOTATION, symbol
    from .printing.article import to_latex
    from .stability.amended_potential import AmendedPotential, CriticalPoint, amended_potential
    from .stability.analysis import analyze
    from .stability.bifurcations import Bifurcation, bifurcations
    from .stability.branch import Branch
    from .stability.conditions import Condition, Criterion, independent
    from .stability.continuation import Continuation, continuation
    from .stability.criteria import formal_criterion, secular_criterion, spectral_criterion
    from .stability.decision import Decision, Rung, Verdict
    from .stability.energy_casimir import (
        SecondVariation,
        augmented_hessian,
        multipliers,
        second_variation,
        secular_variation,
    )
    from .stability.energy_sink import energy_sink_criterion
    from .stability.followed_heavy import HeavyContinuation
    from .stability.followed_rotations import RotationContinuation
    from .stability.free_rotation import PermanentRotation
    from .stability.gyrostat_arcs import GyrostatArc
    from .stability.heavy_rotation import HeavyRotation
    from .stability.linearization import Linearization, linearize
    from .stability.meetings import BifurcationPoint, bifurcation_points
    from .stability.normal_form import NormalForm
    from .stability.orbital_equilibrium import OrbitalEquilibrium
    from .stability.relative_equilibria import relative_equilibria
    from .stability.report import Report
    from .stability.sets import Case, Interval, Solution, SolvedCondition
    from .stability.solve import solve_condition
    from .stability.spectra import Spectrum, spectrum
    from .stability.stabilizing import stabilizing_set
    from .stability.staude import StaudeCone, staude_cone
    from .stability.staude_arcs import StaudeArc
    from .stability.window_families import Window

# loaded when something is shown
_Shown.formula = lambda shown: import_module("gyrostat.printing.latex").formula(shown)
_Shown.plain = lambda shown: import_module("gyrostat.printing.text").plain(shown)

__all__ = [
    "__version__", "amended_potential", "AmendedPotential", "analyze", "assemble", "augmented_hessian",
    "axial_potential", "Bifurcation", "bifurcation_points", "BifurcationPoint", "bifurcations", "Branch",
    "Case", "charts", "circular_orbit", "Condition", "Continuation", "continuation", "coupled_potential",
    "CoupledPotential", "Criterion", "CriticalPoint", "Decision", "earth_pointing",
    "earth_pointing_gyrostat", "energy_sink_criterion", "Equilibrium", "equilibrium", "errors",
    "formal_criterion", "general_potential", "Gyrostat", "gyrostat_with_rotors", "GyrostatArc", "hanging",
    "HeavyContinuation", "HeavyRotation", "ideal_fluid", "inclined", "independent", "Interval",
    "lie_poisson", "LiePoisson", "Linearization", "linearize", "mechanics", "multipliers", "newtonian_field",
    "NormalForm", "NOTATION", "orbit_tangent", "orbital_precession", "OrbitalEquilibrium", "own_precision",
    "parallel_directions", "permanent_rotation", "PermanentRotation", "plotting", "Potential",
    "principal_rotation", "published", "reduce", "relative_equilibria", "release", "Report",
    "RotationContinuation", "Rotor", "Rung", "second_variation", "SecondVariation", "secular_criterion",
    "secular_variation", "Solution", "solve_condition", "SolvedCondition", "spectral_criterion", "Spectrum",
    "spectrum", "stabilizing_set", "static_tilt", "staude_cone", "StaudeArc", "StaudeCone", "steady_motion",
    "stereographic", "symbol", "symmetric_gyrostat", "symplectic_slice", "System", "to_latex",
    "trajectories", "underwater_vehicle", "uniform_field", "upright", "Verdict", "Window",
]

__getattr__, __dir__ = _later(__name__, {
    "charts": "", "mechanics": "", "plotting": "", "published": "", "trajectories": "",
    "algebra.precision": "own_precision", "mechanics.body": "Gyrostat symmetric_gyrostat",
    "mechanics.circular_orbit": "circular_orbit earth_pointing",
    "mechanics.release": "release",
    "mechanics.claimed": "equilibrium", "mechanics.coupled": "CoupledPotential coupled_potential",
    "mechanics.directions": "stereographic",
    "mechanics.equilibria": "Equilibrium",
    "mechanics.fields": "ideal_fluid newtonian_field uniform_field",
    "mechanics.held_pointing": "earth_pointing_gyrostat",
    "mechanics.liepoisson": "LiePoisson lie_poisson", "mechanics.orbit": "orbit_tangent symplectic_slice",
    "mechanics.orbital_precession": "orbital_precession",
    "mechanics.parallel": "parallel_directions",
    "mechanics.permanent_rotation": "permanent_rotation", "mechanics.potential": "Potential",
    "mechanics.potentials": "axial_potential general_potential",
    "mechanics.principal": "principal_rotation", "mechanics.reduction": "reduce",
    "mechanics.rotors": "Rotor gyrostat_with_rotors", "mechanics.steady": "steady_motion",
    "mechanics.system": "System assemble",
    "mechanics.tilted": "inclined static_tilt", "mechanics.vehicles": "underwater_vehicle",
    "mechanics.vertical": "hanging upright",
    "notation": "NOTATION symbol", "printing.article": "to_latex",
    "stability.amended_potential": "amended_potential AmendedPotential CriticalPoint",
    "stability.analysis": "analyze", "stability.bifurcations": "Bifurcation bifurcations",
    "stability.branch": "Branch",
    "stability.conditions": "Condition Criterion independent",
    "stability.criteria": "formal_criterion secular_criterion spectral_criterion",
    "stability.continuation": "Continuation continuation",
    "stability.followed_heavy": "HeavyContinuation",
    "stability.followed_rotations": "RotationContinuation",
    "stability.gyrostat_arcs": "GyrostatArc",
    "stability.heavy_rotation": "HeavyRotation",
    "stability.energy_casimir": "SecondVariation augmented_hessian multipliers "
                                "second_variation secular_variation",
    "stability.energy_sink": "energy_sink_criterion",
    "stability.linearization": "Linearization linearize",
    "stability.meetings": "BifurcationPoint bifurcation_points",
    "stability.orbital_equilibrium": "OrbitalEquilibrium",
    "stability.normal_form": "NormalForm", "stability.free_rotation": "PermanentRotation",
    "stability.decision": "Decision Rung Verdict",
    "stability.relative_equilibria": "relative_equilibria", "stability.report": "Report",
    "stability.sets": "Case Interval Solution SolvedCondition", "stability.solve": "solve_condition",
    "stability.spectra": "Spectrum spectrum", "stability.stabilizing": "stabilizing_set",
    "stability.staude": "staude_cone StaudeCone", "stability.staude_arcs": "StaudeArc",
    "stability.window_families": "Window",
})
