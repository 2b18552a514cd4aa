"""Wells of a body of revolution in U(k3): barrier, escape, kicks, against a line that is filled up."""
from random import Random

import numpy as np
import pytest
from filled_line import Line, greatest_angle
from sympy import Rational, S, expand, integrate, oo

import gyrostat as gs
from gyrostat.equilibria.wells.tilts import NO_MINIMUM, ROUND, TURNS, WALLS, tilt_well
from gyrostat.errors import ScopeError, ValuesError

KINDS = ("E1", "E2", "tilted", "at a pole's level", "damped")


def body(I1, I3, l, U):
    field = gs.axial_potential(sum((u * gs.symbol("k3")**n for n, u in enumerate(U)), S.Zero))
    return gs.assemble(gs.Gyrostat((I1, I1, I3), (0, 0, l)), field)


def drawn(kind, random):
    """(scene, its Line, the rotations of a level): fractions of which one rotation is as the kind says."""
    def fraction(low, high, d):
        return Rational(random.randint(low * d, high * d), d)

    while True:
        I1, I3, l, P = fraction(1, 3, 4), fraction(1, 3, 4), fraction(-1, 1, 4), fraction(-2, 2, 4)
        U = [S.Zero, *(fraction(-4, 4, 2) for _ in range(random.randint(1, 4)))]
        k3, omega = Rational(random.randint(-7, 7), 8), fraction(-2, 2, 2)
        if I3 > 2 * I1 or not omega or not any(U):
            continue
        if kind == "damped":
            scene = body(I1, I3, l, U)
            motions = [e for e in gs.relative_equilibria(scene, {"omega": omega}) if e.label in ("E1", "E2")]
            motion = random.choice(motions)
            level = (motion.place["pi3"] + l) * motion.place["k3"]
            return scene, Line(U, I1, I3, l, level), [motion]
        level = {"E1": P, "E2": -P}.get(kind)
        if level is None:
            P = I1 * omega * (1 + k3) if kind == "at a pole's level" else P
            level = I1 * omega * (1 - k3**2) + P * k3
            U[1] += P * omega - I1 * k3 * omega**2 - sum(n * u * k3 ** (n - 1) for n, u in enumerate(U) if n)
        scene = body(I1, I3, l, U)
        motions = gs.relative_equilibria(scene, {"pi3_0": P - l, "C1": level})
        if not any(m.locus for m in motions):
            return scene, Line(U, I1, I3, l, level, P - l), motions


def close(exact, number, scale):
    return exact == number if oo in (exact, number) else abs(float(exact) - number) < 1e-9 * scale


@pytest.mark.few(10)
@pytest.mark.parametrize("seed", range(60))
def test_the_barrier_is_where_a_filled_line_first_runs_over(seed):
    """Barrier and escape are those of a fill of [−1, 1] on a grid that knows no critical point."""
    _, line, motions = drawn(KINDS[seed % len(KINDS)], Random(seed))
    for motion in motions:
        k3 = float(motion.place["k3"])
        well = tilt_well(motion, damped=line.damped)
        scale = 1 + abs(line.height(np.linspace(-0.99, 0.99, 99))).max()
        barrier, escape = line.rise(k3)
        if well.barrier is None:
            assert barrier < 1e-9 * scale and well.reason == NO_MINIMUM and well.kick is None
            continue
        assert barrier > 0 and close(well.barrier, barrier, scale) and close(well.escape, escape, scale)
        assert (well.reason == "") == (well.escape < oo) and bool(well.passes) == (well.barrier < oo)
        assert all(p.height - well.barrier - line.height(np.array([k3]))[0] < 1e-9 * scale
                   and (p.kind == "summit") == (p.k3**2 == 1) for p in well.passes)


@pytest.mark.few(6)
@pytest.mark.parametrize("seed", range(60, 120))
def test_the_kick_within_an_angle_is_the_greatest_height_on_the_way(seed):
    """√(2 I1 E) with E the greatest V between the tilt and the nearer tilt an angle away."""
    random = Random(seed)
    _, line, motions = drawn(KINDS[seed % len(KINDS)], random)
    for motion in motions:
        well, degrees = tilt_well(motion, damped=line.damped), random.randint(1, 170)
        if well.barrier is None:
            with pytest.raises(ScopeError, match=f"within {degrees}°: its tilt is no strict minimum"):
                well.within(degrees)
            continue
        rise = line.within(float(motion.place["k3"]), np.radians(degrees))
        assert close(well.within(degrees), rise, 1e3)
        assert close(well.kick_within(degrees) ** 2 / (2 * well.moment), rise, 1e3)


