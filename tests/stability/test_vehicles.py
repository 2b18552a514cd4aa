"""Vehicles in a fluid: textbook conditions, and random ones against their velocities in fractions."""
from random import Random

import pytest
from kirchhoff import SPHERE, random_vehicle
from satellites import exact
from slow import sampled
from sympy import Rational, sqrt
from two_directions import dot, second_variation
from two_directions import random_fraction as some
from vehicles import SHIFTED, ZERO, margins, scene_of, translating

import gyrostat as gs

m0, p0, across, along = map(gs.symbol, ("m0", "p0", "mass1", "mass3"))


def test_horizontal_translation():
    """Leonard's conditions, whatever the coupling: bottom-heavy, broadside, not too fast."""
    second = gs.symbol("mass2")
    for coupling in (None, SHIFTED):
        scene = gs.underwater_vehicle(coupling=coupling, weight=(0, 0, m0))
        report = gs.analyze(gs.steady_motion(scene, (0, p0, 0), (0, 0, 1)))
        assert margins(report.sufficient) == {
            m0, second - across, (second * along * m0 + p0**2 * (second - along)).expand()}
    values = {"I1": 1, "I2": 1, "I3": 1, "mass1": 1, "mass2": "3/2", "mass3": 2, "m0": 1, "d": "1/10"}
    for impulse, name in ((sqrt(6) - Rational(1, 100), "STABLE"), (sqrt(6) + Rational(1, 100), "UNSTABLE")):
        assert report.verdict({**values, "p0": impulse}).verdict.name == name


def test_damping_that_reaches_no_impulse():
    """M a multiple of 1, D = 2 hat(c): a rigid body alone, seen from beside its centre of mass."""
    inertia = [["3/2", 0, "-1/2"], [0, 3, 0], ["-1/2", 0, "7/2"]]      # about c: 1, 2, 3
    scene = gs.underwater_vehicle(inertia, (2, 2, 2), [[0, -1, 0], [1, 0, -1], [0, 1, 0]])
    assert scene.body.moments == (1, 2, 3)
    for axis, modes in (((1, 0, 0), 2), ((0, 1, 0), 1)):
        damped = gs.analyze(gs.steady_motion(scene, axis, omega=axis)).verdict({}, damped=True)
        assert damped.verdict is gs.Verdict.UNSTABLE and damped.growing == modes


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_random_translations(seed, full):
    """The sextic, the signature of the second variation, the verdicts, and a damper inside."""
    rng = Random(f"translation {seed}")
    for _ in range(sampled(40, full, 3)):
        vehicle, p, z = translating(rng)
        assert not any(vehicle.rates(z))
        eq = gs.steady_motion(scene_of(vehicle), exact(p), exact(z[6:]))
        found, report = vehicle.polynomial(z), gs.analyze(eq)
        assert gs.derivation.linearize(eq).coefficients == tuple(exact([found[2], found[4], found[6]]))
        state = [*vehicle.momenta(z[:3], z[3:6])[0], *p, *z[6:]]
        plus, minus, null = second_variation(vehicle.energy(), state)
        assert (report.verdict({}).verdict.name == "STABLE") == (plus == 6)
        if not null:
            assert report.verdict({}, damped=True).growing == minus == vehicle.growing(z)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_random_steady_rotations(seed, full):
    """Kirchhoff's body of any shape, turning about the impulse: p and q, and a damper inside."""
    rng = Random(f"kirchhoff {seed}")
    for _ in range(sampled(40, full, 3)):
        vehicle = random_vehicle(rng, weight=False)
        heavier = [[x + SPHERE * (i == j) for j, x in enumerate(row)] for i, row in enumerate(vehicle.J)]
        p, rate = [some(rng, 3) + 4 * (i == 2) for i in range(3)], some(rng, 2)
        omega = [rate * x for x in p]
        still = vehicle._replace(J=heavier)
        pulled = [a - b for a, b in zip(p, still.momenta(omega, [ZERO] * 3)[1])]
        v = still._replace(J=still.M, D=[[ZERO] * 3] * 3, M=still.J).accelerations([*pulled, *[ZERO] * 6])[:3]
        pi = still.momenta(omega, v)[0]
        if not rate:
            continue
        extra = some(rng)
        turned = still._replace(rotor=[x / rate - y + extra * z for x, y, z in zip(v, pi, p)])
        z = [*omega, *v, *[ZERO] * 3]
        assert not any(turned.rates(z))
        eq = gs.steady_motion(scene_of(turned, weight=False), exact(p), omega=exact(omega))
        found, report = turned.polynomial(z), gs.analyze(eq)
        turning = dot(omega, omega)                        # γ, without weight, is carried along
        assert found[6] == turning * (found[4] - turning * (found[2] - turning))
        assert gs.derivation.linearize(eq).coefficients == tuple(
            exact([found[2] - turning, found[4] - turning * (found[2] - turning)]))
        assert report.verdict({}, damped=True).growing == turned.growing(z)
