"""Barriers of stable rotations: numbers of another program, floods, kicks, and what has none."""
import math
import random
from fractions import Fraction

import numpy as np
import pytest
from oracles.flooded import cell_of, escape, frames, shape, sphere
from scipy.spatial.transform import Rotation
from sympy import Rational

import gyrostat as gs
from gyrostat.errors import ScopeError, ValuesError

SUM = gs.general_potential("k1 + k2 + k3")
HEAVY = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), SUM)


def stable(scene, values):
    """The stable equilibria whose energy has a minimum or a maximum."""
    found = [e for e in gs.relative_equilibria(scene, values) if e.decision.stable]
    return [e for e in found if e.well.barrier_double is not None]


def satellite(moments, rotor, rate=1):
    return gs.assemble(gs.Gyrostat(moments, rotor), gs.circular_orbit(rate))


# computed by Newton's method at 40 digits and by paths, in another program
@pytest.mark.parametrize(("scene", "values", "barriers", "kind"), [
    (HEAVY, {"C1": "5/2"}, [1.86180390026476], "round"),
    (gs.assemble(gs.Gyrostat(("5/4", 2, "11/4"), (1, "-1/2", 2)), gs.general_potential("k1/2 + k2/3 + k3")),
     {"C1": "1/4"}, [1.09793976914391], "round"),
    (gs.assemble(gs.Gyrostat((1, 2, 3), ("1/10", "1/5", "1/7"))), {"M": 1},
     [0.252560194019127, 0.0729304362154052, 0.268165321903604], None),
    (gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/4"))), {"M": 1}, [3 / 16, 1 / 48, 15 / 64, 15 / 64], None),
    (satellite((60, 70, 35), (0, 0, 0)), {}, [5] * 4, "well"),
    (satellite((1, "5/4", "8/5"), ("3/10", "1/5", "1/10")), {}, [0.367293882640091] * 2, "well"),
    (satellite((1, "7/10", "4/5"), (0, "1/2", 0)), {}, [23 / 240] * 2, "well"),
    (satellite((60, 70, 35), (0, 5, 0)), {}, [45 / 4] * 2 + [5 / 4] * 2, "well")])
def test_barriers_that_another_program_has_found(scene, values, barriers, kind):
    """To 15 digits, and at which kind of pass."""
    found = [e.well for e in stable(scene, values)]
    assert sorted(w.barrier_double for w in found) == pytest.approx(sorted(barriers), rel=3e-15)
    assert kind is None or {w.kind for w in found} == {kind}


def test_the_barrier_is_exact():
    """A fraction where it is one; an algebraic number whose digits are those of the balls."""
    found = stable(satellite((60, 70, 35), (0, 5, 0)), {})
    assert sorted(e.well.barrier for e in found) == [Rational(5, 4)] * 2 + [Rational(45, 4)] * 2
    free = stable(gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, "1/4"))), {"M": 1})
    assert sorted(e.well.barrier for e in free) == [Rational(1, 48), Rational(3, 16), *[Rational(15, 64)] * 2]
    top, *_ = stable(HEAVY, {"C1": "5/2"})
    assert float(top.well.barrier.evalf(20)) == top.well.barrier_double
    assert top.well.escape == math.inf and top.well.beyond == () and len(top.well.passes) == 1


def test_kicks():
    """Numbers of the other program; along an axis they are at least as strong as the weakest."""
    top, *_ = stable(HEAVY, {"C1": "5/2"})
    assert top.well.kick(level=True) == pytest.approx(2.02880462166252, rel=1e-14)
    assert top.well.kick() == pytest.approx(2.46273204849046, rel=1e-14)
    with pytest.raises(ValuesError, match="not across k"):
        top.well.kick((0, 0, 1), level=True)
    craft, *_ = stable(satellite((60, 70, 35), (0, 0, 0)), {})
    assert math.sqrt(350) * (1 - 1e-15) < craft.well.kick() < math.sqrt(350)
    each = [craft.well.kick([int(n == m) for m in range(3)]) for n in range(3)]
    assert each == pytest.approx([math.sqrt(2 * 5 * I) for I in (60, 70, 35)], rel=1e-15)
    with pytest.raises(ValuesError, match="direction"):
        craft.well.kick((0, 0, 0))


def test_the_kick_of_a_sphere():
    """All directions are equal: the two stiffnesses across k coincide."""
    scene = gs.assemble(gs.Gyrostat((2, 2, 2), (0, 0, 1)), gs.general_potential("k1 + 2*k3"))
    well = stable(scene, {"C1": 1})[0].well
    assert well.kick(level=True) == pytest.approx(math.sqrt(4 * well.barrier_double), rel=1e-14)


