"""Scenes in other units: kilograms, metres and seconds times powers of ten change no verdict and no count."""
from fractions import Fraction as F

import numpy as np
import pytest
from stability.units import Units
from sympy import Rational

import gyrostat as gs

OTHERS = [(24, 6, 8), (-26, -10, -13), *(pytest.param(*[powers], marks=pytest.mark.slow) for powers in (
    (100, -50, 30), (-100, 20, 50), (0, 0, 100), (0, 0, -100)))]
TOP = {"I1": 2, "I3": 1, "l": F(1, 3), "m0": 3}


def said(decisions):
    """Verdicts, and whether they are modulo a group."""
    return [(d.verdict.name, d.modulo != ()) for d in decisions]


def body(u, moments, rotor=(0, 0, 0)):
    """With three moments and a rotor."""
    return gs.Gyrostat([u(x, "I") for x in moments], [u(x, "l") for x in rotor])


def heavy(u, rotor=(0, 0, 0), c=(1, 2, 3)):
    """A body in a uniform field of any direction."""
    weights = [str(u(x, "m0")) for x in c]
    return gs.assemble(body(u, (1, 2, 3), rotor), gs.general_potential("+".join(
        f"({x})*k{n}" for n, x in enumerate(weights, 1))))


def satellite(u, rotor=(0, 0, 0)):
    """In a circular orbit."""
    return gs.assemble(body(u, (1, F(5, 4), F(8, 5)), rotor), gs.circular_orbit(u(1, "omega")))


def upright(u):
    """E1, at numbers and as floats, with damping, itself, where it is stable, and in a chart."""
    top, spins = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), (1, 3, 5)
    report = gs.analyze(gs.upright(top))
    at = [u.values(**TOP, pi3_0=p) for p in spins]
    fixed = {name: float(x) for name, x in u.values(**TOP).items() if name in report.required}
    found = gs.stabilizing_set(report, "l", {n: x for n, x in at[1].items() if n not in ("l", "I3")})
    return [said([report.verdict(v), report.verdict(v, damped=True), report.itself(v)]) for v in at], said(
        report.verdict({name: float(x) for name, x in v.items()}) for v in at), gs.charts.verdicts(
        report, **fixed, pi3_0=[float(u(p, "pi")) for p in spins]).tolist(), [
        len(case.intervals) for part in found.parts for case in part.cases]


def lists_of_a_top(u):
    """Every precession at a rate, continuation over it, and where branches meet."""
    scene, numbers = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), u.values(**TOP)
    found = gs.relative_equilibria(scene, numbers | u.values(omega=5))
    along = gs.continuation(scene, "omega", (u(F(1, 2), "omega"), u(3, "omega")), numbers)
    points = gs.bifurcation_points(scene, "pi3_0", numbers)
    return [(b.label, *said([b.decision])) for b in found], [m.kind for m in along.marks], [
        p.kind for p in points], [(p.label, p.verdict) for p in along.pieces]


def heavy_bodies(u):
    """At a rate, on a level, and over a range of rates."""
    along = gs.continuation(heavy(u), "omega", (u(1, "omega"), u(2, "omega")), {})
    return [said([r.decision, r.damped]) for asked in ({"omega": u(2, "omega")}, {"C1": u(2, "C")})
            for rotor in ((0, 0, 0), (0, F(1, 2), 1))
            for r in gs.relative_equilibria(heavy(u, rotor), asked)], [p.verdict for p in along.pieces]


def windows(u):
    """E1 of an asymmetric body: verdicts, resonances."""
    report = gs.analyze(gs.upright(heavy(u, c=(0, 0, 3))))
    return said([report.verdict(u.values(pi3_0=p)) for p in (1, 5, 9, 12)]), len(report.window({}).resonances)


def free_bodies(u):
    """Every rotation of a level, about the axes, and along a rotor."""
    rotors = ((0, 0, 0), (0, 0, 1), (1, F(1, 2), F(1, 3)))
    return [said([r.decision, r.damped]) for rotor in rotors for r in gs.relative_equilibria(
        gs.assemble(body(u, (1, 2, F(5, 2)), rotor)), {"M": u(1, "M")})]


def satellites(u):
    """Every attitude, and the Earth-pointing one."""
    report = gs.analyze(gs.earth_pointing(satellite(u, (0, F(1, 10), 0))))
    return [said([r.decision, r.damped]) for rotor in ((0, 0, 0), (F(1, 10), F(1, 5), F(3, 10)))
            for r in gs.relative_equilibria(satellite(u, rotor), {})], said([
                report.verdict({}), report.verdict({}, damped=True)])


