"""The speeds of a wheel at which an attitude in orbit is stable, against Newton and Euler in floats."""
import re
from fractions import Fraction as F
from random import Random

import numpy as np
import pytest
from orbital_stiffness import at_rest
from satellites import rotation
from slow import sampled
from sympy import Rational, oo, pi, symbols

import gyrostat as gs

S = gs.symbol("s")


def tensor_of(rng, coupled):
    """A tensor in fractions, the product of roll and yaw 0 or not."""
    a, b, c = (F(rng.randint(20, 40), 10) for _ in range(3))
    u, v, w = (F(rng.randint(-5, 5), 10) for _ in range(3))
    return [[a, u, w * coupled], [u, b, v], [w * coupled, v, c]]


def scene_of(tensor, axis, w, J=F(1, 10), speed=S):
    """A wheel along an axis, in an orbit of a rate."""
    body = gs.gyrostat_with_rotors(tensor, [gs.Rotor(axis, axial=J, rate=speed)], lumped=True)
    return gs.assemble(body, gs.circular_orbit(w))


def floats(x):
    """As an array."""
    return np.array([[float(y) for y in row] for row in x])


def resting(I, n, r):
    """The nearest r in the plane across n where t·I r is 0."""
    t = np.cross(n, r)
    plane = np.array([t, r])
    _, vectors = np.linalg.eigh(plane @ I @ plane.T)
    near = max((v * np.sign(v[1]) for v in vectors.T), key=lambda v: v[1])
    return near @ plane


def inner(i):
    """A point inside an interval."""
    low, high = (None if x.is_infinite else float(x) for x in (i.low, i.high))
    if low is None and high is None:
        return 0.7
    return high - 2 if low is None else low + 2 if high is None else (low + high) / 2


@pytest.mark.slow
@pytest.mark.parametrize("coupled", [0, 1])
def test_inside_every_interval_the_motion_does_what_is_said(full, coupled):
    """No torque acts; growth is 0 or not; the stiffness is positive if and only if damping leaves it stable.

    The wheel is along the normal of an attitude in any direction, or against it.
    """
    rng, kinds = Random(29 + coupled), set()
    for _ in range(sampled(12, full, 2)):
        turn, way, w = rotation(rng), rng.choice([1, -1]), F(rng.randint(2, 6), 4)
        R = floats(turn)
        tensor = tensor_of(rng, coupled)
        rotated = [[sum(turn[k][i] * tensor[k][m] * turn[m][j] for k in range(3) for m in range(3))
                    for j in range(3)] for i in range(3)]                    # t, n, r are the rows of turn
        found = gs.wheel_speeds(scene_of(rotated, [way * x for x in turn[1]], w), "s", unit="",
                                directions=turn[1:])
        I, n, r = floats(rotated), R[1], resting(floats(rotated), R[1], R[2])
        carried = np.array([float(x) for x in found.carried])
        for kind, sets in (("undamped", found.undamped), ("damped", found.damped)):
            for said in ("stable", "unstable", "undecided"):
                for i in (i for i in getattr(sets, said) if i.low != i.high):
                    l = carried + 0.1 * inner(i) * way * n
                    torque, growth, least = at_rest(I, n, r, l, float(w))
                    kinds.add((kind, said))
                    assert torque < 1e-10                                   # round-off
                    if kind == "damped":
                        assert (least > 0) == (said == "stable") and said != "undecided"
                    else:
                        assert (growth > 1e-4) == (said == "unstable")     # a boundary is not met by chance
                        assert (least > 0) == (said == "stable")
    assert {("undamped", "stable"), ("undamped", "unstable"), ("damped", "unstable")} <= kinds


def test_a_pitch_wheel_has_the_ends_of_the_textbook():
    """I = (1, 7/10, 4/5), ω0 = 1: stable above l = 2/5; the other ends are 3/10 and roots of p² = 4 q."""
    found = gs.wheel_speeds(scene_of([F(1), F(7, 10), F(4, 5)], (0, 1, 0), 1), "s")
    (above,), (first, second) = found.undamped.stable, found.undamped.unstable
    assert (above.low, second.low, second.high) == (4, 3, 4)
    x = symbols("x")
    margin = (x**2 - 2 * x / 5 + Rational(59, 100))**2 - Rational(16, 5) * (x - Rational(2, 5)) * (
        x - Rational(3, 10))
    for end, near in ((first.low, -1.4134959831540943713), (first.high, 0.020762905883088805319)):
        assert abs(margin.subs(x, (end / 10).evalf(60))) < 1e-50 and abs(float(end) / 10 - near) < 1e-15
    assert [(i.low, i.high) for i in found.damped.unstable] == [(-oo, above.low)]