@pytest.mark.parametrize("rotor", [(0, 0, 0), (0, 5, 0), (1, 2, 3)])
def test_tilts_at_rest(rotor):
    """Along every turn below the angle V is below the pass; without a rotor the angle is the theory's."""
    moments, l = np.array([60, 70, 35.0]), np.array(rotor, dtype=float)
    rng = np.random.default_rng(3)
    for e in stable(satellite((60, 70, 35), rotor), {}):
        n, r = (np.array([e.doubles.place[f"{v}{m}"] for m in (1, 2, 3)]) for v in "nr")
        axes = rng.normal(size=(500, 3))
        axes /= np.linalg.norm(axes, axis=1)[:, None]
        for share in (0.3, 0.7, 0.999):
            turns = Rotation.from_rotvec(np.radians(e.well.tilt()) * share * axes)
            N, R = turns.apply(n), turns.apply(r)
            V = 1.5 * R**2 @ moments - 0.5 * N**2 @ moments - N @ l
            here = 1.5 * r**2 @ moments - 0.5 * n**2 @ moments - n @ l
            assert np.all(V - here < e.well.barrier_double)
            assert not any(rotor) or np.max(V - here) > 0.3 * share**2 * e.well.barrier_double
        if not any(rotor):
            assert e.well.tilt() == pytest.approx(15.5013595669370, rel=1e-14)
    with pytest.raises(ScopeError, match="gravity gradient"):
        stable(HEAVY, {"C1": "5/2"})[0].well.tilt()


def test_kicks_within_an_angle():
    """Every scene whose vertical axis is followed has them; numbers of the other program."""
    top, *_ = stable(HEAVY, {"C1": "5/2"})
    assert top.well.within(10, level=True) == pytest.approx(0.206108123741844, rel=1e-14)
    assert top.well.within("10 deg", level=True) == top.well.within(10, level=True) > top.well.within(10)
    body = gs.assemble(gs.Gyrostat((1, 1, "8/5"), (0, 0, 0)), gs.axial_potential("k3"))
    sleeping = gs.relative_equilibria(body, {"omega": "3/2"})[0].well
    assert sleeping.within(10) == pytest.approx(0.117064424992385, rel=1e-14)
    with pytest.raises(ScopeError, match="body in a field"):
        stable(satellite((60, 70, 35), (0, 0, 0)), {})[0].well.within(10)


def test_the_size_of_a_scene_does_not_matter():
    """In SI a satellite's barriers are ω0² times those at the rate 1; all but the rate is the same."""
    small, large = (stable(satellite((60, 70, 35), (0, 0, 0), rate), {})[0] for rate in ("11/10000", 1))
    assert small.well.barrier_double == pytest.approx(large.well.barrier_double * 0.0011**2, rel=1e-14)


def heavy(chance):
    """A body, a field of degree 2 and a level, at random fractions."""
    while True:
        I = [Fraction(chance.randint(4, 16), 4) for _ in range(3)]
        if 2 * max(I) < sum(I) and len(set(I)) == 3:
            break
    l, c, q = ([Fraction(chance.randint(-6, 6), 4) for _ in range(3)] for _ in range(3))
    return I, l, c, [x * chance.randint(0, 1) for x in q], Fraction(chance.randint(-8, 8), 4)


def amended(I, l, c, q, level):
    """U_c of arrays of directions, written out."""
    I, l, c, q = (np.array(x, dtype=float) for x in (I, l, c, q))
    return lambda k: k @ c + k**2 @ q + (float(level) - k @ l)**2 / (2 * k**2 @ I)


