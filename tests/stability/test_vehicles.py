"""Vehicles in a fluid: textbook conditions, and random ones against their velocities in fractions."""
from fractions import Fraction
from random import Random

import pytest
from kirchhoff import SPHERE, Vehicle, random_vehicle
from satellites import exact
from slow import sampled
from sympy import Rational, sqrt
from two_directions import cross, dot, second_variation, signature
from two_directions import random_fraction as some

import gyrostat as gs
from gyrostat.errors import ScopeError, SingularOrbitError

d, m0, p0, l, w = map(gs.symbol, ("d", "m0", "p0", "l", "omega3_0"))
I1, I3, across, along = map(gs.symbol, ("I1", "I3", "mass1", "mass3"))
SHIFTED = [[0, -d, 0], [d, 0, 0], [0, 0, 0]]               # m hat(c), c on axis 3
ONE, ZERO = Fraction(1), Fraction(0)


def margins(criterion):
    """Of a criterion of one alternative."""
    (conditions,) = criterion.alternatives
    return {c.margin.expand() for c in conditions}


def unit(rng):
    """A rational unit vector."""
    a, b = rng.randint(-3, 3), rng.randint(-3, 3)
    s = 1 + a * a + b * b
    return [Fraction(2 * a, s), Fraction(2 * b, s), Fraction(s - 2, s)]


def positive(rng):
    """A random positive matrix."""
    G = [[some(rng, 2) + 2 * (i == j) for j in range(3)] for i in range(3)]
    return [[dot(a, b) + (i == j) for j, b in enumerate(G)] for i, a in enumerate(G)]


def translating(rng, parallel=False):
    """A vehicle that translates with the impulse p, down γ, both anywhere, p × v = γ × w; p; velocities."""
    down, p, share = unit(rng), [some(rng, 3) for _ in range(3)], some(rng, 2)
    v, pull = [x + share * y for x, y in zip(p, down)], [-share * x for x in p]
    if parallel:
        ratio = 3 * rng.choice((-1, 1))
        p = [ratio * x for x in down]
        v = [x + some(rng, 1) for x in p]
        pull = [ratio * x for x in v]
    if dot(v, p) <= 0 or not parallel and not any(cross(p, down)):
        return translating(rng, parallel)
    S, hat = positive(rng), [[ZERO, -v[2], v[1]], [v[2], ZERO, -v[0]], [-v[1], v[0], ZERO]]
    half = [[dot(row, column) for column in zip(*hat)] for row in S]
    turned = [[dot(column, other) for other in zip(*half)] for column in zip(*hat)]
    M = [[p[i] * p[j] / dot(v, p) + turned[i][j] for j in range(3)] for i in range(3)]
    D = [[some(rng, 2) for _ in range(3)] for _ in range(3)]
    still = Vehicle(M, [[ZERO] * 3] * 3, positive(rng), [], [])
    columns = [still.accelerations([Fraction(i == n) for i in range(9)])[:3] for n in range(3)]
    moved = [[sum(D[i][a] * columns[b][a] * D[j][b] for a in range(3) for b in range(3)) for j in range(3)]
             for i in range(3)]
    J = [[x + y + SPHERE * (i == j) for j, (x, y) in enumerate(zip(*rows))]
         for i, rows in enumerate(zip(moved, positive(rng)))]
    heavy = some(rng)
    weight = [x + heavy * y for x, y in zip(pull, down)]
    return Vehicle(J, D, M, weight, [some(rng) for _ in range(3)]), p, [ZERO] * 3 + v + down


def scene_of(vehicle, weight=True):
    """The scene of a vehicle of the oracle."""
    return gs.underwater_vehicle(
        *([exact(row) for row in rows] for rows in (vehicle.J, vehicle.M, vehicle.D)),
        weight=exact(vehicle.weight) if weight else None, gyrostatic_momentum=exact(vehicle.rotor))


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


