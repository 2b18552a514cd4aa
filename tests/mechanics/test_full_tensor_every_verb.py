"""Every verb with a full tensor: right, or refused with a sentence that says what to do."""
import inspect

import matplotlib
import matplotlib.pyplot as plt
import pytest
from sympy import ImmutableMatrix

import gyrostat as gs
from gyrostat.errors import EquilibriumError, ScopeError

TENSOR = [[3, 1, 0], [1, 3, 0], [0, 0, 5]]
FREE = gs.assemble(gs.Gyrostat(TENSOR, (0, 0, "1/2")))
HEAVY = gs.assemble(gs.Gyrostat(TENSOR, (0, 0, "1/2")), gs.axial_potential(lambda z: z))
LEVEL = {"p_phi": 1, "p_psi": 1}

# what needs principal moments
REFUSED = {
    "reduce": lambda: gs.mechanics.reduce(HEAVY), "inclined": lambda: gs.inclined(HEAVY),
    "static_tilt": lambda: gs.static_tilt(HEAVY), "bifurcations": lambda: gs.bifurcations(HEAVY),
    "bifurcation_points": lambda: gs.bifurcation_points(HEAVY, "omega", {}),
    "angular_momentum": lambda: gs.mechanics.angular_momentum(HEAVY.body),
    "lagrangian": lambda: gs.mechanics.lagrangian(HEAVY.body, HEAVY.potential),
    "momenta": lambda: gs.mechanics.momenta(HEAVY.body),
    "effective_potential": lambda: gs.mechanics.effective_potential(HEAVY.body, HEAVY.potential),
    "momentum_limits": lambda: gs.mechanics.momentum_limits(gs.Gyrostat(TENSOR, (0, 0, 0)), 1),
    "draw_effective_potential": lambda: gs.plotting.draw_effective_potential(HEAVY, LEVEL),
    "draw_energy_momentum": lambda: gs.plotting.draw_energy_momentum(HEAVY, {"p_psi": 1}),
    "animate_top": lambda: gs.plotting.animate_top(gs.trajectories.motion(FREE, (1, 2, 3)), [0, 1]),
    "view_motion": lambda: gs.plotting.view_motion(gs.trajectories.motion(FREE, (1, 2, 3)), [0, 1]),
}
ANSWERED = {
    "draw_attitudes": lambda: gs.plotting.draw_attitudes(gs.assemble(
        gs.Gyrostat(TENSOR, (-1, 3, 0)), gs.circular_orbit(1))),
    "draw_momentum_sphere": lambda: gs.plotting.draw_momentum_sphere(FREE, 2),
    "draw_rotor_set": lambda: gs.plotting.draw_rotor_set(gs.assemble(gs.Gyrostat(TENSOR)), {"l3": 0, "M": 1}),
    "draw_staude_cone": lambda: gs.plotting.draw_staude_cone(gs.assemble(
        gs.Gyrostat(TENSOR, (0, 0, 0)), HEAVY.potential)),
    "draw_staude_plane": lambda: gs.plotting.draw_staude_plane(gs.assemble(
        gs.Gyrostat(TENSOR, (0, 0, 1)), HEAVY.potential)),
    "continuation": lambda: gs.continuation(HEAVY, "omega", (0, 1), {}),
    "draw_bifurcation_diagram": lambda: gs.plotting.draw_bifurcation_diagram(HEAVY, "omega", (0, 1), {}),
    "principal_axes": lambda: gs.mechanics.principal_axes(FREE.body),
    "torque_equations": lambda: gs.mechanics.torque_equations(FREE.body),
    "amended_potential": lambda: gs.amended_potential(HEAVY).expression,
    "draw_amended_potential": lambda: gs.plotting.draw_amended_potential(gs.assemble(
        FREE.body, gs.general_potential(lambda a, b, c: a + 2 * b + c)), {"C1": 1}),
    "upright": lambda: gs.upright(HEAVY, spin="omega3_0"), "hanging": lambda: gs.hanging(HEAVY),
    "earth_pointing": lambda: gs.analyze(gs.earth_pointing(gs.assemble(
        gs.Gyrostat(TENSOR, (-1, 3, 0)), gs.circular_orbit(1)))).verdict({}),
    "orbital_precession": lambda: gs.orbital_precession(gs.assemble(gs.Gyrostat(
        [[21, 2, 2], [2, 24, 4], [2, 4, 24]], (1, 2, 2)), gs.circular_orbit(1)), "conical"),
    "wheel_speeds": lambda: gs.wheel_speeds(gs.assemble(
        gs.Gyrostat(TENSOR, (0, gs.symbol("s"), 0)), gs.circular_orbit(1)), "s").damped,
    "steady_motion": lambda: gs.steady_motion(gs.assemble(
        gs.Gyrostat(TENSOR, (-1, 3, 0)), gs.circular_orbit(1)), (0, 1, 0), (0, 0, 1)),
    "principal_rotation": lambda: gs.principal_rotation(FREE, 3),
    "permanent_rotation": lambda: gs.analyze(gs.permanent_rotation(gs.assemble(
        FREE.body, gs.general_potential()))).sufficient,
    "relative_equilibria": lambda: gs.relative_equilibria(HEAVY, {"omega": 1})[0].decision,
    "staude_cone": lambda: gs.staude_cone(HEAVY).polynomial,
    "permanent rotations": lambda: gs.relative_equilibria(FREE, {"M": 1}),
    "motion": lambda: gs.trajectories.motion(FREE, (1, 2, 3)).attributes,
    "to_latex": lambda: gs.to_latex(gs.analyze(gs.principal_rotation(FREE, 3))),
    "spectrum": lambda: gs.spectrum(gs.upright(HEAVY), "pi3_0", [0, 1], {}),
    "stabilizing_set": lambda: gs.stabilizing_set(gs.analyze(gs.upright(HEAVY)), "pi3_0", {}),
    "verdicts": lambda: gs.charts.verdicts(gs.analyze(gs.upright(HEAVY)), {"pi3_0": [0, 20]}),
    "draw_eigenvalues": lambda: gs.plotting.draw_eigenvalues(gs.upright(HEAVY), "pi3_0", [0, 1], {}),
    "release": lambda: gs.release(gs.assemble(
        gs.Gyrostat(TENSOR, (-1, 3, 0)), gs.circular_orbit(1)), (0, 0, 0)),
    "draw_well": lambda: gs.plotting.draw_well(next(e for e in gs.relative_equilibria(gs.assemble(
        gs.Gyrostat(TENSOR, (1, 0, 0))), {"M": 2}) if e.well.barrier_double)),
    "draw_librations": lambda: gs.plotting.draw_librations(gs.trajectories.motion(gs.assemble(
        gs.Gyrostat(TENSOR, (-1, 3, 0)), gs.circular_orbit(1)), (0, 5, 0, 0, 1, 0, 0, 0, 1)), [0, 1]),
    "draw_nutation": lambda: gs.plotting.draw_nutation(
        gs.trajectories.motion(HEAVY, (1, 2, 3, "3/5", 0, "4/5")), [0, 0.5, 1]),
}
# of no body, of numbers, or of what the verbs above make
OTHERS = {
    "angle_rates", "angular_velocity", "rotation", "free_precession", "FreePrecession", "polhode_period",
    "Reduction", "Kind", "expansion", "caption", "draw_chart", "draw_cones", "draw_smelt_plane",
    "save_animation"}


