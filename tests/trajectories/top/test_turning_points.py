"""The roots of g between which a body of revolution nutates, proved from exact numbers."""
from fractions import Fraction as F

import numpy as np
import pytest
from flint import arb, ctx
from sympy import Rational, atan, cos, exp, log, pi, sin, sqrt

import gyrostat as gs
from gyrostat.algebra.text.numbers import exact_number
from gyrostat.errors import AccuracyError, ScopeError, ValuesError
from gyrostat.trajectories import motion
from gyrostat.trajectories.top.level import Level
from gyrostat.trajectories.top.turning_points import roots_of


def level(U, state, inertia=("1", "3/5"), l="2/5"):
    """U a function of k3."""
    I1, I3, l = map(exact_number, (*inertia, l))
    return Level(gs.assemble(gs.Gyrostat((I1, I1, I3), (0, 0, l)), gs.axial_potential(U)),
                 tuple(map(exact_number, state)))


def found(level, precision=200):
    with ctx.workprec(precision):
        return roots_of(level)


def g_of(U, state, inertia=(1.0, 0.6), l=0.4):
    """g in doubles, from the energy and v; a function of k3."""
    p1, p2, p3, k1, k2, k3 = (float(F(x)) for x in state)
    r2, P = k1**2 + k2**2 + k3**2, p3 + l
    E, v = (p1**2 + p2**2) / (2 * inertia[0]) + U(k3), p1 * k1 + p2 * k2 + P * k3
    return lambda z: 2 * inertia[0] * (E - U(z)) * (r2 - z * z) - (v - P * z) ** 2


GENERAL = ("3/10", "-1/5", "3/2", "3/5", "0", "4/5")
POLYNOMIALS = [(3 / 2,), (-1.75,), (1, 0.5), (0, -2), (1, -0.375, 0.5), (0.5, 0, 0, 0, 0, 0.25)]


@pytest.mark.parametrize("c", POLYNOMIALS)
@pytest.mark.parametrize("state", [GENERAL, ("1", "2", "-1/2", "3/4", "0", "-1"),
                                   ("1/2", "-1/3", "1", "0", "0", "1")])
def test_roots_of_a_polynomial_are_those_of_numpy(c, state):
    """All roots of g, with the turning points on either side of k3 and the leading coefficient, against a fit
    of g from the energy.
    """
    roots = found(level(lambda z: sum(Rational(x) * z**n for n, x in enumerate(c, 1)), state))
    g, n = g_of(lambda z: sum(x * z**n for n, x in enumerate(c, 1)), state), len(c) + 2
    nodes = 5 * np.cos(np.pi * (np.arange(n + 1) + 0.5) / (n + 1))
    fit = np.polynomial.Polynomial.fit(nodes, g(nodes), n).convert()
    assert float(roots.leading) == pytest.approx(fit.coef[-1], rel=1e-9)
    ours = [float(roots.lower), float(roots.upper)] + [complex(float(x.real), float(x.imag))
                                                       for x, m in roots.others for _ in range(m)]
    theirs = fit.roots()
    # conditioned by a fit over ±5
    assert len(ours) == n and all(min(abs(x - y) for y in theirs) < 1e-6 for x in ours)
    assert roots.lower < roots.upper and roots.double == (False, False)
    between = np.linspace(float(roots.lower), float(roots.upper), 50)[1:-1]
    assert (g(between) > 0).all() and between[0] - 0.1 <= float(F(state[5])) <= between[-1] + 0.1


@pytest.mark.parametrize("side", [-1, 1])
def test_a_pole_that_is_reached_is_a_root_wherever_it_lies(side):
    """abs(k) = 5, v = ±5 P with an irrational P: g vanishes at k3 = ±5."""
    P = sqrt(2)
    roots = found(level(lambda z: z / 20, (side * P / 3, 0, P - Rational(2, 5), 3, 0, side * 4)))
    assert (roots.upper if side == 1 else roots.lower).contains(side * 5)


