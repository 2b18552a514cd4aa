"""Every attitude of a satellite with any tensor under torques of a potential: complete, and decided by K."""
import pickle
from fractions import Fraction as F
from random import Random

import numpy as np
import pytest
from attitude_search import growth, search
from flint import arb
from satellites import rotation
from slow import sampled
from sympy import pi
from torques_on_satellites import ONE, TURN, Satellite, in_axes, turned

import gyrostat as gs
from gyrostat.algebra.enclosures.precision import own_precision
from gyrostat.equilibria.finders.orbit_torques import attitude_forms
from gyrostat.equilibria.finders.orbital_form import balls
from gyrostat.equilibria.relative_equilibrium import RelativeEquilibrium


def places(equilibria):
    """(n, r) in floats."""
    return np.array([[*e.doubles.place.values()] for e in equilibria])


def check(satellite, seed):
    """Newton's method finds no other, K has the index that is found, and minima − saddles … are 0.

    A verdict is UNSTABLE where an eigenvalue of the motion has a positive real part.
    """
    equilibria = satellite.found()
    here = places(equilibria)
    for attitude, bend in search(satellite.matrix, satellite.vector, seed=seed):
        apart = np.abs(here - attitude[1:].reshape(6)).max(1)
        assert apart.min() < 1e-7
        signs = np.linalg.eigvalsh(-(bend + bend.T) / 2)
        e = equilibria[apart.argmin()]
        if np.abs(signs).min() > 1e-6:
            assert e.form.index == sum(signs < 0)
            grows = growth(satellite.own, satellite.rotor, attitude[1], -(bend + bend.T) / 2)
            assert (e.decision.verdict is gs.Verdict.UNSTABLE) == (grows > 1e-6)
    assert sum((-1) ** e.form.index for e in equilibria) == 0
    assert len({tuple(np.round(p, 7)) for p in here}) == len(here)
    for e in equilibria:
        assert (e.decision.verdict is gs.Verdict.STABLE) == (e.form.index == 0)
        assert e.damped.verdict is (gs.Verdict.STABLE if e.form.index == 0 else gs.Verdict.UNSTABLE)
    return equilibria


def some(rng, kind):
    """A satellite with a tensor in any axes, and torques of one kind."""
    size = rng.choice((F(1, 40), F(1, 5), F(1)))

    def vector():
        return [F(rng.randint(-20, 20), 20) * size for _ in range(3)]

    tensor = turned([F(n, 20) for n in rng.sample(range(12, 23), 3)], rotation(rng))
    if kind == "rotor":
        return Satellite(tensor, vector())
    if kind == "drag":
        return Satellite(tensor, linear={"t": vector()})
    if kind == "dipole":
        return Satellite(tensor, linear={rng.choice("rn"): vector()})
    if kind == "free wheel":
        return Satellite(tensor, wheel=([F(2, 3), F(1, 3), F(2, 3)], F(rng.randint(1, 9), 40), size))
    if kind == "asteroid":
        part = [[F(rng.randint(-9, 9), 3) * x for x in row] for row in tensor]
        return Satellite(tensor, vector(), forms={("t", "t"): tensor, ("r", "t"): part})
    return Satellite(tensor, vector(), {a: vector() for a in "tnr"})