def test_rising_with_spin():
    """(Π3 + l)² > 4 I1* [p² (1/m3 − 1/m1) − m0], I1* = I1 − d²/m1; the number of the example."""
    scene = gs.underwater_vehicle((I1, I1, I3), (across, across, along), SHIFTED, weight=(0, 0, m0),
                                  gyrostatic_momentum=(0, 0, l))
    rising = gs.steady_motion(scene, (0, 0, p0), (0, 0, 1), omega=(0, 0, w))
    held = gs.analyze(gs.parallel_directions(rising))
    star = I1 - d**2 / across
    margin = (I3 * w + l) ** 2 - 4 * star * (p0**2 * (1 / along - 1 / across) - m0)
    ratio = {(x / margin).cancel() for x in margins(held.sufficient)}
    assert ratio == {across**2 * along} == {(x / margin).cancel() for x in margins(held.necessary)}
    values = {"I1": 1, "I3": 1, "mass1": 2, "mass3": 1, "d": "3/10", "m0": 1, "p0": 2, "l": 0}
    critical = 2 * sqrt(Rational(955, 1000))
    near = {name: critical + step for name, step in (("UNSTABLE", -Rational(1, 10**9)),
                                                     ("STABLE", Rational(1, 10**9)))}
    assert {held.verdict({**values, "omega3_0": x}).verdict.name for x in near.values()} == near.keys()
    for name, x in near.items():
        assert held.verdict({**values, "omega3_0": x}).verdict.name == name
        whole = gs.analyze(rising).verdict({**values, "omega3_0": x})
        assert whole.verdict.name == ("UNDECIDED" if name == "STABLE" else name)
    assert "do not stay parallel nothing is proved" in whole.reason


@pytest.mark.parametrize("sense", [1, -1])
def test_rising_without_spin(sense):
    """Against all motions, in nine coordinates: ± m0 > p² (1/m3 − 1/m_i)."""
    scene = gs.underwater_vehicle(coupling=SHIFTED, weight=(0, 0, m0))
    rising = gs.steady_motion(scene, (0, 0, p0), (0, 0, sense))
    report = gs.analyze(rising)
    second = gs.symbol("mass2")
    expected = {(sense * m0 * m * along - p0**2 * (m - along)).expand() for m in (across, second)}
    assert margins(report.sufficient) == expected == margins(report.damped)
    with pytest.raises(SingularOrbitError, match="directions p and gamma are parallel .* analyze"):
        gs.linearize(rising)
    with pytest.raises(ScopeError, match="no two directions that are parallel"):
        gs.parallel_directions(gs.steady_motion(scene, (0, p0, 0), (0, 0, 1)))


def test_a_rotor_holds_only_what_stays_parallel():
    """M·a is a Casimir of the parallel motions only: with a rotor across it they are stable."""
    scene = gs.underwater_vehicle((1, 1, 1), (2, 1, 1), weight=(0, 0, "1/2"), gyrostatic_momentum=(9, 0, 0))
    rising = gs.steady_motion(scene, (0, 0, "3/2"), (0, 0, 1))
    assert gs.analyze(gs.parallel_directions(rising)).verdict({}).verdict.name == "STABLE"
    for damped in (False, True):
        decision = gs.analyze(rising).verdict({}, damped=damped)
        assert decision.verdict.name == "UNDECIDED" and "nothing is proved" in decision.reason


