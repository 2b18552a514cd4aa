"""Lie-Poisson gyrostat stability analyser: from the bracket to the stability inequalities.

A scene is a body and a field, `assemble`d into a Lie-Poisson system; its equilibria (`upright`, `hanging`,
`inclined`, …, or all by `relative_equilibria`) are analysed (`analyze`) into conditions and verdicts, and
those solved for parameters (`stabilizing_set`, `wheel_speeds`). Beyond that there are `gyrostat.derivation`,
the steps to the conditions one by one; `gyrostat.charts`, verdicts over ranges of parameters;
`gyrostat.trajectories`, motions; `gyrostat.mechanics`, the classical formulas; `gyrostat.plotting`, pictures;
`gyrostat.published`, printed formulas checked; `gyrostat.questions`, a scene as a table in, an answer as data
for JSON out. What these need is loaded when they are used.
"""
from importlib import import_module
from typing import TYPE_CHECKING

from . import errors
from ._display import Shown as _Shown
from ._lazy import later as _later
from .cli import start as _start  # noqa: F401 (what Ctrl-C does while the rest is loaded)
from .version import __version__

if TYPE_CHECKING:
    from . import charts, derivation, mechanics, plotting, published, questions, trajectories
    from .equilibria.attitude_in_orbit import Attitude
    from .equilibria.continuation.continuation import continuation
    from .equilibria.continuation.mark import Mark
    from .equilibria.continuation.meeting_equations import Bifurcation, bifurcations
    from .equilibria.continuation.meeting_values import bifurcation_points
    from .equilibria.continuation.pieces import Continuation, Piece
    from .equilibria.curves.amended_potential import AmendedPotential, CriticalPoint, amended_potential
    from .equilibria.curves.arc import Arc
    from .equilibria.curves.staude import StaudeCone, staude_cone
    from .equilibria.relative_equilibrium import RelativeEquilibrium
    from .equilibria.search import relative_equilibria
    from .equilibria.table_rows import table
    from .mechanics.equilibrium.claimed_point import equilibrium
    from .mechanics.equilibrium.equilibrium import Equilibrium
    from .mechanics.equilibrium.parallel_directions import parallel_directions
    from .mechanics.equilibrium.unit_vectors import stereographic
    from .mechanics.families.circular_orbit import circular_orbit, earth_pointing
    from .mechanics.families.holding_rotor import earth_pointing_gyrostat
    from .mechanics.families.orbital_precession import orbital_precession
    from .mechanics.families.permanent_rotation import permanent_rotation
    from .mechanics.families.principal_rotation import principal_rotation
    from .mechanics.families.release import release
    from .mechanics.families.steady_motion import steady_motion
    from .mechanics.families.tilted import inclined, static_tilt
    from .mechanics.families.vertical import hanging, upright
    from .mechanics.scenes.body import Gyrostat, symmetric_gyrostat
    from .mechanics.scenes.coupled import CoupledPotential, coupled_potential
    from .mechanics.scenes.entered_potential import axial_potential, general_potential
    from .mechanics.scenes.fields import ideal_fluid, newtonian_field, uniform_field
    from .mechanics.scenes.lie_poisson import LiePoisson, lie_poisson
    from .mechanics.scenes.potential import Potential
    from .mechanics.scenes.rotors import Rotor, gyrostat_with_rotors
    from .mechanics.scenes.system import System, assemble
    from .mechanics.scenes.vehicles import underwater_vehicle
    from .notation import NOTATION, symbol
    from .parameters.sets import Case, Interval, Solution, SolvedCondition
    from .parameters.solve import solve_condition
    from .parameters.spectra import Spectrum, spectrum
    from .parameters.stabilizing_set import stabilizing_set
    from .parameters.wheel_speeds import wheel_speeds
    from .printing.formats.article import to_latex
    from .stability.criteria.conditions import Condition, Criterion
    from .stability.decision import Decision, Rung, Verdict
    from .stability.normal_forms.d4_along_family import Window
    from .stability.normal_forms.normal_form import NormalForm
    from .stability.notion import Notion
    from .stability.report.analysis import analyze
    from .stability.report.report import Report

# loaded when something is shown
_Shown.formula = lambda shown: import_module("gyrostat.printing.formats.latex").formula(shown)
_Shown.plain = lambda shown: import_module("gyrostat.printing.formats.text").plain(shown)

