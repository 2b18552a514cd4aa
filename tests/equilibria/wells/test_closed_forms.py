"""Wells of free gyrostats and satellites in closed form: every case, against spheres that are filled up."""
from random import Random

import numpy as np
import pytest
from filled_sphere import frames, free, lowest_way, satellite
from scipy.integrate import solve_ivp
from sympy import Max, Min, Piecewise, Poly, Rational, S, rad

import gyrostat as gs
from gyrostat.equilibria.wells.closed_forms import THETA, Z, closed_forms

AXES = [(1, 2, 3), (2, 3, 1), (3, 1, 2), (2, 1, 3), (1, 3, 2), (3, 2, 1)]


def fraction(random, low, high, d):
    return Rational(random.randint(low * d, high * d), d)


def moments(random, d=8):
    while True:
        I = [fraction(random, 1, 3, d) for _ in range(3)]
        if 2 * max(I) <= sum(I) and len(set(I)) == 3:
            return I


def placed(values, axes):
    """The value of the first at the first of the axes, and so on."""
    return tuple(dict(zip(axes, values))[n] for n in (1, 2, 3))


def named(form, numbers):
    """A form at numbers, by name."""
    return form.at({gs.symbol(name): S(x) for name, x in numbers.items()})


SPINS = {  # on the sphere of M = I3 ω + l: which energy, of a = 1/I − 1/I3 and λ = l/I3 the case
    "least, saddle": (1, lambda a, x: abs(x) < a),
    "least, the other end": (1, lambda a, x: 0 < a <= abs(x)),
    "least by the rotor": (1, lambda a, x: a <= 0 < a + x),
    "greatest, saddle": (-1, lambda a, x: abs(x) < a),
    "greatest, the other end": (-1, lambda a, x: 0 < a <= abs(x)),
    "greatest by the rotor": (-1, lambda a, x: a <= 0 < a + x),
}