def test_published_cubic():
    """Simo & Wong's top: the roots of the nutation cubic as printed."""
    roots = found(level(lambda z: 20 * z, (0, 0, 50, 0, sin(Rational(1, 20)), cos(Rational(1, 20))), (5, 1),
                        0))
    ends = roots.lower, roots.upper, roots.others[0][0].real
    for ours, printed in zip(ends, (".998512425506186", ".998750260394966", "11.5014875744938")):
        assert abs(ours - arb(printed)) < arb("0.51") * arb(10) ** -len(printed.partition(".")[2])
        assert ours.rad() < arb("1e-40")
    assert len(roots.others) == 1 and float(roots.leading) == 200


@pytest.mark.few(1)
@pytest.mark.parametrize("precision", [128, 300])
@pytest.mark.parametrize("U", [exp, lambda z: log(z + 2), lambda z: 1 / (z + 2)])
def test_turning_points_of_a_function_are_enclosed(U, precision):
    """g changes its sign between the ends of each enclosure; between them it does not vanish."""
    for state in (GENERAL, ("3", "1/2", "3/2", "0", "3/5", "-4/5"), ("1/2", "-1/3", "1", "3", "0", "4")):
        if U is not exp and state[3] == "3":
            continue
        place = level(U, state)
        roots = found(place, precision)
        g = g_of(lambda x, U=U: float(U(Rational(x)).evalf(30)), state)
        for end, inward in ((roots.lower, 1), (roots.upper, -1)):
            assert end.rad() < arb(2) ** -(precision - 24)
            x = float(end)
            assert g(x + inward * 1e-6) > 0 > g(x - inward * 1e-6)
        assert roots.leading is None and float(roots.lower) <= float(F(state[5])) <= float(roots.upper)
        assert all(g(x) > 0 for x in np.linspace(float(roots.lower), float(roots.upper), 60)[1:-1])


def test_a_polynomial_and_the_same_function_have_the_same_roots():
    """U = z³/2 and what it is with a vanishing transcendental part.

    Turning points to all bits, other roots to a few.
    """
    smooth = level(lambda z: z + z**3 / 2 + exp(-z - 200), GENERAL)
    exact, near = found(level(lambda z: z + z**3 / 2, GENERAL)), found(smooth)
    with ctx.workprec(300):
        assert abs(exact.lower - near.lower) < arb("1e-55") and abs(exact.upper - near.upper) < arb("1e-55")
    for x, _ in exact.others:
        assert min(float(abs(x - y)) for y, _ in near.others) < 1e-9


@pytest.mark.parametrize("U", [lambda z: z / 2, lambda z: z / 8 + exp(z) / 8])
@pytest.mark.parametrize(("state", "end"), [(("1", "0", "3/2", "3/5", "0", "4/5"), 0),
                                            (("3", "0", "3/2", "3/5", "0", "4/5"), 1)])
def test_a_start_at_rest_is_a_turning_point_itself(U, state, end):
    """Where k̇3 = 0 the start is the lower turning point if k̈3 > 0, else the upper one, without an error."""
    place = level(U, state)
    assert place.direction == 0 and place.turn == (1, -1)[end]
    roots = found(place)
    with ctx.workprec(200):
        assert abs((roots.lower, roots.upper)[end] - arb(4) / 5) < arb("1e-50")
    assert ((roots.upper, roots.lower)[end] - arb(4) / 5) * (1, -1)[end] > 0


@pytest.mark.parametrize(("state", "poles", "direction"), [
    (("7/15", "2", "1", "3/5", "0", "4/5"), (1, 0), 1),
    (("-21/5", "-1/2", "1", "3/5", "0", "4/5"), (0, -1), -1),
    (("0", "1", "-2/5", "3/5", "0", "4/5"), (0, 0), 1), (GENERAL, (1, -1), -1),
    (("1/2", "0", "1", "0", "0", "1"), (1, 0), 0),
    (("1/2", "0", "1", "0", "0", "-2"), (0, -1), 0), (("30", "0", "1/10", "3/5", "0", "4/5"), (1, 1), 0)])