@pytest.mark.parametrize("fraction, least, most", [(0.999, 9.9, 10), (1.001, 10, 10.1)])
def test_a_kick_keeps_a_sleeping_top_within_an_angle(fraction, least, most):
    """Motions of the Euler-Poisson equations with 0.999 and 1.001 of the kick of 10°."""
    scene = body(1, Rational(8, 5), Rational(1, 3), [0, 1, Rational(1, 2)])
    motion = gs.relative_equilibria(scene, {"omega": 2})[0]
    kick = float(tilt_well(motion).kick_within(10))
    assert least < greatest_angle([0, 1, 0.5], 1, 1.6, 1 / 3, 3.2, fraction * kick, 12) < most


def test_values_of_the_theory():
    """Two wells of U = k3⁴ − k3²/2, and a top that sleeps for ever, but not under damping."""
    scene = body(2, 1, Rational(1, 2), [0, 0, -Rational(1, 2), 0, 1])
    upper, middle, lower = gs.relative_equilibria(scene, {"pi3_0": 0, "C1": Rational(1, 10)})
    assert [str(tilt_well(e).barrier.n(15)) for e in (lower, upper)] == ["0.0307728698111402",
                                                                       "0.0586704230832507"]
    assert [str(tilt_well(e).passes[0].k3.n(15)) for e in (lower, upper)] == ["-0.0289263893172080"] * 2
    assert tilt_well(middle).barrier is None
    sleeping = gs.relative_equilibria(body(1, Rational(8, 5), 0, [0, 1]), {"omega": Rational(3, 2)})[0]
    assert (well := tilt_well(sleeping)).barrier == well.escape == well.kick == oo and well.reason == WALLS
    assert str(well.kick_within(10).n(15)) == "0.117064424992385"
    damped = tilt_well(sleeping, damped=True)
    assert [str(x.n(15)) for x in (damped.passes[0].k3, damped.barrier, damped.kick)] == [
        "0.327885244991177", "0.233367464231220", "0.683180011755643"]


def test_a_shelf_is_touched_but_is_no_way_out():
    """U' = (z − 1/4)² (z + 1/2) without spin: a shelf at 1/4; times 3/4 − z, a way out behind it."""
    z, found = gs.symbol("k3"), []
    for slope in ((z - Rational(1, 4))**2 * (z + Rational(1, 2)) * f for f in (1, Rational(3, 4) - z)):
        field = gs.axial_potential(integrate(expand(slope), z))
        scene = gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), field)
        motions = {m.place["k3"]: m for m in gs.relative_equilibria(scene, {"pi3_0": 0, "C1": 0})}
        found.append(well := tilt_well(motions[-Rational(1, 2)]))
        assert tilt_well(motions[Rational(1, 4)]).reason == NO_MINIMUM
        assert [(p.k3, p.kind) for p in well.passes] in ([(Rational(1, 4), "shelf")], [(-1, "summit")])
    closed, way = found
    assert closed.escape == oo and closed.reason == ROUND
    assert way.reason == "" and way.barrier < way.escape == way.potential.subs(z, Rational(3, 4)) - (
        way.potential.subs(z, -Rational(1, 2)))


def test_a_potential_that_is_infinite_is_a_wall():
    """U = 1/(2 k3 − 1)² stops every tilt; −1/(2 k3 − 1)² lets it fall."""
    field, k3 = gs.axial_potential, gs.symbol("k3")
    tops = [gs.assemble(gs.Gyrostat((1, 1, 1), (0, 0, 0)), field(k3 + s / (2 * k3 - 1)**2)) for s in (1, -1)]
    held, falls = (tilt_well(gs.relative_equilibria(top, {"omega": 8})[0]) for top in tops)
    assert held.escape == oo and held.reason == WALLS and held.within(90) == oo
    assert falls.escape < oo and falls.reason == "" and falls.within(90) == falls.barrier


def test_what_has_no_well_says_why():
    """A precession is none under damping; a satellite is no body of revolution in U(k3)."""
    scene = body(2, 1, Rational(1, 2), [0, 0, -Rational(1, 2), 0, 1])
    precession = gs.relative_equilibria(scene, {"pi3_0": 0, "C1": Rational(1, 10)})[0]
    assert tilt_well(precession, damped=True).reason == TURNS
    with pytest.raises(ValuesError, match="choose one above 0°, below 180°"):
        tilt_well(precession).within(180)
    satellite = gs.assemble(gs.Gyrostat((3, 4, 5), (0, 0, 0)), gs.circular_orbit(1))
    with pytest.raises(ScopeError, match="no motion of a body of revolution"):
        tilt_well(gs.relative_equilibria(satellite, {})[0])