@pytest.mark.few(6)
@pytest.mark.parametrize("seed", range(24))
def test_a_free_gyrostat_against_a_filled_sphere(seed):
    """The barrier of a rotation of least or greatest energy is the lowest way to another rest."""
    random, (s, case) = Random(seed), list(SPINS.values())[seed // 4]
    while True:
        I, M, l = moments(random), fraction(random, 1, 2, 4), fraction(random, -4, 4, 16)
        a = s * (1 / (Max if s == 1 else Min)(I[0], I[1]) - 1 / I[2])
        if l and case(a * M, s * l / I[2]) and a * M + s * l / I[2] > 0:
            break
    axes = random.choice(AXES)
    scene = gs.assemble(gs.Gyrostat(("I1", "I2", "I3"), placed((0, 0, gs.symbol("l")), axes)))
    numbers = {f"I{n}": x for n, x in zip(axes, I)} | {"l": l, f"omega{axes[2]}_0": (M - l) / I[2]}
    forms = [there for form in closed_forms(gs.principal_rotation(scene, axes[2]))
             if (there := named(form, numbers)) is not None]
    [form] = [f for f in forms if ("has the least" in f.scene) == (s == 1)]
    h = free(I, (0, 0, l), float(M))
    assert (form.kick is None) == (abs(l) / I[2] >= a * M)
    height, _ = lowest_way(lambda x: s * h(x), (0, 0, 1), np.random.default_rng(seed), False, 2000)
    assert abs(height - s * h(np.array([0, 0, 1.0])) - float(form.barrier)) < 1e-4 * float(M)**2


@pytest.mark.parametrize(("moments", "l", "to_rest"), [
    ((1, 2, 3), "1/4", False), ((2, "21/10", 3), "1/5", True), ((2, "21/10", 3), "-1/8", False),
    (("5/2", 2, 1), "-1/5", True), (("5/2", 2, 1), "1/5", False), ((1, 2, 3), 0, False)])
def test_the_smallest_kick_is_that_of_the_planes(moments, l, to_rest):
    """Also where a kick of -M, to rest, is smaller than the way to a plane."""
    axis = gs.principal_rotation(gs.assemble(gs.Gyrostat(("I1", "I2", "I3"), (0, 0, "l"))), 3)
    values = dict(zip(("I1", "I2", "I3"), moments)) | {"l": l}
    values["omega3_0"] = (1 - Rational(l)) / Rational(moments[2])
    forms = [f.at({gs.symbol(n): Rational(x) for n, x in values.items()}) for f in closed_forms(axis)]
    [form] = [form for form in forms if form]
    found = gs.relative_equilibria(gs.assemble(gs.Gyrostat(moments, (0, 0, l))), {"M": 1})
    [spin] = [e for e in found if e.momentum == (0, 0, 1)]
    assert float(form.kick) == pytest.approx(spin.well.kick(), rel=1e-13)
    assert (form.kick == 1) == to_rest


@pytest.mark.parametrize("factor, leaves", [(0.99, False), (1.01, True)])
def test_the_smallest_kick_of_a_free_gyrostat(factor, leaves):
    """Of M = (0, 0, 1), l = (0, 0, 1/4), I = (1, 2, 3): 3/4, towards the plane of the separatrices."""
    body = gs.Gyrostat(("I1", "I2", "I3"), (0, 0, "l"))
    form = named(closed_forms(gs.principal_rotation(gs.assemble(body), 3))[0],
                 {"I1": 1, "I2": 2, "I3": 3, "l": Rational(1, 4), "omega3_0": Rational(1, 4)})
    assert form.kick == Rational(3, 4) and form.barrier == Rational(3, 16)
    a1, a2 = 2 / 3, 1 / 6
    M = np.array([0, 0, 1]) + factor * 0.75 * np.array([np.sqrt(a1 - a2), 0, -np.sqrt(a2)]) / np.sqrt(a1)

    def field(_, M):
        return np.cross(M, (M - [0, 0, 0.25]) / [1, 2, 3])

    turned = solve_ivp(field, (0, 400), M, rtol=1e-10, atol=1e-12).y
    # inside it goes round axis 3, outside M1 keeps its sign
    assert (turned[0].min() > 0) == leaves


# at l = ω0 D the other end is degenerate, and differences do not find it
WHEELS = {  # of D/roll moment, l/ω0: which of the two ways is the lower, and its case
    "yaw, saddle": (False, lambda D, l, Y, P: Y < P and abs(l) < D),
    "yaw, the other end": (False, lambda D, l, Y, P: Y < P and l > D > 0),
    "yaw, smaller pitch moment": (False, lambda D, l, Y, P: Y < P and D < 0),
    "pitch": (False, lambda D, l, Y, P: P < Y and D > 0),
    "pitch, by rolling": (False, lambda D, l, Y, P: P < Y and l < -4 * D),
    "pitch, without rolling": (False, lambda D, l, Y, P: P < Y and D < 0 and l >= -4 * D),
    "rigid, yaw": (True, lambda D, l, Y, P: Y < P),
    "rigid, pitch": (True, lambda D, l, Y, P: P < Y),
}


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(32))
def test_a_satellite_against_filled_rotations(seed):
    """The barrier of an Earth-pointing satellite is the lowest way on SO(3) to another rest."""
    random, (rigid, case) = Random(seed), list(WHEELS.values())[seed // 4]
    while True:
        I, l = moments(random, 16), S.Zero if rigid else fraction(random, -2, 4, 8)
        D = I[1] - I[0]
        if not (I[0] > I[2] and l + D > 0 and l + 4 * (I[1] - I[2]) > 0):
            continue
        Y = (D + l)**2 / (2 * D) if abs(l) < D else 2 * l
        P = 3 * (I[0] - I[2]) / 2 - (max(0, -4 * D - l)**2 / (-8 * D) if D < 0 else 0)
        if abs(Y - P) > 0.01 and case(D, l, Y, P):
            break
    axes, rate = random.choice(AXES), Rational(random.randint(1, 4), 2)
    scene = gs.assemble(gs.Gyrostat(("I1", "I2", "I3"), placed((0, 0 if rigid else "l", 0), axes)),
                        gs.circular_orbit())
    [form] = closed_forms(gs.earth_pointing(scene, *axes))
    there = named(form, {f"I{n}": x for n, x in zip(axes, I)} | {"omega0": rate, "l": rate * l})
    V = satellite(I, (0, rate * l, 0), float(rate))
    rest = np.array([1.0, 0, 0, 0])
    height, _ = lowest_way(V, rest, np.random.default_rng(seed), True, 6000)
    assert abs(height - V(rest) - float(there.barrier)) < 1e-3 * float(rate)**2
    assert there.barrier == rate**2 * min(Y, P) and there.kick**2 == 2 * there.barrier * min(I[1], I[2])
    assert (there.tilt is None) != rigid


def test_a_tilt_at_rest_stays_below_the_barrier():
    """V of a turn about any axis by the tilt of the form is at most the barrier, about roll equal to it."""
    scene = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 0, 0)), gs.circular_orbit(1))
    form = closed_forms(gs.earth_pointing(scene))[0].at({})
    half, V = float(form.tilt) / 2, satellite((60, 70, 35), (0, 0, 0), 1)
    axes = np.random.default_rng(3).normal(size=(4000, 3))
    axes = np.concatenate([[[1, 0, 0]], axes / np.linalg.norm(axes, axis=1, keepdims=True)])
    rises = V(np.column_stack([np.full(len(axes), np.cos(half)), np.sin(half) * axes])) - V(np.eye(4)[0])
    assert abs(rises[0] - 5) < 1e-9 and rises.max() < 5 + 1e-9 and frames(np.eye(4)[0])[0][1] == 1


