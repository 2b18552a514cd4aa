"""Vehicles in a fluid: the equations of motion by their velocities, in fractions; what is refused."""
from fractions import Fraction
from random import Random

import pytest
from kirchhoff import random_vehicle
from satellites import exact
from vehicles import scene_of

import gyrostat as gs
from gyrostat.errors import BodyError, EquilibriumError, ScopeError


@pytest.mark.few(2)
@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("weight", [True, False])
def test_equations_of_motion(seed, weight):
    """Π̇ and ṗ of random velocities, J, D and M full."""
    rng = Random(f"vehicle {seed}")
    vehicle = random_vehicle(rng, weight)
    z = [Fraction(rng.randint(-5, 5), rng.randint(1, 3)) for _ in range(9)]
    pi, p = vehicle.momenta(z[:3], z[3:6])
    scene = scene_of(vehicle, weight)
    state = exact([*pi, *p, *(z[6:] if weight else ())])
    at = dict(zip(scene.space.coordinates, state))
    assert [rate.xreplace(at) for rate in scene.vector_field()] == exact(vehicle.rates(z))[:len(state)]


def test_the_tensor_of_the_scene_is_not_that_of_the_body():
    """J − D M⁻¹ Dᵀ, with the centre of gravity on axis 3."""
    d = gs.symbol("d")
    scene = gs.underwater_vehicle(coupling=[[0, -d, 0], [d, 0, 0], [0, 0, 0]])
    I1, I2, I3, first, second = map(gs.symbol, ("I1", "I2", "I3", "mass1", "mass2"))
    expected = I1 - d**2 / second, I2 - d**2 / first, I3
    assert all((a - b).cancel() == 0 for a, b in zip(scene.body.moments, expected))


def test_without_coupling_it_is_the_ideal_fluid():
    """Of a body of revolution, up to a constant: the conditions of ideal_fluid."""
    I1, I3, across, along, l, w, p0 = map(gs.symbol, ("I1", "I3", "mass1", "mass3", "l", "omega3_0", "p0"))
    scene = gs.underwater_vehicle((I1, I1, I3), (across, across, along), gyrostatic_momentum=(0, 0, l))
    mine = gs.analyze(gs.steady_motion(scene, (0, 0, p0), omega=(0, 0, w)))
    (condition,), = mine.sufficient.alternatives
    top = gs.analyze(gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.ideal_fluid())))
    (expected,), = top.sufficient.alternatives
    assert (condition.margin - expected.margin.xreplace({gs.symbol("pi3_0"): I3 * w})).expand() == 0


@pytest.mark.parametrize(("given", "wrong"), [
    ({"coupling": [[0, -5, 0], [5, 0, 0], [0, 0, 0]]}, "J − D M⁻¹ Dᵀ = .* the kinetic energy is positive"),
    ({"mass": (1, -1, 1)}, "the mass .* is not positive definite"),
    ({"mass": [[1, 2, 0], [0, 1, 0], [0, 0, 1]]}, "symmetric"),
    ({"coupling": [[0, 0], [0, 0], [0, 0]]}, "coupling has 2 entries"),
    ({"coupling": [[0, 0, 0]]}, "coupling has 1 rows"), ({"weight": (1, 2)}, "weight has 2 entries")])
def test_impossible_vehicles(given, wrong):
    """One sentence each."""
    with pytest.raises(BodyError, match=wrong):
        gs.underwater_vehicle(**{"inertia": (1, 1, 1), "mass": (1, 2, 3), **given})


def test_what_is_no_steady_motion():
    """The message names what turns it; another number of directions; a scene of one direction."""
    scene = gs.underwater_vehicle(weight=(0, 0, 1))
    with pytest.raises(EquilibriumError, match="dpi1/dt"):
        gs.steady_motion(scene, (0, 1, 1), (0, 0, 1))
    with pytest.raises(EquilibriumError, match="2 directions, p, gamma"):
        gs.steady_motion(scene, (0, 1, 1))
    with pytest.raises(ScopeError, match="permanent_rotation"):
        gs.steady_motion(gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), (0, 0, 1))