def rates(u):
    """Frequencies and growth rates in lists of each kind, in units of time."""
    unit = Rational(*u(1, "omega").as_integer_ratio())
    top = gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field())
    lists = ((heavy(u, (0, F(1, 2), 1)), {"omega": u(2, "omega")}), (top, u.values(**TOP, omega=2)),
             (gs.assemble(body(u, (1, 2, F(5, 2)), (1, F(1, 2), F(1, 3)))), {"M": u(1, "M")}),
             (satellite(u, (F(1, 10), F(1, 5), F(3, 10))), {}))
    return [[f"{float((x / unit).evalf(20)):.9e}" for x in (*e.frequencies, e.growth_rate) if x is not None]
            for scene, values in lists for e in gs.relative_equilibria(scene, values)]


def precessions(u):
    """Of a satellite of revolution: in a well, unstable, a ball; itself, and under damping."""
    scene = gs.assemble(gs.symmetric_gyrostat(), gs.circular_orbit())
    reports = [gs.analyze(gs.orbital_precession(scene, kind)) for kind in ("conical", "hyperbolic")]
    at = [u.values(I1=1, I3=x, omega0=1) | {"n3": F(3, 4)} for x in (F(1, 2), F(9, 5), 1)]
    return [said([r.verdict(v), r.verdict(v, damped=True), r.itself(v)]) for r in reports for v in at]


def two_directions(u):
    """A vehicle that rises, in three weights; a body at rest in two constant fields."""
    def rising(weight):
        D = [[0, -u(F(3, 10), (1, 1, 0)), 0], [u(F(3, 10), (1, 1, 0)), 0, 0], [0, 0, 0]]
        scene = gs.underwater_vehicle([u(1, "I")] * 3, [u(x, "mass") for x in (2, 2, 1)], D,
                                      weight=(0, 0, u(weight, "m0")))
        return gs.analyze(gs.steady_motion(scene, (0, 0, u(2, "impulse")), (0, 0, 1),
                                           omega=(0, 0, u(1, "omega"))))

    a, b = u(2, "m0"), u(1, "m0")
    fields = gs.coupled_potential(f"-({a})*k1 - ({b})*e2", ("k", "e"))
    rests = [gs.analyze(gs.steady_motion(gs.assemble(body(u, (1, 2, F(5, 2))), fields), k, (0, 1, 0)))
             for k in ((1, 0, 0), (-1, 0, 0))]
    return [said([r.verdict({}), r.verdict({}, damped=True)]) for r in (*map(rising, (5, 1)), *rests)]


def motions(u):
    """The route and the period, in units of time."""
    state, top = [u(F(x), "pi") for x in ("0.3", "-0.2", "1.5")], gs.assemble(
        gs.symmetric_gyrostat(), gs.uniform_field())
    found = [gs.trajectories.motion(top, [*state, F(3, 5), 0, F(4, 5)], u.values(**TOP)),
             gs.trajectories.motion(gs.assemble(body(u, (1, 2, 3))), state),
             gs.trajectories.motion(gs.assemble(body(u, (1, 2, 3), (0, F(1, 2), 1))), state)]
    return [(motion.route, round(motion.period / float(u(1, (0, 0, 1))), 9)) for motion in found]


@pytest.mark.slow
@pytest.mark.parametrize("powers", [(100, -50, 30), (0, 0, 100)], ids=str)
def test_arcs_are_the_same_in_other_units_of_time_and_torque(powers):
    """Along the cone of Staude, of moments near 1."""
    def arcs(u):
        return [[p.decision.verdict for p in a.pieces] for a in gs.staude_cone(heavy(u)).arcs({})]

    assert arcs(Units(*powers)) == arcs(Units())


@pytest.mark.few(1)
@pytest.mark.parametrize("powers", OTHERS, ids=str)
@pytest.mark.parametrize("question", [upright, lists_of_a_top, heavy_bodies, windows, free_bodies, satellites,
                                      rates, precessions, two_directions, motions])
def test_units_change_nothing(question, powers):
    """The Moon in SI, a molecule in SI, and what is far beyond both: the answers are those near 1."""
    np.testing.assert_equal(question(Units(*powers)), question(Units()))