@pytest.mark.few(2)
@pytest.mark.parametrize("seed", range(12))
def test_heavy_wells_are_those_of_a_flood(seed):
    """Below its barrier the well is a disc with one minimum; above, it has a hole, a neighbour, or is all."""
    chance = random.Random(seed)
    for _ in range(3):
        I, l, c, q, level = heavy(chance)
        field = " + ".join(f"({a})*k{n} + ({b})*k{n}^2" for n, (a, b) in enumerate(zip(c, q), 1))
        scene = gs.assemble(gs.Gyrostat(I, l), gs.general_potential(field))
        V = amended(I, l, c, q, level)
        found = stable(scene, {"C1": level}) if any(c) else []
        for e in [e for e in found if e.well.barrier_double > 0.05][:1]:
            k = np.array([e.doubles.place[f"k{n}"] for n in (1, 2, 3)])
            low, rise = float(V(k)), e.well.barrier_double
            values = sphere(lambda x, V=V, k=k, low=low: np.where(x @ k > 1 - 1e-3, low - 1, V(x)))
            inside, rest = shape(values, low + 0.97 * rise)
            assert rest == 1
            inside, rest = shape(values, low + 1.03 * rise)
            near = [float(h.mid()) for h in e.well.heights if rise < float(h.mid()) < 1.06 * rise]
            if not near and e.well.kind == "round":
                assert rest > 1
            if not near and e.well.kind == "summit":
                assert rest == 0
            if not near and e.well.kind == "well":
                near = [np.array([o.doubles.place[f"k{n}"] for n in (1, 2, 3)]) for o in e.well.beyond]
                assert all(inside[cell_of(k)] for k in near)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_wells_of_satellites_are_those_of_a_flood(seed):
    """The escape of the lowest attitude from its twins, on a grid of 2·10⁵ attitudes."""
    chance = random.Random(seed)
    while True:
        I = [Fraction(chance.randint(16, 40), 16) for _ in range(3)]
        if 2 * max(I) < sum(I) and len(set(I)) == 3:
            break
    l = [Fraction(chance.randint(-4, 4), 16) for _ in range(3)]
    found = stable(satellite(I, l), {})
    e = min(found, key=lambda e: float(e.energy.evalf(8)))
    n, r = frames(36)
    moments, rotor = (np.array(x, dtype=float) for x in (I, l))
    values = 1.5 * r**2 @ moments - 0.5 * n**2 @ moments - n @ rotor

    def cell(e):
        place = [np.array([e.doubles.place[f"{v}{m}"] for m in (1, 2, 3)]) for v in "nr"]
        return np.unravel_index(np.argmax(n @ place[0] + r @ place[1]), values.shape)

    start = tuple(map(int, cell(e)))
    goals = {tuple(map(int, cell(other))) for other in found} - {start}
    top = escape(values, start, goals) - float(e.energy.evalf(15))
    assert top == pytest.approx(e.well.escape_double, abs=0.03 * max(moments))


def test_what_has_no_well_says_why():
    """Unstable; held by gyroscopic forces; a level that is no fraction; a field of higher degree."""
    for e in gs.relative_equilibria(HEAVY, {"C1": "5/2"}):
        if not e.decision.stable:
            assert e.well.barrier is None and "not stable" in e.well.reason
        elif e.form.index:
            assert e.well.barrier is None and "gyroscopic" in e.well.reason
            with pytest.raises(ScopeError, match="gyroscopic"):
                e.well.kick(level=True)
    turning = next(e for e in gs.relative_equilibria(HEAVY, {"omega": "1/2"}) if not e.form.index)
    assert turning.well.barrier is None and "C1 is no fraction" in turning.well.reason
    cubic = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, 1)), gs.general_potential("k1^3 + k2 + k3"))
    top = next(e for e in gs.relative_equilibria(cubic, {"C1": "5/2"}) if e.form.index == 0)
    assert "dimple" in top.well.reason and top.well.barrier_double is None and top.well.kind == ""


def test_a_body_of_revolution_has_the_well_of_its_tilt():
    """A sleeping top has walls at every energy; a precession between two wells of U has a pass."""
    top = gs.assemble(gs.Gyrostat((1, 1, "8/5"), (0, 0, 0)), gs.axial_potential("k3"))
    sleeping = gs.relative_equilibria(top, {"omega": "3/2"})[0].well
    assert sleeping.barrier == sleeping.kick(level=True) == math.inf and "walls" in sleeping.reason
    double = gs.assemble(gs.Gyrostat((2, 2, 1), (0, 0, 0)), gs.axial_potential("k3^4 - k3^2/2"))
    found = [e.well for e in gs.relative_equilibria(double, {"pi3_0": "1/2", "C1": "1/10"})
             if e.decision.stable]
    assert sorted(w.barrier_double for w in found) == pytest.approx([0.0307728698111402, 0.0586704230832507])


def test_which_wells_come_back_under_damping():
    """A minimum does, if no other motion has a constant rate in the body; a maximum does not."""
    free = stable(gs.assemble(gs.Gyrostat((1, 2, 3), ("1/10", "1/5", "1/7"))), {"M": 1})
    assert sorted(e.well.damped for e in free) == [False, False, True]
    assert [e.well.damped for e in free] == [e.form.index == 0 for e in free]
    assert stable(HEAVY, {"C1": "5/2"})[0].well.damped is True
    assert stable(satellite((60, 70, 35), (0, 5, 0)), {})[0].well.damped is True