@pytest.mark.few(2)
@pytest.mark.parametrize("kind", ["drag", "free wheel", "sum", "rotor", "dipole", "asteroid"])
def test_none_is_missing(kind, full):
    """Random satellites against a search from many starts."""
    rng = Random(kind)
    for seed in range(sampled(100, full, 1)):
        check(some(rng, kind), seed)


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("kind", ["drag", "rotor"])
def test_axes_are_turned_with_the_body(kind, seed):
    """In axes turned by a rational rotation the same attitudes, turned, with the same verdicts and rates."""
    moments, drag, rotor = [F(1), F(5, 4), F(8, 5)], [F(1, 10), F(1, 7), 0], [F(3, 10), F(1, 20), F(1, 10)]
    turn, torques = rotation(Random(seed)), {"t": drag} if kind == "drag" else {}
    own = Satellite(turned(moments, ONE), rotor, torques).found()
    other = Satellite(turned(moments, turn), in_axes(turn, rotor),
                      {a: in_axes(turn, v) for a, v in torques.items()}).found()
    assert len(own) == len(other)
    left = [(e, sum(enclosed(e), [])) for e in other]
    with own_precision(300):
        columns = [*zip(*([arb(x.numerator) / x.denominator for x in row] for row in turn))]
        for e in own:
            here = [sum(a * b for a, b in zip(row, vector)) for vector in enclosed(e) for row in columns]
            (n,) = (n for n, (_, there) in enumerate(left)
                    if all((x - y).contains(0) for x, y in zip(here, there)))
            same, _ = left.pop(n)
            assert (e.decision, e.damped) == (same.decision, same.damped)
            assert e.doubles.frequencies == same.doubles.frequencies


def enclosed(e):
    """(n, r) in balls of a few times 10⁻²⁵ at most."""
    found = [balls(vector, 300) for vector in (e.form.n, e.form.r)]
    assert max(float(x.rad()) for vector in found for x in vector) < 1e-25
    return found


def test_a_tensor_is_answered_as_its_principal_axes_are():
    """The gravity gradient alone, a rotor in general position: as of the body in principal axes."""
    moments, rotor = [F(1), F(5, 4), F(8, 5)], [F(1, 50), F(3, 100), F(1, 25)]
    own = Satellite(turned(moments, ONE), rotor).found()
    other = Satellite(turned(moments, TURN), in_axes(TURN, rotor)).found()
    place = places(other).reshape(-1, 2, 3) @ np.array(TURN, float).T
    assert len(own) == len(other) == 24
    for e, here in zip(own, places(own).reshape(-1, 2, 3)):
        apart = np.abs(place - here).max((1, 2))
        assert apart.min() < 1e-12
        assert e.decision == other[apart.argmin()].decision


@pytest.mark.slow
@pytest.mark.parametrize(("rotor", "count", "meet"), [((1, 0, 0), 20, 2), ((3, 0, 0), 16, 2)])
def test_where_attitudes_meet(rotor, count, meet):
    """At a fork, l = ω0 (I_j − I_i), three are one: exact algebra finds it as the closed form does."""
    body = gs.Gyrostat((1, 2, 4), rotor)
    scene = gs.assemble(body, gs.circular_orbit(1))
    equilibria = list(map(RelativeEquilibrium, attitude_forms(scene)))
    assert len(equilibria) == count
    singular = [e for e in equilibria if e.form.index is None]
    assert len(singular) == meet
    assert {e.decision.verdict for e in singular} <= {gs.Verdict.UNDECIDED, gs.Verdict.UNSTABLE}
    closed = gs.relative_equilibria(scene, {})
    assert sorted(map(str, (e.point for e in closed))) == sorted(map(str, (e.point for e in equilibria)))


def test_wheels_in_rpm_at_a_height():
    """l/ω0 with π, √2 and the root of μ/a³ in it: the attitudes are those at decimals, as near as these."""
    wheels = [gs.Rotor((0, 0, 1), axial="1/100", rate=100 * pi), gs.Rotor((1, 1, 0), axial=3, rate=7)]
    tensor = [[F(621, 10), F(13, 10), 0], [F(13, 10), F(714, 10), F(3, 5)], [0, F(3, 5), F(382, 10)]]
    body, orbit = gs.gyrostat_with_rotors(tensor, wheels, lumped=True), gs.circular_orbit(mu=2, radius=3)
    equilibria = gs.relative_equilibria(gs.assemble(body, orbit), {})
    rate = F(np.sqrt(2 / 27))
    rotor = [F(float(x)) for x in body.gyrostatic_momentum]
    near = gs.relative_equilibria(gs.assemble(gs.Gyrostat(tensor, rotor), gs.circular_orbit(rate)), {})
    assert len(equilibria) == len(near)
    for e, here in zip(equilibria, places(equilibria)):
        apart = np.abs(places(near) - here).max(1)
        assert apart.min() < 1e-11
        assert (e.decision, e.damped) == (near[apart.argmin()].decision, near[apart.argmin()].damped)
    first = equilibria[0]
    assert str(first.place["n1"]) == str(first.place["n1"].evalf(17))
    copy = pickle.loads(pickle.dumps(first))
    assert copy.doubles.place == first.doubles.place