def test_values_of_the_theory():
    """Sleeping tops with and without damping, satellites rigid and with a wheel, free gyrostats."""
    top = gs.assemble(gs.Gyrostat(("I1", "I1", "I3"), (0, 0, 0)), gs.uniform_field())
    numbers = {"I1": 1, "I3": Rational(8, 5), "m0": 1, "pi3_0": Rational(12, 5)}
    undamped, damped = (named(form, numbers) for form in closed_forms(gs.upright(top)))
    assert str(undamped.kick.xreplace({THETA: rad(10)}).n(15)) == "0.117064424992385"
    [z] = [x for x in Poly(damped.equation, Z).nroots(n=30) if x.is_real and 0 < x < 1]
    found = [x.xreplace({Z: z}).n(15) for x in (Z, damped.barrier, damped.kick)]
    assert list(map(str, found)) == ["0.327885244991177", "0.233367464231220", "0.683180011755643"]
    rigid, pitch = (gs.assemble(gs.Gyrostat(I, (0, l, 0)), gs.circular_orbit(1)) for I, l in (
        ((60, 70, 35), 0), ((1, Rational(7, 10), Rational(4, 5)), Rational(1, 2))))
    form = closed_forms(gs.earth_pointing(rigid))[0].at({})
    assert form.barrier == 5 and form.kick**2 == 350
    assert str((form.tilt * 180 / S.Pi).n(15)) == "15.5013595669370"
    assert closed_forms(gs.earth_pointing(pitch))[0].at({}).barrier == Rational(23, 240)
    wheel = gs.assemble(gs.Gyrostat((60, 70, 35), (0, 5, 0)), gs.circular_orbit(1))
    ends = [closed_forms(gs.earth_pointing(wheel, s, 2 * s, 3))[0].at({}).barrier for s in (1, -1)]
    assert ends == [Rational(45, 4), Rational(5, 4)]
    body = gs.assemble(gs.Gyrostat((1, 2, 3), (0, 0, Rational(1, 4))))
    form, _ = closed_forms(gs.principal_rotation(body, 3))
    for omega, barrier in ((Rational(1, 4), Rational(3, 16)), (Rational(-5, 12), Rational(1, 48))):
        assert named(form, {"omega3_0": omega}).barrier == barrier


def test_where_no_form_is_known_there_is_none():
    """A field across the axis, an unspecified U, a magnet in orbit, a name that a form uses itself."""
    body = gs.Gyrostat(gyrostatic_momentum=(0, 0, 0))
    z, k3 = gs.symbol("z"), gs.symbol("k3")
    magnet = gs.circular_orbit(potential="B*n2")
    for eq in (gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())),
               gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential(z * k3))),
               gs.upright(gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential("1/(2 - k3)"))),
               gs.upright(gs.assemble(body, gs.uniform_field())),
               gs.earth_pointing(gs.assemble(body, magnet))):
        assert closed_forms(eq) == ()
    satellite = closed_forms(gs.earth_pointing(gs.assemble(body, gs.circular_orbit())))
    assert named(satellite[0], {"I1": 1, "I2": 2, "I3": 2}) is None


def test_a_piecewise_form_has_every_case_by_name():
    """Names that stay are kept, with what they mean."""
    scene = gs.assemble(gs.Gyrostat(("I1", "I2", "I3"), (0, "l", 0)), gs.circular_orbit())
    numbers = {"omega0": 1, "I1": 60, "I2": 70, "I3": 35}
    (yaw, first), (pitch, second) = (form := named(closed_forms(gs.earth_pointing(scene))[0], numbers)).names
    assert isinstance(first, Piecewise) and isinstance(second, Piecewise) and form.barrier == Min(yaw, pitch)
    assert named(form, {"l": 5}).barrier == Rational(45, 4) and named(form, {"l": -20}) is None
    equal = named(closed_forms(gs.earth_pointing(scene))[0], {"omega0": 1, "I1": 3, "I2": 3, "I3": 2})
    assert equal.names == ((yaw, 2 * gs.symbol("l")),) and equal.barrier == Min(yaw, Rational(3, 2))