@pytest.mark.parametrize("axis", [(0, 1, 0), (0, -1, 0)])
def test_what_is_printed_of_stable_and_unstable_speeds_is_true(axis):
    """The decimals of proved sets are rounded inwards, in rpm; an equality is told by digits that go on."""
    wheel = gs.Rotor(axis, "0.01 kg m^2", rate=S)
    body = gs.gyrostat_with_rotors("410, 580, 250 kg m^2", [wheel], lumped=True)
    found = gs.wheel_speeds(gs.assemble(body, gs.circular_orbit(height="500 km")), "s")
    first, second, third, *_ = str(found).replace("\n", " ").split(". ")
    (stable,), (unstable,) = found.undamped.stable, found.undamped.unstable
    ends = [re.findall(r"−?\d+\.?\d*", text) for text in (first, second)]
    (edge,), (low, high) = ([Rational(x.replace("−", "-")) * pi / 30 for x in some] for some in ends)
    inside = edge - stable.low if axis[1] == 1 else stable.high - edge
    assert first.startswith("Stable for a wheel speed " + ("above" if axis[1] == 1 else "below"))
    assert first.endswith(" rpm") and second.startswith("Unstable for a wheel speed between ")
    assert 0 < inside < 1e-4
    assert 0 < low - unstable.low < 1e-3 and 0 < unstable.high - high < 1e-3
    assert third.startswith("Nothing is proved for ") and "…" in third


@pytest.mark.slow
def test_an_end_at_which_a_sign_is_not_proved_is_undecided():
    """A tensor in pounds and inches, whose ends are roots over a field of two square roots."""
    tensor = "[[5.1e6, 1.2e5, -3e4], [1.2e5, 7.7e6, 2.2e4], [-3e4, 2.2e4, 3.9e6]] lb in^2"
    body = gs.gyrostat_with_rotors(tensor, [gs.Rotor((0, 1, 0), "2 lb in^2", rate=S)], lumped=True)
    found = gs.wheel_speeds(gs.assemble(body, gs.circular_orbit(height="400 km", body="moon")), "s")
    (stable,), (*_, last) = found.undamped.stable, found.undamped.undecided
    assert last.low == last.high == stable.low and not stable.low_if
    assert [len(x) for x in (found.damped.stable, found.damped.unstable)] == [1, 2]


def test_a_wheel_across_the_normal_holds_one_speed_at_most():
    """l·t = −ω0 t·I n: at that speed alone the attitude is held; a product of pitch and yaw needs more."""
    tensor = [[3, F(1, 2), 0], [F(1, 2), 4, 0], [0, 0, 2]]
    found = gs.wheel_speeds(scene_of(tensor, (1, 0, 0), 2), "s", unit="")
    assert found.only == -10 and found.carried == (0, 0, 0)
    alone = scene_of(tensor, (1, 0, 0), 2, speed=-10)
    assert gs.analyze(gs.earth_pointing(alone)).verdict({}).verdict is gs.Verdict.STABLE
    assert found.undamped.stable and found.damped.stable and not found.undamped.unstable
    assert str(found).startswith("Stable at the one speed that holds the attitude, −10; with internal")
    with pytest.raises(gs.errors.EquilibriumError, match=r"momentum \(-1, 0, -4\) more"):
        tensor = [[3, F(1, 2), 0], [F(1, 2), 4, F(1, 2)], [0, F(1, 2), 2]]
        gs.wheel_speeds(scene_of(tensor, (1, 1, 0), 2), "s")


@pytest.mark.slow
def test_other_wheels_carry_what_is_missing():
    """With their momentum the attitude is an equilibrium at each speed; what they have is taken off."""
    tensor = [[3, F(1, 2), 0], [F(1, 2), 4, F(1, 4)], [0, F(1, 4), 2]]
    carried = gs.wheel_speeds(scene_of(tensor, (0, 1, 0), 2), "s").carried
    assert carried == (-1, 0, -2)
    for momentum, left in ((carried, (0, 0, 0)), ((1, 5, 0), (-2, 0, -2))):
        body = gs.Gyrostat(tensor, (momentum[0], momentum[1] + S, momentum[2]))
        scene = gs.assemble(body, gs.circular_orbit(2))
        assert gs.wheel_speeds(scene, "s", unit="N m s").carried == left
    assert gs.earth_pointing(gs.assemble(gs.Gyrostat(tensor, (-1, S, -2)), gs.circular_orbit(2)))


@pytest.mark.parametrize(("scene", "given", "why"), [
    (lambda: gs.assemble(gs.symmetric_gyrostat(), gs.uniform_field()), {}, "is for a satellite"),
    (lambda: scene_of((3, 4, 2), (0, 1, 0), gs.symbol("omega0")), {}, "omega0 is open beside s"),
    (lambda: scene_of((3, 4, 2), (0, 1, 0), 1, speed=2), {}, "no wheel has the speed s"),
    (lambda: scene_of((3, 4, 2), (0, 1, 0), 1, speed=S**2), {}, "not linear in s"),
    (lambda: scene_of((3, 4, 2), (0, 1, 0), 1), {"unit": "furlong"}, "is no unit"),
    (lambda: scene_of((3, 4, 2), (0, 1, 0), 1), {"directions": ((0, 2, 0), (0, 0, 1))}, "unit vectors"),
    (lambda: scene_of((3, 4, 2), (0, 1, 0), 1), {"directions": ("n", "r")}, "give the normal"),
    (lambda: scene_of((3, 4, 3), (0, 1, 0), 1), {}, "leaves the turn about the normal free"),
    (lambda: scene_of((3, 4, 2), (0, 1, 0), 1), {"pitch": 3}, "give the body axes 1, 2, 3")])
def test_what_is_no_such_question_is_refused(scene, given, why):
    """In at most 300 characters."""
    with pytest.raises(gs.errors.GyrostatError, match=why) as refused:
        gs.wheel_speeds(scene(), "s", **given)
    assert len(str(refused.value)) <= 300