@pytest.mark.few(1)
@pytest.mark.parametrize("name", REFUSED)
def test_it_is_refused_with_what_to_do(name):
    """Never silently of the diagonal."""
    if name == "view_motion":
        pytest.importorskip("plotly")
    matplotlib.use("Agg")
    with pytest.raises(ScopeError, match=r"principal_axes\(body\) turns the body"):
        REFUSED[name]()


@pytest.mark.few(2)
@pytest.mark.parametrize("name", [
    pytest.param(name, marks=[pytest.mark.slow] * (name in ("continuation", "draw_bifurcation_diagram")))
    for name in ANSWERED])
def test_it_answers(name, monkeypatch):
    """What it says is compared with principal axes elsewhere."""
    matplotlib.use("Agg")
    monkeypatch.setattr("gyrostat.trajectories.integrated.integrated_motion.find_spec", lambda name: None)
    assert ANSWERED[name]() is not None
    plt.close("all")


def test_no_verb_is_left_out():
    """Of the classical formulas and the pictures."""
    named = REFUSED.keys() | ANSWERED.keys() | OTHERS
    assert {*gs.mechanics.__all__, *gs.plotting.__all__} <= named
    takes = {name for name in gs.__all__ if inspect.isfunction(verb := getattr(gs, name))
             and "scene" in inspect.signature(verb).parameters}
    assert takes - {"equilibrium", "assemble"} <= named


def test_named_rotations_have_the_moment_of_their_axis():
    """Where an axis is principal; Euler's equations have the whole tensor."""
    omega = gs.symbol("omega3_0")
    assert gs.principal_rotation(FREE, 3).point == (0, 0, 5 * omega)
    assert gs.upright(HEAVY, spin="omega3_0").point == (0, 0, 5 * omega, 0, 0, 1)
    with pytest.raises(EquilibriumError, match="rotation about axis 1 is not an equilibrium"):
        gs.principal_rotation(FREE, 1)
    pi = ImmutableMatrix(FREE.space.coordinates)
    rate = gs.mechanics.torque_equations(FREE.body, (0, 0, 0))
    assert (rate - FREE.vector_field()).expand().is_zero_matrix and rate.free_symbols == {*pi}