__all__ = [
    "__version__", "amended_potential", "AmendedPotential", "analyze", "Arc", "assemble", "Attitude",
    "axial_potential",
    "Bifurcation", "bifurcation_points", "bifurcations", "Case", "charts",
    "circular_orbit", "Condition", "Continuation", "continuation", "coupled_potential",
    "CoupledPotential", "Criterion", "CriticalPoint", "Decision", "derivation", "earth_pointing",
    "earth_pointing_gyrostat", "Equilibrium", "equilibrium", "errors",
    "general_potential", "Gyrostat", "gyrostat_with_rotors", "hanging",
    "ideal_fluid", "inclined", "Interval", "lie_poisson", "LiePoisson", "Mark", "mechanics",
    "newtonian_field", "NormalForm", "NOTATION", "Notion", "orbital_precession", "parallel_directions",
    "permanent_rotation", "Piece", "plotting", "Potential", "principal_rotation", "published", "questions",
    "relative_equilibria", "RelativeEquilibrium", "release", "Report", "Rotor",
    "Rung", "Solution", "solve_condition", "SolvedCondition", "Spectrum", "spectrum", "stabilizing_set",
    "static_tilt", "staude_cone", "StaudeCone", "steady_motion", "stereographic", "symbol",
    "symmetric_gyrostat", "System", "table", "to_latex", "trajectories", "underwater_vehicle",
    "uniform_field", "upright", "Verdict", "wheel_speeds", "Window",
]

__getattr__, __dir__ = _later(__name__, {
    "charts": "", "derivation": "", "mechanics": "", "plotting": "", "published": "", "questions": "",
    "trajectories": "",
    "mechanics.scenes.body": "Gyrostat symmetric_gyrostat",
    "mechanics.scenes.coupled": "CoupledPotential coupled_potential",
    "mechanics.scenes.entered_potential": "axial_potential general_potential",
    "mechanics.scenes.fields": "ideal_fluid newtonian_field uniform_field",
    "mechanics.scenes.lie_poisson": "LiePoisson lie_poisson",
    "mechanics.scenes.potential": "Potential",
    "mechanics.scenes.rotors": "Rotor gyrostat_with_rotors",
    "mechanics.scenes.system": "System assemble",
    "mechanics.scenes.vehicles": "underwater_vehicle",
    "mechanics.equilibrium.claimed_point": "equilibrium",
    "mechanics.equilibrium.equilibrium": "Equilibrium",
    "mechanics.equilibrium.parallel_directions": "parallel_directions",
    "mechanics.equilibrium.unit_vectors": "stereographic",
    "mechanics.families.circular_orbit": "circular_orbit earth_pointing",
    "mechanics.families.holding_rotor": "earth_pointing_gyrostat",
    "mechanics.families.orbital_precession": "orbital_precession",
    "mechanics.families.permanent_rotation": "permanent_rotation",
    "mechanics.families.principal_rotation": "principal_rotation",
    "mechanics.families.release": "release",
    "mechanics.families.steady_motion": "steady_motion",
    "mechanics.families.tilted": "inclined static_tilt",
    "mechanics.families.vertical": "hanging upright",
    "stability.criteria.conditions": "Condition Criterion",
    "stability.decision": "Decision Rung Verdict", "stability.notion": "Notion",
    "stability.normal_forms.d4_along_family": "Window",
    "stability.normal_forms.normal_form": "NormalForm",
    "stability.report.analysis": "analyze",
    "stability.report.report": "Report",
    "equilibria.attitude_in_orbit": "Attitude",
    "equilibria.search": "relative_equilibria",
    "equilibria.table_rows": "table",
    "equilibria.relative_equilibrium": "RelativeEquilibrium",
    "equilibria.continuation.continuation": "continuation",
    "equilibria.continuation.meeting_equations": "Bifurcation bifurcations",
    "equilibria.continuation.meeting_values": "bifurcation_points",
    "equilibria.continuation.mark": "Mark",
    "equilibria.continuation.pieces": "Continuation Piece",
    "equilibria.curves.amended_potential": "amended_potential AmendedPotential CriticalPoint",
    "equilibria.curves.arc": "Arc",
    "equilibria.curves.staude": "staude_cone StaudeCone",
    "parameters.sets": "Case Interval Solution SolvedCondition",
    "parameters.solve": "solve_condition",
    "parameters.spectra": "Spectrum spectrum",
    "parameters.stabilizing_set": "stabilizing_set",
    "parameters.wheel_speeds": "wheel_speeds",
    "printing.formats.article": "to_latex",
    "notation": "NOTATION symbol",
})
