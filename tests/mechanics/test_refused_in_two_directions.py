"""What is of a field in one direction is refused of two, and of a coupling, in one sentence."""
import inspect

import matplotlib
import pytest

import gyrostat as gs
from gyrostat.errors import ScopeError

BODY = gs.Gyrostat((4, 5, 3), (0, 0, 0))
TOP = gs.Gyrostat((4, 4, 3), (0, 0, 1))
K = gs.lie_poisson().coordinates[3:]
SCENES = {"satellite": gs.assemble(BODY, gs.circular_orbit(1)),
          "of revolution": gs.assemble(TOP, gs.circular_orbit(1)),
          "coupled": gs.assemble(TOP, gs.coupled_potential(K[2], ("k",), drift=K))}
LEVEL = {"p_phi": 1, "p_psi": 1}

REFUSED = {
    "upright": gs.upright, "hanging": gs.hanging, "inclined": gs.inclined, "static_tilt": gs.static_tilt,
    "permanent_rotation": gs.permanent_rotation, "reduce": gs.reduce, "bifurcations": gs.bifurcations,
    "amended_potential": gs.amended_potential, "staude_cone": gs.staude_cone,
    "principal_rotation": lambda scene: gs.principal_rotation(scene, 3),
    "bifurcation_points": lambda scene: gs.bifurcation_points(scene, "omega", {}),
    "continuation": lambda scene: gs.continuation(scene, "omega", (0, 1), {}),
    "lagrangian": lambda scene: gs.mechanics.lagrangian(scene.body, scene.potential),
    "effective_potential": lambda scene: gs.mechanics.effective_potential(scene.body, scene.potential),
    "draw_amended_potential": lambda scene: gs.plotting.draw_amended_potential(scene, {"C1": 1}),
    "draw_bifurcation_diagram": lambda scene: gs.plotting.draw_bifurcation_diagram(
        scene, "omega", (0, 1), {}),
    "draw_effective_potential": lambda scene: gs.plotting.draw_effective_potential(scene, LEVEL),
    "draw_energy_momentum": lambda scene: gs.plotting.draw_energy_momentum(scene, {"p_psi": 1}),
    "draw_momentum_sphere": lambda scene: gs.plotting.draw_momentum_sphere(scene, 2),
    "draw_rotor_set": lambda scene: gs.plotting.draw_rotor_set(scene, {"l3": 0, "M": 1}),
    "draw_staude_cone": gs.plotting.draw_staude_cone, "draw_staude_plane": gs.plotting.draw_staude_plane}
ANSWERED = {"equilibrium", "assemble", "earth_pointing", "relative_equilibria", "orbital_precession"}


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("name", REFUSED)
def test_it_is_refused(name, scene):
    """Never a wrong answer, never a foreign error."""
    matplotlib.use("Agg")
    with pytest.raises(ScopeError) as error:
        REFUSED[name](SCENES[scene])
    assert len(str(error.value)) < 400


def test_no_verb_is_left_out():
    """Of those that take a scene."""
    takes = {name for module in (gs, gs.plotting, gs.mechanics) for name in module.__all__
             if inspect.isfunction(verb := getattr(module, name))
             and "scene" in inspect.signature(verb).parameters}
    assert takes <= REFUSED.keys() | ANSWERED


def test_a_normal_form_is_refused():
    """Three degrees of freedom."""
    report = gs.analyze(gs.earth_pointing(SCENES["satellite"]))
    for verb in (report.normal_form, report.window):
        with pytest.raises(ScopeError, match="a normal form"):
            verb({})


def test_integrals_are_refused():
    """n·r is 0, and a rate that vanishes where it is 1 does not vanish."""
    scene = SCENES["satellite"]
    with pytest.raises(ScopeError, match="an integral that is given"):
        gs.assemble(scene.body, scene.potential, integrals=("k1",))


def test_a_coupled_body_of_revolution_is_not_recognised():
    """The coupling would be lost: it is stable by its own second variation, and damping is its own."""
    scene = SCENES["coupled"]
    decision = gs.analyze(gs.equilibrium(scene, (0, 0, -3, 0, 0, 1))).verdict({})
    assert "recognised" not in decision.reason
    with pytest.raises(ScopeError, match="coupling"):
        gs.relative_equilibria(scene, {"omega": 1})
