"""Two directions that are parallel, as of a vehicle that rises: textbook conditions, and fractions."""
from fractions import Fraction
from random import Random

import pytest
from satellites import exact
from slow import sampled
from sympy import Matrix, Rational, sqrt, zeros
from two_directions import cross, dot, signature
from vehicles import SHIFTED, ZERO, d, margins, scene_of, translating

import gyrostat as gs
from gyrostat.errors import ScopeError, SingularOrbitError

I1, I3, across, along = map(gs.symbol, ("I1", "I3", "mass1", "mass3"))
m0, p0, l, w = map(gs.symbol, ("m0", "p0", "l", "omega3_0"))
ONE = Fraction(1)


@pytest.mark.slow
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
        gs.derivation.linearize(rising)
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


@pytest.mark.few(1)
@pytest.mark.parametrize("axis", [(0, 0, 1), (1, 0, 0), (0, -1, 0), ("3/5", 0, "4/5"), ("2/3", "1/3", "2/3")])
def test_rising_in_any_direction(axis):
    """The same vehicle in other axes: stable iff the weight exceeds 1 − 1/3."""
    third = Matrix([Rational(x) for x in axis])
    first = third.cross(Matrix([0, 1, 0]) if not axis[1] else Matrix([1, 0, 0]))
    axes = [first, third.cross(first), third]
    M = sum((m * a * a.T / a.dot(a) for m, a in zip((2, 3, 1), axes)), zeros(3, 3))
    for weight, name in (("3/5", "UNSTABLE"), ("7/10", "STABLE")):
        scene = gs.underwater_vehicle((2, 3, 4), M, weight=Rational(weight) * third)
        report = gs.analyze(gs.steady_motion(scene, third, third))
        assert report.verdict({}).verdict.name == report.verdict({}, damped=True).verdict.name == name


@pytest.mark.slow
@pytest.mark.parametrize("damped", [False, True])
@pytest.mark.parametrize("turning", [0, 1])
def test_arrays(turning, damped):
    """They say what verdicts do, with a rotor that holds parallel motions alone."""
    scene = gs.underwater_vehicle((1, 1, 1), (2, 1, 1), weight=(0, 0, m0), gyrostatic_momentum=(0, 0, l))
    report = gs.analyze(gs.steady_motion(scene, (0, 0, "3/2"), (0, 0, 1), omega=(0, 0, turning)))
    weights = [Rational(n, 8) for n in (-8, 0, 8, 9, 10)]
    found = gs.charts.verdicts(report, {"l": 9, "m0": [float(x) for x in weights]}, damped=damped)
    codes = {"STABLE": 1, "UNDECIDED": 0, "UNSTABLE": -1}
    decisions = [report.verdict({"l": 9, "m0": x}, damped=damped) for x in weights]
    assert found.tolist() == [codes[d.verdict.name] for d in decisions]
    assert (1 in found) == (not turning)


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
    longer = gs.parallel_directions(gs.steady_motion(scene, (0, 0, 2), (0, 0, 2)))
    assert longer.system.coupled and longer.system.potential.expression == -3 * gs.symbol("k3")
    opposite = gs.steady_motion(scene, (0, 0, 1), (0, 0, -1))
    assert gs.parallel_directions(opposite).system.potential.expression == -gs.symbol("k3")


@pytest.mark.slow
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