@pytest.mark.parametrize("turning", [0, 1])
def test_two_fields_that_pull_together(turning):
    """U = −(a k1 + b e1), k = e: a body in one field of the strength a + b; at rest against all motions."""
    field = gs.coupled_potential(-2 * gs.symbol("k3") - gs.symbol("e3"))
    scene = gs.assemble(gs.Gyrostat((2, 3, 4), (0, 0, 0)), field)
    hanging = gs.steady_motion(scene, (0, 0, 1), (0, 0, 1), omega=(0, 0, turning))
    along = gs.parallel_directions(hanging)
    assert along.system.potential.expression == -3 * gs.symbol("k3") and not along.system.coupled
    assert gs.analyze(along).verdict({}).verdict.name == "STABLE"
    assert gs.analyze(hanging).verdict({}).verdict.name == ("UNDECIDED" if turning else "STABLE")
    opposite = gs.steady_motion(scene, (0, 0, 1), (0, 0, -1))
    assert gs.parallel_directions(opposite).system.potential.expression == -gs.symbol("k3")


@pytest.mark.few(2)
@pytest.mark.parametrize("seed", range(4))
def test_random_translations(seed, full):
    """The sextic, the signature of the second variation, the verdicts, and a damper inside."""
    rng = Random(f"translation {seed}")
    for _ in range(sampled(40, full, 3)):
        vehicle, p, z = translating(rng)
        assert not any(vehicle.rates(z))
        eq = gs.steady_motion(scene_of(vehicle), exact(p), exact(z[6:]))
        found, report = vehicle.polynomial(z), gs.analyze(eq)
        assert gs.linearize(eq).coefficients == tuple(exact([found[2], found[4], found[6]]))
        state = [*vehicle.momenta(z[:3], z[3:6])[0], *p, *z[6:]]
        plus, minus, null = second_variation(vehicle.energy(), state)
        assert (report.verdict({}).verdict.name == "STABLE") == (plus == 6)
        if not null:
            assert report.verdict({}, damped=True).growing == minus == vehicle.growing(z)


@pytest.mark.few(2)
@pytest.mark.parametrize("seed", range(4))
def test_random_parallel_directions(seed, full):
    """Nine eigenvalues are those of the motions that stay parallel, and five zeros; the minimum; a damper."""
    rng, undecided = Random(f"parallel {seed}"), 0
    for _ in range(sampled(40, full, 3)):
        vehicle, p, z = translating(rng, parallel=True)
        assert not any(vehicle.rates(z))
        eq = gs.steady_motion(scene_of(vehicle), exact(p), exact(z[6:]))
        report, found = gs.analyze(eq), vehicle.polynomial(z)
        assert (*report.linearization.coefficients, 0, 0) == tuple(exact(found[2:9:2]))
        assert not any(found[1::2])
        least = _least(vehicle, p, z)
        assert (report.verdict({}).verdict.name == "STABLE") == least
        damped = report.verdict({}, damped=True)
        assert (damped.verdict.name == "STABLE") == least
        assert damped.growing == vehicle.growing(z) or damped.verdict.name == "UNDECIDED"
        undecided += damped.verdict.name == "UNDECIDED"
    assert undecided <= 4


def _least(vehicle, p, z):
    """Whether h has a minimum where p = ratio γ, for any π and |γ| = 1."""
    energy, down = vehicle.energy(), z[6:]
    ratio = dot(p, down)
    _, slopes = energy.gradient([*vehicle.momenta(z[:3], z[3:6])[0], *p, *down])
    form, pull = energy.hessian(), ratio * dot(slopes[:3], down) + dot(slopes[3:], down)
    for i in range(3):
        form[6 + i][6 + i] -= pull
    first = [ONE, ZERO, ZERO] if down[1] or down[2] else [ZERO, ONE, ZERO]
    basis = [[Fraction(i == n) for i in range(9)] for n in range(3)]
    basis += [[ZERO, ZERO, ZERO, *(ratio * x for x in e), *e]
              for e in (cross(down, first), cross(down, cross(down, first)))]
    return signature([[dot(u, [dot(row, x) for row in form]) for x in basis] for u in basis])[0] == 5


@pytest.mark.few(2)
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
        assert gs.linearize(eq).coefficients == tuple(
            exact([found[2] - turning, found[4] - turning * (found[2] - turning)]))
        assert report.verdict({}, damped=True).growing == turned.growing(z)
