"""Motions of which two roots of g almost meet."""
import mpmath
import numpy as np
import oracle
import pytest
from flint import ctx
from slow import slow
from sympy import Rational, Symbol, exp, lambdify, log, sin
from trajectories.tops import F, off

import gyrostat as gs
from gyrostat.trajectories import motion
from gyrostat.trajectories.top.level import Level
from gyrostat.trajectories.top.turning_points import roots_of


def fitted(functions, where, value, across, P, height):
    """U = A f1 + B f2 + f3, as (A, B), for which g has an extremum of a value at a k3.

    I1 = 1, abs(k) = 1, k2 = 0.

    g = (abs(p)² + 2 (U(k3₀) − U)) (1 − z²) − (v − P z)²
    """
    (p1, p2), k1 = across, mpmath.sqrt(1 - height**2)
    v = p1 * k1 + P * height

    def g(weights, z):
        fallen = sum(w * (f(height) - f(z)) for w, f in zip(weights, functions))
        return (p1 * p1 + p2 * p2 + 2 * fallen) * (1 - z * z) - (v - P * z) ** 2

    zero, A, B = [mpmath.matrix([mpmath.diff(lambda z, w=w: g(w, z), where, n) for n in (0, 1)])
                  for w in ((0, 0, 1), (1, 0, 1), (0, 1, 1))]
    system = mpmath.matrix([[A[i] - zero[i], B[i] - zero[i]] for i in (0, 1)])
    return mpmath.lu_solve(system, mpmath.matrix([value, 0]) - zero)


THIRD = {"degree 3": 3, "degree 6": 6, "exp": 0}           # U = A z + B z² + z³, + z⁶, + exp z


def nearly_double(kind, gap):
    """A body that falls from k3 = 4/5, two roots of g at k3 = 1/5 ± about the gap, a pair if it is negative:
    U, state, the oracle's U.
    """
    n, state, gap = THIRD[kind], (F(1, 4), F(-1, 2), F(11, 10), F(3, 5), F(0), F(4, 5)), mpmath.mpf(gap)
    with mpmath.workdps(60):
        third = (lambda z: z**n) if n else mpmath.exp
        A, B = fitted([lambda z: z, lambda z: z * z, third], mpmath.mpf("0.2"), -gap * abs(gap),
                      (mpmath.mpf("0.25"), mpmath.mpf("-0.5")),
                      mpmath.mpf("1.5"), mpmath.mpf("0.8"))
        A, B = F(mpmath.nstr(A, 45)), F(mpmath.nstr(B, 45))
    terms = [(A, (0, 0, 1)), (B, (0, 0, 2))]
    if n:
        return (lambda z: Rational(A) * z + Rational(B) * z**2 + z**n), state, [*terms, (1, (0, 0, n))]
    return (lambda z: Rational(A) * z + Rational(B) * z**2 + exp(z)), state, lambda z: (
        z.exp() + z.scaled(2 * mpmath.mpf(B.numerator) / B.denominator)
        + oracle.constant(mpmath.mpf(A.numerator) / A.denominator))


def near(kind, gap, precision=None):
    U, state, series = nearly_double(kind, gap)
    return motion(gs.assemble(gs.Gyrostat((1, 1, 2), (0, 0, F(2, 5))), gs.axial_potential(U)), state,
                  precision=precision), state, series


GAPS = ["1e-2", "-1e-2", "1e-5", "-1e-6", "1e-9", "-1e-11", "1e-14", "-1e-14"]
QUICK = [("degree 3", "-1e-6"), ("degree 3", "1e-14"), ("degree 6", "1e-2"), ("exp", "1e-9"),
         ("exp", "-1e-14")]


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "gap"), [
    *QUICK, *slow(*((kind, gap) for kind in THIRD for gap in GAPS if (kind, gap) not in QUICK))])