@pytest.mark.parametrize("U", [lambda z: 2 * z, exp])
def test_poles_that_may_be_passed(U, state, poles, direction):
    """Signs of v + P abs(k) and v − P abs(k), the sign of k̇3, and the pole as an exact turning point of
    order 1.
    """
    place = level(U, state)
    assert place.poles == poles and place.direction == direction
    assert place.contact == tuple(int(sign == 0) for sign in poles)
    roots = found(place)
    r = sum(F(x) ** 2 for x in state[3:]) ** F(1, 2)
    for sign, end, pole in zip(poles, (roots.lower, roots.upper), (-r, r)):
        assert (float(end) == pole) == (sign == 0 and (abs(float(end)) > 0.999 * r))


SLEEPING = ("1", "1", "13/5", "3/5", "0", "4/5")


def test_double_roots_at_a_pole():
    """The sleeping top's energy and v.

    The upper pole is a double root, for rational numbers, roots and transcendental U alike.
    """
    place = level(lambda z: 5 * z, SLEEPING)
    assert place.contact == (0, 2) and place.poles == (1, 0)
    roots = found(place)
    assert roots.double == (False, True)
    assert roots.upper == 1
    assert not any(float(x.real) == 1 for x, _ in roots.others)
    irrational = level(lambda z: 5 * sqrt(2) * z, (1, sqrt(2 * sqrt(2) - 1), *SLEEPING[2:]))
    assert found(irrational).double == (False, True) and irrational.contact == (0, 2)
    with ctx.workprec(200):
        assert abs(found(irrational).upper - 1) < arb("1e-50")
    function = level(exp, (F(1, 3), sqrt(2 * (exp(1) - exp(Rational(4, 5))) - Rational(1, 9)), F(3, 5),
                           F(3, 5), 0, F(4, 5)))
    assert function.contact == (0, 2) and found(function).double == (False, True)


@pytest.mark.slow
def test_a_root_of_third_order_is_out_of_scope():
    """P² = 4 I1 U′(1), U′ + U″ < 0, energy of E1.

    The critical sleeping top escapes as a power of the time, and is integrated.
    """
    U, state = (lambda z: Rational(33, 8) * z - Rational(25, 16)
                * z**2), ("3/2", "9/10", "8/5", "24/25", "0", "7/25")
    place = level(U, state)
    assert place.contact == (0, 3)
    with pytest.raises(ScopeError, match="order 3"):
        found(place)
    moving = motion(place.scene, state)
    assert moving.route in ("heyoka", "DOP853") and moving.period is None
    assert 0 < 1 - moving(30.0)[5] < 1 - moving(10.0)[5] < 0.1


def test_higher_contact_with_roots():
    """The same where the numbers are not rational."""
    U = lambda z: sqrt(2) * (3 * z - z**2)                 # noqa: E731
    p1, P = sqrt(sqrt(2)) * 2 / 3, 2 * sqrt(sqrt(2))
    p2 = sqrt(2 * sqrt(2) * (2 - Rational(44, 25)) - p1**2)
    place = level(U, (p1, p2, P - Rational(2, 5), F(3, 5), 0, F(4, 5)))
    assert place.contact == (0, 3)
    with pytest.raises(ScopeError, match="order 3"):
        found(place)


def test_roots_that_are_not_told_apart():
    """At too low a precision, next to a double root, the roots are refused rather than guessed.

    With more bits they are found.
    """
    near = level(lambda z: 5 * z, ("1", "1.00000000000000000000000000000000000000001", *SLEEPING[2:]))
    assert found(near, 400).double == (False, False)
    function = level(lambda z: z + exp(z), (*SLEEPING[:2], "13/5", "0", "3/5", "4/5"))
    with pytest.raises(AccuracyError):
        found(function, 2)


def test_what_is_not_proved_is_an_error():
    """Whether a transcendental number is 0 decides the motion: without a proof there is none."""
    hidden = 4 * atan(Rational(1, 5)) - atan(Rational(1, 239)) - pi / 4          # 0, by Machin
    with pytest.raises(ValuesError, match="is 0 is not proved"):
        found(level(lambda z: 2 * z, (F(1, 2), hidden, 1, F(3, 5), 0, F(4, 5))))