def test_a_body_of_revolution_with_drag_off_its_axis():
    """Points, though the gravity gradient alone leaves circles."""
    tensor = turned([F(3, 2), F(3, 2), F(2)], ONE)
    equilibria = check(Satellite(tensor, (0, 0, F(1, 5)), {"t": (F(1, 3), F(1, 4), F(1, 5))}), 0)
    assert not any(e.locus for e in equilibria)


@pytest.mark.slow
@pytest.mark.parametrize("c", [F(6, 7), F(-6, 7)])
def test_rates_where_a_coefficient_of_the_spectrum_vanishes(c):
    """Of the sextic that of λ²: K_roll = K_yaw, and K_pitch is minus what the other parts give."""
    t, n, r, A = F(1, 7), F(5, 7), F(9, 7), F(-10, 7)
    forms = {("r", "r"): turned([0, 0, 2 * A], ONE)}
    e = next(e for e in Satellite(turned([t, n, r], ONE), linear={"n": (0, c, 0)}, forms=forms).found()
             if e.doubles.place["n2"] == e.doubles.place["r3"] == 1)
    K = [4 * (n - r) - c - 2 * A, 3 * (t - r) - 2 * A, n - t - c]
    assert n * K[0] * K[2] + K[1] * (t * K[2] + r * K[0] + (t + r - n)**2) == 0
    roots = np.roots([float(x) for x in (n * t * r, K[1] * t * r + n * (t * K[2] + r * K[0] + (t + r - n)**2),
                                         0, K[0] * K[1] * K[2])])
    slow = sorted(np.sqrt(-x.real) for x in roots if abs(x.imag) < 1e-12 and x.real < 0)
    assert e.doubles.frequencies == pytest.approx(slow, rel=1e-12)
    assert e.doubles.growth_rate == pytest.approx(np.sqrt(roots.astype(complex)).real.max(), rel=1e-12)


@pytest.mark.parametrize(("inertia", "rotor", "potential", "what"), [
    ((1, 2, 3), (0, 0, 0), "n1^3", "degree above 2"),
    ((1, 2, 3), (0, 0, 0), "sqrt(2 + n1)", "no polynomial"),
    ((1, 2, 3), (0, 0, 0), "sqrt(1 + sqrt(2))*t1 + n2", "as decimals"),
    ((1, 1, 2), (0, 0, 0), "sqrt(2)*t3 + n3", "as decimals"),
    ((1, 1, 1), (0, 0, 0), "n1 + r2", r"about .0, 0, 1. and the frame t, n, r about .-1, 0, 0."),
    ((1, 1, 1), (0, 0, 1), "n3", "in every attitude"),
    ((2, 1, "3/2"), (0, 2, 0), "t1^2 + t2^2/2 + 3*t3^2/4", "n × ∂V/∂n")])
def test_what_is_refused(inertia, rotor, potential, what):
    """In at most 300 characters, with what there is instead."""
    scene = gs.assemble(gs.Gyrostat(inertia, rotor), gs.circular_orbit(1, potential=potential))
    with pytest.raises(gs.errors.ScopeError, match=what) as refused:
        gs.relative_equilibria(scene, {})
    assert len(str(refused.value)) <= 300


def test_the_direction_of_flight_in_a_text():
    """t1, t2, t3 are the components of n × r."""
    texts = "a*t1 + t3", "a*(n2*r3 - n3*r2) + n1*r2 - n2*r1"
    one, other = (gs.circular_orbit(1, potential=text).expression for text in texts)
    assert (one - other).expand() == 0