def test_roots_that_almost_meet(kind, gap):
    """k3 turns before a double root of which a little is missing, and passes a pair.

    The integrals stay, the state is the oracle's.
    """
    found, state, series = near(kind, gap)
    low, size = found.limits[0], abs(float(gap))
    assert abs(low - 0.2) < 10 * size if float(gap) > 0 else low < 0.1
    # relative to the start, which is small
    assert max(found.drift(np.linspace(-1e6, 1e6, 50)).values()) < 5e-14
    t = 4 if size > 1e-6 else F(-1, 2)
    assert (
        off(found(float(t)), oracle.taylor_motion((1, 1, 2), (0, 0, F(2, 5)), state, t, series, 15)) < 5e-14
    )


@pytest.mark.parametrize(("kind", "gap"), [
    ("degree 3", "1e-8"),
    *slow(("degree 3", "1e-2"), ("degree 6", "1e-2"), ("exp", "1e-2"),
          *((kind, gap) for kind in THIRD for gap in ("-1e-14", "-1e-2", "-1e-8", "1e-14")))])
def test_digits_where_roots_almost_meet(kind, gap):
    """Doubles agree with 25 digits at any time, short or long; the 25 digits with the oracle."""
    (found, state, series), exact = near(kind, gap), near(kind, gap, 25)[0]
    times = [F(-3, 2), F(17, 4), F(301, 8), F(10**6), F(10**9)]
    values = exact(times)
    with mpmath.workdps(35):
        for ours, value in zip(values[0], oracle.taylor_motion((1, 1, 2), (0, 0, F(2, 5)), state, times[0],
                                                               series, 24)):
            assert abs(ours - value) < 1e-23
    # 60 radians in a period
    assert np.abs(found([float(t) for t in times]) - values.astype(float)).max() < 1e-13


z = Symbol("z")
BESIDE = [exp(z), log(z + Rational(3, 2)), 1 / (1 + 4 * z * z), -1 / (z + Rational(13, 10)), -sin(3 * z)]


def elsewhere(U, side, size, mass):
    """The same body upside down, in other units of k and of mass."""
    l, *state = (mass * side * Rational(2, 5), *(mass * Rational(x) for x in ("1/4", "-1/2")),
                 mass * side * Rational(11, 10), size * Rational(3, 5), 0, size * side * Rational(4, 5))
    return Level(gs.assemble(gs.Gyrostat((mass, mass, 2 * mass), (0, 0, l)),
                             gs.axial_potential(lambda k3: mass * U.subs(z, side * k3 / size))), tuple(state))


@pytest.mark.few(1)
@pytest.mark.parametrize("gap", ["1e-3", "1e-10", "1e-14"])
@pytest.mark.parametrize("third", BESIDE, ids=["exp", "log", "bell", "pole", "sin"])
def test_the_pair_beside_a_motion_is_found(third, gap):
    """Whatever U(k3) is, on either side, in any units."""
    with mpmath.workdps(60):
        A, B = fitted([lambda x: x, lambda x: x * x, lambdify(z, third, "mpmath")], mpmath.mpf("0.2"),
                      mpmath.mpf(gap) ** 2, (mpmath.mpf("0.25"), mpmath.mpf("-0.5")), mpmath.mpf("1.5"),
                      mpmath.mpf("0.8"))
        U = Rational(mpmath.nstr(A, 45)) * z + Rational(mpmath.nstr(B, 45)) * z**2 + third
    for side, size, mass in ((1, 1, 1), (-1, 1, 1), (1, 50, Rational(1, 900)), (-1, Rational(1, 7), 1000)):
        with ctx.workprec(181):
            roots = roots_of(elsewhere(U, side, size, mass))
            pairs = [(float(x.real / float(size)) - side / 5, float(x.imag / float(size)))
                     for x, _ in roots.others if x.imag > 0]
        away, apart = min(pairs, key=lambda pair: abs(pair[0]))
        assert (roots.lower if side == 1 else roots.upper) * side < 0.2 * float(size)
        assert abs(away) < float(gap) and 0.5 * float(gap) < apart < 6 * float(gap)
