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
    "permanent_rotation": gs.permanent_rotation, "reduce": gs.mechanics.reduce,
    "bifurcations": gs.bifurcations, "amended_potential": gs.amended_potential, "staude_cone": gs.staude_cone,
    "principal_rotation": lambda scene: gs.principal_rotation(scene, 3),
    "lagrangian": lambda scene: gs.mechanics.lagrangian(scene.body, scene.potential),
    "effective_potential": lambda scene: gs.mechanics.effective_potential(scene.body, scene.potential),
    "draw_amended_potential": lambda scene: gs.plotting.draw_amended_potential(scene, {"C1": 1}),
    "draw_effective_potential": lambda scene: gs.plotting.draw_effective_potential(scene, LEVEL),
    "draw_energy_momentum": lambda scene: gs.plotting.draw_energy_momentum(scene, {"p_psi": 1}),
    "draw_momentum_sphere": lambda scene: gs.plotting.draw_momentum_sphere(scene, 2),
    "draw_rotor_set": lambda scene: gs.plotting.draw_rotor_set(scene, {"l3": 0, "M": 1}),
    "draw_staude_cone": gs.plotting.draw_staude_cone,
    "draw_staude_plane": gs.plotting.draw_staude_plane}
ONLY_IN_ORBIT = {
    "bifurcation_points": lambda scene: gs.bifurcation_points(scene, "omega", {}),
    "continuation": lambda scene: gs.continuation(scene, "omega", (0, 1), {}),
    "draw_bifurcation_diagram": lambda scene: gs.plotting.draw_bifurcation_diagram(
        scene, "omega", (0, 1), {})}
ANSWERED = {"equilibrium", "assemble", "earth_pointing", "relative_equilibria", "orbital_precession",
            "steady_motion", "release", "draw_attitudes", "wheel_speeds"}


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("name", REFUSED)
def test_it_is_refused(name, scene):
    """Never a wrong answer, never a foreign error."""
    matplotlib.use("Agg")
    with pytest.raises(ScopeError) as error:
        REFUSED[name](SCENES[scene])
    assert len(str(error.value)) < 400


@pytest.mark.parametrize("name", ONLY_IN_ORBIT)
def test_what_is_answered_in_orbit_is_refused_with_a_coupling(name):
    """By the same sentence."""
    with pytest.raises(ScopeError, match="coupling β"):
        ONLY_IN_ORBIT[name](SCENES["coupled"])


def test_no_verb_is_left_out():
    """Of those that take a scene."""
    takes = {name for module in (gs, gs.plotting, gs.mechanics) for name in module.__all__
             if inspect.isfunction(verb := getattr(module, name))
             and "scene" in inspect.signature(verb).parameters}
    assert takes <= REFUSED.keys() | ONLY_IN_ORBIT.keys() | ANSWERED


def test_a_normal_form_is_refused():
    """Three degrees of freedom."""
    report = gs.analyze(gs.earth_pointing(SCENES["satellite"]))
    for verb in (report.normal_form, report.window):
        with pytest.raises(ScopeError, match="a normal form"):
            verb({})


def test_integrals_prove_nothing():
    """They are watched along motions; the criteria and the verdict are those without them."""
    body = gs.Gyrostat((2, 2, 1), (0, 0, 0))
    pi1, pi2, k1, k2, e1, e2 = map(gs.symbol, ("pi1", "pi2", "k1", "k2", "e1", "e2"))
    field, w1, w2 = gs.coupled_potential(-k1 - 2 * e2), pi1 / 2, pi2 / 2
    F = (w1**2 - w2**2 + k1 - 2 * e2) ** 2 + (2 * w1 * w2 + k2 + 2 * e1) ** 2
    for sides in ((1, 1), (-1, -1), (-1, 1), (1, -1)):
        point = (0, 0, 0, sides[0], 0, 0, 0, sides[1], 0)
        plain, watched = (gs.analyze(gs.equilibrium(gs.assemble(body, field, integrals), point))
                          for integrals in ((), (F,)))
        assert watched.sufficient == plain.sufficient
        assert watched.verdict({}).verdict is plain.verdict({}).verdict


def test_a_confirmation_is_refused():
    """The points beside it are those of one direction."""
    with pytest.raises(ScopeError, match="a confirmation by motions"):
        gs.trajectories.confirm(gs.analyze(gs.earth_pointing(SCENES["satellite"])), {})


def test_a_coupled_body_of_revolution_is_not_recognised():
    """The coupling would be lost: it is stable by its own second variation, and damping is its own."""
    scene = SCENES["coupled"]
    decision = gs.analyze(gs.equilibrium(scene, (0, 0, -3, 0, 0, 1))).verdict({})
    assert "recognised" not in decision.reason
    with pytest.raises(ScopeError, match="coupling"):
        gs.relative_equilibria(scene, {"omega": 1})
